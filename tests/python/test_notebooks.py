"""The notebooks of docs/notebooks run from top to bottom, and what they show at the end of a cell can be shown."""
import json
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cmake"))
from notebooks import page, run_cell  # noqa: E402

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("file", NOTEBOOKS, ids=lambda f: f.stem)
def test_it_runs(file, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib").use("Agg")
    monkeypatch.chdir(tmp_path)
    notebook = json.loads(file.read_text(encoding="utf-8"))
    names = {}
    shown = [run_cell("".join(c["source"]), names) for c in notebook["cells"] if c["cell_type"] == "code"]
    assert all(not c["outputs"] for c in notebook["cells"] if c["cell_type"] == "code")  # kept without what machines differ in
    values = {file.stem: shown}
    if file.stem == "diagnosis":
        assert values["diagnosis"][1][0] == ["coulomb-level"] and values["diagnosis"][1][1]["value"] == pytest.approx(1.2, abs=0.01)
    if file.stem == "arm":
        assert values["arm"][-1] == ("no-gap", ["gravity"])
    if file.stem == "sampled_loop":
        kind, stable, _, phase_margin, _ = shown[1]
        assert kind == "sampled" and stable and 20 < phase_margin < 60
        assert names["delay_margin"] == pytest.approx(12.0e-3, abs=0.2e-3)
        assert shown[3] == ["stable-sliding", "stick-slip"]
        assert shown[-1][0] is True
    if file.stem == "ros_log":
        log = names["log"]
        assert list(log["position"]) == list(names["run"]["position"])  # every digit goes through the bag
        verdict, causes, found = shown[3]
        assert (verdict, causes) == ("gap", ["viscous"]) and found["viscous slope"]["value"] == pytest.approx(1.2, abs=0.01)
        assert 'damping="1.2' in names["exported"]["text"]
    for value in shown:
        if hasattr(value, "_repr_html_"):
            assert value._repr_html_().lstrip().startswith("<")


def test_every_notebook_is_in_the_navigation_of_the_site_and_on_the_page_of_python():
    assert len(NOTEBOOKS) >= 5
    navigation = (ROOT / "mkdocs.yml").read_text(encoding="utf-8")
    python = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    for file in NOTEBOOKS:
        assert f"notebooks/{file.stem}.md" in navigation and f"notebooks/{file.name}" in python


def test_a_notebook_becomes_a_page_with_what_its_cells_show(tmp_path):
    pytest.importorskip("matplotlib")
    source = ["import stickslip\nprint(3 * 7)\nstickslip.Answer({'a': {'b': 1.5}})", "from matplotlib import pyplot\npyplot.plot([0, 1])", "6 * 9"]
    cells = [{"cell_type": "markdown", "source": ["# Title\n", "Words."]}, *({"cell_type": "code", "source": [s], "outputs": []} for s in source)]
    notebook = tmp_path / "small.ipynb"
    notebook.write_text(json.dumps({"cells": cells}), encoding="utf-8")
    text = page(notebook, tmp_path)
    assert text.startswith("# Title\nWords.\n\n```python\nimport stickslip\n")
    assert "```text\n21\n```\n" in text and "<td style='text-align:left'>a.b</td>" in text
    assert "![](../pictures/small-2.svg)" in text and (tmp_path / "small-2.svg").read_text().lstrip().startswith("<?xml")
    assert "```text\n54\n```" in text
