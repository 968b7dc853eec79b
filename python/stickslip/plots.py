"""One-line figures on matplotlib that look like the charts of the report."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.axes import Axes

INK, HALO, GOLD, VELOCITY_ONLY, MOTION = "#000000", "#fefefe", "#ffdd33", "#a4006d", "#0c5e92"
# every sixteenth colour of the report's map: F. Crameri's vik, blue where motions decay
_VIK = ("#001261", "#022b71", "#034481", "#0c5e92", "#307da6", "#619ebd", "#94bed2", "#c6dbe6", "#ece5e0", "#e9ccba", "#dcac90",
        "#cf8e68", "#c37243", "#b3531f", "#942f06", "#741506", "#590008")
# colour, dashes and name of a boundary, as the report draws it
_CURVES = {"linear": (INK, "-", "boundary, with frictional memory"), "velocity-only": (VELOCITY_ONLY, "--", "boundary, velocity-only model"),
           "fold": ("#00594c", "-.", "fold of limit cycles"), "outcome": ("#3d2f9c", ":", "boundary, nonlinear simulation")}


def _axes(ax: "Axes | None") -> "Axes":
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots(layout="constrained")[1]  # long names of effects stay on the page


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


def _signed(values: Any) -> tuple[Any, Any]:
    """Colours and their scale: asinh, with a knee that a fifth of the field stays below, so that the boundary keeps its contrast."""
    import numpy
    from matplotlib import colors

    sizes = numpy.sort(numpy.abs(values[numpy.isfinite(values) & (values != 0)]))
    limit = sizes[-1] if len(sizes) else 1.0
    knee = 10 ** numpy.floor(numpy.log10(max(sizes[len(sizes) // 5], limit / 1e4))) if len(sizes) else 1.0
    scale = colors.FuncNorm((lambda v: numpy.arcsinh(numpy.asarray(v) / knee), lambda p: knee * numpy.sinh(p)), vmin=-limit, vmax=limit)
    table = colors.LinearSegmentedColormap.from_list("vik", _VIK)
    table.set_bad("#b8bcc2")
    return table, scale


def _draw_theories(ax: "Axes", x: Any, y: Any, growth: Any, simple: Any) -> None:
    """Both boundaries, and the regions in which the theories disagree or forbid sliding."""
    import numpy
    from matplotlib import lines, patches, rc_context

    entries: list[Any] = []

    def boundary(field: Any, kind: str) -> None:
        colour, dashes, label = _CURVES[kind]
        if numpy.nanmin(field) <= 0 < numpy.nanmax(field):
            ax.contour(x, y, field, levels=[0], colors=[HALO], linewidths=[4.5])
            ax.contour(x, y, field, levels=[0], colors=[colour], linestyles=[dashes], linewidths=[2])
            entries.append(lines.Line2D([], [], color=colour, linestyle=dashes, linewidth=2, label=label))

    def region(where: Any, hatch: str, colour: str, face: str, label: str) -> None:
        if where.any():
            with rc_context({"hatch.color": colour, "hatch.linewidth": 1.2}):
                ax.contourf(x, y, where.astype(float), levels=[0.5, 1.5], colors="none", hatches=[hatch])
            entries.append(patches.Patch(facecolor=face, edgecolor=colour, hatch=hatch, label=label))

    stable = growth <= 0
    known = numpy.isfinite(growth)
    if simple is None:
        region(known & ~stable, "\\\\\\", "#00000066", _VIK[11], "stick-slip")
    else:
        region(known & ~stable & ~simple, "\\\\\\", "#00000066", _VIK[11], "stick-slip in both models")
        region(known & stable & ~simple, "///", GOLD, _VIK[4], "smooth with memory only")
        region(known & ~stable & simple, "xxx", "#000000d9", _VIK[11], "stick-slip with memory only")
        boundary(0.5 - simple, "velocity-only")
    boundary(growth, "linear")
    if entries:
        ax.legend(handles=entries, loc="upper center", bbox_to_anchor=(0.5, -0.15), ncol=2, frameon=False, fontsize="small")


def plot_map(dataset: "xarray.Dataset", x: str, y: str, variable: str = "spectral_abscissa", ax: "Axes | None" = None, **at: float) -> "Axes":
    """Two axes of a sweep: the growth of disturbances, blue where they decay, both models' boundaries, and hatched where they
    disagree; any other `variable` alone. Other axes stand at the nearest value to `at`, else in the middle:
    plot_map(ds, "control.k_p", "control.V0", **{"control.k_v": 30}), in the units of the dataset. Draws into `ax` or new axes, and returns
    them. Raises ValueError for an axis or a variable that the sweep has not, with those that it has."""
    import numpy

    ax = _axes(ax)
    x, y = _dimension(dataset, x), _dimension(dataset, y)
    at = {_dimension(dataset, name): value for name, value in at.items()}
    if variable not in dataset:
        raise ValueError(f"{variable}: is no variable of this sweep, variables are {', '.join(map(str, dataset.data_vars))}")

    def slice_of(name: str) -> Any:
        values = dataset[name]
        for other in map(str, values.dims):
            if other not in (x, y):
                values = values.sel({other: at[other]}, method="nearest") if other in at else values.isel({other: values.sizes[other] // 2})
        return values.transpose(y, x).values

    values = numpy.asarray(slice_of(variable), dtype=float)
    growth = variable == "spectral_abscissa"
    table, scale = _signed(values) if growth else ("viridis", None)
    drawn = ax.pcolormesh(dataset[x], dataset[y], values, shading="nearest", cmap=table, norm=scale)
    label = "spectral abscissa max Re s [1/s], asinh scale" if growth else _label(dataset[variable])
    ax.figure.colorbar(drawn, ax=ax, label=label)
    if growth and min(values.shape) > 1:
        simple = slice_of("velocity_only_stable").astype(float) == 1 if "velocity_only_stable" in dataset else None
        _draw_theories(ax, dataset[x], dataset[y], values, simple)
    for axis, name in ((ax.xaxis, x), (ax.yaxis, y)):
        steps = dataset[name].values
        if len(steps) > 2 and steps.min() > 0 and steps[1] / steps[0] > 1.001 and abs(steps[1] ** 2 / (steps[0] * steps[2]) - 1) < 1e-6:
            (ax.set_xscale if axis is ax.xaxis else ax.set_yscale)("log")
    ax.set(xlabel=_label(dataset[x]), ylabel=_label(dataset[y]), title="Stability of sliding" if growth else "",
           xlim=(dataset[x].min(), dataset[x].max()), ylim=(dataset[y].min(), dataset[y].max()))
    return ax


def plot_motion(frame: "pandas.DataFrame", y: str = "velocity", ax: "Axes | None" = None) -> "Axes":
    """A column of `simulate` over time [s], in its unit. Raises ValueError for a column that the motion has not."""
    ax = _axes(ax)
    units = frame.attrs.get("units", {})
    if y not in frame:
        raise ValueError(f"{y}: is no column of this motion, columns are {', '.join(map(str, frame.columns))}")
    ax.plot(frame["time"], frame[y], color=MOTION, linewidth=1.2)
    ax.set(xlabel="time [s]", ylabel=f"{y} [{units.get(y, '')}]" if units.get(y) else y)
    return ax


def plot_boundary(answer: Any, ax: "Axes | None" = None) -> "Axes":
    """The curves of `boundary(…, over=[x, y])` in the units of both axes, each kind as the report draws it. Raises ValueError where the
    answer has no curves."""
    ax = _axes(ax)
    curves = answer.get("curves", [])
    if not curves:
        raise ValueError("the answer has no curves: ask with over=[x, y]")
    for curve in curves:
        colour, dashes, label = _CURVES.get(curve["kind"], (INK, ":", curve["kind"]))
        for number, piece in enumerate(curve["pieces"]):
            ax.plot([p["x"] for p in piece["points"]], [p["y"] for p in piece["points"]], color=colour, linestyle=dashes, linewidth=2,
                    label="_" * (number > 0) + label)
    for of, set_label, set_scale in (("x", ax.set_xlabel, ax.set_xscale), ("y", ax.set_ylabel, ax.set_yscale)):
        axis = curves[0][of]
        unit = axis.get("unit", "1")
        set_label(axis["path"] + (f" [{unit}]" if unit != "1" else ""))
        set_scale(axis.get("scale", "linear"))
    if ax.get_legend_handles_labels()[0]:
        ax.legend(frameon=False, fontsize="small")
    return ax


def plot_effects(answer: Any, ax: "Axes | None" = None) -> "Axes":
    """Causes of a gap by their probability, from the answer of `diagnose`. Raises KeyError for another answer."""
    ax = _axes(ax)
    effects = answer["effects"][::-1]
    ax.barh([" + ".join(e["names"]) for e in effects], [e["probability"] for e in effects], color=MOTION)
    ax.set(xlabel="probability", xlim=(0, 1), title=answer["verdict"])
    return ax
