#!/usr/bin/env python3
"""One study on threads, on the ranks of a real mpirun and srun, and as an array of a real Slurm, with processes killed
at random moments: whatever was killed, it must end in the table of one thread, to the bit.

usage: tests/cluster/kill_studies.py TERP [--kills N] [--seed N]
needs tools/install-dependencies --cluster, and root
"""
import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[1] / "python")]
from samples import COLUMN  # noqa: E402
from slurm import Slurm  # noqa: E402

N_REALISATIONS = 3000
N_RANKS = 4
N_TASKS = 6
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
number = {number}
[events]
volume = 1.0
displacement = 0.3
"""


def children_of(pid):
    """Process identifiers of what a process has started."""
    try:
        found = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
        return [int(child) for child in found]
    except FileNotFoundError:
        return []


def kill(pid):
    """True: it was there."""
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        return False
    return True


def processes_with(pattern):
    """Process identifiers whose command line has it."""
    found = subprocess.run(["pgrep", "-f", pattern], capture_output=True, text=True).stdout.split()
    return [int(pid) for pid in found]


class Trial:
    def __init__(self, terp, folder, chance, n_kills):
        self.terp, self.folder, self.chance, self.n_kills = terp, Path(folder), chance, n_kills
        self.n_done = {}
        (self.folder / "column.toml").write_text(COLUMN.replace("end = 0.4", "end = 3.0"))
        (self.folder / "study.toml").write_text(STUDY.format(number=N_REALISATIONS))
        self.run("-j", "1", "-o", "one")
        self.table = self.table_in("one")

    def words(self, *more):
        return [self.terp, "study", "run", "study.toml", "-q", *more]

    def start(self, *words):
        return subprocess.Popen(words, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def run(self, *more):
        subprocess.run(self.words(*more), cwd=self.folder, check=True)

    def table_in(self, name):
        return (self.folder / name / "results.csv").read_bytes()

    def solved_in(self, name):
        files = (self.folder / name).glob("part_*.rows")
        return sum(max(0, file.read_bytes().count(b"\n") - 1) for file in files)

    def count(self, what, was_there):
        self.n_done[what] = self.n_done.get(what, 0) + was_there

    def number_of(self, *kinds):
        return sum(self.n_done.get(kind, 0) for kind in kinds)

    def check(self, name):
        if self.table_in(name) != self.table:
            sys.exit(f"{self.folder}/{name}/results.csv is not that of one thread")

    def round_until(self, name, number, one_round, last_round):
        """Rounds on a study, and on the next one where it is complete, until `number` says that there are enough."""
        wanted = number() + self.n_kills
        study = 0
        while number() < wanted:
            one_round(f"{name}_{study}")
            if self.solved_in(f"{name}_{study}") >= N_REALISATIONS:
                study += 1
        for k in range(study + 1):
            last_round(f"{name}_{k}")
            self.check(f"{name}_{k}")

    # Threads: the whole process.
    def kill_threads(self, name):
        process = self.start(*self.words("-o", name, "-j", str(self.chance.randint(1, 4))))
        time.sleep(self.chance.uniform(0.1, 1.0))
        self.count("threads", process.poll() is None and kill(process.pid))
        process.wait()

    # Ranks, with --enable-recovery and without; mpirun itself, and then the ranks that it leaves behind.
    def mpirun(self, name, *words):
        return ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(N_RANKS), *words,
                *self.words("-o", name)]

    def kill_ranks(self, name):
        process = self.start(*self.mpirun(name, *self.chance.choice([[], ["--enable-recovery"]])))
        while process.poll() is None and len(children_of(process.pid)) < N_RANKS:
            time.sleep(0.1)
        for _ in range(self.chance.randint(1, 3)):
            time.sleep(self.chance.uniform(0.2, 1.0))
            ranks = children_of(process.pid)
            if process.poll() is not None or not ranks:
                break
            what = self.chance.choices(["rank", "mpirun"], [4, 1])[0]
            self.count(what, kill(self.chance.choice(ranks) if what == "rank" else process.pid))
        process.wait()
        for pid in processes_with(f"^{self.terp} study run study.toml -q -o {name}$"):
            self.count("rank left behind", kill(pid))

    def end_ranks(self, name):
        subprocess.run(self.mpirun(name), cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    # Tasks of an array: killed, or put back into the queue by the batch system.
    def submit(self, slurm, name):
        task = " ".join(self.words("-j", "1", "-o", name))
        slurm.call("sbatch", f"--array=5-{4 + 2 * N_TASKS}:2", "--output=/dev/null", "--requeue", "--wrap",
                   f"exec {task}", folder=self.folder)

    def kill_tasks(self, slurm, name):
        self.submit(slurm, name)
        for _ in range(4):
            time.sleep(self.chance.uniform(0.3, 1.0))
            if self.chance.random() < 0.5:
                running = slurm.call("squeue", "-h", "-r", "-t", "R", "-o", "%i").split()
                if running:
                    done = subprocess.run(["scontrol", "requeue", self.chance.choice(running)], env=slurm.environment,
                                          capture_output=True)
                    self.count("task put back", done.returncode == 0)
                continue
            found = processes_with(f"^{self.terp} study run study.toml -q -j 1 -o {name}$")
            self.count("task", bool(found) and kill(self.chance.choice(found)))
        slurm.wait_for(lambda: not slurm.jobs(), "an end of the array", 300)

    def end_tasks(self, slurm, name):
        self.submit(slurm, name)
        slurm.wait_for(lambda: not slurm.jobs(), "an end of the array", 300)

    def kill_steps(self, slurm):
        """Ranks of srun: one is killed in each job, unless it ends first; then the same command once more."""
        name = "srun"
        words = ["srun", "-n", str(N_RANKS), *self.words("-o", name)]
        while self.number_of("rank of srun") < 3:
            process = subprocess.Popen(words, cwd=self.folder, env=slurm.environment, stderr=subprocess.DEVNULL)
            own = f"^{self.terp} study run study.toml -q -o {name}$"
            slurm.wait_for(lambda: process.poll() is not None or processes_with(own), "a rank of srun", 120)
            time.sleep(self.chance.uniform(0.0, 0.3))
            ranks = processes_with(own)
            self.count("rank of srun", bool(ranks) and kill(self.chance.choice(ranks)))
            process.wait()
            subprocess.run(words, cwd=self.folder, env=slurm.environment, check=True)
            self.check(name)
            shutil.rmtree(self.folder / name)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("terp", type=lambda path: str(Path(path).resolve()))
    parser.add_argument("--kills", type=int, default=16, help="of each: threads, ranks, tasks")
    parser.add_argument("--seed", type=int, default=random.randrange(10**6))
    options = parser.parse_args()
    missing = [name for name in ("mpirun", "sbatch", "srun") if shutil.which(name) is None]
    if missing or os.getuid() != 0:
        sys.exit(f"needs root, and tools/install-dependencies --cluster; missing: {', '.join(missing) or 'root'}")
    print(f"seed {options.seed}")
    with tempfile.TemporaryDirectory(prefix="terp_cluster_") as folder:
        trial = Trial(options.terp, folder, random.Random(options.seed), options.kills)
        trial.round_until("threads", lambda: trial.number_of("threads"), trial.kill_threads,
                          lambda name: trial.run("-o", name))
        print(f"threads: {trial.n_done}", flush=True)
        trial.round_until("ranks", lambda: trial.number_of("rank", "mpirun"), trial.kill_ranks, trial.end_ranks)
        print(f"ranks of mpirun: {trial.n_done}", flush=True)
        with Slurm(Path(folder) / "slurm") as slurm:
            trial.kill_steps(slurm)
            trial.round_until("tasks", lambda: trial.number_of("task", "task put back"),
                              lambda name: trial.kill_tasks(slurm, name),
                              lambda name: trial.end_tasks(slurm, name))
        print(f"in all {sum(trial.n_done.values())} kills: {trial.n_done}\nevery table has the bits of one thread")


if __name__ == "__main__":
    main()
