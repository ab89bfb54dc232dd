"""pandas: a DataFrame with one row per line and one column per (response, reference)."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import InputError
from ..frf_set import FrfSet


def to_pandas(frfs: FrfSet) -> Any:
    """The set as a DataFrame. Its ``attrs`` have quantity and units."""
    import pandas

    columns = pandas.MultiIndex.from_product([[str(dof) for dof in frfs.responses], [str(dof) for dof in frfs.references]],
                                             names=["response", "reference"])
    table = pandas.DataFrame(frfs.frfs.reshape(len(frfs), -1), index=pandas.Index(frfs.frequency, name="frequency"), columns=columns)
    table.attrs.update(quantity=frfs.quantity, units=frfs.unit)
    return table


def from_pandas(table: Any, *, quantity: str | None = None, name: str = "pandas") -> FrfSet:
    """A DataFrame as a set. Columns are in any order; missing pairs are NaN."""
    if getattr(getattr(table, "columns", None), "nlevels", 1) != 2:
        raise InputError("the columns are no pairs (response, reference)", place="table", remedy="give a MultiIndex of two levels")
    responses = list(dict.fromkeys(table.columns.get_level_values(0)))
    references = list(dict.fromkeys(table.columns.get_level_values(1)))
    frfs = np.full((len(table), len(responses), len(references)), np.nan + 1j * np.nan)
    for k, (response, reference) in enumerate(table.columns):
        frfs[:, responses.index(response), references.index(reference)] = table.iloc[:, k]
    return FrfSet(frfs, np.asarray(table.index, dtype=float), responses, references,
                  quantity=quantity or table.attrs.get("quantity", "receptance"), name=name)
