#!/usr/bin/env python3
"""Takes each key of a D-Stability file out in turn, and looks at what `terp import` says.

    dropped_keys.py TERP FILE.stix... [--cell H] [--all] [--table]

A key that is dropped must be refused, told (something new is in the list of what was not understood), or harmless: the
list of the file and the cases of all stages that can be made are the same to the letter. Prints what is none of these,
and how many were what; --table prints each key. --all drops a key in all objects of its kind, else in the first.
Exit status 1: a key was lost without a word.
"""
import argparse
import collections
import json
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path


SHOWN = {"ApplicationModified", "ApplicationCreated"}  # the head of the list shows them, or that they are unknown


def members_of(path):
    """Names and JSON trees; None for a member that is no JSON."""
    with zipfile.ZipFile(path) as archive:
        raw = {name.replace("\\", "/"): archive.read(name) for name in archive.namelist()}
    return {name: json.loads(text.decode("utf-8-sig")) if name.endswith(".json") else None
            for name, text in raw.items()}


def objects_of(node, place):
    """(place, object) of all objects in a tree; a place has no numbers: `Layers[].Points[]`."""
    if isinstance(node, dict):
        yield place, node
        for key, value in node.items():
            yield from objects_of(value, f"{place}.{key}")
    elif isinstance(node, list):
        for value in node:
            yield from objects_of(value, place + "[]")


def keys_of(members):
    """(kind and place, key) -> the objects that have it."""
    found = collections.OrderedDict()
    for name, tree in members.items():
        if tree is not None:
            kind = name.split("/")[0].removesuffix(".json")
            for place, thing in objects_of(tree, kind):
                for key in thing:
                    found.setdefault((place, key), []).append(thing)
    return found


def write(members, path):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for name, tree in members.items():
            archive.writestr(name, json.dumps(tree) if tree is not None else "")


def call(terp, *arguments):
    return subprocess.run([terp, "import", *arguments], capture_output=True, text=True)


def cases_of(terp, path, listing, cell):
    """The text of each stage's case and tables, or why it was refused."""
    texts = {}
    for s, scenario in enumerate(json.loads(listing)["scenarios"], 1):
        k = len(scenario["stages"])
        with tempfile.TemporaryDirectory() as folder:
            made = call(terp, path, "--scenario", str(s), "-o", folder, "--force", "--cell", cell)
            files = sorted(Path(folder).iterdir()) if made.returncode == 0 else []
            texts[s, k] = {f.name: f.read_text() for f in files} or made.stderr
    return texts


def verdict_on(terp, path, sound, cell):
    """refused, told, harmless or LOST."""
    listing = call(terp, path, "--json")
    if listing.returncode != 0:
        return "refused" if listing.returncode == 2 else "LOST"
    text = listing.stdout
    known = json.loads(sound[0])["remarks"]
    if any(remark not in known for remark in json.loads(text)["remarks"]):
        return "told"
    if text != sound[0]:
        return "LOST"
    return "harmless" if cases_of(terp, path, text, cell) == sound[1] else "LOST"


def look_at(arguments, source):
    members = members_of(source)
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        path = f"{folder}/{Path(source).name}"
        write(members, path)
        listing = call(arguments.terp, path, "--json").stdout
        sound = listing, cases_of(arguments.terp, path, listing, arguments.cell)
        for (place, key), owners in keys_of(members).items():
            if key in SHOWN:
                continue
            kept = [(owner, owner.pop(key)) for owner in (owners if arguments.all else owners[:1])]
            write(members, path)
            verdict = verdict_on(arguments.terp, path, sound, arguments.cell)
            for owner, value in kept:
                owner[key] = value
            counts[verdict] += 1
            if verdict == "LOST" or arguments.table:
                print(f"{Path(source).stem}  {place}.{key}  {verdict}", flush=True)
    print(f"{Path(source).stem}: " + ", ".join(f"{n} {verdict}" for verdict, n in sorted(counts.items())), flush=True)
    return counts["LOST"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("terp")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--cell", default="4")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--table", action="store_true")
    arguments = parser.parse_args()
    return 1 if sum(look_at(arguments, source) for source in arguments.files) else 0


if __name__ == "__main__":
    sys.exit(main())
