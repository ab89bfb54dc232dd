"""Motions and forces of a steady state as sets."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from .errors import InputError, short
from .frf_set import FrfSet, complex_numbers, dofs_of

_KINDS = {"displacement": "receptance", "velocity": "mobility", "acceleration": "accelerance", "force": "receptance"}


def phasors(values: Any, frequency: Any, dofs: Iterable[str], *, kind: str = "displacement", variance: Any = None,
            name: str = "phasors") -> FrfSet:
    """Phasors of one force level as a set, for ``[[data.levels]]`` of friction_laws(): x(t) = Re(X e^{iωt}), peak values.

    Parameters
    ----------
    values : array, complex, [line, DOF]
        In m, m/s, m/s² or N (rotations in rad, moments in N·m). NaN where not measured.
    frequency : array, Hz, [line]
        Frequency of each line, strictly increasing. Harmonic n of a force at f is at n·f.
    dofs : sequence of DOFs
    kind : "displacement", "velocity", "acceleration" or "force"
    variance : array, [line, DOF], optional
        A real array is the variance of real and imaginary part each. A complex array is variance of the real part + i · variance of
        the imaginary part.
    name : str
        Name of the set in messages.

    Returns
    -------
    FrfSet
        With one reference, which has no meaning.

    Raises
    ------
    InputError
        For another kind, or for shapes that do not agree.

    >>> import numpy as np
    >>> phasors(np.full((3, 1), 2.0 + 0j), [80.0, 85.0, 90.0], ["1:+Y"], kind="force", name="2 N").shape
    (3, 1, 1)
    """
    if kind not in _KINDS:
        raise InputError(f"{short(kind)} is no kind of phasor", place="kind", remedy="give one of " + ", ".join(_KINDS))
    array = complex_numbers(values, "values")
    if array.ndim != 2:
        raise InputError(f"it has {array.ndim} axes, not 2", place="values", kind="data", remedy="the axes are [line, DOF]")
    own = dofs_of(dofs, "dofs")
    return FrfSet(array[:, :, None], frequency, own, own[:1], quantity=_KINDS[kind],
                  variance=None if variance is None else np.asarray(variance)[..., None], name=name)
