"""Progress of a call that takes its time: a line that is drawn over, in a notebook or on a terminal.

The program draws its line for terminals alone; so it is given one, a pseudo-terminal, and what it draws is passed on.
"""
from __future__ import annotations

import os
import re
import sys
from typing import Callable, Optional

Show = Callable[[str], None]

_REDRAWN = re.compile(r"\r\x1b\[K")


def _in_notebook() -> bool:
    if "IPython" not in sys.modules:
        return False
    shell = sys.modules["IPython"].get_ipython()
    return shell is not None and hasattr(shell, "kernel")


def default() -> Optional[Show]:
    """Where progress is shown: below a cell of a notebook, on a terminal, or nowhere."""
    if os.name != "posix":
        return None
    if _in_notebook():
        return _notebook_line()
    return _terminal_line if sys.stderr is not None and sys.stderr.isatty() else None


def _terminal_line(text: str) -> None:
    sys.stderr.write("\r\x1b[K" + text)
    sys.stderr.flush()


def _notebook_line() -> Show:
    from IPython.display import display

    handle = None

    def show(text: str) -> None:
        nonlocal handle
        line = {"text/plain": text}
        if handle is None and text:
            handle = display(line, raw=True, display_id=True)
        elif handle is not None:
            handle.update(line, raw=True)

    return show


class Listener:
    """Takes what the program writes on its terminal apart: lines that are drawn over, and words that stay."""

    def __init__(self, show: Show):
        self._show, self._pending, self._drawn = show, "", False
        self._kept: list[str] = []

    def feed(self, text: str) -> None:
        parts = _REDRAWN.split(self._pending + text.replace("\r\n", "\n"))
        self._pending = parts.pop()
        for part in parts:
            self._take(part, drawn_over=True)
        # what was drawn last is shown at once; whether it stays is known when more comes, or at the end
        if self._pending and "\n" not in self._pending:
            self._draw(self._pending)

    def end(self) -> str:
        """Ends the line; gives back the words that stay."""
        self._take(self._pending, drawn_over=False)
        self._pending = ""
        if self._drawn:
            self._show("")
        return "".join(self._kept)

    def _take(self, part: str, drawn_over: bool) -> None:
        if "\n" in part or not drawn_over:
            self._kept.append(part)

    def _draw(self, text: str) -> None:
        self._drawn = True
        self._show(text)


def read_all(terminal: int, listener: Listener) -> None:
    """Feeds the listener until the program has closed its end."""
    import codecs

    decoder = codecs.getincrementaldecoder("utf-8")("replace")
    while True:
        try:
            data = os.read(terminal, 4096)
        except OSError:  # Linux says so at the end of a pseudo-terminal
            break
        if not data:
            break
        listener.feed(decoder.decode(data))
    os.close(terminal)
