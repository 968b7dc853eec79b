"""The line of progress, and errors that come the same way."""
import pytest

from stickslip import StickslipError, program
from stickslip.progress import Listener


def test_lines_that_are_drawn_over_are_shown_and_words_are_kept():
    shown = []
    listener = Listener(shown.append)
    for piece in ("warning: one\r\n\r\x1b[K 10 %  fits", "\r\x1b[K 20 %  fits\r\x1b", "[Kerror: two\r\nthree\r\n"):
        listener.feed(piece)
    assert listener.end() == "warning: one\nerror: two\nthree\n"
    assert [s for s in shown if s.strip("\r\x1b")][:2] == [" 10 %  fits", " 20 %  fits\r\x1b"] and shown[-1] == ""


def test_a_sweep_shows_how_far_it_is(tmp_path):
    spec = tmp_path / "spec.toml"
    spec.write_text(program.run(["new", "spec"]).stdout)
    shown = []
    done = program.run(["sweep", spec, "-o", tmp_path / "out", "--no-report", "--json"], show=shown.append)
    assert done.stdout.lstrip().startswith("{")
    assert shown == [] or shown[-1] == ""  # quick sweeps draw nothing
    with pytest.raises(StickslipError, match="nosuch.toml"):
        program.run(["sweep", tmp_path / "nosuch.toml", "-o", tmp_path / "out2"], show=shown.append)


def test_without_pseudo_terminals_there_is_an_answer_and_no_progress(tmp_path, monkeypatch):
    def none():
        raise OSError(19, "No such device")

    monkeypatch.setattr(program.os, "openpty", none)
    shown = []
    with pytest.raises(StickslipError, match="nosuch.toml"):
        program.run(["sweep", tmp_path / "nosuch.toml", "-o", tmp_path / "out"], show=shown.append)
    assert shown == []
