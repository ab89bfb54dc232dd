"""Joints for finite-element programs: export."""

from __future__ import annotations

import os
import tempfile
from typing import Any

from . import _jointid
from ._progress import watcher
from ._run import NoScene, stopped
from ._scene import path_of, text_of, whole_number, write_text
from .errors import InputError
from .results import Result, Solution


def export(of: Any, out: str | os.PathLike | None = None, *, to: str, way: str = "auto", units: str = "SI", band: int = 0,
           first_id: int = 900001, threads: int = 0, progress: Any = None) -> dict[str, str]:
    """A joint as cards of a finite-element program, the standard error of each value beside it: ``jointid export``.

    Parameters
    ----------
    of : path or Solution
        A scene, which is solved, the JSON of ``jointid solve``, or a result of identify().
    out : path, optional
        Beginning of the names of files that are written.
    to : "nastran", "ansys", "abaqus" or "matrix-market"
    way : "auto", "springs", "bush" or "matrix"
        Elements: CELAS2, COMBIN14, ``*SPRING``; CBUSH, ``*CONNECTOR``; DMIG, MATRIX27, ``*MATRIX INPUT``.
    units : "SI", or "mm" for N, mm, s, t
    band : int
        Which frequency band of the joint, from 1. 0: it has one.
    first_id : int
        Number of the first element, property and type.

    Returns
    -------
    dict of str
        Text of each file by the ending of its name. Covariances are in SI units.

    Raises
    ------
    InputError
        For a joint that is not usable, and for what the elements do not hold.

    >>> import jointid, tempfile
    >>> scene = jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)
    >>> files = jointid.export(jointid.identify(scene), to="nastran", way="matrix")
    >>> list(files)
    ['.bdf', '_covariance.csv']
    >>> "$ case control: K2GG = KJOINT" in files[".bdf"]
    True
    """
    if units not in ("SI", "mm"):
        raise InputError(f"{units!r} is no system of units", place="units", remedy='use "SI" or "mm"')
    if isinstance(of, Result) and not isinstance(of, Solution):
        raise InputError(f"a {type(of).__name__} has no joint of matrices", place="of", remedy="give a path or a result of identify()")
    with tempfile.TemporaryDirectory() as folder:
        file = path_of(of, "of") if not isinstance(of, Solution) else os.path.join(folder, "result.json")
        if isinstance(of, Solution):
            of.save(file)
        names = NoScene(names={file: "the solution"} if isinstance(of, Solution) else {})
        with stopped(names, "export", Result), watcher(progress) as watch, names.errors():
            found = dict(_jointid.export_joint(file, text_of(to, "to", "write e.g. nastran"), text_of(way, "way", "write e.g. auto"), units == "mm", whole_number(band, "band"),
                                               whole_number(first_id, "first_id"), whole_number(threads, "threads"), watch))
        files = found if not isinstance(of, Solution) else \
            {ending: text.replace(file, "a solution of jointid.identify()") for ending, text in found.items()}
    if out is not None:
        for ending, text in files.items():
            write_text(path_of(out, "out") + ending, text)
    return files
