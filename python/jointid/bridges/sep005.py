"""SEP 5: time records as dicts, one per channel ("data", "fs", "unit_str", "name", "start_timestamp" …)."""

from __future__ import annotations

from typing import Any, Iterable, Mapping

import numpy as np

from .._tasks import frf, pod
from ..errors import InputError
from ..results import FrfResult, Result


def _records(channels: Iterable[Mapping[str, Any]] | Mapping[str, Any]) -> tuple[np.ndarray, float, list[str], list[str]]:
    channels = [channels] if isinstance(channels, Mapping) else list(channels)
    if not channels:
        raise InputError("there is no channel", place="channels", kind="data", remedy="give at least one")
    lengths, rates = {len(each["data"]) for each in channels}, {float(each["fs"]) for each in channels}
    if len(lengths) > 1 or len(rates) > 1:
        raise InputError(f"the channels have {sorted(lengths)} samples at {sorted(rates)} Hz", place="channels", kind="data",
                         remedy="give channels that were sampled together")
    names = [str(each.get("name", k + 1)) for k, each in enumerate(channels)]
    units = [str(each.get("unit_str", "")) for each in channels]
    return np.column_stack([np.asarray(each["data"], dtype=float) for each in channels]), rates.pop(), names, units


def frf_of_sep005(channels: Any, dofs: Mapping[str, str], **options: Any) -> FrfResult:
    """jointid.frf() for channels of one record. `dofs` names the DOF of each channel to use: ``{"hammer": "1:+Z", "acc": "4:+Z"}``."""
    data, rate, names, units = _records(channels)
    missing = [name for name in dofs if name not in names]
    if missing:
        raise InputError(f"there is no channel {missing[0]!r}", place="dofs", kind="data", remedy="there are " + ", ".join(names))
    given = [f"{names.index(name) + 1}={dof} {units[names.index(name)]}" for name, dof in dofs.items()]
    return frf(data, channel=given, rate=rate, **options)


def pod_of_sep005(channels: Any, **options: Any) -> Result:
    """jointid.pod() for channels of one record."""
    data, _, names, units = _records(channels)
    return pod(data, names=names, units=units, **options)
