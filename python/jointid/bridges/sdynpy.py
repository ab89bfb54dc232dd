"""SDynPy: TransferFunctionArray (NDDataArray) and its .npz files."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from .._scene import path_of
from ..errors import InputError
from ..frf_set import FrfSet
from ._pairs import dof_of, numbers_of, set_of_pairs

_FRF = 4  # FunctionTypes.FREQUENCY_RESPONSE_FUNCTION


def from_sdynpy(data: Any, *, quantity: str, unit: str | None = None, name: str = "sdynpy") -> FrfSet:
    """A set from a TransferFunctionArray, or from the path of its .npz.

    The array has no quantity: give `quantity` (or `unit`). Its fields are abscissa [line], ordinate [line] and coordinate
    [(response, reference)], each with a node and a direction ±1 to ±6.
    Frequencies are in Hz.

    Raises
    ------
    InputError
        For a file or an array without FRFs, and for directions that are none.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.sdynpy import from_sdynpy, structured
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:-Z"], ["1:+Z"])
    >>> from_sdynpy(structured(frfs), quantity="receptance") == frfs
    True
    """
    if isinstance(data, (str, os.PathLike)):
        if not os.path.isfile(data):
            raise InputError("there is no such file", file=os.fspath(data), kind="data", remedy="check its path")
        with np.load(os.fspath(data), allow_pickle=False) as archive:
            if "data" not in archive:
                raise InputError("there is no array 'data'", file=os.fspath(data), kind="data", remedy="save it by NDDataArray.save()")
            if int(np.asarray(archive.get("function_type", _FRF))) != _FRF:
                raise InputError("the functions are no FRFs", file=os.fspath(data), kind="data", remedy="save a TransferFunctionArray")
            data = archive["data"]
    fields = {key: np.asarray(_field(data, key)) for key in ("abscissa", "ordinate", "coordinate")}
    lines = fields["abscissa"].shape[-1]
    abscissa, ordinate = (fields[key].reshape(-1, lines) for key in ("abscissa", "ordinate"))
    coordinates = fields["coordinate"].reshape(len(abscissa), -1)
    if coordinates.shape[1] != 2:
        raise InputError(f"each function has {coordinates.shape[1]} coordinates", place="coordinate", kind="data",
                         remedy="FRFs have two: response and reference")
    pairs = [(_dof(pair[0]), _dof(pair[1]), x, y) for pair, x, y in zip(coordinates, abscissa, ordinate)]
    return set_of_pairs(pairs, quantity=quantity, unit=unit, name=name)


def _field(data: Any, key: str) -> Any:
    if getattr(getattr(data, "dtype", None), "names", None):
        return data[key]
    if not hasattr(data, key):
        raise InputError(f"{type(data).__name__} has no {key!r}", place="data", kind="data", remedy="give a TransferFunctionArray")
    return getattr(data, key)


def _dof(coordinate: Any) -> Any:
    return dof_of(coordinate["node"], coordinate["direction"], "coordinate")


def to_sdynpy(frfs: FrfSet) -> Any:
    """``sdynpy.data_array(FunctionTypes.FREQUENCY_RESPONSE_FUNCTION, …)``: ordinates [response, reference, line] in SI units.

    Needs sdynpy, else ImportError. A DOF without a node number raises InputError.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.sdynpy import to_sdynpy
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:-Z"], ["1:+Z"])
    >>> array = to_sdynpy(frfs)  # doctest: +SKIP
    """
    import sdynpy

    array = structured(frfs)
    coordinates = sdynpy.coordinate_array(node=array["coordinate"]["node"], direction=array["coordinate"]["direction"])
    return sdynpy.data_array(sdynpy.data.FunctionTypes.FREQUENCY_RESPONSE_FUNCTION, array["abscissa"], array["ordinate"], coordinates)


def structured(frfs: FrfSet) -> np.ndarray:
    """The structured array [response, reference] of SDynPy, made without SDynPy: abscissa in Hz, ordinate in SI units.

    A DOF without a node number raises InputError.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.sdynpy import structured
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:-Z"], ["1:+Z"])
    >>> array = structured(frfs)
    >>> array["ordinate"].shape, array["coordinate"]["direction"][1, 0].tolist()
    ((2, 1, 3), [-3, 3])
    """
    coordinate = np.dtype([("node", "<u8"), ("direction", "i1")])
    array = np.zeros(frfs.shape[1:], dtype=[("abscissa", "<f8", (len(frfs),)), ("ordinate", "<c16", (len(frfs),)), 
                                            *((f"comment{k}", "<U80") for k in range(1, 6)), ("coordinate", coordinate, (2,))])
    array["abscissa"] = frfs.frequency
    array["ordinate"] = np.moveaxis(frfs.frfs, 0, -1)
    for row, response in enumerate(frfs.responses):
        for column, reference in enumerate(frfs.references):
            array["coordinate"][row, column] = [numbers_of(response), numbers_of(reference)]
    return array


def save_sdynpy(path: str | os.PathLike, frfs: FrfSet) -> None:
    """Writes the .npz for ``sdynpy.data.NDDataArray.load()``. Does not need SDynPy.

    A DOF without a node number raises InputError, a folder that is not there OSError.

    >>> import numpy as np, jointid, tempfile
    >>> from jointid.bridges.sdynpy import from_sdynpy, save_sdynpy
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:-Z"], ["1:+Z"])
    >>> path = f"{tempfile.mkdtemp()}/beam.npz"
    >>> save_sdynpy(path, frfs)
    >>> from_sdynpy(path, quantity="receptance") == frfs
    True
    """
    np.savez(path_of(path, "path"), data=structured(frfs), function_type=_FRF)
