"""FRFs of assemblies: couple, decouple, virtual_points."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

from . import _jointid
from ._joint import frequency_table, is_scene
from ._lines import DecoupledResult
from ._run import run_scene
from ._scene import Scene, as_list, list_of, path_of, table_of
from .errors import InputError
from .files import read
from .frf_set import FrfSet, dofs_of
from .results import FrfResult

PathOrSet = Any  # str, os.PathLike or FrfSet


def couple(parts: Any, *, join: Any = None, ground: Any = None, keep: Any = None, remove: Any = None, joints: Any = None,
           out: str | os.PathLike | None = None, bounds: bool = False, frequency: Any = None, data: Mapping[str, Any] | None = None,
           virtual_points: Any = None, threads: int = 0, progress: Any = None, **options: Any) -> FrfResult:
    """FRFs of an assembly from those of its substructures: ``jointid couple`` (LM-FBS and others).

    Call ``couple(scene)`` with a path or dict, or ``couple(parts, join=...)``.

    Parameters
    ----------
    parts : a scene, or a list of FrfSets and paths
    join : list of lists of DOFs
        Each list has DOFs that move alike (compatibility). One list of DOFs is one of these. A DOF that two parts have is "NAME/4:+Y".
    ground, keep : lists of DOFs
        DOFs fixed to ground; DOFs of the result.
    remove : list of parts or their names
        Substructures to decouple.
    joints : list of dicts
        Each with the keys of ``[[couple.joint]]``.
    out : path, optional
        HDF5 file for the FRFs. None keeps them in memory.
    bounds : bool
        Predict without redundant compatibility conditions, and with all of them.
    options : method, threshold, epsilon, alpha, uncertainty …: other keys of ``[couple]``

    Returns
    -------
    FrfResult
        ``result.frfs()`` is the FrfSet of the assembly.

    Raises
    ------
    InputError
        For a wrong scene, unknown DOFs or parts, and files that cannot be read.

    >>> import numpy as np, jointid
    >>> f = np.linspace(10.0, 20.0, 3)
    >>> mass = lambda m, node: jointid.FrfSet(-1 / (m * (2 * np.pi * f) ** 2).reshape(-1, 1, 1), f, [node], name=node)
    >>> both = jointid.couple([mass(1.0, "1:+X"), mass(2.0, "2:+X")], join=[["1:+X", "2:+X"]]).frfs()
    >>> bool(np.allclose(both["1:+X", "1:+X"], -1 / (3.0 * (2 * np.pi * f) ** 2)))
    True
    """
    if isinstance(join, (list, tuple)) and join and all(isinstance(each, str) for each in join):
        join = [list(join)]  # one pair
    table = {"join": join, "ground": ground, "keep": keep, "remove": remove, "joint": joints, **options}
    table = {key: value for key, value in table.items() if value is not None}
    sections = {"couple": table or None, "frequency": None if frequency is None else frequency_table(frequency),
                "virtual_points": virtual_points}
    sections = {key: value for key, value in sections.items() if value is not None}
    data = {} if data is None else table_of(data, "data")
    if is_scene(parts):
        own = dict(parts) if isinstance(parts, Mapping) else Scene.table_of(parts) if sections or data else None
        if own is None:
            scene = Scene(parts)
        else:
            own["data"] = {**table_of(own.get("data", {}), "[data]"), **data}
            own.update({**sections, "couple": {**table_of(own.get("couple", {}), "[couple]"), **table}})
            scene = Scene(own, file=None if isinstance(parts, Mapping) else os.fspath(parts))
    else:
        sections.setdefault("couple", {})
        scene = Scene({"data": {**data, "parts": as_list(parts)}, **sections})
    path = "" if out is None else path_of(out, "out")
    return run_scene(scene, "couple", _jointid.couple, path, bool(bounds), threads=threads, progress=progress, kind=FrfResult)


def decouple(assembly: Any, part: Any = None, interface: Sequence[str] | str | None = None, *, way: Any = None,
             noise: Mapping[str, Any] | None = None, out: str | os.PathLike | None = None, threads: int = 0, progress: Any = None,
             **options: Any) -> Any:
    """FRFs of an assembly without one of its substructures (decoupling, B from AB and A).

    There are two ways to call it:

    - ``decouple(scene)``, or with a `way`: ``jointid decouple``. FRFs of B with variances, and the dynamic stiffness of B with 95 %
      bands. FRFs need variances: their own, or a law in `noise`.
    - Without `way`: dual decoupling of exact FRFs, LM-FBS, ``jointid couple`` with ``remove``.

    Parameters
    ----------
    assembly, part : FrfSet or path, or a list of them
        AB and A. The first may be a scene with ``[decouple]``.
    interface : sequence of DOFs that both have
        Without `way`, internal DOFs of the part can join them (extended interface). The compatibility conditions are then redundant:
        give ``threshold="fixed"`` or another of couple().
    way : "likelihood", "standard", "extended", "both", or a list of them
        How B is found. The first is the result.
    noise : dict with the keys of ``[noise]``
    out : path, optional
        File for the FRFs of B. None keeps them in memory.
    options : with a `way` tables of a scene (frequency, identify, data, nodes, title, virtual_points); else those of couple()

    Returns
    -------
    DecoupledResult with a `way`, else FrfResult
        ``result.frfs()`` has the DOFs of B, or without `way` those of the assembly.

    Raises
    ------
    InputError
        For an interface DOF that one of them does not have.

    Warns
    -----
    DoubtfulWarning, UnusableWarning
        If errors are large, or if the compatibility conditions are redundant.

    The result includes a joint between the parts; identify() separates it. Errors grow if the part hardly moves on its own, or if it
    outweighs the rest.

    >>> import numpy as np, jointid
    >>> f = np.linspace(10.0, 20.0, 3)
    >>> mass = lambda m, name: jointid.FrfSet(-1 / (m * (2 * np.pi * f) ** 2).reshape(-1, 1, 1), f, ["1:+X"], name=name)
    >>> left = jointid.decouple(mass(3.0, "both"), mass(2.0, "fixture"), ["1:+X"]).frfs()
    >>> bool(np.allclose(left["1:+X", "1:+X"], mass(1.0, "alone")["1:+X", "1:+X"]))
    True
    """
    if way is None and not (part is None and interface is None and is_scene(assembly)):
        if noise is not None:
            raise InputError("noise needs a way: decoupling without one has no variances of its own", place="noise",
                             remedy='add way="likelihood", or give variances in the sets and uncertainty=True')
        if part is None or interface is None:
            raise InputError("the part or the interface is missing", place="decouple", remedy="give assembly, part and interface")
        return _dual_decoupling(assembly, part, interface, out=out, threads=threads, progress=progress, **options)
    scene = _decoupling_scene(assembly, part, interface, way, noise, options)
    path = "" if out is None else path_of(out, "out")
    return run_scene(scene, "decouple", _jointid.decouple, path, threads=threads, progress=progress, kind=DecoupledResult)


def _decoupling_scene(assembly: Any, part: Any, interface: Any, way: Any, noise: Any, sections: dict[str, Any]) -> Scene:
    valid = ("frequency", "identify", "data", "nodes", "title", "virtual_points")
    wrong = next((name for name in sections if name not in valid), None)
    if wrong is not None:
        raise InputError(f"there is no option {wrong!r}", place=wrong, remedy="with a way there are " + ", ".join(valid))
    made = {key: value for key, value in {**sections, "noise": noise}.items() if value is not None}
    if "frequency" in made:
        made["frequency"] = frequency_table(made["frequency"])
    if "data" in made:
        made["data"] = table_of(made["data"], "data")
    table = {key: value for key, value in (("interface", [interface] if isinstance(interface, str) else interface), ("way", way))
             if value is not None}
    if part is None and is_scene(assembly):
        if not made and not table:
            return Scene(assembly)
        own = dict(assembly) if isinstance(assembly, Mapping) else Scene.table_of(assembly)
        data = {**table_of(own.get("data", {}), "[data]"), **made.get("data", {})}
        own.update({**made, "data": data, "decouple": {**table_of(own.get("decouple", {}), "[decouple]"), **table}})
        return Scene(own, file=None if isinstance(assembly, Mapping) else os.fspath(assembly))
    if part is None or interface is None:
        raise InputError("the part or the interface is missing", place="decouple", remedy="give assembly, part and interface")
    data = {**made.pop("data", {}), "assembly": as_list(assembly), "substructures": as_list(part)}
    return Scene({"data": data, "decouple": table, **made})


def _dual_decoupling(assembly: PathOrSet, part: PathOrSet, interface: Sequence[str] | str, **options: Any) -> FrfResult:
    """Of exact FRFs, by couple()."""
    whole, taken = (each if isinstance(each, FrfSet) else read(each) for each in (assembly, part))
    if whole.name == taken.name:
        taken = taken._like(name=f"{taken.name} (part)")
    own = {dof.coordinate for dof in taken.dofs}
    coordinates = {dof.coordinate for dof in whole.dofs}
    shared = dofs_of(interface, "interface")
    for dof in shared:
        for known, name in ((coordinates, whole.name), (own, taken.name)):
            if dof.coordinate not in known:
                raise InputError(f"{name} has no DOF {dof}", place="interface", kind="data",
                                 remedy="it has " + ", ".join(sorted(known)[:12]))
    join = [[f"{whole.name}/{dof}", f"{taken.name}/{dof}"] for dof in shared]
    options.setdefault("keep", [f"{whole.name}/{dof}" if dof.coordinate in own else str(dof) for dof in whole.dofs])
    return couple([whole, taken], join=join, remove=[taken.name], **options)


def virtual_points(frfs: PathOrSet, points: Any, *, nodes: Mapping[Any, Sequence[float]] | None = None) -> FrfSet:
    """FRFs with virtual points in place of the sensors and impacts around interfaces (VPT).

    Parameters
    ----------
    frfs : FrfSet or path
    points : dict, or list of dicts, with the keys of ``[[virtual_points]]``
        ``{"name": "VP1", "position": [0, 0, 0], "sensors": ["11:+X", ...], "impacts": ["31:+X", ...]}``; lengths in m.
    nodes : {node: (x, y, z)}, optional
        Positions in m. They override those of the set.

    Raises
    ------
    InputError
        For a DOF that the set does not have, a node without position, and channels that do not determine the motions.

    >>> import numpy as np, jointid
    >>> places = {1: (0.1, 0, 0), 2: (-0.1, 0, 0), 3: (0, 0.1, 0)}
    >>> dofs = [f"{node}:+{axis}" for node in places for axis in "XYZ"]
    >>> of_node = lambda x, y, z: [[1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x], [0, 0, 1, y, -x, 0]]
    >>> move = np.vstack([of_node(*place) for place in places.values()])  # of a rigid body of 2 kg and 0.01 kg m² about its middle
    >>> at_middle = -np.diag([1 / 2] * 3 + [1 / 0.01] * 3) / (2 * np.pi * 10.0) ** 2
    >>> measured = jointid.FrfSet((move @ at_middle @ move.T)[None], [10.0], dofs, nodes=places)
    >>> point = jointid.virtual_points(measured, {"name": "VP1", "position": [0, 0, 0], "sensors": dofs, "impacts": dofs})
    >>> point.responses[3], bool(np.allclose(point.frfs[0], at_middle))
    ('VP1:+RX', True)
    """
    many = [points] if isinstance(points, Mapping) else list_of(points, "points", "give a dict with the keys of [[virtual_points]], or a list")
    table: dict[str, Any] = {"virtual_points": [table_of(point, "points") for point in many]}
    if nodes is not None:
        table["nodes"] = {str(node): place for node, place in table_of(nodes, "nodes").items()}
    scene = Scene(table)
    path = scene.add(frfs) if isinstance(frfs, FrfSet) else path_of(frfs, "frfs")
    with scene.errors():
        return FrfSet._of(_jointid.virtual_points(scene.text, scene.file, path))
