"""What the check of links and the site share: the files of the repository, and the anchors of headings."""
import re
import subprocess
from pathlib import Path

root = Path(__file__).resolve().parent.parent


def listed(*patterns: str) -> list[Path]:
    out = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *patterns],
                         cwd=root, capture_output=True, text=True, check=True).stdout
    return [root / line for line in out.splitlines() if (root / line).is_file()]


def anchor(heading: str) -> str:
    """As web forges make it: lower case, letters, digits, hyphens; a hyphen for each space."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.lstrip("#").strip().lower())
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
