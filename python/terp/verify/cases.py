"""Which verification cases there are: folders with an expected.toml."""

from pathlib import Path

from terp.errors import RunError
from terp.verify.formula import did_you_mean

PLACES = ("cases/verification", "share/terp/cases/verification")


def find_folder():
    """The folder of the cases: in a folder above this package, the nearest one, or in its share/terp."""
    tried = [above / inside for above in Path(__file__).resolve().parents for inside in PLACES]
    for folder in tried:
        if folder.is_dir():
            return folder
    raise RunError("there are no verification cases beside this package. Looked for:\n  " +
                   "\n  ".join(map(str, tried)) + "\n  Say where they are with --cases DIR.")


def choose(folder, wanted):
    """Names of the wanted cases, each once, or of all; NAME* means all that begin with NAME."""
    names = sorted(path.parent.name for path in folder.glob("*/expected.toml"))
    if not names:
        raise RunError(f"{folder}: there are no verification cases: folders with an expected.toml")
    chosen = []
    for word in wanted or ["*"]:
        found = [name for name in names if name == word or (word.endswith("*") and name.startswith(word[:-1]))]
        if not found:
            raise RunError(f"there is no verification case `{word}`.{did_you_mean(word, names)}\n  "
                           f"Cases: {', '.join(names)}")
        chosen += found
    return list(dict.fromkeys(chosen))
