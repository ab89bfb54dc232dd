"""Scenes as paths, dicts or text, with FRFs in memory in place of files."""

from __future__ import annotations

import datetime
import functools
import math
import os
import re
import tempfile
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from json.encoder import encode_basestring  # type: ignore[attr-defined]
from typing import Any

from . import _jointid
from ._provenance import files_named, of_file, of_set, of_text
from .errors import InputError, short

_IN_MEMORY = "scene"  # what messages call a scene that is no file
_LINE = re.compile(r"^((?:scene|\S*\.toml): )?line \d+(?:, column \d+)?(?:, |: |$)")  # of a text that nobody wrote
_NAMES_FILES = {"remove", "files", "file"}  # keys whose text names a file of [data]


def _quoted(text: str, place: str) -> str:
    if not text.isascii():
        try:
            text.encode("utf-8")
        except UnicodeEncodeError:
            raise InputError(f"{text!r} is no text of Unicode", place=place, remedy="use other letters") from None
    return encode_basestring(text).replace("\x7f", "\\u007f")


def _number(value: float) -> str:
    if math.isfinite(value):
        return repr(float(value))
    return "nan" if math.isnan(value) else "inf" if value > 0 else "-inf"


def _plain(value: Any) -> Any:
    """Arrays and numbers of NumPy as lists and numbers of Python; paths as text."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    return value.tolist() if hasattr(value, "tolist") else value


def toml_value(value: Any, place: str) -> str:
    """A value of a dict as TOML, on one line."""
    kind = type(value)
    if kind is str:
        return _quoted(value, place)
    if kind is float:
        return _number(value)
    if kind is bool:
        return "true" if value else "false"
    if kind is int:
        return str(value)
    if kind is list or kind is tuple:
        return "[" + ", ".join([toml_value(item, f"{place}[{i + 1}]") for i, item in enumerate(value)]) + "]"
    if isinstance(value, Mapping):
        return "{ " + ", ".join([f"{_quoted(_key(key, place), place)} = {toml_value(item, _below(place, key))}"
                                 for key, item in value.items() if item is not None]) + " }"
    return _other_value(value, place)


def _other_value(value: Any, place: str) -> str:
    """Of what is not a plain value of Python, by what it is like."""
    plain = _plain(value)
    if plain is not value:
        return toml_value(plain, place)
    if isinstance(value, (datetime.date, datetime.time)):
        return value.isoformat()
    for kind in (str, int, float):
        if isinstance(value, kind):
            return toml_value(kind(value), place)
    if isinstance(value, (list, tuple, set, frozenset, range)):
        return toml_value(list(value), place)
    raise InputError(f"{short(value)} is of type {type(value).__name__}, which no scene can have", place=place,
                     remedy="give a number, text, bool, list, dict, array, path or FrfSet")


def _below(place: str, key: str) -> str:
    return f"[{key}]" if not place else f"{place} {key}"


def _key(key: Any, place: str) -> str:
    if isinstance(key, str):
        return key
    raise InputError(f"the key {short(key)} is of type {type(key).__name__}", place=place or "scene", remedy="keys are text")


def toml_text(scene: Mapping) -> str:
    """A dict as TOML: a line for every table.

    >>> print(toml_text({"joint": {"dofs": ["4:+Y"]}, "title": "rig"}), end="")
    "title" = "rig"
    "joint" = { "dofs" = ["4:+Y"] }
    """
    lines = [(isinstance(value, Mapping), f"{_quoted(_key(key, ''), '')} = {toml_value(value, f'[{key}]')}\n")
             for key, value in scene.items() if value is not None]
    return "".join(line for _, line in sorted(lines, key=lambda each: each[0]))


@functools.cache
def _frf_set() -> type:
    from .frf_set import FrfSet

    return FrfSet


def _no_scene(value: Any) -> InputError:
    return InputError(f"{short(value)} is no scene", place="scene",
                      remedy="give the path of a scene file, or a dict with the same keys")


_OPTION = re.compile(r"--([a-z][a-z-]*)(?: [A-Z]+\b)?")  # "--rate HZ"
_QUOTED = r"'[^']*'"
_LISTED = re.compile(rf"--([a-z][a-z-]*) {_QUOTED}(?: --\1 {_QUOTED})+")  # "--channel '1=1:+Z N' --channel '2=4:+Z m/s^2'"


def with_arguments(text: str) -> str:
    """A message with arguments of functions in place of options of the command."""
    text = _LISTED.sub(lambda option: f"{option[1]}=[{', '.join(re.findall(_QUOTED, option[0]))}]", text)
    return _OPTION.sub(lambda option: option[1].replace("-", "_") + ("" if text[option.end():option.end() + 1] in ("", ":") else "="), text)


class Scene:
    """The text of a scene, and the FRFs in memory that it names.

    While one is alive, so are the files in memory that represent its sets.
    """

    def __init__(self, scene: Any, file: str | None = None) -> None:
        """`file`: by whose folder paths are found, and which messages name."""
        self._names: dict[str, str] = {}  # path of a file in memory → name of its set
        self._sets: dict[int, tuple[Any, str]] = {}  # id of a set → the set, which stays alive, and its path
        self._files: list[Any] = []
        self._folder: tempfile.TemporaryDirectory | None = None  # of time histories
        self.is_file = isinstance(scene, (str, os.PathLike))
        self.file = os.fspath(scene) if self.is_file else file or _IN_MEMORY
        if not self.is_file and not isinstance(scene, Mapping):
            raise _no_scene(scene)
        self.text: str | bytes = _jointid.read_text(self.file) if self.is_file else toml_text(self._with_paths(scene))

    @staticmethod
    def table_of(file: str | os.PathLike) -> dict[str, Any]:
        """A scene file as a dict."""
        if not isinstance(file, (str, os.PathLike)):
            raise _no_scene(file)
        try:
            return tomllib.loads(_jointid.read_text(os.fspath(file)).decode("utf-8-sig"))
        except InputError:
            raise
        except ValueError as error:
            raise InputError(str(error), file=os.fspath(file), remedy="see https://toml.io") from None

    def _with_paths(self, value: Any, key: str = "") -> Any:
        """The same with the paths of files in memory in place of sets, and of the names of these."""
        kind = type(value)
        if kind is str:
            return self._with_path(value, key) if self._names else value
        if kind is float or kind is int:
            return value
        if isinstance(value, _frf_set()):
            return self._path_of(value)
        if key == "records" and getattr(value, "ndim", None) == 2:
            return self._path_of_record(value)
        if isinstance(value, Mapping):
            first = sorted(value.items(), key=lambda item: item[0] not in ("data", "parts", "substructures", "assembly"))
            made = {each: self._with_paths(item, each) for each, item in first}
            return {self._path_named(each) or each: item for each, item in made.items()} if key == "files" else made
        if isinstance(value, (list, tuple)):
            return [self._with_paths(item, key) for item in value]
        return self._with_path(value, key) if isinstance(value, str) else value

    def _path_named(self, name: str) -> str | None:
        return next((path for path, known in self._names.items() if known == name), None)

    def _with_path(self, text: str, key: str) -> str:
        """Of the name of a set, or of a DOF of one, as in "engine/4:+Y"."""
        if key in _NAMES_FILES:
            return self._path_named(text) or text
        if "/" not in text:
            return text
        name, slash, dof = text.rpartition("/")
        path = self._path_named(name) if slash and ":" in dof else None
        return f"{path}/{dof}" if path else text

    def _path_of(self, frfs: Any) -> str:
        if id(frfs) not in self._sets:
            file = _jointid.MemoryFile(frfs._parts())
            self._files.append(file)
            self._sets[id(frfs)] = (frfs, file.path)
            self._names[file.path] = frfs.name
        return self._sets[id(frfs)][1]

    def _path_of_record(self, array: Any) -> str:
        """Of time histories in memory: a file for as long as the scene."""
        from ._records import save_record

        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="jointid-")
        number = 1 + len(os.listdir(self._folder.name))
        path = os.path.join(self._folder.name, f"record_{number}.npy")
        save_record(path, array, f"record {number}")
        self._names[path] = f"record {number}"
        return path

    def add(self, frfs: Any) -> str:
        """The path that represents a set outside of the scene's text."""
        return self._path_of(frfs)

    def inputs(self, run_ns: int) -> Iterator[dict[str, Any]]:
        """What was read, with sums. `run_ns`: when the run ended; what was written later has none."""
        if self.is_file:
            yield of_file(self.file, "the scene", run_ns)
        elif self.text:
            yield of_text(self.text, self.file)
        for frfs, path in self._sets.values():
            yield of_set(frfs, self._names[path])
        own = self._folder.name + os.sep if self._folder else None
        for path in files_named(self.text, self.file):
            place = "in memory" if own and path.startswith(own) else "named by the scene"
            yield {**of_file(path, place, run_ns), "file": self._names.get(path, path)}

    def named(self, text: str) -> str:
        """The text with the names of sets in place of their paths."""
        for path, name in self._names.items():
            text = text.replace(path, name)
        return text

    @contextmanager
    def errors(self) -> Iterator[None]:
        """Errors name sets by their names; lines of a text that nobody wrote are left out."""
        try:
            yield
        except InputError as error:
            raise self._readable(error) from None

    def _readable(self, error: InputError) -> InputError:
        def readable(text: str) -> str:
            text = with_arguments(self.named(text))
            return text if self.is_file else _LINE.sub(r"\1", text)

        return error.with_texts(readable)


def pair_of(value: Any, place: str) -> tuple[float, float]:
    """Two numbers, the lower one first."""
    try:
        low, high = (float(number) for number in value)
    except (TypeError, ValueError):
        raise InputError(f"{short(value)} is no pair of numbers", place=place, remedy="give (low, high) in Hz") from None
    return low, high


def whole_number(value: Any, place: str) -> int:
    try:
        number = value.__index__()
    except AttributeError:
        raise InputError(f"{short(value)} is no whole number", place=place, remedy="give e.g. 1000") from None
    if not 0 <= number < 2**64 or isinstance(value, bool):
        raise InputError(f"{short(value)} is no number from 0 to 2^64", place=place, remedy="give e.g. 1000")
    return number


def paths_of(value: Any, place: str, also: str = "") -> list[str]:
    """One path or several as text. `also` is what the remedy names besides."""
    try:
        paths = [os.fspath(each) for each in ([value] if isinstance(value, (str, os.PathLike)) else value)]
        if not hasattr(value, "read") and all(isinstance(path, str) for path in paths):
            return paths
        raise TypeError
    except TypeError:
        raise InputError(f"{short(value)} is no path", place=place, remedy=f"give the path of a file, or a list of them{also}") from None


def path_of(value: Any, place: str) -> str:
    """One path as text."""
    if isinstance(value, (str, os.PathLike)):
        return paths_of(value, place)[0]
    raise InputError(f"{short(value)} is no path", place=place, remedy="give the path of a file or a folder")


def write_text(path: str, text: str) -> None:
    """A file that is complete or not there."""
    temporary = f"{path}.{os.getpid()}.part"
    try:
        with open(temporary, "w", encoding="utf-8") as stream:
            stream.write(text)
        os.replace(temporary, path)
    except OSError as error:
        raise InputError(f"cannot be written: {error.strerror}", file=path, kind="data",
                         remedy="check the folder, its permissions and the space left on the disk") from None
    finally:
        if os.path.exists(temporary):
            os.remove(temporary)


def text_of(value: Any, place: str, remedy: str) -> str:
    if isinstance(value, str):
        return value
    raise InputError(f"{short(value)} is no text", place=place, remedy=remedy)


def table_of(value: Any, place: str) -> dict[str, Any]:
    """A dict of an argument, as one of its own."""
    if isinstance(value, Mapping):
        return dict(value)
    raise InputError(f"{short(value)} is no dict", place=place, remedy="give a dict with the keys of that table of a scene")


def list_of(value: Any, place: str, remedy: str) -> list:
    """Of a list or another iterable that is no text."""
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes, Mapping)):
        return list(value)
    raise InputError(f"{short(value)} is no list", place=place, remedy=remedy)


def as_list(value: Any) -> list:
    """One set or path as a list of one; lists may have lists of files that measure the same."""
    if isinstance(value, (str, os.PathLike, _frf_set())):
        return [value]
    array = any(hasattr(value, name) for name in ("dtype", "read", "columns", "dims"))
    if array or not isinstance(value, Iterable) or isinstance(value, (bytes, Mapping)):
        raise InputError(f"{short(value)} is neither a path nor a set of FRFs", place="data", remedy=_MAKES_A_SET if array else
                         "give paths and FrfSets, or a list of them")
    return [as_list(each) if isinstance(each, (list, tuple)) else as_list(each)[0] for each in value]


_MAKES_A_SET = "jointid.FrfSet(array, frequency, dofs) makes a set; so do from_xarray() and from_pandas() of jointid.bridges"
