"""The notebooks of docs/notebooks as pages of the site, with what each cell shows. Used by docs.py, and by the test that runs them.

Cells run as in a notebook, one after the other in a folder of their own, by this Python and the package in python/.
"""
import ast
import contextlib
import io
import json
import os
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).parent.parent
FOLDER = ROOT / "docs" / "notebooks"
NEEDED = ("matplotlib", "pandas", "xarray")


def run_cell(source, names):
    """As a notebook does: statements, then the value of the last line if it is an expression."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    return eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None


def cells(file):
    """(kind, text) of every cell."""
    return [(cell["cell_type"], "".join(cell["source"])) for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]]


def _fenced(text):
    return f"```text\n{text.rstrip()}\n```\n"


def _shown(value, printed, figure):
    """What stands below a cell; `figure` draws the open chart into a file and gives its name, or nothing."""
    text = _fenced(printed) if printed.strip() else ""
    picture = figure()
    if picture:
        return text + f"![]({picture})\n"
    if value is None:
        return text
    if hasattr(value, "_repr_html_"):
        return text + f"<div class=\"shown\">{' '.join(value._repr_html_().split())}</div>\n"
    return text + _fenced(repr(value))


def page(file, pictures):
    """Markdown of a notebook that is run; charts are written into the folder `pictures`, beside the page."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    names, text = {}, ""
    for number, (kind, source) in enumerate(cells(file)):
        if kind == "markdown":
            text += source + "\n\n"
            continue
        printed = io.StringIO()
        pyplot.close("all")
        with contextlib.redirect_stdout(printed):
            value = run_cell(source, names)

        def figure():
            if not pyplot.get_fignums():
                return ""
            name = f"{file.stem}-{number}.svg"
            pyplot.gcf().savefig(pictures / name, bbox_inches="tight")
            return f"../pictures/{name}"
        text += f"```python\n{source}\n```\n\n{_shown(value, printed.getvalue(), figure)}\n"
    pyplot.close("all")
    return text + f"This page is [{file.name}]({file.name}), run when the site was built.\n"


def source_page(file):
    """Markdown of a notebook that this machine cannot run."""
    text = "".join(source + "\n\n" if kind == "markdown" else f"```python\n{source}\n```\n\n" for kind, source in cells(file))
    return text + f"This page is [{file.name}]({file.name}).\n"


def write_pages(program, docs):
    """A page for each notebook into docs/notebooks, with the results of `program` where Python has what they need."""
    missing = [name for name in NEEDED if not _importable(name)]
    if missing:
        print(f"notebooks are on the site without results: {', '.join(missing)} not installed")
    os.environ["STICKSLIP_PROGRAM"] = str(program)
    sys.path.insert(0, str(ROOT / "python"))
    for file in sorted(FOLDER.glob("*.ipynb")):
        target = docs / "notebooks" / f"{file.stem}.md"
        if missing:
            target.write_text(source_page(file), encoding="utf-8")
            continue
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as room:
            os.chdir(room)
            try:
                target.write_text(page(file, docs / "pictures"), encoding="utf-8")
            finally:
                os.chdir(before)


def _importable(name):
    try:
        __import__(name)
        return True
    except ImportError:
        return False
