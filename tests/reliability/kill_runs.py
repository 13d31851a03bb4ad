"""Kills `terp run` and `terp resume` with SIGKILL again and again, and compares what comes out with an undisturbed run.

A kill comes after a random time, or, with --library, at a random one of the calls that write, cut, rename or remove a
file of the run (a write is then done by half). After each kill every frame that is there must be that of the reference,
byte by byte, and the frames that the index lists must be there. Then the run is resumed, and killed again in one of
three cases, until it ends; the last time on another number of threads. At the end every file must be that of the
reference, byte by byte, but for the clock in summary.json; and there must be no other file.

usage: kill_runs.py TERP [--kills N] [--seed S] [--library kill_at_call.so] [--keep]
"""
import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

CASE = Path(__file__).with_name("column.toml")
AGAIN = 1 / 3                                        # share of resumed runs that are killed too
# Of summary.json: they differ between equal runs.
CLOCK = {"wall_s", "search_s", "point_steps_per_s", "threads", "passes", "checksum"}


def content_of(path):
    """What of a file must not differ."""
    if path.name == "summary.json":
        return {key: value for key, value in json.loads(path.read_text()).items() if key not in CLOCK}
    return path.read_bytes()


def files_in(folder):
    """{name: path} of all files, those in frames/ included."""
    return {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}


class Fault(Exception):
    pass


class Harness:
    def __init__(self, options, scratch):
        self.terp, self.library, self.scratch = options.terp, options.library, scratch
        self.random = random.Random(options.seed)
        self.kills = self.runs = self.half = self.missed = self.anew = 0
        self.killed_in = {}

    def start(self, words, folder, environment=None):
        return subprocess.Popen([self.terp, *words], env={**os.environ, **(environment or {})}, cwd=self.scratch,
                                stdout=subprocess.DEVNULL, stderr=open(f"{folder}.err", "w"))

    def run_words(self, folder, threads):
        return ["run", str(CASE), "-o", str(folder), "-j", str(threads), "-q", "--force"]

    def make_reference(self):
        folder = self.scratch / "reference"
        count = self.scratch / "count"
        begin = time.monotonic()
        process = self.start(self.run_words(folder, 1), folder, self.preload({"KILL_COUNT": str(count),
                                                                              "KILL_IN": str(folder)}))
        if process.wait() != 0:
            raise Fault("the reference run fails: " + Path(f"{folder}.err").read_text())
        self.duration = time.monotonic() - begin
        self.n_calls = int(count.read_text()) if self.library else 0
        self.reference = {name: content_of(path) for name, path in files_in(folder).items()}
        self.n_frames = sum(name.endswith(".vtkhdf") for name in self.reference)

    def preload(self, variables):
        return {"LD_PRELOAD": self.library, **variables} if self.library else {}

    def run_and_kill(self, words, folder):
        """True if the run was killed, False if it ended before."""
        self.runs += 1
        at_call = self.library and self.random.random() < 0.5
        variables = {"KILL_AT": str(self.random.randint(1, self.n_calls)), "KILL_IN": str(folder)} if at_call else {}
        process = self.start(words, folder, self.preload(variables) if at_call else None)
        if not at_call:
            try:
                process.wait(self.random.uniform(0, 1.05 * self.duration))
            except subprocess.TimeoutExpired:
                process.kill()
        status = process.wait()
        if status == -signal.SIGKILL:
            self.kills += 1
            kind = "at a call" if at_call else "at a time"
            self.killed_in[kind] = self.killed_in.get(kind, 0) + 1
            return True
        if status != 0:
            raise Fault(f"terp {' '.join(words)} ended with {status}: " + Path(f"{folder}.err").read_text())
        self.missed += 1
        return False

    def look_at_results(self, folder):
        """What a reader sees after a kill."""
        for path in folder.glob("frames/*.vtkhdf"):
            if path.read_bytes() != self.reference[f"frames/{path.name}"]:
                raise Fault(f"{path} is not that of the reference")
        for index in folder.glob("*.series"):
            for entry in json.loads(index.read_text())["files"]:
                if not (folder / entry["name"]).exists():
                    raise Fault(f"{index} lists {entry['name']}, which is not there")
        self.half += any(True for _ in folder.rglob("*.tmp"))

    def go_on(self, folder, threads):
        if any(folder.glob("checkpoint_*.h5")):
            return ["resume", str(folder), "-j", str(threads), "-q"]
        self.anew += 1
        return self.run_words(folder, threads)

    def compare(self, folder):
        names = set(files_in(folder))
        if names != set(self.reference):
            raise Fault(f"{folder}: its files differ: {sorted(names ^ set(self.reference))}")
        for name, expected in self.reference.items():
            got = content_of(folder / name)
            if got == expected:
                continue
            parts = [key for key in expected if got.get(key) != expected[key]] if isinstance(expected, dict) else []
            raise Fault(f"{folder / name} differs from the reference {parts}")

    def one_run(self, number):
        folder = self.scratch / f"run_{number}"
        words = self.run_words(folder, self.random.choice([1, 2]))
        while self.run_and_kill(words, folder):
            self.look_at_results(folder)
            words = self.go_on(folder, self.random.choice([1, 2, 3]))
            if self.random.random() > AGAIN:
                process = self.start(words, folder)
                if process.wait() != 0:
                    raise Fault(f"terp {' '.join(words)} fails: " + Path(f"{folder}.err").read_text())
                break
        self.compare(folder)
        shutil.rmtree(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("terp")
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--library", help="kill_at_call.so: also kill at a random call that changes a file")
    parser.add_argument("--keep", action="store_true", help="keep the scratch folder")
    options = parser.parse_args()
    options.terp = os.path.abspath(options.terp)
    options.library = options.library and os.path.abspath(options.library)
    scratch = Path(tempfile.mkdtemp(prefix="terp_kills_"))
    harness = Harness(options, scratch)
    try:
        harness.make_reference()
        number = 0
        while harness.kills < options.kills:
            harness.one_run(number)
            number += 1
    except Fault as fault:
        print(f"fault after {harness.kills} kills, seed {options.seed}: {fault}\n  kept: {scratch}", file=sys.stderr)
        return 1
    kinds = ", ".join(f"{n} {kind}" for kind, n in sorted(harness.killed_in.items()))
    print(f"{harness.kills} kills ({kinds}) of {harness.runs} runs; "
          f"{harness.missed} ended before their kill, {harness.anew} began anew (no checkpoint yet), {harness.half} "
          f"left a half-written file under a temporary name.\n"
          f"All ended in the files of the undisturbed run: {len(harness.reference)} files, {harness.n_frames} VTKHDF, "
          f"{harness.duration:.2f} s, {harness.n_calls} calls that change files.")
    if not options.keep:
        shutil.rmtree(scratch)
    return 0


if __name__ == "__main__":
    sys.exit(main())
