"""pyEMA and sdypy-EMA, pyFRF: FRFs of one input, [location, line]."""

from __future__ import annotations

from typing import Any, Iterable

import numpy as np

from ..errors import InputError
from ..frf_set import FrfSet


def from_pyema(frequency: Any, frf: Any, responses: Iterable[str], reference: str, *, frf_type: str = "accelerance",
               name: str = "pyEMA") -> FrfSet:
    """A set from the arrays of ``pyEMA.Model(frf, freq)``, [location, line]. They have no DOFs, so you name them."""
    array = np.asarray(frf)
    if array.ndim != 2:
        raise InputError(f"its shape is {array.shape}", place="frf", kind="data", remedy="the axes are [location, line]")
    return FrfSet(np.ascontiguousarray(array.T)[:, :, None], frequency, responses, [reference], quantity=frf_type, name=name)


def to_pyema(frfs: FrfSet, reference: str | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Frequency [line], Hz, and FRFs [location, line] of one reference, for ``pyEMA.Model(frf, frequency)``."""
    if reference is None and len(frfs.references) > 1:
        raise InputError(f"{frfs.name} has {len(frfs.references)} references", place="reference", kind="data",
                         remedy="name one: " + ", ".join(frfs.references[:12]))
    column = frfs.references[0] if reference is None else reference
    return frfs.frequency, np.ascontiguousarray(np.stack([frfs[response, column] for response in frfs.responses]))


def from_pyfrf(frf: Any, response: str, reference: str, *, quantity: str = "accelerance", name: str = "pyFRF") -> FrfSet:
    """A set from a ``pyFRF.FRF`` after its averages: H1 with the coherence and the number of averages."""
    h1 = np.asarray(frf.get_H1()).reshape(-1)
    coherence = np.asarray(frf.get_coherence()).real.reshape(-1)
    count = float(getattr(frf, "curr_meas", 0) or 0)
    shape = (len(h1), 1, 1)
    return FrfSet(h1.reshape(shape), np.asarray(frf.get_f_axis()), [response], [reference], quantity=quantity,
                  coherence=np.clip(coherence, 0.0, 1.0).reshape(shape) if count >= 2 else None, averages=count, name=name)
