"""Runs what cases/NAME/expected.toml lists and holds each number of summary.json against it.

check_expected.py TERP CASE_FOLDER [--only TEXT] [--long] [--accept]

expected.toml holds one table per run:
    [model_2_gp]
    case = "model_2.toml"                 # in the same folder
    set  = ["scheme=mpm_gp"]              # further --set options
    long = true                           # only with --long (make verify); otherwise only without it
    front_x = { value = 13.03, absolute = 0.05 }   # or relative; a name is a key of summary.json, "a.0.b" goes deeper
    energy_balance_error = { at_most = 2e-3 }      # or at_least
--only takes the tables with TEXT in their name.
--accept writes the values that came out; the tolerances stay.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

NOT_NUMBERS = {"case", "set", "long"}


def run(terp, folder, table, runs):
    """Summary of one run of the table."""
    out = Path(runs) / "run"
    command = [terp, "run", folder / table["case"], "-o", out, "-q", "--force"]
    for setting in table.get("set", []):
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return json.loads((out / "summary.json").read_text())


def look_up(summary, key):
    for part in key.split("."):
        summary = summary[int(part)] if isinstance(summary, list) else summary[part]
    return summary


def judge(got, expected):
    """Whether a number agrees, and what was wanted in words. A number that is null in summary.json is `never`."""
    if "at_least" in expected:
        return got is not None and got >= expected["at_least"], f"at least {expected['at_least']:g}"
    if "at_most" in expected:
        return got is not None and got <= expected["at_most"], f"at most {expected['at_most']:g}"
    if got is None or expected["value"] == "never":
        return got is None and expected["value"] == "never", str(expected["value"])
    band = expected["absolute"] if "absolute" in expected else expected["relative"] * abs(expected["value"])
    return abs(got - expected["value"]) <= band, f"{expected['value']:g} +- {band:g}"


def check(name, table, summary):
    """Prints one line per number; True if all agree."""
    good = True
    for key, expected in table.items():
        if key in NOT_NUMBERS:
            continue
        got = look_up(summary, key)
        agrees, wanted = judge(got, expected)
        good &= agrees
        print(f"{'   ok' if agrees else 'WRONG'}  {name}.{key}: "
              f"{'never' if got is None else f'{got:.6g}'}, expected {wanted}")
    return good


def accept(text, name, summary):
    """The text of expected.toml with this table's values replaced."""
    start = text.index(f"[{name}]")
    end = text.find("\n[", start + 1)
    end = len(text) if end < 0 else end

    def replace(match):
        got = look_up(summary, match["key"])
        return f"{match['key_part']}{{ value = " + ('"never"' if got is None else f"{got:.6g}")

    body = re.sub(r'(?m)(?P<key_part>^"?(?P<key>[\w.]+)"?\s*=\s*)\{\s*value\s*=\s*[^,}]+(?<!\s)', replace,
                  text[start:end])
    return text[:start] + body + text[end:]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("terp", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="", help="take only tables with this text in their name")
    parser.add_argument("--long", action="store_true", help="the runs with long = true, instead of the others")
    parser.add_argument("--accept", action="store_true", help="write what came out into expected.toml")
    options = parser.parse_args()
    path = options.folder / "expected.toml"
    text = path.read_text()
    good = True
    for name, table in tomllib.loads(text).items():
        if table.get("long", False) != options.long or options.only not in name:
            continue
        with tempfile.TemporaryDirectory() as runs:
            summary = run(options.terp, options.folder, table, runs)
        good &= check(name, table, summary)
        if options.accept:
            text = accept(text, name, summary)
    if options.accept:
        path.write_text(text)
    sys.exit(0 if good or options.accept else 1)


if __name__ == "__main__":
    main()
