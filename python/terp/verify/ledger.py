"""The ledger as text for a terminal, as a Markdown page with all rows, and as the short page docs/verification.md.

The short page is its own store: a line of its table begins with the name of its case as a link, an item of the list of
reasons with the name in bold. Reading takes these two marks, and the heading behind which the reasons are those of
regression rows. So a case that was not solved keeps what the page says of it.
"""

import collections
import re
import textwrap
from dataclasses import dataclass

from terp.verify.judge import FAIL, PASS, RED, REGRESSION

HEADS = ("quantity", "run", "reference", "Terp", "error", "tolerance", "result", "source")
WIDEST = 120  # columns of a line of the documents
REGRESSION_HEADING = "## Regression"
WRITTEN = "# Verification\n\nWritten by `python3 -m terp.verify`; not to be changed by hand.\n\n"


@dataclass
class CaseRows:
    name: str
    title: str
    rows: list


@dataclass
class Entry:
    """What the short page says of a case."""

    line: str  # of the table
    rows: int
    red: int
    regression: int
    reasons: str = ""      # a list: why rows are red; empty: all agree
    regressions: str = ""  # a list: why rows are regression rows; empty: there are none


def count(cases):
    """How many rows have each verdict, as a Counter."""
    return collections.Counter(row.verdict for case in cases for row in case.rows)


def counts_text(cases):
    """ "12 rows: 10 pass, 1 red, 1 regression"."""
    n = count(cases)
    text = f"{n.total()} rows: {n[PASS]} pass, {n[RED] + n[FAIL]} red"
    agree = sum(row.agrees_though_red for case in cases for row in case.rows)
    for number, words in ((n[REGRESSION], ", {} regression"), (n[RED], " ({} known, with the reason)"),
                          (agree, " ({} declared red, but agree)"), (n[FAIL], " ({} not known: FAIL)")):
        text += words.format(number) if number else ""
    return text


def too_many_regressions(regressions, rows):
    """More than a tenth of the rows hold Terp against its own results alone."""
    return 10 * regressions > rows


def _cells(row):
    missed = row.verdict == FAIL and row.declared_regression
    return (row.quantity, row.run, row.reference, row.terp, row.error, row.tolerance,
            "FAIL: regression, misses" if missed else row.verdict, row.source)


def _remark_of(row):
    """Why a row is no pass; empty: it passes, or has no reason."""
    if row.verdict == PASS or not row.remark:
        return ""
    return f"{row.run if row.quantity == 'the run' else row.quantity}: {row.remark}"


def _remarks(case, of_regressions):
    """{remark: number of its rows}, of rows that do not agree or of the regression rows: many may have one reason."""
    counts = collections.Counter(_remark_of(row) for row in case.rows if (row.verdict == REGRESSION) == of_regressions)
    counts.pop("", None)
    return counts


def text_table(case):
    lines = [HEADS] + [_cells(row) for row in case.rows]
    widths = [max(len(line[k]) for line in lines) for k in range(len(HEADS) - 1)] + [0]
    text = f"{case.name}: {case.title}\n"
    for line in lines:
        text += "  " + "  ".join(cell.ljust(width) for cell, width in zip(line, widths)) + "\n"
    for row in case.rows:
        if row.agrees_though_red:
            text += (f"  ? {row.quantity}, {row.run}: declared red in expected.toml, but agrees. Take `red` away, or "
                     "name in `red_runs` the runs that it is true of.\n")
    text += "".join("  ! " + remark.replace("\n", "\n    ") + "\n" for remark in _remarks(case, False))
    return text + "".join(f"  = regression, no pass: {remark}\n" for remark in _remarks(case, True))


def _for_markdown(text):
    """Without what Markdown would take for marks."""
    return text.replace("<", "\\<").replace("|", "\\|").replace("*", "\\*").replace("\n", " ")


def markdown_page(cases, head):
    """head: Markdown that stands above the tables, after the title."""
    text = f"{WRITTEN}{counts_text(cases)}.\n\n{head}\n"
    for case in cases:
        text += (f"\n## {case.name}\n\n{_for_markdown(case.title)}: [`cases/verification/{case.name}`]"
                 f"(../cases/verification/{case.name}/README.md)\n\n")
        text += "|" + "".join(f" {name} |" for name in HEADS) + "\n|" + "---|" * len(HEADS) + "\n"
        for row in case.rows:
            text += "|" + "".join(f" {_for_markdown(cell)} |" for cell in _cells(row)) + "\n"
        text += "".join(f"\n**Red.** {_for_markdown(remark)}\n" for remark in _remarks(case, False))
        text += "".join(f"\n**Regression.** {_for_markdown(remark)}\n" for remark in _remarks(case, True))
    return text


# The short page

def _nearest_to_bound(case):
    passed = [row for row in case.rows if row.verdict == PASS and row.used >= 0.0]
    if not passed:
        return "-"
    row = max(passed, key=lambda row: row.used)
    return f"{100.0 * row.used:.0f} % of {row.tolerance}: {row.quantity}, {row.run}"


def _reasons_of(case, of_regressions):
    """A list of the reasons, each once with the number of its rows, in lines of a document."""
    text = ""
    for remark, n in _remarks(case, of_regressions).items():
        item = f"- **{case.name}**, {n} row{'' if n == 1 else 's'}: {_for_markdown(remark)}"
        text += textwrap.fill(" ".join(item.split()), WIDEST, subsequent_indent="  ", break_long_words=False,
                              break_on_hyphens=False) + "\n"
    return text


def overview_of(cases):
    """{name: Entry} of cases that were solved, each with the row that comes nearest to its bound."""
    entries = {}
    for case in cases:
        n = count([case])
        red, fail = n[RED] + n[FAIL], f" ({n[FAIL]} FAIL)" if n[FAIL] else ""
        line = (f"| [{case.name}](../cases/verification/{case.name}/README.md) | {_for_markdown(case.title)} | "
                f"{n.total()} | {red}{fail} | {n[REGRESSION]} | {_for_markdown(_nearest_to_bound(case))} |")
        entries[case.name] = Entry(line, n.total(), red, n[REGRESSION], _reasons_of(case, False),
                                   _reasons_of(case, True))
    return entries


def read_overview(page):
    """The entries of a page that overview_page wrote; what is no entry is left out."""
    entries, of_regressions, kind, entry = {}, False, "", None
    for line in page.splitlines():
        of_regressions |= line == REGRESSION_HEADING
        if row := re.match(r"\| \[(.+?)\]", line):
            cells = [re.match(r"(\d+)(?=$| \()", cell.strip()) for cell in re.split(r"(?<!\\)\|", line)[3:6]]
            entries[row[1]] = Entry(line, *(int(cell[1]) if cell else 0 for cell in cells))
            entry = None
        elif (item := re.match(r"- \*\*(.+?)\*\*", line)) and item[1] in entries:
            entry, kind = entries[item[1]], "regressions" if of_regressions else "reasons"
        elif not line.startswith("  "):
            entry = None
        if entry is not None:
            setattr(entry, kind, f"{getattr(entry, kind)}{line}\n")
    return entries


def overview_page(entries, head):
    """head: Markdown that stands above the table, after the title."""
    in_order = [entries[name] for name in sorted(entries)]
    n_rows, n_red, n_regression = (sum(getattr(entry, key) for entry in in_order)
                                   for key in ("rows", "red", "regression"))
    text = (f"{WRITTEN}{n_rows} rows: {n_rows - n_red - n_regression} pass, {n_red} red, {n_regression} regression.\n\n"
            f"{head}\n| case | | rows | red | regression | nearest to its bound |\n|---|---|---|---|---|---|\n")
    text += "".join(f"{entry.line}\n" for entry in in_order)
    if reasons := "".join(entry.reasons for entry in in_order):
        text += f"\n## Red\n\n{reasons}"
    if regressions := "".join(entry.regressions for entry in in_order):
        text += f"\n{REGRESSION_HEADING}\n\n{regressions}"
    return text
