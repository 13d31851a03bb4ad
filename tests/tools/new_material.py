"""tools/new_material in a copy of the files that it touches: its files compile, and what it refuses stays as it was.

usage: new_material.py REPOSITORY COMPILER
"""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

repository, compiler = Path(sys.argv[1]), sys.argv[2]


def make(root, name):
    return subprocess.run([repository / "tools/new_material", name, root], capture_output=True, text=True)


with tempfile.TemporaryDirectory() as folder:
    root = Path(folder)
    for name in ("src/soil/laws/materials.def", "docs/methods.md"):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(repository / name, root / name)
    (root / "tests/soil/laws").mkdir(parents=True)

    made = make(root, "soft_clay")
    assert made.returncode == 0, made.stderr
    assert (root / "src/soil/laws/materials.def").read_text().endswith("TERP_MATERIAL(soft_clay)\n")
    assert "### soft_clay\n" in (root / "docs/methods.md").read_text().split("## 5. Energy ledger")[0]
    for file in ("src/soil/laws/soft_clay.cpp", "tests/soil/laws/soft_clay_test.cpp"):
        subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", f"-I{repository}/src",
                        f"-I{repository}/tests",
                        root / file], check=True)

    before = (root / "src/soil/laws/materials.def").read_text()
    again, wrong = make(root, "soft_clay"), make(root, "Soft-Clay")
    assert again.returncode == 1 and "there is a law `soft_clay` already" in again.stderr, again.stderr
    assert wrong.returncode == 1 and "`Soft-Clay` is not a name for a law" in wrong.stderr, wrong.stderr
    assert (root / "src/soil/laws/materials.def").read_text() == before
