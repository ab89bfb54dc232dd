"""The commands of a joint: identify, check, plan, bound, study, compare."""

from __future__ import annotations

import difflib
import os
import shutil
import tempfile
import weakref
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from . import _jointid
from ._run import run_scene, with_options
from ._scene import Scene, as_list, list_of, pair_of, path_of, table_of, whole_number
from .errors import InputError, short
from ._lines import LineSolution
from .frf_set import dofs_of
from .results import BoundResult, Result, Solution


def _joint_table(joint: Any) -> dict[str, Any]:
    """[joint] or [[joints]]; a word in place of a matrix is its pattern."""
    def table(each: Any) -> dict[str, Any]:
        if not isinstance(each, Mapping):
            raise InputError(f"{short(each)} is no joint", place="joint",
                             remedy='give e.g. {"dofs": ["4:+Y", "5:+Y"], "stiffness": "symmetric"}')
        matrices = ("stiffness", "mass", "viscous_damping", "hysteretic_damping")
        return {key: {"pattern": value} if key in matrices and isinstance(value, str) else value for key, value in each.items()}

    if isinstance(joint, (list, tuple)):
        return {"joints": [table(each) for each in joint]}
    return {"joint": table(joint)}


def frequency_table(frequency: Any) -> dict[str, Any]:
    return dict(frequency) if isinstance(frequency, Mapping) else {"range": list(pair_of(frequency, "frequency"))}


def is_scene(value: Any) -> bool:
    return isinstance(value, Mapping) or (isinstance(value, (str, os.PathLike)) and os.fspath(value).endswith(".toml"))


def _scene(substructures: Any, assembly: Any, joint: Any, sections: dict[str, Any]) -> Scene:
    """Of a path or dict (first argument), of that with other data and sections, or of arguments alone."""
    base = sections.pop("scene", None)
    alone = assembly is None and isinstance(substructures, (str, os.PathLike))
    if base is None and joint is None and (alone or is_scene(substructures)):
        base, substructures = substructures, None
    made = {key: value for key, value in sections.items() if value is not None}
    if "data" in made:
        made["data"] = table_of(made["data"], "data")
    if joint is not None:
        made.update(_joint_table(joint))
    if "frequency" in made:
        made["frequency"] = frequency_table(made["frequency"])
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
    own["data"] = {**table_of(own.get("data", {}), "[data]"), **data}
    if "joint" in made:
        own.pop("joints", None)
    if "joints" in made:
        own.pop("joint", None)
    return Scene(own, file=None if isinstance(base, Mapping) else os.fspath(base))


def _identify_table(method: str | None, equations: Any, weighting: str | None, delta: float | None,
                    identify: Mapping[str, Any] | None) -> dict[str, Any] | None:
    table = {} if identify is None else table_of(identify, "identify")
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
    """The joint between substructures, identified from their FRFs and those of the assembly: ``jointid solve``.

    There are three ways to call it:

    - ``identify(scene)`` with a path, or a dict with the keys of a scene file. Sets can replace files in ``data``.
    - ``identify(substructures, assembly, joint)``.
    - ``identify(sets, assembly, scene=path)``: a scene with some of it changed.

    Parameters
    ----------
    substructures, assembly : FrfSet or path, or a list of them
        Several substructures are uncoupled. Several sets of the assembly are blocks of one FRF matrix.
    joint : dict, or a list of dicts with names
        ``{"dofs": [...], "stiffness": "symmetric", "hysteretic_damping": {"springs": [["4:+Y", "5:+Y"]]}}``: as ``[joint]`` of a scene.
        A word in place of a matrix is its pattern.
    method : "auto" (default), "one", "two", "direct", "newton" or "likelihood"
    equations, weighting, delta
        As in ``[identify]``. The argument `identify` takes all other keys of that table.
    frequency : (low, high) in Hz, or a dict with the keys of ``[frequency]``
    noise, truth, nodes, data, virtual_points, title
        The tables of a scene with these names.
    threads : int
        0: all cores. The results do not depend on it.
    progress : None, bool or function of (stage, done, total)
        None: a bar on a terminal and in a notebook.

    Returns
    -------
    Solution
        For a scene with ``[joint] lines`` a LineSolution, as of identify_lines().

    Raises
    ------
    InputError
        For wrong input, with place, value and remedy. For sets the place is their name.

    KeyboardInterrupt
        By Ctrl-C, within 2 s, or if `progress` raises it. Its attribute `partial` is the best Solution so far (``not_converged``),
        or None. This holds for all commands.

    Warns
    -----
    DoubtfulWarning, UnusableWarning
        If ``solution.status`` is "doubtful", or if the numbers are not usable.

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
    kind = LineSolution if _jointid.is_line_scene(scene.text, scene.file) else Solution
    return run_scene(scene, "identify", _jointid.solve, threads=threads, progress=progress, kind=kind)


def identify_lines(substructures: Any = None, assembly: Any = None, joint: Any = None, *, lines: Any = None, way: Any = None,
                   laws: Any = None, threads: int = 0, progress: Any = None, **sections: Any) -> LineSolution:
    """Dynamic stiffness Z_J(ω) of a joint at every line, with 95 % bands: ``jointid solve`` of a scene with ``[joint] lines``.

    The joint is called an isolator or a rubber mount if its law is not known. The field calls this inverse substructuring.

    Parameters
    ----------
    substructures, assembly : FrfSet or path, or a list of them, as in identify()
        The first may be a scene, too.
    joint : dict, or list of DOFs
        The keys of ``[joint]``, ``{"dofs": [...], "smooth": "gcv"}``, or the DOFs alone: those of one part, then those that face them.
    lines : "symmetric", "massless" (default), "masses", "diagonal", or a dict with "matrix" or "springs"
        The structure of Z_J at a line.
    way : str or list of str
        "likelihood" (default), "primal", "dual", "relative" …; the first is the result.
    laws : str or list of str
        Laws fitted to the lines: "all", "zener", "kelvin-voigt" …
    sections : identify, frequency, noise, nodes, data, virtual_points, title, scene
        The tables of a scene with these names. FRFs need variances: their own, or a law in `noise`.

    Returns
    -------
    LineSolution
        ``solution.z`` [line, element], ``solution.band``, ``solution.laws``, ``solution.dynamic_stiffness()``, ``solution.plot()``.

    Raises
    ------
    InputError
        For wrong input, with place, value and remedy.

    >>> import jointid, tempfile
    >>> solution = jointid.identify_lines(jointid.write_problem("isolator", tempfile.mkdtemp()))
    >>> solution.elements[0], solution.z.shape == (len(solution.frequency), len(solution.elements)), next(iter(solution.laws))
    ('z(1,1)', True, 'fractional-zener')
    """
    if joint is not None and not isinstance(joint, Mapping):
        joint = {"dofs": [joint] if isinstance(joint, str) else list_of(joint, "joint", 'give DOFs, or a dict with "dofs"')}
    chosen = {key: value for key, value in (("lines", lines), ("way", way), ("laws", laws)) if value is not None}
    if joint is not None:
        joint = {"lines": "massless", **joint, **chosen}
    scene = _joint_scene(substructures, assembly, joint, None, None, None, None, sections.pop("identify", None), sections)
    if joint is None and chosen:
        table = Scene.table_of(scene.file) if scene.is_file else None
        if table is None or not isinstance(table.get("joint"), Mapping):
            raise InputError("lines, way and laws change the [joint] of a scene file", place="identify_lines",
                             remedy="give them in the dict of the joint")
        scene = Scene({**table, "joint": {**table["joint"], **chosen}}, file=scene.file)
    if not _jointid.is_line_scene(scene.text, scene.file):
        raise InputError("its joint has no `lines`", file=scene.file, place="[joint]",
                         remedy='add lines = "massless" or another structure, or call identify()')
    return run_scene(scene, "identify_lines", _jointid.solve, threads=threads, progress=progress, kind=LineSolution)


def check(substructures: Any = None, assembly: Any = None, joint: Any = None, *, threads: int = 0, progress: Any = None,
          identify: Mapping[str, Any] | None = None, **sections: Any) -> Result:
    """Errors in the FRFs, such as signs, labels, units, axes, loose joints: ``jointid check``. Arguments are those of identify().

    ``result.status`` is "clean", "suspicious" or "wrong"; ``result.findings`` has the suspects with their remedies.

    Raises
    ------
    InputError
        For wrong input, as identify(). FRFs that are wrong are findings, not errors.

    >>> import jointid, tempfile
    >>> jointid.check(jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)).status
    'clean'
    """
    scene = _joint_scene(substructures, assembly, joint, None, None, None, None, identify, sections)
    return run_scene(scene, "check", _jointid.check, threads=threads, progress=progress)


def plan(substructures: Any = None, assembly: Any = None, joint: Any = None, *, method: str | None = None,
         equations: Sequence[str] | None = None, weighting: str | None = None, delta: float | None = None,
         identify: Mapping[str, Any] | None = None, threads: int = 0, progress: Any = None, **sections: Any) -> Result:
    """The plan of identify(): what it would read, compute and leave out: ``jointid plan``. Arguments are those of identify().

    Raises
    ------
    InputError
        For wrong input, as identify().

    >>> import jointid, tempfile
    >>> plan = jointid.plan(jointid.write_problem("A1", tempfile.mkdtemp(), clean=True))
    >>> plan["method"], len(plan["frequency_hz"])
    ('one', 31)
    """
    scene = _joint_scene(substructures, assembly, joint, method, equations, weighting, delta, identify, sections)
    return run_scene(scene, "plan", _jointid.plan, threads=threads, progress=progress)


def bound(substructures: Any = None, assembly: Any = None, joint: Any = None, *, candidates: Iterable[str] = (),
          method: str | None = None, equations: Sequence[str] | None = None, weighting: str | None = None,
          delta: float | None = None, identify: Mapping[str, Any] | None = None, threads: int = 0, progress: Any = None,
          **sections: Any) -> BoundResult:
    """Cramér–Rao bounds of a test, and the effect of other data: ``jointid plan --bound``. Arguments are those of identify().

    It needs the noise (`noise`, or errors in the files) and an assumed joint (`truth`, or ``identify={"start": ...}``).

    Parameters
    ----------
    candidates : sequence of DOFs
        DOFs of the sets that count as not measured. The result has the benefit of each.

    Raises
    ------
    InputError
        For wrong input, as identify(), without noise or an assumed joint, and for candidates that no set has.

    >>> import jointid, tempfile
    >>> scene = jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)
    >>> bound = jointid.bound(scene=scene, noise={"model": "gaussian", "level": 0.02})["bound"]
    >>> bound["unknowns"][0]["name"], 0 < bound["unknowns"][0]["relative"] < 0.05
    ('K(1,1)', True)
    """
    scene = _joint_scene(substructures, assembly, joint, method, equations, weighting, delta, identify, sections)
    return run_scene(scene, "bound", _jointid.bound, [str(dof) for dof in dofs_of(candidates, "candidates")], threads=threads, progress=progress,
                     kind=BoundResult)


def _kept(result: Result, folder: str | None) -> Result:
    """The result, with whose end a folder of its own ends."""
    if folder is not None:
        weakref.finalize(result, shutil.rmtree, folder, ignore_errors=True)
    return result


def study(substructures: Any = None, assembly: Any = None, joint: Any = None, *, trials: int = 1000, seed: int = 1,
          out: str | os.PathLike | None = None, resume: bool = False, method: str | None = None,
          equations: Sequence[str] | None = None, weighting: str | None = None, delta: float | None = None,
          identify: Mapping[str, Any] | None = None, threads: int = 0, progress: Any = None, **sections: Any) -> Result:
    """Repeated identification with simulated noise (Monte-Carlo study): ``jointid study``. Arguments are those of identify().

    Parameters
    ----------
    trials, seed : whole numbers
    out : path, optional
        File of all trials, HDF5 (CSV for friction laws). None deletes them with the result.
    resume : bool
        Continue an interrupted study with the same `out`.

    Raises
    ------
    InputError
        For wrong input, as identify(), and for an `out` that is another study or cannot be written.

    >>> import jointid, tempfile
    >>> found = jointid.study(jointid.write_problem("A1", tempfile.mkdtemp(), clean=True), trials=20, method="one")
    >>> found["trials"]["ok"], len(found["unknowns"])
    (20, 20)
    """
    scene = _joint_scene(substructures, assembly, joint, method, equations, weighting, delta, identify, sections)
    folder = tempfile.mkdtemp(prefix="jointid-") if out is None else None
    path = path_of(out, "out") if out is not None else os.path.join(folder or "", "study.h5")
    try:
        result = run_scene(scene, "study", _jointid.study, whole_number(trials, "trials"), whole_number(seed, "seed"), path, bool(resume),
                      threads=threads, progress=progress)
    except BaseException as error:
        if folder is not None:
            shutil.rmtree(folder, ignore_errors=True)
        elif isinstance(error, KeyboardInterrupt) and os.path.exists(f"{path}.partial"):
            error.args = (f"interrupted; {path}.partial keeps the trials so far, the same call with resume=True goes on",)
        raise
    return _kept(result, folder)


def compare(substructures: Any = None, assembly: Any = None, joint: Any = None, *, trials: int = 200, seed: int = 1,
            methods: Sequence[str] | None = None, equation_sets: Sequence[Sequence[str]] | None = None,
            weightings: Sequence[str] | None = None, deltas: Sequence[float] | None = None, solvers: Sequence[str] | None = None,
            regenerate: Sequence[str] | None = None, identify: Mapping[str, Any] | None = None, threads: int = 0,
            progress: Any = None, **sections: Any) -> Result:
    """Methods compared by error and run time, on the same trials with simulated noise: ``jointid compare``.

    It needs `truth` and `noise`, or a scene with them. Other arguments are those of identify().

    Parameters
    ----------
    methods, equation_sets, weightings, deltas, solvers, regenerate
        Lists. Every combination is tried. A list that is not given has the choice of the scene.

    Raises
    ------
    InputError
        For wrong input, as identify(), and without `truth` or `noise`.

    >>> import jointid, tempfile
    >>> scene = jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)
    >>> ways = jointid.compare(scene, trials=3, methods=["one", "two"], weightings=["WA"])["combinations"]
    >>> [way["method"] for way in ways]
    ['one', 'two']
    """
    scene = _joint_scene(substructures, assembly, joint, None, None, None, None, identify, sections)
    task = with_options(_jointid.CompareTask(), {
        "trials": whole_number(trials, "trials"), "seed": whole_number(seed, "seed"), "methods": methods, "equations": equation_sets,
        "weightings": weightings, "deltas": deltas, "solvers": solvers, "regenerate": regenerate}, "compare")
    return run_scene(scene, "compare", _jointid.compare, task, threads=threads, progress=progress)
