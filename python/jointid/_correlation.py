"""How FRFs or modes of two sources agree, and FRFs where nothing was measured: correlate, expand."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from . import _jointid
from ._run import NoScene, run_task
from ._scene import Scene, path_of, text_of, whole_number
from .errors import InputError, short
from .frf_set import FrfSet
from .results import FrfResult, Result


class Correlation(Result):
    """Criteria of correlate(). Of FRFs ``frac``, ``lac`` … have one number an FRF; of modes ``mac`` is a matrix.

    Criteria are between 0 and 1. A criterion that was not asked for raises KeyError.

    >>> import jointid, numpy as np
    >>> frfs = jointid.FrfSet(np.arange(1.0, 7.0).reshape(3, 2, 1), [10.0, 20.0, 30.0], ["1:+Z", "2:+Z"], ["1:+Z"], name="beam")
    >>> found = jointid.correlate(frfs, 2 * frfs, fdac="1:+Z")
    >>> found.frac.shape, found.fdac.shape, bool(np.isnan(found.chi_square_ratio))
    ((2,), (3, 3), True)
    """

    def _column(self, name: str) -> np.ndarray:
        return np.array([each[name] for each in self["frfs"]], dtype=float)

    @property
    def frac(self) -> np.ndarray:
        """[FRF], in the order of ``self["frfs"]``."""
        return self._column("frac")

    @property
    def chi_square_ratio(self) -> float:
        """χ² over degrees of freedom of all FRFs. NaN if neither set states its noise."""
        return np.nan if self["chi_square"] is None else self["chi_square"] / self["degrees_of_freedom"]

    @property
    def fdac(self) -> np.ndarray:
        """[line, line] of the reference that was asked for. Lines of the first set are rows."""
        return np.array(self["fdac"]["rows"], dtype=float)

    @property
    def mac(self) -> np.ndarray:
        """[mode of the first, mode of the other]."""
        return np.array(self["mac"], dtype=float)


def correlate(one: Any, other: Any, *, modes: bool = False, fdac: str | None = None, progress: Any = None) -> Correlation:
    """Criteria of agreement of FRFs (FRAC, LAC, FDAC, shape and amplitude of each line) beside χ²/f: ``jointid correlate``.

    Parameters
    ----------
    one, other : FrfSet or path
        FRFs of the same structure; DOFs and lines that both have are compared.
    modes : bool
        Compare mode shapes of universal files (dataset 55): MAC, CoMAC, ECoMAC.
    fdac : a reference
        ``result.fdac`` is its FDAC.

    Raises
    ------
    InputError
        For sets without a common DOF or line, and files that cannot be read.

    >>> import jointid, numpy as np
    >>> f = np.arange(10.0, 50.0)
    >>> mass = lambda m: jointid.FrfSet(-1 / (m * (2 * np.pi * f) ** 2).reshape(-1, 1, 1), f, ["1:+X"], name="mass")
    >>> found = jointid.correlate(mass(1.0), mass(2.0))
    >>> round(float(found.frac[0]), 12), round(found["frfs"][0]["error_db"], 3)  # FRAC does not see a factor
    (1.0, 6.021)
    """
    scene = Scene({})
    first, second = _file_of(scene, one, "one"), _file_of(scene, other, "other")
    if modes and any(isinstance(each, FrfSet) for each in (one, other)):
        raise InputError("an FrfSet has no mode shapes", place="modes", remedy="give universal files with dataset 55, or leave modes out")
    if modes and fdac is not None:
        raise InputError("FDAC is of FRFs, not of modes", place="fdac", remedy="leave out modes or fdac")
    reference = "" if fdac is None else text_of(fdac, "fdac", 'give a reference such as "1:+Z"')
    return run_task(NoScene(scene, files=[first, second]), "correlate", progress,
                    lambda watch: _jointid.correlate(first, second, bool(modes), reference, watch), Correlation)


def expand(parent: Any, measured: Any, *, way: str = "extended", modes: int = 0, progress: Any = None) -> FrfResult:
    """FRFs at coordinates that were not measured, from a parent model: ``jointid expand`` (SEMM, SEREP).

    Parameters
    ----------
    parent : FrfSet or path
        FRFs of the model between all its coordinates. For way "serep" a universal file with its modes.
    measured : FrfSet or path
        FRFs at some of them.
    way : "extended" or "semm" (system equivalent model mixing), or "serep"
    modes : int
        Modes that "serep" keeps, the first so many. 0 for all.

    Returns
    -------
    FrfResult
        ``result.frfs()`` has all coordinates. A joint where nothing was measured is that of the parent.

    Raises
    ------
    InputError
        For an unknown way, sets without common coordinates or lines, gaps of the parent, and more modes than the coordinates distinguish.

    >>> import jointid, numpy as np
    >>> f = np.arange(10.0, 20.0)
    >>> def chain(k):  # two masses on springs
    ...     stiffness, omega = np.array([[2 * k, -k], [-k, k]]), 2 * np.pi * f.reshape(-1, 1, 1)
    ...     return jointid.FrfSet(np.linalg.inv(stiffness - omega**2 * np.eye(2)), f, ["1:+X", "2:+X"], name="chain")
    >>> truth, model = chain(2e4), chain(3e4)
    >>> all_dofs = jointid.expand(model, truth.sel(["1:+X"], ["1:+X"])).frfs()
    >>> bool(np.allclose(all_dofs["1:+X", "1:+X"], truth["1:+X", "1:+X"]))
    True
    """
    if way not in ("extended", "semm", "serep"):
        raise InputError(f"{short(way)} is no way", place="way", remedy='use "extended", "semm" or "serep"')
    if modes and way != "serep":
        raise InputError(f'way "{way}" has FRFs for a parent, no modes', place="modes", remedy='use way="serep", or leave modes out')
    scene = Scene({})
    first, second = _file_of(scene, parent, "parent"), _file_of(scene, measured, "measured")
    return run_task(NoScene(scene, files=[first, second]), "expand", progress,
                    lambda watch: _jointid.expand(first, second, way, whole_number(modes, "modes"), watch), FrfResult)


def _file_of(scene: Scene, of: Any, name: str) -> str:
    return scene.add(of) if isinstance(of, FrfSet) else path_of(of, name)
