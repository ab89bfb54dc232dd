"""pyFBS: arrays [line, output, input], and tables of channels and impacts."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ..dof import Dof
from ..errors import InputError
from ..frf_set import FrfSet

_AXES = np.eye(3)
_SKEW = 1e-6  # how far from an axis a unit vector may be


def _columns(table: Any, prefix: str) -> np.ndarray:
    missing = next((f"{prefix}_{k}" for k in (1, 2, 3) if f"{prefix}_{k}" not in table), None)
    if missing is not None:
        raise InputError(f"the table has no column {missing!r}", place="channels, impacts", kind="data",
                         remedy="give df_chn and df_imp with Position_1 to Position_3 and Direction_1 to Direction_3")
    return np.column_stack([np.asarray(table[f"{prefix}_{k}"], dtype=float) for k in (1, 2, 3)])


def _nodes(positions: np.ndarray, groups: dict[tuple, int]) -> list[int]:
    """A node number for each position, from 1 in their order."""
    return [groups.setdefault(tuple(np.round(place, 9)), len(groups) + 1) for place in positions]


def _is_rotation(quantity: Any) -> bool:
    """Of "Angular Acceleration" and "Moment", as pyFBS calls rotational channels and impacts."""
    return any(word in str(quantity).lower() for word in ("angular", "rotation", "moment", "torque"))


def _direction(vector: np.ndarray, name: str) -> str:
    length = np.linalg.norm(vector)
    axis = int(np.argmax(np.abs(vector)))
    if not length > 0.0:
        raise InputError(f"{name} has no direction", place="Direction", kind="data", remedy="give a unit vector")
    if np.linalg.norm(np.abs(vector / length) - _AXES[axis]) > _SKEW:
        raise InputError(f"{name} points along {np.round(vector, 4).tolist()}, along no axis", place="Direction", kind="data",
                         remedy="name the DOFs yourself (responses=, references=), and give its direction to "
                         "jointid.virtual_points (directions={\"DOF\": [x, y, z]})")
    return ("-" if vector[axis] < 0.0 else "+") + "XYZ"[axis]


def _dofs(table: Any, groups: dict[tuple, int], given: Any) -> list[Dof]:
    if given is not None:
        return [Dof(name) for name in given]
    names = [str(name) for name in table["Name"]] if "Name" in table else [str(k) for k in range(len(table))]
    nodes = _nodes(_columns(table, "Position"), groups)
    turned = [_is_rotation(word) for word in table["Quantity"]] if "Quantity" in table else [False] * len(names)
    axes = [_direction(vector, name) for vector, name in zip(_columns(table, "Direction"), names)]
    return [Dof(f"{node}:{axis[0]}{'R' if turns else ''}{axis[1]}") for node, axis, turns in zip(nodes, axes, turned)]


def from_pyfbs(frequency: Any, frfs: Any, channels: Any, impacts: Any, *, responses: Any = None, references: Any = None,
               quantity: str = "accelerance", name: str = "pyFBS") -> FrfSet:
    """A set from FRFs [line, channel, impact] with ``df_chn`` and ``df_imp``, DataFrames or other tables with their columns.

    Positions are numbered from 1 in their order, channels first. Rows with one Position are one node; Direction gives the DOF. The
    set has the positions, m. Rows whose Quantity is "Angular Acceleration" or "Moment" are rotations. Directions along no axis raise
    InputError, unless `responses` and `references` name the DOFs.
    """
    groups: dict[tuple, int] = {}
    rows, columns = _dofs(channels, groups, responses), _dofs(impacts, groups, references)
    positions = {node: place for place, node in groups.items()}
    for table, dofs in ((channels, rows), (impacts, columns)):
        positions.update({dof.node: tuple(place) for dof, place in zip(dofs, _columns(table, "Position"))})
    return FrfSet(frfs, frequency, rows, columns, quantity=quantity, nodes=positions, name=name)


def read_positions(path: str | os.PathLike, sheet: str) -> Any:
    """A sheet of pyFBS's table of positions (.xlsx): ``"Channels_A"`` and so on, as a DataFrame. Needs pandas and openpyxl."""
    import pandas

    with pandas.ExcelFile(path) as book:
        if sheet not in book.sheet_names:
            raise InputError(f"there is no sheet {sheet!r}", file=os.fspath(path), place="sheet", kind="data",
                             remedy="there are " + ", ".join(map(str, book.sheet_names)))
        return book.parse(sheet)


def to_pyfbs(frfs: FrfSet) -> tuple[np.ndarray, np.ndarray, dict[str, list], dict[str, list]]:
    """Frequency [line], Hz, FRFs [line, channel, impact], and columns of ``df_chn`` and ``df_imp`` for ``pandas.DataFrame()``."""
    return frfs.frequency, frfs.frfs, _table(frfs, frfs.responses, True), _table(frfs, frfs.references, False)


def _table(frfs: FrfSet, dofs: Any, is_response: bool) -> dict[str, list]:
    out: dict[str, list] = {"Name": [str(dof) for dof in dofs], "Description": [""] * len(dofs), "Quantity": [], "Grouping": []}
    for k in (1, 2, 3):
        out[f"Position_{k}"], out[f"Direction_{k}"] = [], []
    words = {"receptance": "Displacement", "mobility": "Velocity", "accelerance": "Acceleration"}
    for dof in dofs:
        place = frfs.nodes.get(dof.node, (np.nan,) * 3)
        for k in (0, 1, 2):
            out[f"Position_{k + 1}"].append(place[k])
            out[f"Direction_{k + 1}"].append(dof.sign * _AXES["XYZ".index(dof.direction[-1])][k])
        quantity = words[frfs.quantity] if is_response else "Force"
        out["Quantity"].append({"Force": "Moment"}.get(quantity, f"Angular {quantity}") if dof.is_rotation else quantity)
        out["Grouping"].append(dof.node)
    return out
