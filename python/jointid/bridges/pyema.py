"""pyEMA and sdypy-EMA, pyFRF: FRFs of one input, [location, line]."""

from __future__ import annotations

from typing import Any, Iterable

import numpy as np

from ..errors import InputError
from ..frf_set import FrfSet


def from_pyema(frequency: Any, frf: Any, responses: Iterable[str], reference: str, *, frf_type: str = "accelerance",
               name: str = "pyEMA") -> FrfSet:
    """A set from the arrays of ``pyEMA.Model(frf, freq)``, [location, line]. They have no DOFs, so you name them.

    Parameters
    ----------
    frequency : array [line], Hz
    frf : complex array [location, line], SI units
    responses : the DOF of each location
    reference : the DOF of the force
    frf_type : "accelerance" (default, as in pyEMA), "mobility" or "receptance"

    Raises
    ------
    InputError
        For an array of other axes, and for DOFs that are not as many as the locations.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.pyema import from_pyema
    >>> from_pyema([10.0, 20.0, 30.0], np.ones((2, 3), complex), ["1:+Z", "2:+Z"], "1:+Z").shape
    (3, 2, 1)
    """
    array = np.asarray(frf)
    if array.ndim != 2:
        raise InputError(f"its shape is {array.shape}", place="frf", kind="data", remedy="the axes are [location, line]")
    return FrfSet(np.ascontiguousarray(array.T)[:, :, None], frequency, responses, [reference], quantity=frf_type, name=name)


def to_pyema(frfs: FrfSet, reference: str | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Frequency [line], Hz, and FRFs [location, line] of one reference, for ``pyEMA.Model(frf, frequency)``.

    The FRFs are in SI units, of the quantity of the set: give it to pyEMA as ``frf_type``.

    Raises
    ------
    InputError
        For a set with several references, where none is named.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.pyema import to_pyema
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:+Z"], ["1:+Z"])
    >>> frequency, frf = to_pyema(frfs)
    >>> frf.shape
    (2, 3)
    """
    if reference is None and len(frfs.references) > 1:
        raise InputError(f"{frfs.name} has {len(frfs.references)} references", place="reference", kind="data",
                         remedy="name one: " + ", ".join(frfs.references[:12]))
    column = frfs.references[0] if reference is None else reference
    return frfs.frequency, np.ascontiguousarray(np.stack([frfs[response, column] for response in frfs.responses]))


def from_pyfrf(frf: Any, response: str | Iterable[str], reference: str | Iterable[str], *, name: str = "pyFRF") -> FrfSet:
    """A set of receptances from a ``pyFRF.FRF`` (``sdypy.FRF.FRF``) after its measurements, by H1.

    Coherence and number of measurements come with it, if there is one excitation and more than one measurement. A line without a
    finite value, as that at 0 Hz of accelerations, is not measured.

    Parameters
    ----------
    response, reference : DOF or DOFs, in the order of the measurement's responses and excitations

    Raises
    ------
    InputError
        For DOFs that are not as many as the FRFs.

    >>> import numpy as np, types, jointid
    >>> from jointid.bridges.pyema import from_pyfrf
    >>> measured = types.SimpleNamespace(get_f_axis=lambda: [10.0, 20.0, 30.0], get_H1=lambda: np.ones(3) * 1e-6)  # in place of pyFRF
    >>> from_pyfrf(measured, "2:+Z", "1:+Z").quantity
    'receptance'
    """
    rows, columns = ([each] if isinstance(each, str) else list(each) for each in (response, reference))
    frequency = np.asarray(frf.get_f_axis())
    h1 = np.asarray(frf.get_H1()).reshape(-1, len(frequency))  # [response, excitation, line]; older versions: [line]
    if len(h1) != len(rows) * len(columns):
        raise InputError(f"{len(h1)} FRFs for {len(rows)} × {len(columns)} DOFs", place="response, reference", kind="data",
                         remedy="name all responses and excitations")
    shape = (len(rows), len(columns), len(frequency))
    frfs = np.moveaxis(np.where(np.isfinite(h1), h1, np.nan).reshape(shape), -1, 0)
    count = float(getattr(frf, "total_meas", 0) or getattr(frf, "curr_meas", 0) or 0)
    coherence = None
    if count >= 2 and len(columns) == 1:  # of several excitations it is the multiple coherence, which is of no single FRF
        found = np.asarray(frf.get_coherence()).real.reshape(len(rows), 1, -1)
        coherence = np.moveaxis(np.clip(np.where(np.isfinite(found), found, 0.0), 0.0, 1.0), -1, 0)
    return FrfSet(frfs, frequency, rows, columns, quantity="receptance", coherence=coherence, averages=count, name=name)
