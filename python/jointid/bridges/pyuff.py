"""pyuff: a list of dicts, one of dataset 58 for each FRF."""

from __future__ import annotations

from typing import Any, Iterable, Mapping

import numpy as np

from ..errors import InputError, short
from ..frf_set import FrfSet
from ._pairs import dof_of, numbers_of, set_of_pairs

_QUANTITIES = {8: "receptance", 11: "mobility", 12: "accelerance"}  # ordinate_spec_data_type
_FRF = 4  # func_type
_FORCE = 13


def from_pyuff(datasets: Iterable[Mapping[str, Any]] | Mapping[str, Any], *, quantity: str | None = None, name: str = "pyuff") -> FrfSet:
    """A set from ``pyuff.UFF(file).read_sets()``: the FRFs (datasets 58 with func_type 4). Other datasets are left out.

    Nodes of datasets 15 and 2411 become positions. `quantity` is for datasets without one. Datasets that disagree raise InputError.

    >>> import numpy as np
    >>> from jointid.bridges.pyuff import from_pyuff
    >>> dataset = {"type": 58, "func_type": 4, "rsp_node": 2, "rsp_dir": 3, "ref_node": 1, "ref_dir": -3, "x": [10.0, 20.0],
    ...            "data": np.ones(2, complex), "ordinate_spec_data_type": 12}
    >>> frfs = from_pyuff([dataset])
    >>> frfs.responses, frfs.references, frfs.quantity
    (('2:+Z',), ('1:-Z',), 'accelerance')
    """
    if not isinstance(datasets, Iterable):
        raise InputError(f"{short(datasets)} is no list of datasets", place="datasets", remedy="give pyuff.UFF(file).read_sets()")
    datasets = [datasets] if isinstance(datasets, Mapping) else list(datasets)
    pairs, quantities, nodes = [], set(), {}
    for each in datasets:
        if each.get("type") in (15, 2411):
            nodes.update({int(node): (x, y, z) for node, x, y, z in _rows(each)})
        if each.get("type") != 58 or each.get("func_type", _FRF) != _FRF:
            continue
        missing = [key for key in ("rsp_node", "rsp_dir", "ref_node", "ref_dir", "x", "data") if key not in each]
        if missing:
            raise InputError(f"a dataset 58 has no {missing[0]!r}", place="datasets", kind="data", remedy="give it as pyuff reads it")
        pairs.append((dof_of(each["rsp_node"], each["rsp_dir"], "rsp_dir"), dof_of(each["ref_node"], each["ref_dir"], "ref_dir"),
                      each["x"], each["data"]))
        quantities.add(_QUANTITIES.get(each.get("ordinate_spec_data_type", 0), None))
    if quantity is None and (len(quantities) != 1 or None in quantities) and pairs:
        raise InputError("ordinate_spec_data_type states no quantity, or several", place="datasets", kind="data",
                         remedy='give quantity="accelerance", "mobility" or "receptance"')
    return set_of_pairs(pairs, quantity=quantity or next(iter(quantities), "receptance"), nodes=nodes, name=name)


def _rows(dataset: Mapping[str, Any]) -> Iterable[tuple]:
    if "grid_global" in dataset:
        return [(row[0], *row[1:4]) for row in np.atleast_2d(dataset["grid_global"])]
    return zip(dataset["node_nums"], dataset["x"], dataset["y"], dataset["z"])


def to_pyuff(frfs: FrfSet) -> list[dict[str, Any]]:
    """Datasets 58 for ``pyuff.UFF(file).write_sets()``: frequency in Hz, FRFs in SI units, complex [line].

    FRFs that were not measured (NaN) are left out. A DOF without a node number raises InputError.

    >>> import numpy as np, jointid
    >>> from jointid.bridges.pyuff import to_pyuff
    >>> frfs = jointid.FrfSet(np.ones((3, 2, 1)) * 1e-6, [10.0, 20.0, 30.0], ["1:+Z", "2:-Z"], ["1:+Z"])
    >>> [(each["type"], each["rsp_node"], each["rsp_dir"]) for each in to_pyuff(frfs)]
    [(58, 1, 3), (58, 2, -3)]
    """
    kind = next(number for number, word in _QUANTITIES.items() if word == frfs.quantity)
    out = []
    for row, response in enumerate(frfs.responses):
        for column, reference in enumerate(frfs.references):
            data = np.ascontiguousarray(frfs.frfs[:, row, column])
            if np.isnan(data).all():
                continue
            (response_node, response_direction), (reference_node, reference_direction) = numbers_of(response), numbers_of(reference)
            steps = np.diff(frfs.frequency)
            even = len(steps) > 0 and np.allclose(steps, steps[0], rtol=1e-9)
            out.append({"type": 58, "func_type": _FRF, "binary": 1, "id1": frfs.name, "id2": "", "id3": "", "id4": "", "id5": "",
                        "rsp_node": response_node, "rsp_dir": response_direction, "ref_node": reference_node,
                        "ref_dir": reference_direction, "x": frfs.frequency.copy(), "data": data,
                        "n_bytes": data.nbytes, "num_pts": len(data), "abscissa_spacing": int(even), "abscissa_min": frfs.frequency[0],
                        "abscissa_inc": steps[0] if even else 0.0, "ord_data_type": 6, "abscissa_spec_data_type": 18,
                        "ordinate_spec_data_type": kind, "orddenom_spec_data_type": _FORCE})
    return out
