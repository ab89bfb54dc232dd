"""How commands are run, watched and warned of."""

from __future__ import annotations

import difflib
import os
import re
import sys
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from ._progress import watcher
from ._provenance import of_arrays, of_file
from ._scene import Scene
from .errors import DoubtfulWarning, InputError, UnusableWarning, short
from .results import Result


def warn_of(result: Result, what: str) -> None:
    """At the caller's line, who is outside of this package."""
    level = 1
    while sys._getframe(level).f_globals.get("__name__", "").partition(".")[0] == __name__.partition(".")[0]:
        level += 1
    if not result.usable and result.status not in ("suspicious", "wrong"):
        warnings.warn(f"{what}: {result.status or 'not usable'}: {result.message}", UnusableWarning, stacklevel=level + 1)
    elif result.status == "doubtful":
        warnings.warn(f"{what}: doubtful: {result.message}", DoubtfulWarning, stacklevel=level + 1)


@contextmanager
def stopped(names: Any, command: str, kind: type[Result]) -> Iterator[None]:
    """Ctrl-C hands over what there is so far. The exception is a plain KeyboardInterrupt: of one of another class Python would
    exit with 1, where a shell expects an end by SIGINT."""
    try:
        yield
    except KeyboardInterrupt as error:
        outcome = getattr(error, "partial", None)
        partial = kind(outcome, names, command) if outcome is not None else None
        error.partial = partial  # type: ignore[attr-defined]
        error.args = error.args or ("interrupted" if partial is None else "interrupted; `partial` of this exception is what there is",)
        raise


def run_scene(scene: Scene, command: str, function: Callable, *options: Any, threads: int = 0, progress: Any = None,
              kind: type[Result] = Result) -> Any:
    if not hasattr(threads, "__index__") or isinstance(threads, bool) or threads < 0:
        raise InputError(f"{short(threads)} is no number of threads", place="threads", remedy="give 0 for all cores, or how many")
    with stopped(scene, command, kind), watcher(progress) as watch, scene.errors():
        outcome = function(scene.text, scene.file, int(threads), watch, *options)
    result = kind(outcome, scene, command)
    warn_of(result, scene.file if scene.is_file else command)
    return result


def with_options(task: Any, options: Mapping[str, Any], what: str) -> Any:
    """Sets the attributes of a class of C++; None leaves the default."""
    valid = [name for name in dir(type(task)) if not name.startswith("_")]
    for name, value in options.items():
        if name not in valid:
            near = difflib.get_close_matches(name, valid, 1)
            raise InputError(f"{what} has no option {name!r}", place=name,
                             remedy=f"did you mean {near[0]!r}?" if near else "it has " + ", ".join(valid))
        if value is None:
            continue
        try:
            setattr(task, name, _plain(value))
        except TypeError:
            raise InputError(f"{short(value)} is a {type(value).__name__}, which {name} does not take", place=name,
                             remedy=f"see help(jointid.{what})") from None
    return task


def _plain(value: Any) -> Any:
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist") and not isinstance(value, (str, bytes)):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    return value


_OPTION = re.compile(r"--([a-z][a-z-]*)(?: [A-Z]+\b)?")  # "--rate HZ"
_QUOTED = r"'[^']*'"
_LISTED = re.compile(rf"--([a-z][a-z-]*) {_QUOTED}(?: --\1 {_QUOTED})+")  # "--channel '1=1:+Z N' --channel '2=4:+Z m/s^2'"


class NoScene:
    """In place of a scene, for commands without one; `names` by paths that only this package has."""

    def __init__(self, scene: Scene | None = None, names: Mapping[str, str] | None = None, files: Iterable[str] = (),
                 arrays: Mapping[str, Iterable[Any]] | None = None) -> None:
        """`files`: paths of what is read; `arrays`: what is read in memory, by its name."""
        self._scene = scene or Scene({})
        self._names = names or {}
        self._files = tuple(files)
        self._arrays = arrays or {}

    def inputs(self, run_ns: int) -> Iterator[dict[str, Any]]:
        yield from self._scene.inputs(run_ns)
        for path in self._files:
            if os.path.isfile(path) and path not in self._names and self._scene.named(path) == path:
                yield of_file(path, "an argument", run_ns)
        for name, arrays in self._arrays.items():
            yield of_arrays(arrays, name)

    def named(self, text: str) -> str:
        for path, name in self._names.items():
            text = text.replace(path, name)
        return self._scene.named(text)

    @contextmanager
    def errors(self) -> Iterator[None]:
        """Errors with names in place of paths of this package, and arguments for options of the command."""
        try:
            with self._scene.errors():
                yield
        except InputError as error:
            made = {part: self._in_words(getattr(error, part)) for part in ("problem", "file", "place", "remedy", "what")}
            raise InputError(made.pop("problem"), kind=error.kind, **made) from None

    def _in_words(self, text: str) -> str:
        text = _LISTED.sub(lambda option: f"{option[1]}=[{', '.join(re.findall(_QUOTED, option[0]))}]", self.named(text))
        return _OPTION.sub(lambda option: option[1].replace("-", "_") + "=", text)


def run_task(names: NoScene, command: str, progress: Any, run: Callable, kind: type[Result] = Result) -> Any:
    with stopped(names, command, kind), watcher(progress) as watch, names.errors():
        outcome = run(watch)
    result = kind(outcome, names, command)
    warn_of(result, command)
    return result
