"""Kills `terp run` and `terp resume` with SIGKILL again and again, and compares the files with an undisturbed run.

A kill comes after a random time, or, with --library, at a random one of the calls that write, cut, rename or remove a
file of the run (a write is then half done). After each kill results.vtkhdf is opened as ParaView would, and must
contain whole frames, equal to those of the reference. Then the run is resumed, and killed again in one of three cases,
until it ends; the last time on another number of threads. At the end every file must be that of the reference: tables
and case to the bit, results.vtkhdf and checkpoints array by array to the bit, summary.json but for the clock; and there
must be no other file.

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

import h5py

CASE = Path(__file__).with_name("column.toml")
AGAIN = 1 / 3                                        # share of resumed runs that are killed too
CLOCK = {"wall_s", "point_steps_per_s", "threads", "passes"}   # of summary.json: they differ between equal runs
FRAMES = "VTKHDF/Steps"


def arrays_of(path, skip=()):
    """Every dataset and attribute of an HDF5 file, as bytes."""
    found = {}

    def add(name, thing):
        for key, value in thing.attrs.items():
            found[f"{name}@{key}"] = bytes(memoryview(value)) if hasattr(value, "dtype") else repr(value)
        if isinstance(thing, h5py.Dataset) and name not in skip:
            found[name] = (str(thing.dtype), thing.shape, thing[()].tobytes())

    with h5py.File(path, "r") as file:
        add("/", file)
        file.visititems(add)
    return found


def content_of(path):
    """What of a file must not differ."""
    if path.suffix == ".vtkhdf":
        return arrays_of(path)
    if path.suffix == ".h5":
        found = arrays_of(path, skip=("arrays/wall_s",))
        found.pop("/@checksum", None)  # covers wall_s
        return found
    if path.name == "summary.json":
        return {key: value for key, value in json.loads(path.read_text()).items() if key not in CLOCK}
    return path.read_bytes()


def frames_of(path):
    """The frames that a reader sees: a list of {name: bytes}."""
    frames = []
    with h5py.File(path, "r") as file:
        steps, root = file[FRAMES], file["VTKHDF"]
        n = int(root["NumberOfPoints"][0])
        for k in range(int(steps.attrs["NSteps"])):
            frame = {"time": steps["Values"][k].tobytes(), "step": int(steps["step"][k])}
            first = int(steps["PointOffsets"][k, 0] if steps["PointOffsets"].ndim == 2 else steps["PointOffsets"][k])
            frame["Points"] = root["Points"][first:first + n].tobytes()
            for name, table in root["PointData"].items():
                first = int(steps["PointDataOffsets"][name][k])
                frame[name] = table[first:first + n].tobytes()
            frames.append(frame)
    return frames


class Fault(Exception):
    pass


class Harness:
    def __init__(self, options, scratch):
        self.terp, self.library, self.scratch = options.terp, options.library, scratch
        self.random = random.Random(options.seed)
        self.kills = self.runs = self.commits = self.missed = self.anew = 0
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
        process = self.start(self.run_words(folder, 1), folder,
                             self.preload({"KILL_COUNT": str(count), "KILL_IN": str(folder)}))
        if process.wait() != 0:
            raise Fault("the reference run fails: " + Path(f"{folder}.err").read_text())
        self.duration = time.monotonic() - begin
        self.n_calls = int(count.read_text()) if self.library else 0
        self.reference = {path.name: content_of(path) for path in folder.iterdir()}
        self.frames = frames_of(folder / "results.vtkhdf")

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
        path, journal = folder / "results.vtkhdf", folder / "results.vtkhdf.journal"
        if journal.exists():  # terp died while it changed the file; terp resume ends the change
            self.commits += 1
            return
        if not path.exists():
            return
        frames = frames_of(path)
        if frames != self.frames[:len(frames)]:
            raise Fault(f"{path}: its {len(frames)} frames are not those of the reference")

    def go_on(self, folder, threads):
        if any(folder.glob("checkpoint_*.h5")):
            return ["resume", str(folder), "-j", str(threads), "-q"]
        self.anew += 1
        return self.run_words(folder, threads)

    def compare(self, folder):
        names = {path.name for path in folder.iterdir()}
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
    print(f"{harness.kills} kills ({', '.join(f'{n} {kind}' for kind, n in sorted(harness.killed_in.items()))}) of "
          f"{harness.runs} runs; {harness.missed} ended before their kill, {harness.anew} began anew "
          f"(no checkpoint yet), {harness.commits} were killed while results.vtkhdf changed.\n"
          f"All ended in the files of the undisturbed run: {len(harness.reference)} files, "
          f"{len(harness.frames)} frames, {harness.duration:.2f} s, {harness.n_calls} calls that change files.")
    if not options.keep:
        shutil.rmtree(scratch)
    return 0


if __name__ == "__main__":
    sys.exit(main())
