"""Answers of the program: dicts that show themselves in a notebook."""
from __future__ import annotations

from html import escape
from typing import Any, Iterator


class Answer(dict):
    """The program's JSON. Keys are those of the documented formats; `answer.at("nonlinear.outcome")` follows a path."""

    def at(self, path: str) -> Any:
        """The value at a dotted path; list elements by their index: "effects.0.names"."""
        value: Any = self
        for part in path.split("."):
            try:
                value = value[int(part)] if isinstance(value, list) else value[part]
            except (KeyError, IndexError, ValueError, TypeError):
                known = ", ".join(value) if isinstance(value, dict) else f"{len(value)} elements" if isinstance(value, list) else "nothing"
                raise KeyError(f"{path}: there is no {part!r}; here are {known}") from None
        return value

    def leaves(self) -> Iterator[tuple[str, Any]]:
        """Every number and word with its path; long lists stay whole."""
        yield from _leaves(self, "")

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td style='text-align:left'>{escape(path)}</td><td style='text-align:left'>{escape(_short(value))}</td></tr>"
                       for path, value in self.leaves())
        return f"<table>{rows}</table>"


def _leaves(value: Any, path: str) -> Iterator[tuple[str, Any]]:
    if isinstance(value, dict) and value:
        for key, inner in value.items():
            yield from _leaves(inner, f"{path}.{key}" if path else str(key))
    elif isinstance(value, list) and value and len(value) <= 8 and any(isinstance(v, dict) for v in value):
        for i, inner in enumerate(value):
            yield from _leaves(inner, f"{path}.{i}")
    else:
        yield path, value


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        shown = ", ".join(_short(v) for v in value[:6])
        return shown + (f" … ({len(value)} in all)" if len(value) > 6 else "")
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k}: {_short(v)}" for k, v in list(value.items())[:4]) + ("…}" if len(value) > 4 else "}")
    return "–" if value is None else str(value)
