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
    """A node number for each position: that of `groups`, else the next one."""
    return [groups.setdefault(tuple(np.round(place, 9)), max(groups.values(), default=0) + 1) for place in positions]


def _is_rotation(quantity: Any) -> bool:
    """Of "Angular Acceleration" and "Moment", as pyFBS calls rotational channels and impacts."""
    return any(word in str(quantity).lower() for word in ("angular", "rotation", "moment", "torque"))


def _unit(vector: np.ndarray, name: str) -> np.ndarray:
    length = np.linalg.norm(vector)
    if not length > 0.0:
        raise InputError(f"{name} has no direction", place="Direction", kind="data", remedy="give a unit vector")
    return vector / length


def _direction(vector: np.ndarray, name: str) -> str:
    axis = int(np.argmax(np.abs(vector)))
    if np.linalg.norm(np.abs(_unit(vector, name)) - _AXES[axis]) > _SKEW:
        raise InputError(f"{name} points along {np.round(vector, 4).tolist()}, along no axis", place="Direction", kind="data",
                         remedy="name the DOFs yourself (responses=, references=), and give its direction to "
                         "jointid.virtual_points (directions={\"DOF\": [x, y, z]})")
    return ("-" if vector[axis] < 0.0 else "+") + "XYZ"[axis]


def _dofs(table: Any, groups: dict[tuple, int], given: Any) -> list[Dof]:
    if given is not None:
        return [Dof(name) for name in given]
    nodes = _nodes(_columns(table, "Position"), groups)
    names = [str(name) for name in table["Name"]] if "Name" in table else [f"row {k + 1}" for k in range(len(nodes))]
    turned = [_is_rotation(word) for word in table["Quantity"]] if "Quantity" in table else [False] * len(names)
    axes = [_direction(vector, name) for vector, name in zip(_columns(table, "Direction"), names)]
    return [Dof(f"{node}:{axis[0]}{'R' if turns else ''}{axis[1]}") for node, axis, turns in zip(nodes, axes, turned)]


def from_pyfbs(frequency: Any, frfs: Any, channels: Any, impacts: Any, *, responses: Any = None, references: Any = None,
               quantity: str = "accelerance", like: FrfSet | None = None, name: str = "pyFBS") -> FrfSet:
    """A set from FRFs [line, channel, impact], SI units, frequencies [line] in Hz, with ``df_chn`` and ``df_imp``, DataFrames or other tables with their columns.

    Positions are numbered from 1 in their order, channels first. Those of the set `like` keep their numbers: read AB first, then A and
    B like it. Rows with one Position are one node; Direction gives the DOF. The set has the positions, m. Rows whose Quantity is
    "Angular Acceleration" or "Moment" are rotations. Directions along no axis raise InputError, unless `responses` and `references`
    name the DOFs.

    >>> import numpy as np
    >>> from jointid.bridges.pyfbs import from_pyfbs
    >>> rows = {"Name": ["S1"], "Position_1": [0.1], "Position_2": [0.0], "Position_3": [0.0],
    ...         "Direction_1": [0.0], "Direction_2": [0.0], "Direction_3": [-1.0]}
    >>> frfs = from_pyfbs([10.0, 20.0], np.ones((2, 1, 1), complex), rows, rows)
    >>> frfs.responses[0], frfs.nodes
    ('1:-Z', {1: (0.1, 0.0, 0.0)})
    """
    groups: dict[tuple, int] = {}
    if like is not None:
        groups = {tuple(np.round(np.asarray(place), 9)): node for node, place in like.nodes.items()}
    rows, columns = _dofs(channels, groups, responses), _dofs(impacts, groups, references)
    positions: dict[int, tuple] = {}
    for table, dofs in ((channels, rows), (impacts, columns)):
        positions.update({dof.node: tuple(place) for dof, place in zip(dofs, _columns(table, "Position"))})
    return FrfSet(frfs, frequency, rows, columns, quantity=quantity, nodes=positions, name=name)


_RIGID = ("ux", "uy", "uz", "rx", "ry", "rz")
_PLANES: dict[tuple[str, ...], str] = {("ux", "uy", "rz"): "XY", ("uy", "uz", "rx"): "YZ", ("ux", "uz", "ry"): "XZ"}


def virtual_points(frfs: FrfSet, channels: Any, impacts: Any, points: Any) -> list[dict[str, Any]]:
    """The virtual points of ``pyFBS.VPT(df_chn, df_imp, df_vp, df_vpref)``, for ``jointid.virtual_points(frfs, points)``.

    identify(), couple() and others take them as ``virtual_points=points``, and errors of the FRFs as measured then reach the result.

    Parameters
    ----------
    frfs : FrfSet
        That of from_pyfbs(), with a response for each row of `channels` and a reference for each row of `impacts`.
    channels, impacts : df_chn, df_imp
        Rows belong to the virtual point of the same Grouping.
    points : df_vp
        Rows with Grouping, Position_1 to Position_3 and Description: "ux", "uy" … The DOFs are ``VP1:+X`` … of Grouping 1.

    Raises
    ------
    InputError
        For motions that are neither all six rigid ones nor those of a plane, and for a row without a direction.

    >>> import numpy as np
    >>> from jointid.bridges import pyfbs
    >>> rows = {"Name": ["a", "b", "c"], "Grouping": [1, 1, 1], "Position_1": [0.1, -0.1, 0.1], "Position_2": [0.0, 0.0, 0.0],
    ...         "Position_3": [0.0, 0.0, 0.0], "Direction_1": [1, 0, 0], "Direction_2": [0, 1, 1], "Direction_3": [0, 0, 0]}
    >>> frfs = pyfbs.from_pyfbs([10.0], np.ones((1, 3, 3), complex), rows, rows)
    >>> middle = {"Grouping": [1] * 3, "Description": ["ux", "uy", "rz"], **{f"Position_{k}": [0.0] * 3 for k in (1, 2, 3)}}
    >>> point = pyfbs.virtual_points(frfs, rows, rows, middle)[0]
    >>> point["name"], point["plane"], point["sensors"]
    ('VP1', 'XY', ['1:+X', '2:+Y', '1:+Y'])
    """
    listed = []
    for group in dict.fromkeys(int(each) for each in points["Grouping"]):
        rows = [k for k, each in enumerate(points["Grouping"]) if int(each) == group]
        words = [str(list(points["Description"])[k]).lower() for k in rows]
        point: dict[str, Any] = {"name": f"VP{group}", "position": _columns(points, "Position")[rows[0]].tolist(), **_motions(words, group)}
        for key, directions, table, dofs in (("sensors", "directions", channels, frfs.responses),
                                             ("impacts", "impact_directions", impacts, frfs.references)):
            if inside := [k for k, each in enumerate(table["Grouping"]) if int(each) == group]:
                point[key] = [str(dofs[k]) for k in inside]
                point[directions] = _skew(_columns(table, "Direction"), [(k, dofs[k]) for k in inside])
        listed.append(point)
    return listed


def _motions(words: list[str], group: int) -> dict[str, Any]:
    """`plane` and `flexible` of the motions of a virtual point."""
    rigid = tuple(word for word in _RIGID if word in words)
    flexible = [word for word in words if word not in _RIGID]
    if rigid != _RIGID and rigid not in _PLANES:
        raise InputError(f"the motions of grouping {group} are {', '.join(words)}", place="Description", kind="data",
                         remedy="give ux, uy, uz, rx, ry, rz, or those of a plane, ux, uy, rz")
    return {**({} if rigid == _RIGID else {"plane": _PLANES[rigid]}), **({"flexible": flexible} if flexible else {})}


def _skew(vectors: np.ndarray, inside: list[tuple[int, Dof]]) -> dict[str, list[float]]:
    """Unit vectors of those along no axis."""
    units = {str(dof): _unit(vectors[k], str(dof)) for k, dof in inside}
    return {dof: unit.tolist() for dof, unit in units.items() if np.abs(unit).max() < 1.0 - _SKEW}


def read_positions(path: str | os.PathLike, sheet: str) -> Any:
    """A sheet of pyFBS's table of positions (.xlsx): ``"Channels_A"`` and so on, as a DataFrame. Needs pandas and openpyxl.

    Raises
    ------
    InputError
        For a sheet that the table does not have.

    >>> import pandas, tempfile
    >>> from jointid.bridges.pyfbs import read_positions
    >>> path = f"{tempfile.mkdtemp()}/positions.xlsx"
    >>> pandas.DataFrame({"Name": ["S1"], "Position_1": [0.1]}).to_excel(path, sheet_name="Channels_A", index=False)
    >>> read_positions(path, "Channels_A")["Position_1"].tolist()
    [0.1]
    """
    import pandas

    with pandas.ExcelFile(path) as book:
        if sheet not in book.sheet_names:
            raise InputError(f"there is no sheet {sheet!r}", file=os.fspath(path), place="sheet", kind="data",
                             remedy="there are " + ", ".join(map(str, book.sheet_names)))
        return book.parse(sheet)


def to_pyfbs(frfs: FrfSet) -> tuple[np.ndarray, np.ndarray, dict[str, list], dict[str, list]]:
    """Frequency [line], Hz, FRFs [line, channel, impact], and columns of ``df_chn`` and ``df_imp`` for ``pandas.DataFrame()``.

    FRFs are in SI units, positions in m (NaN where the set has none). FRFs are not copied.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.pyfbs import to_pyfbs
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:+Z"], ["1:+Z"], nodes={1: (0.0, 0.0, 0.1)})
    >>> frequency, array, channels, impacts = to_pyfbs(frfs)
    >>> channels["Name"], channels["Direction_3"], impacts["Position_3"]
    (['1:+Z', '2:+Z'], [1.0, 1.0], [0.1])
    """
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
