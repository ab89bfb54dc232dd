"""The commands as functions."""

from __future__ import annotations

import difflib
import os
import shutil
import sys
import tempfile
import warnings
import weakref
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np

from . import _jointid
from ._progress import watcher
from ._scene import Scene, as_list, pair_of, paths_of
from .dof import Dof
from .errors import DoubtfulWarning, InputError, UnusableWarning
from .frf_set import FrfSet
from .results import FrfResult, Result, Solution

PathOrSet = Any  # str, os.PathLike or FrfSet


def _warn(result: Result, what: str) -> None:
    """At the caller's line, who is outside of this package."""
    level = 1
    while sys._getframe(level).f_globals.get("__name__", "").partition(".")[0] == __name__.partition(".")[0]:
        level += 1
    if not result.usable and result.status not in ("suspicious", "wrong"):
        warnings.warn(f"{what}: {result.status or 'not usable'}: {result.message}", UnusableWarning, stacklevel=level + 1)
    elif result.status == "doubtful":
        warnings.warn(f"{what}: doubtful: {result.message}", DoubtfulWarning, stacklevel=level + 1)


def _run(scene: Scene, command: str, function: Callable, *options: Any, threads: int = 0, progress: Any = None,
         kind: type[Result] = Result) -> Any:
    if not isinstance(threads, int) or isinstance(threads, bool) or threads < 0:
        raise InputError(f"{threads!r} is no number of threads", place="threads", remedy="give 0 for all cores, or how many")
    with watcher(progress) as watch, scene.errors():
        outcome = function(scene.text, scene.file, threads, watch, *options)
    result = kind(outcome, scene, command)
    _warn(result, scene.file if scene.is_file else command)
    return result


def _with_options(task: Any, options: Mapping[str, Any], what: str) -> Any:
    """Sets the attributes of a class of C++; None leaves the default."""
    valid = [name for name in dir(type(task)) if not name.startswith("_")]
    for name, value in options.items():
        if name not in valid:
            near = difflib.get_close_matches(name, valid, 1)
            raise InputError(f"{what} has no option {name!r}", place=name,
                             remedy=f"did you mean {near[0]!r}?" if near else "it has " + ", ".join(valid))
        if value is None:
            continue
        try:
            setattr(task, name, _plain(value))
        except TypeError:
            raise InputError(f"{value!r} is a {type(value).__name__}, which {name} does not take", place=name,
                             remedy=f"see help(jointid.{what})") from None
    return task


def _plain(value: Any) -> Any:
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist") and not isinstance(value, (str, bytes)):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    return value


# Scenes of a joint.


def _joint_table(joint: Any) -> dict[str, Any]:
    """[joint] or [[joints]]; a word in place of a matrix is its pattern."""
    def table(each: Any) -> dict[str, Any]:
        if not isinstance(each, Mapping):
            raise InputError(f"{each!r} is no joint", place="joint",
                             remedy='give e.g. {"dofs": ["4:+Y", "5:+Y"], "stiffness": "symmetric"}')
        matrices = ("stiffness", "mass", "viscous_damping", "hysteretic_damping")
        return {key: {"pattern": value} if key in matrices and isinstance(value, str) else value for key, value in each.items()}

    if isinstance(joint, (list, tuple)):
        return {"joints": [table(each) for each in joint]}
    return {"joint": table(joint)}


def _frequency_table(frequency: Any) -> dict[str, Any]:
    return dict(frequency) if isinstance(frequency, Mapping) else {"range": list(pair_of(frequency, "frequency"))}


def _is_scene(value: Any) -> bool:
    return isinstance(value, Mapping) or (isinstance(value, (str, os.PathLike)) and os.fspath(value).endswith(".toml"))


def _scene(substructures: Any, assembly: Any, joint: Any, sections: dict[str, Any]) -> Scene:
    """Of a path or dict (first argument), of that with other data and sections, or of arguments alone."""
    base = sections.pop("scene", None)
    alone = assembly is None and isinstance(substructures, (str, os.PathLike))
    if base is None and joint is None and (alone or _is_scene(substructures)):
        base, substructures = substructures, None
    made = {key: value for key, value in sections.items() if value is not None}
    if joint is not None:
        made.update(_joint_table(joint))
    if "frequency" in made:
        made["frequency"] = _frequency_table(made["frequency"])
    if base is not None:
        return _changed(base, substructures, assembly, made)
    if substructures is None or assembly is None or joint is None:
        missing = ", ".join(name for name, value in (("substructures", substructures), ("assembly", assembly), ("joint", joint))
                            if value is None)
        raise InputError(f"{missing} is missing", place="identify", remedy="give substructures, assembly and joint, or a scene")
    made["data"] = {**made.get("data", {}), "substructures": as_list(substructures), "assembly": as_list(assembly)}
    return Scene(made)


def _changed(base: Any, substructures: Any, assembly: Any, made: dict[str, Any]) -> Scene:
    """A scene with other data, or other sections whole."""
    data = {key: as_list(value) for key, value in (("substructures", substructures), ("assembly", assembly)) if value is not None}
    if not data and not made:
        return Scene(base)
    own = dict(base) if isinstance(base, Mapping) else Scene.table_of(base)
    for key, value in made.items():
        same = isinstance(value, Mapping) and isinstance(own.get(key), Mapping) and key in ("data", "frequency", "identify", "noise")
        own[key] = {**own[key], **value} if same else value
    own["data"] = {**own.get("data", {}), **data}
    if "joint" in made:
        own.pop("joints", None)
    if "joints" in made:
        own.pop("joint", None)
    return Scene(own, file=None if isinstance(base, Mapping) else os.fspath(base))


def _identify_table(method: str | None, equations: Any, weighting: str | None, delta: float | None,
                    identify: Mapping[str, Any] | None) -> dict[str, Any] | None:
    table = dict(identify or {})
    for key, value in (("method", method), ("equations", equations), ("weighting", weighting), ("delta", delta)):
        if value is not None:
            table[key] = value
    return table or None


def _joint_scene(substructures: Any, assembly: Any, joint: Any, method: str | None, equations: Any, weighting: str | None,
                 delta: float | None, identify: Mapping[str, Any] | None, sections: dict[str, Any]) -> Scene:
    valid = ("scene", "frequency", "noise", "truth", "nodes", "title", "data", "virtual_points")
    for name in sections:
        if name not in valid:
            near = difflib.get_close_matches(name, (*valid, "method", "equations", "weighting", "delta", "identify", "joint"), 1)
            raise InputError(f"there is no option {name!r}", place=name,
                             remedy=f"did you mean {near[0]!r}?" if near else "it has " + ", ".join(valid))
    sections["identify"] = _identify_table(method, equations, weighting, delta, identify)
    return _scene(substructures, assembly, joint, sections)


def identify(substructures: Any = None, assembly: Any = None, joint: Any = None, *, method: str | None = None,
             equations: Sequence[str] | None = None, weighting: str | None = None, delta: float | None = None,
             identify: Mapping[str, Any] | None = None, threads: int = 0, progress: Any = None, **sections: Any) -> Solution:
    """The joint between substructures, from their FRFs and those of the assembly: ``jointid solve``.

    ``identify(scene)``, a path or a dict with the keys of a scene file, in whose ``data`` sets may stand in place of files; or
    ``identify(substructures, assembly, joint)``; or a scene with some of it changed: ``identify(sets, assembly, scene=path)``.

    Parameters
    ----------
    substructures, assembly : FrfSet or path, or a list of them
        Several substructures are uncoupled, several sets of the assembly are parts of one FRF matrix.
    joint : dict, or a list of dicts with names
        ``{"dofs": [...], "stiffness": "symmetric", "hysteretic_damping": {"springs": [["4:+Y", "5:+Y"]]}}``: as ``[joint]`` of a scene;
        a word in place of a matrix is its pattern.
    method : "auto" (default), "one", "two", "direct", "newton" or "likelihood"
    equations, weighting, delta
        As in ``[identify]``; `identify` takes all other keys of that table.
    frequency : (low, high) in Hz, or a dict with the keys of ``[frequency]``
    noise, truth, nodes, data, virtual_points, title
        Those tables of a scene.
    threads : int
        0: all cores. The results do not depend on it.
    progress : None, bool or function of (stage, done, total)
        None: a bar on a terminal and in a notebook.

    Returns
    -------
    Solution

    Raises
    ------
    InputError
        As the command does, with place, value and remedy; for sets the place is their name.

    Warns
    -----
    DoubtfulWarning, UnusableWarning
        Where ``solution.status`` is "doubtful", or says that the numbers are not usable.

    >>> import jointid, tempfile
    >>> folder = tempfile.mkdtemp()
    >>> _ = jointid.write_problem("A1", folder, clean=True)
    >>> parts = [jointid.read(f"{folder}/A1_substructure_{i}.h5") for i in (1, 2)]
    >>> joint = {"dofs": ["4:+Y", "4:+RZ", "5:+Y", "5:+RZ"], "stiffness": "symmetric", "hysteretic_damping": "symmetric"}
    >>> solution = jointid.identify(parts, jointid.read(f"{folder}/A1_assembly.h5"), joint, frequency=(400, 1000))
    >>> solution.status, len(solution.unknowns)
    ('ok', 20)
    """
    scene = _joint_scene(substructures, assembly, joint, method, equations, weighting, delta, identify, sections)
    return _run(scene, "identify", _jointid.solve, threads=threads, progress=progress, kind=Solution)


def check(substructures: Any = None, assembly: Any = None, joint: Any = None, *, threads: int = 0, progress: Any = None,
          identify: Mapping[str, Any] | None = None, **sections: Any) -> Result:
    """Mistakes in the FRFs: signs, labels, units, axes, loose joints: ``jointid check``. Arguments as of identify().

    ``result.status`` is "clean", "suspicious" or "wrong"; ``result.findings`` are the suspects with their remedies.

    >>> import jointid, tempfile
    >>> jointid.check(jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)).status
    'clean'
    """
    scene = _joint_scene(substructures, assembly, joint, None, None, None, None, identify, sections)
    return _run(scene, "check", _jointid.check, threads=threads, progress=progress)


def plan(substructures: Any = None, assembly: Any = None, joint: Any = None, *, method: str | None = None,
         equations: Sequence[str] | None = None, weighting: str | None = None, delta: float | None = None,
         identify: Mapping[str, Any] | None = None, threads: int = 0, progress: Any = None, **sections: Any) -> Result:
    """What identify() would read, compute and leave out, without doing it: ``jointid plan``. Arguments as of identify()."""
    scene = _joint_scene(substructures, assembly, joint, method, equations, weighting, delta, identify, sections)
    return _run(scene, "plan", _jointid.plan, threads=threads, progress=progress)


def bound(substructures: Any = None, assembly: Any = None, joint: Any = None, *, candidates: Iterable[str] = (),
          method: str | None = None, equations: Sequence[str] | None = None, weighting: str | None = None,
          delta: float | None = None, identify: Mapping[str, Any] | None = None, threads: int = 0, progress: Any = None,
          **sections: Any) -> Result:
    """Standard errors that a test can have at best, and what other data would change: ``jointid plan --bound``.

    Needs `noise` (or errors in the files) and a joint to assume: `truth`, or ``identify={"start": ...}``.

    Parameters
    ----------
    candidates : DOFs of the sets that count as not measured yet: what would each of them bring?
    """
    scene = _joint_scene(substructures, assembly, joint, method, equations, weighting, delta, identify, sections)
    return _run(scene, "bound", _jointid.bound, [str(Dof(dof)) for dof in candidates], threads=threads, progress=progress)


def _kept(result: Result, folder: str | None) -> Result:
    """The result, with whose end a folder of its own ends."""
    if folder is not None:
        weakref.finalize(result, shutil.rmtree, folder, ignore_errors=True)
    return result


def study(substructures: Any = None, assembly: Any = None, joint: Any = None, *, trials: int = 1000, seed: int = 1,
          out: str | os.PathLike | None = None, resume: bool = False, method: str | None = None,
          equations: Sequence[str] | None = None, weighting: str | None = None, delta: float | None = None,
          identify: Mapping[str, Any] | None = None, threads: int = 0, progress: Any = None, **sections: Any) -> Result:
    """Identifies over and over with simulated noise: how well does a test see the joint? ``jointid study``. Arguments as of identify().

    Parameters
    ----------
    trials, seed : whole numbers
    out : path, optional
        All trials, HDF5 (CSV of friction laws). Without one they are gone with the result.
    resume : bool
        Continue what an interrupted study with the same `out` left.
    """
    scene = _joint_scene(substructures, assembly, joint, method, equations, weighting, delta, identify, sections)
    folder = tempfile.mkdtemp(prefix="jointid-") if out is None else None
    path = os.fspath(out) if out is not None else os.path.join(folder or "", "study.h5")
    try:
        result = _run(scene, "study", _jointid.study, _whole(trials, "trials"), _whole(seed, "seed"), path, bool(resume),
                      threads=threads, progress=progress)
    except BaseException:
        if folder is not None:
            shutil.rmtree(folder, ignore_errors=True)
        raise
    return _kept(result, folder)


def _whole(value: Any, place: str) -> int:
    try:
        number = value.__index__()
    except AttributeError:
        raise InputError(f"{value!r} is no whole number", place=place, remedy="give e.g. 1000") from None
    if not 0 <= number < 2**64 or isinstance(value, bool):
        raise InputError(f"{value!r} is no number from 0 to 2^64", place=place, remedy="give e.g. 1000")
    return number


def compare(substructures: Any = None, assembly: Any = None, joint: Any = None, *, trials: int = 200, seed: int = 1,
            methods: Sequence[str] | None = None, equation_sets: Sequence[Sequence[str]] | None = None,
            weightings: Sequence[str] | None = None, deltas: Sequence[float] | None = None, solvers: Sequence[str] | None = None,
            regenerate: Sequence[str] | None = None, identify: Mapping[str, Any] | None = None, threads: int = 0,
            progress: Any = None, **sections: Any) -> Result:
    """Ways of identifying by error and run time, on the same trials with simulated noise: ``jointid compare``.

    Needs `truth` and `noise` (or a scene with them).

    Parameters
    ----------
    methods, equation_sets, weightings, deltas, solvers, regenerate
        Every combination of these; those of the scene where a list is not given.
    """
    scene = _joint_scene(substructures, assembly, joint, None, None, None, None, identify, sections)
    task = _with_options(_jointid.CompareTask(), {
        "trials": _whole(trials, "trials"), "seed": _whole(seed, "seed"), "methods": methods, "equations": equation_sets,
        "weightings": weightings, "deltas": deltas, "solvers": solvers, "regenerate": regenerate}, "compare")
    return _run(scene, "compare", _jointid.compare, task, threads=threads, progress=progress)


# Coupling.


def couple(parts: Any, *, join: Any = None, ground: Any = None, keep: Any = None, remove: Any = None, joints: Any = None,
           out: str | os.PathLike | None = None, bounds: bool = False, frequency: Any = None, data: Mapping[str, Any] | None = None,
           virtual_points: Any = None, threads: int = 0, progress: Any = None, **options: Any) -> FrfResult:
    """FRFs of an assembly from those of its parts: ``jointid couple`` (LM-FBS and others).

    ``couple(scene)``, a path or dict, or ``couple(parts, join=...)``.

    Parameters
    ----------
    parts : a scene, or a list of FrfSets and paths
    join : list of lists of DOFs that are one; a DOF that two parts have is "NAME/4:+Y"
    ground, keep : DOFs held in place; DOFs of the result
    remove : parts (or their names) that are taken out again: decoupling
    joints : list of dicts as ``[[couple.joint]]``
    out : path, optional
        Where the FRFs are written (HDF5); without one they stay in memory.
    bounds : bool
        Leave out conditions that the others nearly imply, and predict with them as well.
    options : method, threshold, epsilon, alpha, uncertainty …: other keys of ``[couple]``

    Returns
    -------
    FrfResult
        ``result.frfs()`` is the assembly.

    >>> import numpy as np, jointid
    >>> f = np.linspace(10.0, 20.0, 3)
    >>> mass = lambda m, node: jointid.FrfSet(-1 / (m * (2 * np.pi * f) ** 2).reshape(-1, 1, 1), f, [node], name=node)
    >>> both = jointid.couple([mass(1.0, "1:+X"), mass(2.0, "2:+X")], join=[["1:+X", "2:+X"]]).frfs()
    >>> bool(np.allclose(both["1:+X", "1:+X"], -1 / (3.0 * (2 * np.pi * f) ** 2)))
    True
    """
    table = {"join": join, "ground": ground, "keep": keep, "remove": remove, "joint": joints, **options}
    table = {key: value for key, value in table.items() if value is not None}
    sections = {"couple": table or None, "frequency": None if frequency is None else _frequency_table(frequency),
                "virtual_points": virtual_points}
    sections = {key: value for key, value in sections.items() if value is not None}
    if _is_scene(parts):
        own = dict(parts) if isinstance(parts, Mapping) else Scene.table_of(parts) if sections or data else None
        if own is None:
            scene = Scene(parts)
        else:
            own["data"] = {**own.get("data", {}), **(data or {})}
            own.update({**sections, "couple": {**own.get("couple", {}), **table}})
            scene = Scene(own, file=None if isinstance(parts, Mapping) else os.fspath(parts))
    else:
        sections.setdefault("couple", {})
        scene = Scene({"data": {**(data or {}), "parts": as_list(parts)}, **sections})
    path = "" if out is None else os.fspath(out)
    return _run(scene, "couple", _jointid.couple, path, bool(bounds), threads=threads, progress=progress, kind=FrfResult)


def decouple(assembly: PathOrSet, part: PathOrSet, interface: Sequence[str], **options: Any) -> FrfResult:
    """FRFs of what is left of an assembly without one of its parts: dual decoupling, ``jointid couple`` with ``remove``.

    Parameters
    ----------
    assembly, part : FrfSet or path
    interface : DOFs that both have
        Those of the interface. With internal DOFs of the part as well (extended interface) the conditions depend on each other:
        give ``threshold="fixed"`` or another of couple().
    options : as of couple()

    Returns
    -------
    FrfResult
        ``result.frfs()``: the DOFs of the assembly.
    """
    whole, taken = (each if isinstance(each, FrfSet) else _read(each) for each in (assembly, part))
    if whole.name == taken.name:
        taken = taken._like(name=f"{taken.name} (part)")
    own = {dof.coordinate for dof in taken.dofs}
    coordinates = {dof.coordinate for dof in whole.dofs}
    shared = [Dof(dof) for dof in ([interface] if isinstance(interface, str) else interface)]
    for dof in shared:
        for known, name in ((coordinates, whole.name), (own, taken.name)):
            if dof.coordinate not in known:
                raise InputError(f"{name} has no DOF {dof}", place="interface", kind="data",
                                 remedy="it has " + ", ".join(sorted(known)[:12]))
    join = [[f"{whole.name}/{dof}", f"{taken.name}/{dof}"] for dof in shared]
    options.setdefault("keep", [f"{whole.name}/{dof}" if dof.coordinate in own else str(dof) for dof in whole.dofs])
    return couple([whole, taken], join=join, remove=[taken.name], **options)


def _read(path: Any) -> FrfSet:
    from .frf_set import read

    return read(path)


def virtual_points(frfs: PathOrSet, points: Any, *, nodes: Mapping[Any, Sequence[float]] | None = None) -> FrfSet:
    """FRFs with virtual points in place of the sensors and impacts round interfaces.

    Parameters
    ----------
    frfs : FrfSet or path
    points : dict, or list of dicts, with the keys of ``[[virtual_points]]``
        ``{"name": "VP1", "position": [0, 0, 0], "sensors": ["11:+X", ...], "impacts": ["31:+X", ...]}``; lengths in m.
    nodes : {node: (x, y, z)}, optional
        Positions, before those of the set.
    """
    table: dict[str, Any] = {"virtual_points": [points] if isinstance(points, Mapping) else list(points)}
    if nodes is not None:
        table["nodes"] = {str(node): list(place) for node, place in nodes.items()}
    scene = Scene(table)
    path = scene.add(frfs) if isinstance(frfs, FrfSet) else os.fspath(frfs)
    with scene.errors():
        return FrfSet._of(_jointid.virtual_points(scene.text, scene.file, path))


# Friction, motion.


def equivalent(scene: Any, *, threads: int = 0, progress: Any = None) -> Result:
    """Stiffness and damping of a friction joint against its relative displacement: ``jointid equivalent``; a path or dict."""
    return _run(Scene(scene), "equivalent", _jointid.equivalent, threads=threads, progress=progress)


def friction_laws(scene: Any, *, threads: int = 0, progress: Any = None) -> Result:
    """Friction laws of joints from vibration at several force levels: ``jointid solve`` of scenes with ``[[joint.friction]]``."""
    return _run(Scene(scene), "friction_laws", _jointid.solve, threads=threads, progress=progress)


def response(scene: Any, *, compare: bool = False, threads: int = 0, progress: Any = None) -> Result:
    """Periodic response of structures with friction joints: ``jointid response``; a path or dict.

    `compare`: error against run time of all ways to it instead, ``--compare``.
    """
    function = _jointid.response_ways if compare else _jointid.response
    return _run(Scene(scene), "response", function, threads=threads, progress=progress)


def oscillate(scene: Any, *, threads: int = 0, progress: Any = None) -> Result:
    """Exact stick–slip motion, orbits, exponents, reduced models: ``jointid oscillate``; a path or dict."""
    return _run(Scene(scene), "oscillate", _jointid.oscillate, threads=threads, progress=progress)


# Commands of files and arrays.


class _Named:
    """Stands for a scene where a command has none; `names` by paths that nobody but this package knows."""

    def __init__(self, scene: Scene | None = None, names: Mapping[str, str] | None = None) -> None:
        self._scene = scene or Scene({})
        self._names = names or {}

    def named(self, text: str) -> str:
        for path, name in self._names.items():
            text = text.replace(path, name)
        return self._scene.named(text)

    def errors(self) -> Any:
        return self._scene.errors()


def _result(names: _Named, command: str, progress: Any, run: Callable, kind: type[Result] = Result) -> Any:
    with watcher(progress) as watch, names.errors():
        outcome = run(watch)
    result = kind(outcome, names, command)
    _warn(result, command)
    return result


def modalfit(frfs: Any, *, range: tuple[float, float] | None = None, modes: int | None = None,
             poles: Sequence[tuple[float, float]] | None = None, real: bool = False, damping: str = "viscous",
             quantity: str | None = None, unit: str | None = None, progress: Any = None) -> FrfResult:
    """Modes behind FRFs of one structure, and the FRFs regenerated from them: ``jointid modalfit``.

    Parameters
    ----------
    frfs : FrfSet, path, or several paths
    range : (low, high), Hz
    modes : keep the most significant so many
    poles : (Hz, damping ratio) of modes to refine, instead of seeking
    real : real modes
    damping : "viscous" (ratios) or "hysteretic" (loss factors)

    Returns
    -------
    FrfResult
        ``result["modes"]`` and the rest of the command's JSON; ``result.frfs()`` are the regenerated FRFs.
    """
    from .frf_set import _open_options

    scene = Scene({})
    files = [scene.add(each) if isinstance(each, FrfSet) else os.fspath(each) for each in as_list(frfs)]
    task = _with_options(_jointid.ModalTask(), {"range": range, "modes": modes, "poles": poles, "real": real, "damping": damping},
                         "modalfit")
    options = _open_options(quantity, unit, None, None, None, None)
    return _result(_Named(scene), "modalfit", progress, lambda watch: _jointid.modalfit(files, options, task, watch), FrfResult)


def loading_curve(curves: Any, *, progress: Any = None, **options: Any) -> Result:
    """Friction laws fitted to loading curves (hysteresis backbones) or loops: ``jointid loading-curve``.

    Parameters
    ----------
    curves : path or paths; or (displacement, force), or a list of these or {name: (displacement, force)}
        Arrays in m and N, loaded once from rest.
    options : law, ring, limit, normal_load, friction_coefficient, shared, weighting, minimiser, global_search; of files also
        displacement, force, time, energy, stiffness, damping, unit, force_unit, time_unit, sign, velocity, kind,
        specimen_stiffness, specimen: as those of the command

    >>> import numpy as np, jointid
    >>> u = np.linspace(1e-6, 60e-6, 60)
    >>> jointid.loading_curve((u, np.minimum(1e7 * u, 200.0)), law=["bilinear"])["best_law"]
    'bilinear'
    """
    if isinstance(options.get("law"), str):
        options["law"] = [options["law"]]
    if isinstance(options.get("normal_load"), (int, float)):
        options["normal_load"] = [float(options["normal_load"])]
    task = _with_options(_jointid.LoadingCurveTask(), options, "loading_curve")
    arrays = _curves(curves)
    if arrays is not None:
        return _result(_Named(), "loading_curve", progress, lambda watch: _jointid.loading_curve_arrays(arrays or [], task, watch))
    task.files = paths_of(curves, "curves")
    return _result(_Named(), "loading_curve", progress, lambda watch: _jointid.loading_curve(task, watch))


def _curves(curves: Any) -> list[tuple[str, np.ndarray, np.ndarray]] | None:
    """Name, displacement, force of curves in memory; None of files."""
    if isinstance(curves, Mapping):
        named = list(curves.items())
    elif not isinstance(curves, (list, tuple, np.ndarray)) or all(isinstance(each, (str, os.PathLike)) for each in curves):
        return None
    elif len(curves) == 2 and np.ndim(curves[0]) == 1 and np.ndim(curves[1]) == 1:
        named = [("curve", curves)]
    else:
        named = [(f"curve {k + 1}", curve) for k, curve in enumerate(curves)]
    return [(str(name), np.ascontiguousarray(displacement, dtype=float), np.ascontiguousarray(force, dtype=float))
            for name, (displacement, force) in named]


def frf(files: Any, *, progress: Any = None, **options: Any) -> FrfResult:
    """FRFs with coherences, variances and covariances of time records: ``jointid frf``.

    Parameters
    ----------
    files : path or paths: .npy, CSV or text, MATLAB, HDF5, UFF 58; or an array [sample, channel], or several (one a hit)
    options : channel (["2=1:+Z N", ...]), time, rate, reference, shaker, block, pretrigger, trigger, second_blow, force_window,
        exponential, overlap, window, remove_mean, reject, keep_faulty, estimator, variances, highest: as those of the command

    Returns
    -------
    FrfResult
        ``result.frfs()`` are the FRFs.
    """
    for name in ("channel", "reference"):
        if isinstance(options.get(name), str):
            options[name] = [options[name]]
    task = _with_options(_jointid.FrfTask(), options, "frf")
    with _record_files(files) as (task.files, names):
        return _result(_Named(names=names), "frf", progress, lambda watch: _jointid.frf(task, watch), FrfResult)


@contextmanager
def _record_files(records: Any) -> Iterator[tuple[list[str], dict[str, str]]]:
    """The paths of records, and names of those that are arrays, which are written to a folder that ends with the block."""
    arrays = [records] if isinstance(records, np.ndarray) else records
    if not isinstance(arrays, (list, tuple)) or not all(isinstance(each, np.ndarray) for each in arrays):
        yield paths_of(records, "files"), {}
        return
    with tempfile.TemporaryDirectory(prefix="jointid-") as folder:
        paths = [os.path.join(folder, f"record_{k + 1}.npy") for k in np.arange(len(arrays))]
        for path, array in zip(paths, arrays):
            if array.ndim != 2:
                raise InputError(f"its shape is {array.shape}", place="files", remedy="the axes are [sample, channel]", kind="data")
            np.save(path, np.ascontiguousarray(array, dtype=float))
        yield paths, {path: f"record {k + 1}" for k, path in enumerate(paths)}


def pod(record: Any, *, names: Sequence[str] | None = None, units: Sequence[str] | None = None, threads: int = 0,
        progress: Any = None, **options: Any) -> Result:
    """Proper orthogonal modes of time records of many channels: ``jointid pod``.

    Parameters
    ----------
    record : path or paths, or an array [sample, channel]
        Rows with NaN are missing samples.
    names, units : of the channels of an array
    options : channels (of files), mass, stiffness, compare (files), keep_mean

    >>> import numpy as np, jointid
    >>> t = np.arange(500) / 50
    >>> record = np.column_stack([0.6 * np.cos(2 * np.pi * t), 0.8 * np.cos(2 * np.pi * t)])
    >>> round(jointid.pod(record)["values"][0], 9)
    0.5
    """
    task = _with_options(_jointid.PodTask(), options, "pod")
    if isinstance(record, np.ndarray):
        array = np.ascontiguousarray(record, dtype=float)
        if array.ndim != 2 or array.shape[1] == 0:
            raise InputError(f"its shape is {array.shape}", place="record", remedy="the axes are [sample, channel]", kind="data")
        channels = [str(k + 1) for k in np.arange(array.shape[1])] if names is None else list(names)
        of_channels = [""] * array.shape[1] if units is None else list(units)
        if not len(channels) == len(of_channels) == array.shape[1]:
            raise InputError(f"{len(channels)} names and {len(of_channels)} units for {array.shape[1]} channels", place="names",
                             remedy="give one for each channel", kind="data")
        return _result(_Named(), "pod", progress, lambda watch: _jointid.pod_array(array, channels, of_channels, task, watch))
    task.files = paths_of(record, "record")
    return _result(_Named(), "pod", progress, lambda watch: _jointid.pod(task, threads, watch))


# Built-in problems.


def problems() -> dict[str, str]:
    """Names and descriptions of the built-in problems, whose answers are known: ``jointid problem list``."""
    return _jointid.problems()


def write_problem(name: str, directory: str | os.PathLike, *, format: str = "h5", seed: int = 1, clean: bool = False) -> str:
    """Writes the files, the scene and the truth of a built-in problem into a folder: ``jointid problem write``.

    Returns the path of the scene (of loading curves and modal sets of the file).

    `format`: "h5" or "uff"; `seed`: of the noise; `clean`: no noise.
    """
    return _jointid.write_problem(name, os.fspath(directory), format, seed, clean)
