"""xarray: a DataArray with the dimensions frequency, output, input."""

from __future__ import annotations

from typing import Any

from ..errors import InputError
from ..frf_set import AXES, FrfSet


def to_xarray(frfs: FrfSet) -> Any:
    """The set as a DataArray [frequency, output, input], which shares its numbers (no copy).

    Its ``attrs`` have quantity and units, its coordinates Hz and the DOFs. Needs xarray, else ImportError.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.xarray import to_xarray
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:+Z"], ["1:+Z"])
    >>> array = to_xarray(frfs)
    >>> array.dims, array.attrs["units"], np.shares_memory(array.values, frfs.frfs)
    (('frequency', 'output', 'input'), 'm/N', True)
    """
    import xarray

    array = xarray.DataArray(frfs.frfs, dims=AXES, name=frfs.name,
                             coords={"frequency": frfs.frequency, "output": [str(dof) for dof in frfs.responses],
                                     "input": [str(dof) for dof in frfs.references]},
                             attrs={"quantity": frfs.quantity, "units": frfs.unit})
    array["frequency"].attrs["units"] = "Hz"
    return array


def from_xarray(array: Any) -> FrfSet:
    """A DataArray as a set. The dimensions are in any order. The quantity is ``attrs["quantity"]``, else receptance.

    Raises
    ------
    InputError
        For other dimensions than frequency, output and input.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.xarray import from_xarray, to_xarray
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:+Z"], ["1:+Z"])
    >>> from_xarray(to_xarray(frfs)) == frfs
    True
    """
    if set(getattr(array, "dims", ())) != set(AXES) or not hasattr(array, "values") or callable(array.values):
        raise InputError(f"it is no DataArray with the dimensions {', '.join(AXES)}", place="array", kind="data",
                         remedy='rename them to "frequency", "output" and "input", with the DOFs as coordinates')
    return FrfSet(array, array["frequency"].values, [str(dof) for dof in array["output"].values],
                  [str(dof) for dof in array["input"].values], quantity=array.attrs.get("quantity", "receptance"),
                  name=str(array.name or "xarray"))
