"""SEP 5: time records as dicts, one per channel ("data", "name", "unit_str", "fs" or "time", "start_timestamp" …)."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from .._tasks import frf, pod
from ..errors import InputError
from ..results import FrfResult, Result


_UNEVEN = 1e-6  # how much steps of `time` may differ, as a share of the whole


def _channel(channel: Any, number: int) -> Mapping[str, Any]:
    missing = [key for key in ("data", "name", "unit_str") if not isinstance(channel, Mapping) or key not in channel]
    if missing:
        raise InputError(f"channel {number} has no {missing[0]!r}", place="channels", kind="data",
                         remedy="SEP 5 asks for data, name, unit_str, and fs or time")
    return channel


def _rate(channel: Mapping[str, Any]) -> float:
    """Hz: its `fs`, else that of the steps of its `time`, s."""
    if channel.get("fs") is not None:
        return float(channel["fs"])
    time = np.asarray(channel.get("time", ()), dtype=float)
    steps = np.diff(time)
    if len(time) != len(channel["data"]) or not len(steps) or not steps.min() > 0.0:
        raise InputError(f"channel {channel['name']!r} has neither fs nor a time for each sample", place="channels", kind="data",
                         remedy="give fs, Hz, or time, s, which increases")
    if np.ptp(steps) > _UNEVEN * (time[-1] - time[0]):
        raise InputError(f"the steps of time of channel {channel['name']!r} differ, {steps.min():g} to {steps.max():g} s", place="channels",
                         kind="data", remedy="resample it to even steps")
    return round(float(len(steps) / (time[-1] - time[0])), 9)


def _records(channels: Any) -> tuple[np.ndarray, float, list[str], list[str]]:
    listed = [channels] if isinstance(channels, Mapping) else list(channels)
    channels = [_channel(each, k + 1) for k, each in enumerate(listed)]
    if not channels:
        raise InputError("there is no channel", place="channels", kind="data", remedy="give at least one")
    lengths, rates = {len(each["data"]) for each in channels}, {_rate(each) for each in channels}
    starts = {str(each["start_timestamp"]) for each in channels if each.get("start_timestamp") is not None}
    if len(lengths) > 1 or len(rates) > 1 or len(starts) > 1:
        begin = f" from {sorted(starts)}" if len(starts) > 1 else ""
        raise InputError(f"the channels have {sorted(lengths)} samples at {sorted(rates)} Hz{begin}", place="channels", kind="data",
                         remedy="give channels that were sampled together")
    names = [str(each["name"]) for each in channels]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"two channels are called {twice!r}", place="channels", kind="data", remedy="give each a name of its own")
    units = [str(each["unit_str"]) for each in channels]
    return np.column_stack([np.asarray(each["data"], dtype=float) for each in channels]), rates.pop(), names, units


def frf_of_sep005(channels: Any, dofs: Mapping[str, str], **options: Any) -> FrfResult:
    """jointid.frf() for channels of one record. `dofs` names the DOF of each channel to use: ``{"hammer": "1:+Z", "acc": "4:+Z"}``.

    Each channel is a dict with "data" [sample], "name", "unit_str" ("N", "m/s^2", "g" …), and "fs" in Hz or "time" in s.

    Raises
    ------
    InputError
        For a channel without these, channels of other lengths, rates or starts, and a name of `dofs` that no channel has.

    >>> import numpy as np
    >>> from jointid.bridges.sep005 import frf_of_sep005
    >>> t = np.arange(1000) / 1000.0
    >>> force = np.exp(-0.5 * ((t - 0.02) / 0.0008) ** 2)
    >>> motion = np.convolve(force, np.exp(-8 * t) * np.sin(2 * np.pi * 80 * t))[:1000]
    >>> record = [{"name": "hammer", "data": force, "unit_str": "N", "fs": 1000.0},
    ...           {"name": "acc", "data": motion, "unit_str": "m/s^2", "fs": 1000.0}]
    >>> frfs = frf_of_sep005(record, {"hammer": "1:+Z", "acc": "4:+Z"}).frfs()
    >>> float(frfs.frequency[np.nanargmax(abs(frfs["4:+Z", "1:+Z"]))])
    80.0
    """
    data, rate, names, units = _records(channels)
    missing = [name for name in dofs if name not in names]
    if missing:
        raise InputError(f"there is no channel {missing[0]!r}", place="dofs", kind="data", remedy="there are " + ", ".join(names))
    given = [f"{names.index(name) + 1}={dof} {units[names.index(name)]}" for name, dof in dofs.items()]
    return frf(data, channel=given, rate=rate, **options)


def pod_of_sep005(channels: Any, **options: Any) -> Result:
    """jointid.pod() for channels of one record, dicts as in frf_of_sep005(). Wrong channels raise InputError.

    >>> import numpy as np
    >>> from jointid.bridges.sep005 import pod_of_sep005
    >>> t = np.arange(500) / 50
    >>> turn = np.cos(2 * np.pi * t)
    >>> record = [{"name": name, "data": size * turn, "unit_str": "m", "fs": 50.0} for name, size in (("a", 0.6), ("b", 0.8))]
    >>> round(pod_of_sep005(record)["values"][0], 9)
    0.5
    """
    data, _, names, units = _records(channels)
    return pod(data, names=names, units=units, **options)
