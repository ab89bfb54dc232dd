"""Plots by matplotlib, which is imported at the first plot."""

from __future__ import annotations

from typing import Any

import numpy as np

from .dof import Dof
from .errors import InputError

_MOST = 16  # curves in one picture


def pyplot() -> Any:
    try:
        import matplotlib.pyplot as pyplot
    except ImportError:
        raise InputError("matplotlib is missing", place="plot", remedy="install it (Debian: python3-matplotlib)") from None
    return pyplot


def _two_axes(axes: Any) -> Any:
    if axes is not None:
        return axes
    _, axes = pyplot().subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2, 1]}, layout="constrained")
    return axes


def _pairs(frfs: Any, response: str | None, reference: str | None) -> list[tuple[str, str]]:
    responses = frfs.responses if response is None else [response]
    references = frfs.references if reference is None else [reference]
    return [(str(r), str(c)) for r in responses for c in references][:_MOST]


def _curve(axes: Any, frequency: np.ndarray, frf: np.ndarray, label: str, style: dict) -> None:
    axes[0].semilogy(frequency, np.abs(frf), label=label, **style)
    axes[1].plot(frequency, np.degrees(np.angle(frf)), **style)


def _labels(axes: Any, unit: str) -> None:
    axes[0].set_ylabel(f"magnitude, {unit}")
    axes[1].set_ylabel("phase, °")
    axes[1].set_xlabel("frequency, Hz")
    axes[1].set_yticks([-180, -90, 0, 90, 180])
    for each in axes:
        each.grid(alpha=0.3)
    axes[0].legend(fontsize="small")


def plot_frfs(frfs: Any, response: str | None, reference: str | None, axes: Any, style: dict) -> Any:
    axes = _two_axes(axes)
    for pair in _pairs(frfs, response, reference):
        _curve(axes, frfs.frequency, frfs[pair], f"{pair[0]} / {pair[1]}", style)
    _labels(axes, frfs.unit)
    axes[0].set_title(frfs.name)
    return axes


def plot_predicted(solution: Any, response: str, reference: str, measured: Any, axes: Any) -> Any:
    axes = _two_axes(axes)
    predicted = solution.predicted()
    if measured is not None:
        predicted = predicted.to(measured.quantity)
        _curve(axes, measured.frequency, measured[response, reference], "measured", {"color": "0.5", "linewidth": 1})
    _curve(axes, predicted.frequency, predicted[response, reference], "synthesised", {"linewidth": 1})
    _labels(axes, predicted.unit)
    axes[0].set_title(f"{response} / {reference}")
    return axes


def plot_matrix(solution: Any, kind: str, axes: Any) -> Any:
    matrices = solution.matrices
    if kind not in matrices:
        raise InputError(f"the joint has no {kind!r}", place="plot_matrix", remedy="it has " + ", ".join(matrices))
    if axes is None:
        _, axes = pyplot().subplots(layout="constrained")
    matrix, names = matrices[kind], [str(dof) for dof in solution.dofs]
    largest = float(np.nanmax(np.abs(matrix))) or 1.0
    image = axes.imshow(matrix, cmap="RdBu_r", vmin=-largest, vmax=largest)
    axes.set_xticks(range(len(names)), names, rotation=90)
    axes.set_yticks(range(len(names)), names)
    axes.set_title(kind.replace("_", " "))
    axes.figure.colorbar(image, ax=axes, shrink=0.8)
    return axes


def _bars(axes: Any, names: list[str]) -> Any:
    """Axes with a row for each name, the first on top."""
    if axes is None:
        _, axes = pyplot().subplots(layout="constrained", figsize=(6.4, max(2.5, 0.25 * len(names) + 1.0)))
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.grid(axis="x", alpha=0.3)
    return axes


def plot_unknowns(solution: Any, axes: Any) -> Any:
    """A row for each unknown: its interval in percent of the value, grey where the data do not determine it."""
    unknowns = [each for each in solution.unknowns.values() if np.isfinite(each.value) and each.value != 0.0]
    axes = _bars(axes, [f"{each.name} = {each.value:.4g} {each.unit}" for each in unknowns])
    for row, each in enumerate(unknowns):
        low, high = (100.0 * (end - each.value) / abs(each.value) for end in each.ci95 or (np.nan, np.nan))
        axes.plot([low, high], [row, row], color="C0", linewidth=4, alpha=0.4, solid_capstyle="butt")
        axes.plot(0.0, row, "o", color="C0" if each.determined else "0.6", markersize=4)
    axes.set_xlabel("95 % interval, % of the value")
    axes.set_title(solution.status or "unknowns")
    return axes


def plot_bound(result: Any, axes: Any) -> Any:
    bound = result._numbers().get("bound")
    if bound is None:
        raise InputError("friction laws have bounds by force level", place="plot_bound", remedy="see text() and to_dict()")
    if "relative_median" in bound:
        return _plot_bound_of_lines(result, axes)
    axes = _bars(axes, [each["name"] for each in bound["unknowns"]])
    axes.barh(range(len(bound["unknowns"])), [100.0 * (each["relative"] or np.nan) for each in bound["unknowns"]])
    axes.set_xlabel("standard error, % of the value")
    return axes


def _plot_bound_of_lines(result: Any, axes: Any) -> Any:
    """Each element over the lines."""
    if axes is None:
        _, axes = pyplot().subplots(layout="constrained")
    lines = result["bound"]["lines"]
    for t, element in enumerate(result["elements"]):
        errors = [np.nan if line is None or line["relative"][t] is None else 100.0 * line["relative"][t] for line in lines]
        axes.semilogy(result["frequency_hz"], errors, label=element["name"], linewidth=1)
    axes.set_xlabel("Hz")
    axes.set_ylabel("standard error, % of |z|")
    axes.legend()
    return axes


def plot_lines(ways: Any, element: str, unit: str, law: Any, axes: Any) -> Any:
    """Real part above, imaginary part below, each way with its 95 % band."""
    if axes is None:
        _, axes = pyplot().subplots(2, 1, sharex=True, layout="constrained")
    for values in [*ways, *([] if law is None else [law])]:
        if element not in values.elements:
            raise InputError(f"{values.name!r} has no element {element!r}", place="plot", remedy="it has " + ", ".join(values.elements))
        at = values.elements.index(element)
        for part, axis in enumerate(axes):
            numbers = values.z[:, at].imag if part else values.z[:, at].real
            line, = axis.plot(values.frequency, numbers, label=values.name, linewidth=1, linestyle="--" if values is law else "-")
            axis.fill_between(values.frequency, *values.band[:, at, part].T, color=line.get_color(), alpha=0.2, linewidth=0)
    for axis, word in zip(axes, ("Re", "Im")):
        axis.set_ylabel(f"{word} {element}, {unit}")
        axis.grid(alpha=0.3)
    axes[1].set_xlabel("frequency, Hz")
    axes[0].legend(fontsize="small")
    return axes


def plot_with_band(frfs: Any, response: str | None, reference: str | None, axes: Any) -> Any:
    """An FRF, and its magnitude ± 1.96 standard errors."""
    response, reference = response or str(frfs.responses[0]), reference or str(frfs.references[0])
    axes = plot_frfs(frfs, response, reference, axes, {"linewidth": 1})
    size = np.abs(frfs[response, reference])
    row, column = (next(k for k, dof in enumerate(of) if dof.coordinate == Dof(name).coordinate)
                   for of, name in ((frfs.responses, response), (frfs.references, reference)))
    variance = frfs.variance
    if variance is not None:
        half = 1.96 * np.sqrt(0.5 * (variance[:, row, column].real + variance[:, row, column].imag))
        axes[0].fill_between(frfs.frequency, np.maximum(size - half, 1e-3 * size), size + half, alpha=0.2, linewidth=0)
    return axes
