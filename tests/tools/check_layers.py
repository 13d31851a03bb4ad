"""tools/check_layers on small trees: what it refuses, with the text, and what it lets pass.

usage: check_layers.py REPOSITORY
"""
import subprocess
import sys
import tempfile
from pathlib import Path

tool = Path(sys.argv[1]) / "tools/check_layers"
MODEL = "struct Model {\n  int n = 0;\n};\n"


def complaints(**texts):
    """Lines that the tool prints for a tree of files, given as room__file=text."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {"math__types": "#pragma once\n", **texts}.items():
            path = Path(folder) / "src" / (name.replace("__", "/") + ".hpp")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        done = subprocess.run([tool, folder], capture_output=True, text=True)
        assert done.stderr == "" and done.returncode == (1 if done.stdout else 0), done
        return done.stdout.splitlines()


assert complaints() == []
assert complaints(os__a='#include "math/types.hpp"\n') == []
twice = "there is a `Ring` at {}.hpp:1: one name, one type"
assert complaints(io__a="struct Ring {\n};\n", mpm__b="using Ring = int;\n") == [
    "src/mpm/b.hpp:1: " + twice.format("a")]
assert complaints(io__a="using Ring = int;\n", mpm__b="using Ring = int;\n") == [
    "src/mpm/b.hpp:1: " + twice.format("a")]
assert complaints(io__a="using Ring = int;\n", mpm__b="namespace {\nusing Ring = int;\n}  // namespace\n") == []
assert complaints(io__a="using Ring = int;\n", mpm__b="struct B {\n  using Ring = int;\n};\n") == []
assert complaints(math__a='#include "mpm/b.hpp"\n', mpm__b="") == [
    "src/math/a.hpp:1: math may not include mpm: mpm stands to its right"]

alone = "belongs to files NAME_posix.cpp and NAME_win32.cpp alone"
for header in ("unistd.h", "sys/mman.h", "windows.h"):
    assert complaints(run__a=f"#include <{header}>\n") == [f"src/run/a.hpp:1: <{header}> {alone}"], header

for header in ("sys/socket.h", "winsock2.h"):
    assert complaints(os__a_posix=f"#include <{header}>\n") == [
        f"src/os/a_posix.hpp:1: <{header}>: Terp opens no connection (decision 0078)"], header

right = "os may not include model: model stands to its right"
for declaration in ("struct Model;", "class Model;", "  struct Model;", "template <int Dim> struct Model;"):
    assert complaints(os__a=f"\n{declaration}\n", model__model=MODEL) == [
        f"src/os/a.hpp:2: declares `Model` of model: {right}"], declaration
assert complaints(os__a="enum class Pass;\n", model__pass="enum class Pass { nodes, stress };\n") == [
    f"src/os/a.hpp:1: declares `Pass` of model: {right}"]
assert complaints(page__a="struct Model;\n", import__model=MODEL) == [
    "src/page/a.hpp:1: declares `Model` of import: page and import stand side by side: neither includes the other"]
assert complaints(model__a="struct Model;\n", model__model=MODEL) == []  # of its own layer
assert complaints(model__a="struct Model;\n", mpm__model=MODEL) == []  # of a layer to its left
assert complaints(os__a="struct Parser;\n", model__model=MODEL) == []  # defined in its own .cpp
