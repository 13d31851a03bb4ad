"""Problems with a known answer: solved by the program `terp`, measured, and held against their references.

The runs of all cases form one queue, the longest first, so that no worker begins a long one at the end. Each run has
one thread. Cases are judged after all are solved, in the order in which they were chosen. A case that cannot be read
does not stop the others: it has one row with its fault. After an interruption nothing is judged.
"""

import argparse
import os
import shutil
import signal
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace

from terp.errors import CaseError, RunError
from terp.verify import cases, ledger
from terp.verify.expected import read_expected
from terp.verify.judge import FAIL, REGRESSION, Row, judge
from terp.verify.solve import Program, list_jobs, solve

EPILOG = """examples:
  python3 -m terp.verify infinite_slope
  python3 -m terp.verify --short --markdown ledger.md

exit status: 0 every row agrees or is declared red, 2 bad input, 1 anything else"""


def readable_duration(seconds):
    if seconds < 10.0:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02} min"


class Progress:
    """What is done and how long the rest may take: a line that renews itself on a terminal, else one per run."""

    def __init__(self, jobs):
        self.n_jobs, self.n_done, self.seconds = len(jobs), 0, sum(job.run.seconds for job in jobs)
        self.done_seconds, self.start = 0.0, time.monotonic()
        self.lock, self.terminal = threading.Lock(), sys.stderr.isatty()

    def done(self, job, seconds):
        with self.lock:
            self.n_done += 1
            self.done_seconds += job.run.seconds
            wall, rest = time.monotonic() - self.start, max(0.0, self.seconds - self.done_seconds)
            left = wall * rest / self.done_seconds if self.done_seconds else 0.0
            line = (f"[{self.n_done}/{self.n_jobs}] {job.title}  {readable_duration(seconds)}  "
                    f"ETA {readable_duration(left)}")
            clear = "\r\033[K"
            end = "\n" if not self.terminal else clear if self.n_done == self.n_jobs else ""
            print(clear + line if self.terminal else line, end=end, file=sys.stderr, flush=True)


def solve_all(jobs, program, n_workers):
    """Solved runs in the order of the jobs."""
    order = sorted(range(len(jobs)), key=lambda k: -jobs[k].run.seconds)
    progress, solved = Progress(jobs), [None] * len(jobs)

    def solve_one(k):
        solved[k] = solve(jobs[k], program)
        progress.done(jobs[k], solved[k].seconds)
    pool = ThreadPoolExecutor(n_workers)
    try:
        list(pool.map(solve_one, order))
    except KeyboardInterrupt:
        program.stop()
        pool.shutdown(cancel_futures=True)
        raise RunError("stopped before all cases were solved; nothing is said of the others") from None
    return solved


def read_cases(folder, names):
    """Namespaces with name, file and fault: why it cannot be read; then nothing of it is solved."""
    read = []
    for name in names:
        case = SimpleNamespace(name=name, file=None, fault="")
        path = folder / name / "expected.toml"
        try:
            case.file = read_expected(path)
            if not case.file.quantities:
                raise CaseError(f"error: {path}: there is no [[quantity]], so nothing would be judged\n"
                                "  See docs/verification_cases.md.\n")
        except CaseError as error:
            case.fault = str(error)
        read.append(case)
    return read


def list_cases(read, options):
    for case in read:
        if case.fault:
            print(f"{case.name:<28} cannot be read\n{case.fault}", end="")
            continue
        n_short, n_long = len(list_jobs(case.file, True, False)), len(list_jobs(case.file, False, True))
        if not (options.short and n_short == 0 or options.long and n_long == 0):
            print(f"{case.name:<28} {n_short:2} short and {n_long:2} long runs  {case.file.title}")


def judge_all(read, jobs, solved):
    pages = []
    for case in read:
        own = [(job, s) for job, s in zip(jobs, solved) if not case.fault and job.file is case.file]
        rows = [Row("-", "expected.toml", remark=case.fault)] if case.fault else judge(case.file, own)
        if rows:
            pages.append(ledger.CaseRows(case.name, "" if case.fault else case.file.title, rows))
            print(ledger.text_table(pages[-1]), flush=True)
    return pages


def check_page(path):
    """Pages are written at the end, after up to hours of solving: what stands in their way is said before."""
    writable = os.access(path if path.exists() else path.parent, os.W_OK) and not path.is_dir()
    if not writable:
        raise RunError(f"{path}: the page cannot be written; nothing was solved")


def write_pages(options, folder, pages):
    """Cases that were not asked for keep what the short page says of them."""
    readme = folder / "README.md"
    head = readme.read_text(encoding="utf-8") if readme.exists() else ""
    head = head.partition("\n")[2][1:] if head.startswith("# ") else head  # the page has its own title
    texts = {}
    if options.markdown:
        texts[options.markdown] = ledger.markdown_page(pages, head)
    if options.overview:
        entries = ledger.overview_of(pages)
        if options.names and options.overview.exists():
            entries = {**ledger.read_overview(options.overview.read_text(encoding="utf-8")), **entries}
        texts[options.overview] = ledger.overview_page(entries, head)
    for path, text in texts.items():
        path.write_text(text, encoding="utf-8")
        print(f"written: {path}")


def verify(options):
    """Exit status."""
    folder = options.cases or cases.find_folder()
    read = read_cases(folder, cases.choose(folder, options.names))
    if options.list:
        list_cases(read, options)
        return 0
    jobs = [job for case in read if not case.fault for job in list_jobs(case.file, not options.long, not options.short)]
    if not jobs:
        if faults := "".join(case.fault for case in read):
            raise CaseError(faults)
        raise RunError(f"there is nothing to solve: these cases have no {'long' if options.long else 'short'} run")
    for path in filter(None, (options.markdown, options.overview)):
        check_page(path)
    if shutil.which(options.terp) is None:
        raise RunError(f"cannot start `{options.terp}`. Give the path of the program with --terp")
    pages = judge_all(read, jobs, solve_all(jobs, Program(options.terp), options.threads))
    write_pages(options, folder, pages)
    counts = ledger.count(pages)
    print(ledger.counts_text(pages))
    is_all = not (options.names or options.short or options.long)
    too_many = is_all and ledger.too_many_regressions(counts[REGRESSION], counts.total())
    if too_many:
        print("More than a tenth of the rows are regression: hold more of them against outside values.")
    return 1 if counts[FAIL] or too_many else 0


def at_least_one(text):
    if int(text) < 1:
        raise ValueError
    return int(text)


def main(words=None):
    parser = argparse.ArgumentParser(prog="python3 -m terp.verify", epilog=EPILOG,
                                     description="Solve problems with a known answer (docs/verification_cases.md).",
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="CASE", help="names of cases; NAME* for all that begin so")
    parser.add_argument("--list", action="store_true", help="names and titles")
    length = parser.add_mutually_exclusive_group()
    length.add_argument("--short", action="store_true", help="only runs that take seconds")
    length.add_argument("--long", action="store_true", help="only runs that take minutes")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the ledger as a page")
    parser.add_argument("--overview", type=Path, metavar="FILE",
                        help="write one line per case, and what does not agree; an old page keeps the cases that are "
                        "not solved")
    parser.add_argument("--cases", type=Path, metavar="DIR", help="folder of the cases")
    parser.add_argument("--terp", default=os.environ.get("TERP", "terp"), metavar="FILE",
                        help="the program (default: the environment variable TERP, else `terp`)")
    parser.add_argument("-j", "--threads", type=at_least_one, default=len(os.sched_getaffinity(0)), metavar="N",
                        help="runs at a time (default: processors that this job may use); numbers do not depend on it")
    options = parser.parse_args(words)
    if options.overview and (options.short or options.long):
        parser.error("--overview takes all runs: leave out --short and --long")
    try:
        return verify(options)
    except CaseError as error:
        print(str(error).rstrip(), file=sys.stderr)
        return 2
    except (RunError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # the runs must not go on alone
    sys.exit(main())
