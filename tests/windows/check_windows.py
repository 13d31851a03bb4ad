#!/usr/bin/env python3
"""The program for Windows, from its zip, under Wine, and beside the program for Linux.

It is unpacked into a folder with spaces and letters beyond ASCII, and tried as a dike engineer uses it: the column of
the paper, a section imported from D-Stability, a reach, resume, the report, and what goes wrong: lines that end as on
Windows, a file that another program has open, Ctrl-C, gmsh that is not there. Numbers are those of Linux: the bits on
the same instruction set. Prints one line per test, and exits with 1 if one fails.

usage: check_windows.py ZIP CHECK_SYSTEM LINUX_PROGRAM [TEST...]      CHECK_SYSTEM: check_system.cpp, compiled
"""
import csv
import fcntl
import math
import os
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import termios
import time
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
SAMPLES = ROOT / "tests/import/dstability/samples"
COMPILER = "x86_64-w64-mingw32-gcc-posix"
OF_WINDOWS = re.compile(r"(KERNEL32|ADVAPI32|USER32|SHELL32|WS2_32|msvcrt|SHLWAPI|bcrypt|ole32"
                        r"|api-ms-win-[\w-]+)\.dll", re.I)
COLUMN = ["cases/column_collapse/model_2.toml", "--set", "mesh.cell=0.5", "-j", "2"]
SHORT = ["--set", "time.end=0.2"]
LONG = ["--set", "time.end=60", "--set", "output.checkpoint.every=0.05"]
MOST_SECONDS = 540
NEWLINE = b"\n"
STUDY = """\
case = "column.toml"
seed = 3
[[random]]
key = "material.clay.su_peak"
distribution = "lognormal"
mean = "8 kPa"
cov = 0.4
[estimator]
kind = "monte_carlo"
[stop]
number = 6
[events]
volume = 1.0
displacement = 0.3
"""


class Place:
    """The unpacked program, and a Wine of its own."""

    def __init__(self, scratch, archive, check_system, linux):
        self.folder = Path(scratch) / "Grüne Düne 2"
        self.linux = str(Path(linux).resolve())
        self.environment = dict(os.environ, WINEDEBUG="-all", WINEPREFIX=str(Path(scratch) / "wine"), LC_ALL="C.UTF-8")
        self.environment.pop("TERP_INSTRUCTIONS", None)
        with zipfile.ZipFile(archive) as z:
            z.extractall(self.folder)
        (self.home,) = self.folder.iterdir()
        subprocess.run([COMPILER, "-static", "-o", self.home / "hold_file.exe", Path(__file__).parent / "hold_file.c"],
                       check=True)
        shutil.copy(check_system, self.home / "check_system.exe")
        # What the first program starts stays for a while: it has no pipe of ours, whose end would be waited for.
        nowhere = {"env": self.environment, "stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL,
                   "stderr": subprocess.DEVNULL}
        self.server = shutil.which("wineserver") or "/usr/lib/wine/wineserver64"
        subprocess.run(["wine", "cmd", "/c", "exit"], check=True, **nowhere)  # makes its folder, which takes a while

    def end(self):
        subprocess.run([self.server, "-k"], env=self.environment)

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


def test_asks_windows_for_what_terp_needs(place):
    (place.home / "Für Dateien").mkdir()
    said = expect_done(place.windows("check_system.exe", "Für Dateien"))
    expect("0 failures" in said, said)
    return said.strip().splitlines()[0]


def test_says_its_version_and_instructions(place):
    said = expect_done(place.terp("--version"))
    best = expect_done(place.terp_of_linux("--version"))
    expect(said.splitlines()[0] == best.splitlines()[0], f"{said!r} instead of {best!r}")
    return said.splitlines()[0]


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


def test_solves_a_study_goes_on_and_begins_anew(place):
    folder = place.home / "Stüdie 1"
    folder.mkdir()
    case = (place.home / COLUMN[0]).read_text(encoding="utf-8")
    for long, short in (("end = 4.0", "end = 0.5"), ("cell = 0.1", "cell = 0.5")):
        expect(long in case, f"{COLUMN[0]} has no `{long}`")
        case = case.replace(long, short)
    (folder / "column.toml").write_text(case, encoding="utf-8")
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    words = ["study", "run", "Stüdie 1/study.toml", "-j", "2", "-o"]
    expect_done(place.terp(*words, "runs/studied"))
    expect_done(place.terp_of_linux(*words, "runs/studied linux"))
    table = (place.home / "runs/studied linux/results.csv").read_bytes()
    expect((place.home / "runs/studied/results.csv").read_bytes() == table, "the tables differ")
    said = expect_done(place.terp(*words, "runs/studied"))
    expect("another" not in said and "build" not in said, said)
    expect_done(place.terp(*words, "runs/studied", "--force"))
    expect((place.home / "runs/studied/results.csv").read_bytes() == table, "the tables differ after --force")
    return f"{table.count(NEWLINE) - 1} realisations, the bytes of Linux"


def test_calls_a_law_of_the_user(place):
    folder = place.home / "cases/user_law"
    header = ["-O2", "-ffp-contract=off", "-shared", folder / "elastic.c", "-o"]  # terp_law.h lies beside it
    subprocess.run([COMPILER, *header, folder / "elastic.dll"], check=True)
    subprocess.run(["gcc", "-fPIC", *header, folder / "elastic.so"], check=True)
    lines = (folder / "column.toml").read_text(encoding="utf-8").splitlines()
    lines = [line for line in lines if not line.startswith(("library ", "interface", "parameters", "state", "thread"))]
    k = next(k for k, line in enumerate(lines) if line.startswith("model "))
    for ending in ("dll", "so"):
        law = [f'library = "elastic.{ending}"', 'interface = "native"',
               "parameters = { stiffness = 2.0e6, poisson = 0.48 }"]
        (folder / f"{ending}.toml").write_text("\n".join(lines[:k + 1] + law + lines[k + 1:]), encoding="utf-8")
    options = ["--set", "time.end=0.3", "-q", "-o"]
    expect_done(place.terp("run", "cases/user_law/dll.toml", *options, "runs/dll"))
    expect_done(place.terp_of_linux("run", "cases/user_law/so.toml", *options, "runs/so"))
    worst = largest_difference(rows(place.home / "runs/dll/ledger.csv"), rows(place.home / "runs/so/ledger.csv"))
    expect(worst < 1e-9, f"the ledgers differ by {worst:.1e}")
    return f"ledger beside Linux: {worst:.1e}"


def test_says_why_a_law_cannot_be_opened(place):
    folder = place.home / "cases/user_law"
    (folder / "other.c").write_text("__declspec(dllexport) void other(void) {}\n")
    (folder / "needs.c").write_text("void other(void);\n__declspec(dllexport) void umat_(void) { other(); }\n")
    subprocess.run([COMPILER, "-shared", "other.c", "-o", "other.dll"], cwd=folder, check=True)
    subprocess.run([COMPILER, "-shared", "needs.c", "other.dll", "-o", "needs.dll"], cwd=folder, check=True)
    (folder / "other.dll").unlink()
    shutil.copy(folder / "needs.c", folder / "text.dll")
    for name, why in (("needs.dll", "Another library that it needs was not found"),
                      ("text.dll", "This is no library for 64-bit Windows")):
        case = (folder / "one_cell.toml").read_text(encoding="utf-8").replace("tresca.so", name)
        (folder / "opened.toml").write_text(case, encoding="utf-8")
        said = expect_done(place.terp("check", "cases/user_law/opened.toml"), 2)
        expect(why in said and "-shared -static" in said, said)
    return "error 126 and 193, in words"


def test_writes_the_report_page(place):
    expect_done(place.terp("run", *COLUMN, *SHORT, "-q", "-o", "runs/paged"))
    expect_done(place.terp("report", "runs/paged"))
    page = (place.home / "report.html").read_bytes()
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


def test_takes_a_table_by_its_drive(place):
    shutil.copytree(place.home / "cases/verification/water_at_rest", place.home / "Mit Laufwerk")
    case = place.home / "Mit Laufwerk/grid.toml"
    table = (place.home / "Mit Laufwerk/pressure.csv").rename(place.home / "Drücke 1.csv")
    drive = "Z:" + str(table)  # where Wine has the files of this system
    case.write_text(case.read_text(encoding="utf-8").replace('"pressure.csv"', f"'{drive}'"), encoding="utf-8")
    expect_done(place.terp("check", "Mit Laufwerk/grid.toml"))
    backward = drive.replace("/", "\\")
    case.write_text(case.read_text(encoding="utf-8").replace(drive, backward), encoding="utf-8")
    expect_done(place.terp("check", "Mit Laufwerk/grid.toml"))
    return backward


def test_takes_all_files_of_a_pattern(place):
    for name in ("Übung 1", "Übung 2"):
        shutil.copy(SAMPLES / "empty-2023.stix", place.home / f"{name}.stix")
    said = text(place.terp("assess", "Übung*.stix", "--estimate", "-o", "Pattern"))
    expect("Übung 1" in said and "Übung 2" in said, said)
    return "Übung*.stix"


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


def press_ctrl_c(place, words, sign):
    """Runs a program in a console, which Wine makes of a terminal, and presses Ctrl-C once the file `sign` is there.
    Its status, and what it said without the movements of the cursor."""
    ours, theirs = pty.openpty()
    console = subprocess.Popen(["wine", *words], cwd=place.home, env=dict(place.environment, TERM="xterm"),
                               stdin=theirs, stdout=theirs, stderr=theirs, start_new_session=True,
                               preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
    os.close(theirs)
    said, pressed, end = b"", False, time.monotonic() + 120.0
    while console.poll() is None and time.monotonic() < end:
        if select.select([ours], [], [], 0.2)[0]:
            try:
                said += os.read(ours, 65536)
            except OSError:  # the other end is closed
                break
        if not pressed and sign.exists():
            os.write(ours, b"\x03")
            pressed = True
    expect(pressed, f"{sign.name} did not come: {said[-1000:]}")
    os.close(ours)
    status = console.wait(60)
    return status, re.sub(r"\x1b\[[?\d;]*[A-Za-z]", "", said.decode("utf-8", "replace"))


def test_ends_with_a_checkpoint_on_ctrl_c(place):
    status, said = press_ctrl_c(place, ["terp.exe", "run", *COLUMN, *LONG, "-o", "runs/stopped"],
                                place.home / "runs/stopped/ledger.csv")
    expect(status == 1 and "a checkpoint is written" in said, f"status {status}: {said[-1000:]}")
    expect(list((place.home / "runs/stopped").glob("checkpoint_*.h5")), "there is no checkpoint")
    return next(line.strip() for line in said.splitlines() if "a checkpoint is written" in line)


def test_says_that_a_polygon_needs_gmsh(place):
    done = place.terp("check", "cases/verification/direct_shear/unstructured.toml")
    expect(done.returncode != 0 and "gmsh is not installed" in text(done), text(done))
    return text(done).strip().splitlines()[0]


def main():
    archive, check_system, linux, *only = sys.argv[1:]
    tests = {name[5:]: test for name, test in globals().items() if name.startswith("test_")}
    failed = 0
    with tempfile.TemporaryDirectory() as scratch:
        place = Place(scratch, archive, check_system, linux)
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
        place.end()
    print(f"{failed} tests failed" if failed else "all tests passed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
