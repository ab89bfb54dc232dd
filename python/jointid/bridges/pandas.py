"""pandas: a DataFrame with one row per line and one column per (response, reference)."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import InputError
from ..frf_set import FrfSet


def to_pandas(frfs: FrfSet) -> Any:
    """The set as a DataFrame [line, (response, reference)], complex. Its index is the frequency in Hz.

    Its ``attrs`` have quantity and units. Needs pandas, else ImportError.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.pandas import to_pandas
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:+Z"], ["1:+Z"])
    >>> table = to_pandas(frfs)
    >>> table.shape, table.attrs["units"]
    ((3, 2), 'm/N')
    """
    import pandas

    columns = pandas.MultiIndex.from_product([[str(dof) for dof in frfs.responses], [str(dof) for dof in frfs.references]],
                                             names=["response", "reference"])
    table = pandas.DataFrame(frfs.frfs.reshape(len(frfs), -1), index=pandas.Index(frfs.frequency, name="frequency"), columns=columns)
    table.attrs.update(quantity=frfs.quantity, units=frfs.unit)
    return table


def from_pandas(table: Any, *, quantity: str | None = None, name: str = "pandas") -> FrfSet:
    """A DataFrame [line, (response, reference)] as a set. Columns are in any order; missing pairs are NaN.

    Its index is the frequency in Hz. `quantity` is that of its ``attrs`` by default, else receptance.

    Raises
    ------
    InputError
        For columns that are no pairs of DOFs.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.pandas import from_pandas, to_pandas
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:+Z"], ["1:+Z"])
    >>> from_pandas(to_pandas(frfs)) == frfs
    True
    """
    if getattr(getattr(table, "columns", None), "nlevels", 1) != 2:
        raise InputError("the columns are no pairs (response, reference)", place="table", remedy="give a MultiIndex of two levels")
    responses = list(dict.fromkeys(table.columns.get_level_values(0)))
    references = list(dict.fromkeys(table.columns.get_level_values(1)))
    frfs = np.full((len(table), len(responses), len(references)), np.nan + 1j * np.nan)
    for k, (response, reference) in enumerate(table.columns):
        frfs[:, responses.index(response), references.index(reference)] = table.iloc[:, k]
    return FrfSet(frfs, np.asarray(table.index, dtype=float), responses, references,
                  quantity=quantity or table.attrs.get("quantity", "receptance"), name=name)
