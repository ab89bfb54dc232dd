"""How results were made: version, commit, call, inputs with their sums, libraries."""

from __future__ import annotations

import hashlib
import os
import platform
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from . import _jointid

_AT_ONCE = 1 << 20  # bytes


def _sum_of_file(path: str, run_ns: int) -> str | None:
    """SHA-256; None where the file is gone, or was written after the run."""
    try:
        if os.stat(path).st_mtime_ns > run_ns:
            return None
        digest = hashlib.sha256()
        with open(path, "rb") as stream:
            while piece := stream.read(_AT_ONCE):
                digest.update(piece)
        return digest.hexdigest()
    except OSError:
        return None


def _bytes_of(path: str) -> int | None:
    try:
        return os.path.getsize(path)
    except OSError:
        return None


def of_file(path: str, place: str, run_ns: int) -> dict[str, Any]:
    return {"file": path, "place": place, "bytes": _bytes_of(path), "sha256": _sum_of_file(path, run_ns)}


def of_text(text: str | bytes, name: str) -> dict[str, Any]:
    data = text.encode() if isinstance(text, str) else text
    return {"file": name, "place": "in memory", "bytes": len(data), "sha256": hashlib.sha256(data).hexdigest()}


def of_set(frfs: Any, name: str) -> dict[str, Any]:
    """Of the bytes of its frequencies and FRFs."""
    return of_arrays((frfs.frequency, frfs.frfs), name)


def of_arrays(arrays: Iterable[np.ndarray], name: str) -> dict[str, Any]:
    digest, size = hashlib.sha256(), 0
    for array in arrays:
        whole = np.ascontiguousarray(array)
        digest.update(whole.view(np.uint8).data if whole.size else b"")
        size += whole.nbytes
    return {"file": name, "place": "in memory", "bytes": size, "sha256": digest.hexdigest()}


def _texts(value: Any) -> Iterator[str]:
    """All keys and texts of a scene."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield key
            yield from _texts(item)
    elif isinstance(value, (list, tuple)):
        for item in value:
            yield from _texts(item)


def files_named(text: str | bytes, file: str) -> list[str]:
    """Paths of the files that a scene names, in its order."""
    try:
        scene = tomllib.loads(text if isinstance(text, str) else text.decode("utf-8-sig"))
    except ValueError:
        return []
    folder = os.path.dirname(file)
    paths = (os.path.join(folder, each) for each in _texts(scene) if each and "\0" not in each and len(each) < 4096)
    return [path for path in dict.fromkeys(paths) if os.path.isfile(path)]


def _libraries() -> list[str]:
    """Names of the shared libraries of this process: "libhdf5_serial.so.103.3.0"."""
    try:
        with open("/proc/self/maps", encoding="utf-8", errors="replace") as stream:
            paths = {line.split(maxsplit=5)[5].rstrip("\n") for line in stream if line.count("/")}
    except OSError:
        return []
    return sorted({os.path.basename(path) for path in paths if ".so" in os.path.basename(path)})


def provenance(command: str, inputs: Iterable[dict[str, Any]]) -> dict[str, Any]:
    return {"version": _jointid.__version__, "commit": _jointid.__commit__, "python": command,
            "versions": {"python": platform.python_version(), "numpy": np.__version__}, "folder": os.getcwd(), "inputs": list(inputs),
            "libraries": _libraries()}
