"""The plots of a report page, by matplotlib. What a page draws is data inside it (report/page/plot_json.hpp)."""

from __future__ import annotations

import html
import json
import re
from typing import Any

import numpy as np

from ._plots import pyplot
from .errors import InputError

_DATA = re.compile(r'<script type="application/json" id="plots">(.*?)</script>', re.DOTALL)
_PLACES = re.compile(r'<h2>(.*?)</h2>|data-group="(\d+)"', re.DOTALL)
_STYLES = {
    "line": {"linewidth": 1.2},
    "dashed": {"linewidth": 1.2, "linestyle": "--"},
    "points": {"linestyle": "", "marker": ".", "markersize": 4},
    "reference": {"linewidth": 3, "color": "0.75"},
    "reference points": {"linestyle": "", "marker": ".", "markersize": 4, "color": "0.6"},
}

Group = dict[str, list[dict[str, Any]]]  # the plots of each choice


def groups_of(page: str) -> dict[str, Group]:
    """The groups of plots by the title of their section; a second one of the same section as "title (2)"."""
    data = _DATA.search(page)
    if data is None:
        return {}
    groups = json.loads(data[1])
    out: dict[str, Group] = {}
    section, count = "", 0
    for title, number in _PLACES.findall(page[: data.start()]):
        if title:
            section, count = html.unescape(title), 0
            continue
        count += 1
        out[section if count == 1 else f"{section} ({count})"] = _choices(groups[int(number)])
    return out


def _choices(group: dict[str, Any]) -> Group:
    out: Group = {}
    for choice in group["choices"]:
        before: list = []
        for plot in choice["plots"]:
            if plot["kind"] == "curves":
                before = plot["values"] = before if plot["values"] == "same" else plot["values"]
        out[choice["name"]] = choice["plots"]
    return out


def chosen(groups: dict[str, Group], section: str | None, choice: str | None, command: str) -> tuple[str, list[dict[str, Any]]]:
    """The title and the plots of a section and choice; the first ones by default."""
    if not groups:
        raise InputError(f"the page of {command} has no plots", place="plot_page", remedy="see text() and to_dict()")
    if section is not None and section not in groups:
        raise InputError(f"there is no section {section!r}", place="section", remedy="it has " + ", ".join(groups))
    group = groups[section] if section is not None else next(iter(groups.values()))
    if choice is not None and choice not in group:
        raise InputError(f"there is no choice {choice!r}", place="choice", remedy="it has " + ", ".join(list(group)[:12]))
    name = choice if choice is not None else next(iter(group))
    return name, group[name]


def draw(title: str, plots: list[dict[str, Any]], axes: Any) -> list[Any]:
    """Each plot on an axis: below each other, or many in rows of three. Returns the axes."""
    listed = _figure(len(plots)) if axes is None else list(np.ravel(axes))
    if len(listed) != len(plots):
        raise InputError(f"{len(listed)} axes for {len(plots)} plots", place="axes", remedy=f"give {len(plots)}, or none")
    for plot, axis in zip(plots, listed):
        _DRAWN[plot["kind"]](plot, axis)
        axis.set_title(plot["title"] or title, fontsize="medium")
        axis.set_xlabel(plot["x"]["label"])
        axis.grid(alpha=0.3)
    return listed


def _figure(count: int) -> list[Any]:
    columns = 1 if count <= 4 else 3
    rows = -(-count // columns)
    _, axes = pyplot().subplots(rows, columns, squeeze=False, layout="constrained", figsize=(6.4 + 1.6 * columns, max(4.0, 2.6 * rows)))
    listed = list(np.ravel(axes))
    for spare in listed[count:]:
        spare.remove()
    return listed[:count]


def _numbers(values: list) -> np.ndarray:
    return np.array(values, dtype=float)


def _scales(plot: dict[str, Any], axis: Any) -> None:
    axis.set_ylabel(plot["y"]["label"])
    axis.set_xscale("log" if plot["x"]["log"] else "linear")
    axis.set_yscale("log" if plot["y"]["log"] else "linear")


def _series(values: list, listed: list[dict[str, Any]], axis: Any, period: float | None = None) -> None:
    for series in listed:
        y = _numbers(series["y"])
        if period and len(y) > 1:
            y[1:][np.abs(np.diff(y)) > 0.5 * period] = np.nan  # a jump of the phase is no line
        axis.plot(_numbers(values), y, label=series["name"], **_STYLES[series["style"]])


def _curves(plot: dict[str, Any], axis: Any) -> None:
    _scales(plot, axis)
    _series(plot["values"], plot["series"], axis, plot.get("period"))
    if "band" in plot:
        axis.axvspan(*plot["band"], color="0.92", zorder=0)
    if "level" in plot:
        axis.axhline(plot["level"], color="0.4", linewidth=0.8)
    if "yRange" in plot:
        axis.set_ylim(plot["yRange"])
    if plot["series"]:
        axis.legend(fontsize="small")


def _scatter(plot: dict[str, Any], axis: Any) -> None:
    _scales(plot, axis)
    for group in plot["groups"]:
        points = _numbers([point[:2] for point in group["points"]]).reshape(-1, 2)
        axis.plot(points[:, 0], points[:, 1], "o", markersize=5, label=group["name"])
    if plot["front"]:
        front = _numbers([point[:2] for point in plot["front"]])
        axis.plot(front[:, 0], front[:, 1], "k--", linewidth=1, label=plot["frontName"])
    if "backdrop" in plot:
        behind = axis.twinx()
        behind.set_ylabel(plot["backdrop"]["y"]["label"])
        behind.set_yscale("log" if plot["backdrop"]["y"]["log"] else "linear")
        _series(plot["backdrop"]["values"], plot["backdrop"]["series"], behind)
    axis.legend(fontsize="small")


def _histogram(plot: dict[str, Any], axis: Any) -> None:
    low, high = plot["range"]
    axis.stairs(_numbers(plot["counts"]), np.linspace(low, high, len(plot["counts"]) + 1), fill=True, alpha=0.6)
    axis.set_ylabel("count")
    if "mark" in plot:
        axis.axvline(plot["mark"]["x"], color="k", linewidth=1, label=plot["mark"]["name"])
        axis.legend(fontsize="small")


_DRAWN = {"curves": _curves, "scatter": _scatter, "histogram": _histogram}
