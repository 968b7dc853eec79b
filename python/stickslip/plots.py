"""One-line figures on matplotlib, in the colours of the report."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.axes import Axes

STABLE, UNSTABLE, INK = "#4c9f70", "#d1495b", "#264653"


def _axes(ax: "Axes | None") -> "Axes":
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots()[1]


def _label(variable: Any) -> str:
    unit = variable.attrs.get("units", "")
    return f"{variable.name} [{unit}]" if unit and unit != "1" else str(variable.name)


def _dimension(dataset: "xarray.Dataset", name: str) -> str:
    """A dataset calls its axes by the last part of their path; either is taken."""
    for found in dataset.dims:
        if name in (found, dataset[found].attrs.get("path")):
            return str(found)
    paths = ", ".join(str(dataset[d].attrs.get("path", d)) for d in dataset.dims)
    raise ValueError(f"{name}: is no axis of this sweep, axes are {paths}")


def plot_map(dataset: "xarray.Dataset", x: str, y: str, variable: str = "spectral_abscissa", ax: "Axes | None" = None, **at: float) -> "Axes":
    """Stable and unstable parts of two axes of a sweep. Other axes stand at the nearest value to `at`, else in the
    middle: plot_map(ds, "control.k_p", "control.V0", **{"control.k_v": 30})."""
    ax = _axes(ax)
    x, y = _dimension(dataset, x), _dimension(dataset, y)
    at = {_dimension(dataset, name): value for name, value in at.items()}
    values = dataset[variable]
    for name in map(str, values.dims):
        if name in (x, y):
            continue
        values = values.sel({name: at[name]}, method="nearest") if name in at else values.isel({name: values.sizes[name] // 2})
    values = values.transpose(y, x)
    ax.contourf(dataset[x], dataset[y], values > 0, levels=[-0.5, 0.5, 1.5], colors=[STABLE, UNSTABLE], alpha=0.55, zorder=0)
    if bool((values > 0).any()) and bool((values <= 0).any()):
        ax.contour(dataset[x], dataset[y], values, levels=[0], colors=[INK])
    for axis, name in ((ax.xaxis, x), (ax.yaxis, y)):
        steps = dataset[name].values
        if len(steps) > 2 and steps.min() > 0 and steps[1] / steps[0] > 1.001 and abs(steps[1] ** 2 / (steps[0] * steps[2]) - 1) < 1e-6:
            (ax.set_xscale if axis is ax.xaxis else ax.set_yscale)("log")
    ax.set(xlabel=_label(dataset[x]), ylabel=_label(dataset[y]), title=f"{variable} ≤ 0: green")
    return ax


def plot_motion(frame: "pandas.DataFrame", y: str = "velocity", ax: "Axes | None" = None) -> "Axes":
    """A column of `simulate` in time."""
    ax = _axes(ax)
    units = frame.attrs.get("units", {})
    ax.plot(frame["time"], frame[y], color=INK, linewidth=1)
    ax.set(xlabel="time [s]", ylabel=f"{y} [{units.get(y, '')}]" if units.get(y) else y)
    return ax


def plot_boundary(answer: Any, ax: "Axes | None" = None) -> "Axes":
    """The curves of `boundary(…, over=[x, y])`."""
    ax = _axes(ax)
    curves = answer.get("curves", [])
    if not curves:
        raise ValueError("the answer has no curves: ask with over=[x, y]")
    for curve in curves:
        for piece in curve["pieces"]:
            ax.plot([p["x"] for p in piece["points"]], [p["y"] for p in piece["points"]], color=INK)
        ax.set(xlabel=str(curve["x"]["path"]), ylabel=str(curve["y"]["path"]), xscale="log", yscale="log")
    return ax


def plot_effects(answer: Any, ax: "Axes | None" = None) -> "Axes":
    """Causes of a gap by their probability."""
    ax = _axes(ax)
    effects = answer["effects"][::-1]
    ax.barh([" + ".join(e["names"]) for e in effects], [e["probability"] for e in effects], color=STABLE)
    ax.set(xlabel="probability", xlim=(0, 1), title=answer["verdict"])
    return ax
