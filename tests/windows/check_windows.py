#!/usr/bin/env python3
"""The program for Windows, from its zip, under Wine, and beside the program for Linux.

It is unpacked into a folder with spaces and letters beyond ASCII, and tried as a dike engineer uses it: the column of
the paper, a section imported from D-Stability, a reach, resume, the report, and what goes wrong: lines that end as on
Windows, a file that another program has open, Ctrl-C, gmsh that is not there. Numbers are those of Linux: the bits on
the same instruction set. Prints one line per test, and exits with 1 if one fails.

usage: check_windows.py ZIP LINUX_PROGRAM [TEST...]
"""
import csv
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SAMPLES = ROOT / "tests/dstability/samples"
COMPILER = "x86_64-w64-mingw32-gcc-posix"
OF_WINDOWS = re.compile(r"(KERNEL32|ADVAPI32|USER32|SHELL32|WS2_32|msvcrt|SHLWAPI|bcrypt|ole32"
                        r"|api-ms-win-[\w-]+)\.dll", re.I)
COLUMN = ["cases/column_collapse/model_2.toml", "--set", "mesh.cell=0.5", "-j", "2"]
SHORT = ["--set", "time.end=0.2"]
LONG = ["--set", "time.end=60", "--set", "output.checkpoint.every=0.05"]
MOST_SECONDS = 540


class Place:
    """The unpacked program, and a Wine of its own."""

    def __init__(self, scratch, archive, linux):
        self.folder = Path(scratch) / "Grüne Düne 2"
        self.linux = str(Path(linux).resolve())
        self.environment = dict(os.environ, WINEDEBUG="-all", WINEPREFIX=str(Path(scratch) / "wine"), LC_ALL="C.UTF-8")
        self.environment.pop("TERP_INSTRUCTIONS", None)
        with zipfile.ZipFile(archive) as z:
            z.extractall(self.folder)
        (self.home,) = self.folder.iterdir()
        for name in ("hold_file", "press_ctrl_c"):
            subprocess.run([COMPILER, "-static", "-o", self.home / f"{name}.exe", Path(__file__).parent / f"{name}.c"],
                           check=True)
        self.windows("cmd", "/c", "exit")  # makes its folder, which takes a while

    def windows(self, *words, instructions=None):
        return self.run(["wine", *words], instructions)

    def terp(self, *words, instructions=None):
        return self.windows("terp.exe", *words, instructions=instructions)

    def terp_of_linux(self, *words, instructions=None):
        return self.run([self.linux, *words], instructions)

    def run(self, words, instructions):
        environment = dict(self.environment, **({"TERP_INSTRUCTIONS": instructions} if instructions else {}))
        return subprocess.run([str(w) for w in words], cwd=self.home, env=environment, capture_output=True,
                              stdin=subprocess.DEVNULL, timeout=MOST_SECONDS)


def text(done):
    return (done.stdout + done.stderr).decode("utf-8", "replace")


def expect(condition, what):
    if not condition:
        raise AssertionError(what)


def expect_done(done, status=0):
    expect(done.returncode == status, f"status {done.returncode}, not {status}: {text(done)[-2000:]}")
    return text(done)


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def largest_difference(a, b):
    """Of two tables, relative to the largest number of each column; texts must be equal."""
    expect([len(r) for r in a] == [len(r) for r in b], "the tables have other rows")
    worst = 0.0
    for column in zip(*[zip(x, y) for x, y in zip(a, b)]):
        pairs = []
        for x, y in column:
            try:
                pairs.append((float(x), float(y)))
            except ValueError:
                expect(x == y, f"{x} instead of {y}")
        scale = max((abs(y) for _, y in pairs if math.isfinite(y)), default=0.0)
        for x, y in pairs:
            if math.isfinite(y) and scale > 0.0:
                worst = max(worst, abs(x - y) / scale)
            else:
                expect(math.isfinite(x) == math.isfinite(y) or x == y, f"{x} instead of {y}")
    return worst


def test_needs_no_file_beside_those_of_windows(place):
    dump = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", place.home / "terp.exe"], capture_output=True, text=True,
                          check=True).stdout
    names = re.findall(r"DLL Name: (\S+)", dump)
    expect(names and all(OF_WINDOWS.fullmatch(n) for n in names), f"it needs {names}")
    return ", ".join(names)


def test_says_its_version_and_instructions(place):
    said = expect_done(place.terp("--version"))
    best = expect_done(place.terp_of_linux("--version"))
    expect(said == best, f"{said!r} instead of {best!r}")
    return said.strip()


def test_gives_the_numbers_of_linux(place):
    found = []
    for name in ("avx512", "avx2", "sse2"):
        there = place.terp_of_linux("--version", instructions=name)
        if there.returncode != 0:
            continue  # this processor does not offer it
        ours, theirs = f"runs/windows {name}", f"runs/linux {name}"
        expect_done(place.terp("run", *COLUMN, *SHORT, "-q", "-o", ours, instructions=name))
        expect_done(place.terp_of_linux("run", *COLUMN, *SHORT, "-q", "-o", theirs, instructions=name))
        worst = max(largest_difference(rows(place.home / ours / t), rows(place.home / theirs / t))
                    for t in ("ledger.csv", "history.csv"))
        same = all((place.home / ours / t).read_bytes() == (place.home / theirs / t).read_bytes()
                   for t in ("ledger.csv", "history.csv"))
        expect(worst < 1e-9, f"{name}: tables differ by {worst:.1e}")
        found.append(f"{name}: " + ("the same bytes" if same else f"differ by {worst:.1e}"))
    expect(found, "no instruction set")
    return "; ".join(found)


def test_resumes_to_the_same_bits(place):
    whole = [*COLUMN, "--set", "time.end=0.4", "--set", "output.checkpoint.every=0.1", "-q"]
    expect_done(place.terp("run", *whole, "-o", "runs/whole"))
    expect_done(place.terp("run", *whole, "-o", "runs/cut"))
    steps = sorted((place.home / "runs/cut").glob("checkpoint_*.h5"))
    last = steps[-1].name
    for name in ("summary.json", last):
        (place.home / "runs/cut" / name).unlink()
    expect_done(place.terp("resume", "runs/cut", "-q"))
    for name in ("ledger.csv", "history.csv", last):
        expect((place.home / "runs/whole" / name).read_bytes() == (place.home / "runs/cut" / name).read_bytes(),
               f"{name} differs")
    return f"{len(steps)} checkpoints"


def test_imports_a_section_and_solves_it(place):
    shutil.copy(SAMPLES / "berm-fragility-2023.stix", place.home / "Dijk é 1.stix")
    expect_done(place.terp("import", "Dijk é 1.stix", "--held", "--cell", "6", "-o", "Dijk"))
    run = ["run", "Dijk/case.toml", "-j", "2", "-q"]
    expect_done(place.terp(*run, "-o", "runs/section"))
    expect_done(place.terp_of_linux(*run, "-o", "runs/section linux"))
    worst = largest_difference(rows(place.home / "runs/section/ledger.csv"),
                               rows(place.home / "runs/section linux/ledger.csv"))
    expect(worst < 1e-9, f"the ledgers differ by {worst:.1e}")
    return f"ledger beside Linux: {worst:.1e}"


def test_assesses_a_reach_by_processes_of_its_own(place):
    for name in ("example-2020.03-v1", "empty-2023"):
        shutil.copy(SAMPLES / f"{name}.stix", place.home)
    words = ["assess", "example-2020.03-v1.stix", "empty-2023.stix", "--cell", "6", "-j", "2", "--threads", "1",
             "--trigger", "strength=1.3", "-o", "Reach ö"]
    said = expect_done(place.terp(*words), 3)
    expect("1 of 2 sections have a result" in said, said)
    expect((place.home / "Reach ö/example-2020.03-v1/run/report.html").is_file(), "there is no report of the section")
    expect("kept, solved before" in expect_done(place.terp(*words), 3), "the second time is not kept")
    return said.strip().splitlines()[-1]


def test_writes_the_report_page(place):
    expect_done(place.terp("run", *COLUMN, *SHORT, "-q", "-o", "runs/paged"))
    expect_done(place.terp("report", "runs/paged"))
    page = (place.home / "runs/paged/report.html").read_bytes()
    expect(b"</html>" in page[-200:] and b"\r\n" not in page, "the page is not whole")
    expect_done(place.terp_of_linux("report", "runs/paged", "-o", "of_linux.html"))
    size = (place.home / "of_linux.html").stat().st_size
    expect(abs(len(page) - size) < 100, f"{len(page)} bytes, with Linux {size}")  # the time stands in it
    return f"{len(page)} bytes"


def test_takes_letters_beyond_ascii_and_lines_of_windows(place):
    folder = place.home / "Übung mit Leerzeichen"
    folder.mkdir()
    lines = (place.home / COLUMN[0]).read_text(encoding="utf-8")
    case = folder / "Säule 1.toml"
    case.write_bytes(("\ufeff" + lines).replace("\n", "\r\n").encode("utf-8"))
    words = ["run", "Übung mit Leerzeichen/Säule 1.toml", *COLUMN[1:], *SHORT, "-q"]
    expect_done(place.terp(*words, "-o", "runs/Lauf ß"))
    expect_done(place.terp("run", *COLUMN, *SHORT, "-q", "-o", "runs/plain"))
    for name in ("ledger.csv", "history.csv"):
        expect((place.home / "runs/Lauf ß" / name).read_bytes() == (place.home / "runs/plain" / name).read_bytes(),
               f"{name} differs")
    wrong = place.terp("run", "Übung mit Leerzeichen/Säule 2.toml")
    expect_done(wrong, 2)
    expect("Did you mean" in text(wrong) and "Säule 1.toml" in text(wrong), text(wrong))
    return "Säule 1.toml"


def hold(place, path, seconds):
    sign = place.home / "held"
    sign.unlink(missing_ok=True)
    holder = subprocess.Popen(["wine", "hold_file.exe", path, str(seconds), "held"], cwd=place.home,
                              env=place.environment)
    for _ in range(600):
        if sign.exists():
            return holder
        time.sleep(0.1)
    raise AssertionError("the file could not be held")


def test_waits_for_a_file_that_is_open_for_a_moment_and_names_it_else(place):
    expect_done(place.terp("run", *COLUMN, *SHORT, "-q", "-o", "runs/held"))
    holder = hold(place, "runs/held/summary.json", 600)
    try:
        said = expect_done(place.terp("run", *COLUMN, *SHORT, "-q", "--force", "-o", "runs/held"), 1)
    finally:
        holder.terminate()
        holder.wait()
    expect("summary.json" in said and "another program" in said, said)
    return said.strip().splitlines()[0]


def test_ends_with_a_checkpoint_on_ctrl_c(place):
    line = "terp.exe run " + " ".join([*COLUMN, *LONG, "-q", "-o", "runs/stopped"])
    done = place.windows("press_ctrl_c.exe", "runs/stopped/ledger.csv", line)
    expect(done.returncode == 1, f"status {done.returncode}: {text(done)}")
    expect(list((place.home / "runs/stopped").glob("checkpoint_*.h5")), "there is no checkpoint")
    expect("resume" in text(done), text(done))
    return text(done).strip().splitlines()[-1]


def test_says_that_a_polygon_needs_gmsh(place):
    done = place.terp("check", "cases/verification/direct_shear/unstructured.toml")
    expect(done.returncode != 0 and "gmsh is not installed" in text(done), text(done))
    return text(done).strip().splitlines()[0]


def main():
    archive, linux, *only = sys.argv[1:]
    tests = {name[5:]: test for name, test in globals().items() if name.startswith("test_")}
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        place = Place(scratch, archive, linux)
        for name, test in tests.items():
            if only and not any(word in name for word in only):
                continue
            start = time.monotonic()
            try:
                result, mark = test(place), "ok  "
            except (AssertionError, OSError, subprocess.SubprocessError) as error:
                result, mark = error, "FAIL"
                failed += 1
            print(f"{mark} {name.replace('_', ' ')} ({time.monotonic() - start:.0f} s)\n       {result}", flush=True)
        subprocess.run(["wine", "wineboot", "--kill"], env=place.environment, capture_output=True)
    print(f"{failed} tests failed" if failed else "all tests passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
