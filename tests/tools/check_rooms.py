"""tools/check_rooms on small trees: what it refuses, with the text, and what it lets pass.

usage: check_rooms.py REPOSITORY
"""
import subprocess
import sys
import tempfile
from pathlib import Path

tool = Path(sys.argv[1]) / "tools/check_rooms"
MODEL = "struct Model {\n  int n = 0;\n};\n"


def complaints(**texts):
    """Lines that the tool prints for a tree of files, given as room__file=text."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {"base__types": "#pragma once\n", **texts}.items():
            path = Path(folder) / "src" / (name.replace("__", "/") + ".hpp")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        done = subprocess.run([tool, folder], capture_output=True, text=True)
        assert done.stderr == "" and done.returncode == (1 if done.stdout else 0), done
        return done.stdout.splitlines()


assert complaints() == []
assert complaints(parallel__a='#include "base/types.hpp"\n') == []
twice = "there is a `Ring` at {}.hpp:1: one name, one type"
assert complaints(input__a="struct Ring {\n};\n", points__b="using Ring = int;\n") == [
    "src/points/b.hpp:1: " + twice.format("a")]
assert complaints(input__a="using Ring = int;\n", points__b="using Ring = int;\n") == [
    "src/points/b.hpp:1: " + twice.format("a")]
assert complaints(input__a="using Ring = int;\n", points__b="namespace {\nusing Ring = int;\n}  // namespace\n") == []
assert complaints(input__a="using Ring = int;\n", points__b="struct B {\n  using Ring = int;\n};\n") == []
assert complaints(base__a='#include "mesh/b.hpp"\n', mesh__b="") == [
    "src/base/a.hpp:1: base may not include mesh: mesh stands to its right"]

alone = "belongs to files NAME_posix.cpp and NAME_win32.cpp alone"
for header in ("unistd.h", "sys/mman.h", "windows.h"):
    assert complaints(output__a=f"#include <{header}>\n") == [f"src/output/a.hpp:1: <{header}> {alone}"], header

right = "parallel may not include simulation: simulation stands to its right"
for declaration in ("struct Model;", "class Model;", "  struct Model;", "template <int Dim> struct Model;"):
    assert complaints(parallel__a=f"\n{declaration}\n", simulation__model=MODEL) == [
        f"src/parallel/a.hpp:2: declares `Model` of simulation: {right}"], declaration
assert complaints(parallel__a="enum class Pass;\n", simulation__pass="enum class Pass { nodes, stress };\n") == [
    f"src/parallel/a.hpp:1: declares `Pass` of simulation: {right}"]
assert complaints(output__a="struct Model;\n", input__model=MODEL) == [
    "src/output/a.hpp:1: declares `Model` of input: output and input stand side by side: neither includes the other"]
assert complaints(simulation__a="struct Model;\n", simulation__model=MODEL) == []  # of its own room
assert complaints(simulation__a="struct Model;\n", mesh__model=MODEL) == []  # of a room to its left
assert complaints(parallel__a="struct Parser;\n", simulation__model=MODEL) == []  # defined in its own .cpp
