"""TOML from nested dicts: enough for joints and specs."""
from __future__ import annotations

import math
import re
from typing import Any, Mapping

_BARE = re.compile(r"[A-Za-z0-9_-]+\Z")


def _key(name: str) -> str:
    return name if _BARE.match(name) else _text(name)


def _text(value: str) -> str:
    escaped = value.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(c if c >= " " and c != "\x7f" else f"\\u{ord(c):04x}" for c in escaped) + '"'


def _value(value: Any, path: str) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(k)} = {_value(v, path)}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple)) or type(value).__name__ == "ndarray":
        return "[" + ", ".join(_value(v, path) for v in value) + "]"
    if isinstance(value, int):
        return str(value)
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{path}: got {type(value).__name__}, expected a number, text, true or false, a list or a dict") from None
    if math.isinf(number):
        return "inf" if number > 0 else "-inf"
    return repr(number)


def dumps(table: Mapping[str, Any], path: str = "") -> str:
    """Plain values of a table first, then the tables in it: TOML has no way back out of a table."""
    lines, tables = [], []
    for key, value in table.items():
        name = f"{path}.{_key(key)}" if path else _key(key)
        if isinstance(value, Mapping):
            tables.append(f"\n[{name}]\n" + dumps(value, name))
        elif isinstance(value, list) and value and all(isinstance(v, Mapping) for v in value):
            tables += [f"\n[[{name}]]\n" + dumps(v, name) for v in value]
        else:
            lines.append(f"{_key(key)} = {_value(value, name)}\n")
    return "".join(lines + tables)
