"""Dictionaries as TOML text, which Python 3.11 can only read."""

import datetime
import json
import math
import re
from collections.abc import Mapping
from typing import Any

from terp.errors import CaseError


def toml_value(value: Any) -> str:
    """TOML text of one value on one line."""
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) and not math.isfinite(value):
        return "nan" if math.isnan(value) else "inf" if value > 0 else "-inf"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{toml_key(k)} = {toml_value(v)}" for k, v in value.items()) + " }"
    if isinstance(value, (datetime.date, datetime.time)):
        return value.isoformat()
    raise CaseError(f"a {type(value).__name__} cannot stand in a case: {value!r}")


def toml_key(key: object) -> str:
    if not isinstance(key, str):
        raise CaseError(f"a key of a case is a text, not {key!r}")
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else json.dumps(key)


def toml_text(table: Mapping[str, Any], path: str = "") -> str:
    """TOML text of a dictionary, with a header for each table, so that messages name a line that can be found."""
    values, tables = [], []
    for key, value in table.items():
        name = f"{path}.{toml_key(key)}" if path else toml_key(key)
        if isinstance(value, dict) and value:
            tables.append(f"\n[{name}]\n" + toml_text(value, name))
        elif isinstance(value, (list, tuple)) and value and all(isinstance(v, dict) for v in value):
            tables += [f"\n[[{name}]]\n" + toml_text(v, name) for v in value]
        else:
            values.append(f"{toml_key(key)} = {toml_value(value)}\n")
    return "".join(values + tables)
