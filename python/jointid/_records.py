"""Time records in arrays as files for the time of a call."""

from __future__ import annotations

from typing import Any

import numpy as np

from .errors import InputError
from .frf_set import real_numbers

_NUMBERS_AT_ONCE = 2**21


def save_record(path: str, array: Any, place: str) -> None:
    """An array [sample, channel] as .npy, piece by piece: Python looks for Ctrl-C between."""
    if array.ndim != 2 or array.shape[1] == 0:
        raise InputError(f"its shape is {array.shape}", place=place, remedy="the axes are [sample, channel]", kind="data")
    rows = max(1, _NUMBERS_AT_ONCE // array.shape[1])
    with open(path, "wb") as stream:
        np.lib.format.write_array_header_1_0(stream, {"descr": "<f8", "fortran_order": False, "shape": array.shape})
        for first in np.arange(0, len(array), rows):
            stream.write(real_numbers(array[first:first + rows], place).astype("<f8", copy=False).tobytes())
