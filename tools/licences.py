#!/usr/bin/python3
"""Licences of what is in a program that is handed on, each with its version, as Debian and npm have them.

    tools/licences.py LIBRARIES EMSCRIPTEN     prints those of the page of a browser

LIBRARIES: made by tools/build_browser_libraries or tools/build_windows_libraries, from sources whose SHA-256 is given.
"""
import gzip
import json
import re
import subprocess
import sys
from pathlib import Path

from documents import root

DOC = Path("/usr/share/doc")
HEADERS = {"Eigen": "libeigen3-dev", "Boost": "libboost1.74-dev", "JSON": "nlohmann-json3-dev", "CLI11": "libcli11-dev",
           "toml++": "libtomlplusplus-dev"}


def built(libraries: Path) -> dict[str, str]:
    """What was built from Debian's sources."""
    texts = {}
    for file in sorted(libraries.glob("source/*.dsc")):
        said = file.read_text()
        name, version = (re.search(rf"^{key}: (.*)", said, re.M)[1] for key in ("Source", "Version"))
        source = re.search(r"^Checksums-Sha256:\n (\w+) \d+ \S*orig\S*$", said, re.M)[1]
        folder = next(libraries.glob(f"source/{name}-*/debian/copyright"))
        texts[f"{name} {version} (source SHA-256 {source})"] = folder.read_text(encoding="utf-8")
    return texts


def installed(packages: dict[str, str]) -> dict[str, str]:
    """What is in the program from packages of this system. Boost lists its files on 2 MB: its licence is one text."""
    texts = {}
    for name, package in packages.items():
        file = DOC / package / "copyright"
        if not file.is_file():
            raise SystemExit(f"{file} is missing: tools/install-dependencies installs {package}")
        text = file.read_text(encoding="utf-8", errors="replace")
        if name == "Boost":
            text = re.search(r"^License: BSL-1\.0\n (.*?)(?=\n\S|\Z)", text, re.M | re.S)[0]
        version = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True,
                                 check=True).stdout
        texts[f"{name} {version}"] = text
    return texts


def of_the_page() -> dict[str, str]:
    """Packages of npm that are in the report page."""
    texts = {}
    for place, package in json.loads((root / "web/package-lock.json").read_text())["packages"].items():
        if place and not package.get("dev"):
            text = next((root / "web" / place).glob("LICEN[SC]E*")).read_text(encoding="utf-8")
            texts[f"{place.removeprefix('node_modules/')} {package['version']} ({package['integrity']})"] = text
    return texts


def emscripten(folder: Path) -> dict[str, str]:
    """The compiler's own libraries: musl, libc++, compiler-rt. Its tests and tools are not in the page."""
    doc = folder / "debian/usr/share/doc/emscripten"
    version = re.search(r"\((.*?)\)", gzip.decompress((doc / "changelog.Debian.gz").read_bytes()).decode())[1]
    parts = (doc / "copyright").read_text(encoding="utf-8").split("\n\n")
    files = [part for part in parts if part.startswith("Files:")
             and re.search(r"^(Files:)? (\*$|system/lib/|src/)", part.split("Copyright:")[0], re.M)]
    named = " ".join(re.findall(r"^License: (.*)", "\n".join(files), re.M)).split()
    texts = [part for part in parts if re.match(r"License: (\S+)", part) and part.split()[1] in named]
    return {f"emscripten {version}": "\n\n".join(files + texts)}


def together(texts: dict[str, str]) -> str:
    head = "Terp\n====\n\n" + (root / "LICENSE").read_text(encoding="utf-8")
    return head + "".join(f"\n\n{name}\n{'=' * len(name)}\n\n{text}" for name, text in texts.items())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit("usage: tools/licences.py LIBRARIES EMSCRIPTEN")
    print(together(built(Path(sys.argv[1])) | installed(HEADERS) | of_the_page() | emscripten(Path(sys.argv[2]))))
