"""How commands are run, watched and warned of."""

from __future__ import annotations

import difflib
import os
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
    """Errors without a place are at the command. Ctrl-C hands over what there is so far. The exception is a plain KeyboardInterrupt: of one of another class Python would
    exit with 1, where a shell expects an end by SIGINT."""
    try:
        yield
    except InputError as error:
        if error.place or error.file:
            raise
        raise InputError(error.problem, place=command, remedy=error.remedy, kind=error.kind) from None
    except KeyboardInterrupt as error:
        outcome = getattr(error, "partial", None)
        partial = kind(outcome, names, command) if outcome is not None else None
        error.partial = partial  # type: ignore[attr-defined]
        error.args = error.args or ("interrupted" if partial is None else "interrupted; `partial` of this exception is what there is",)
        raise


def run_scene(scene: Scene, command: str, function: Callable, *options: Any, threads: int = 0, progress: Any = None,
              kind: type[Result] = Result) -> Any:
    if not hasattr(threads, "__index__") or isinstance(threads, bool) or not 0 <= threads < 2**31:
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
            _set(task, name, _plain(value))
        except InputError as error:
            raise InputError(error.problem, place=error.place or name, remedy=error.remedy, kind=error.kind) from None
        except TypeError:
            raise InputError(f"{short(value)} is of type {type(value).__name__}, which {name} does not take", place=name,
                             remedy=f"see help(jointid.{what})") from None
    return task


def _set(task: Any, name: str, value: Any) -> None:
    """One text in place of a list is a list of it."""
    try:
        setattr(task, name, value)
    except TypeError:
        if not isinstance(value, str):
            raise
        setattr(task, name, [value])


def _plain(value: Any) -> Any:
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist") and not isinstance(value, (str, bytes)):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(each) for each in value]
    return value


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
        """Errors with names in place of paths of this package."""
        try:
            with self._scene.errors():
                yield
        except InputError as error:
            raise error.with_texts(self.named) from None


def run_task(names: NoScene, command: str, progress: Any, run: Callable, kind: type[Result] = Result) -> Any:
    with stopped(names, command, kind), watcher(progress) as watch, names.errors():
        outcome = run(watch)
    result = kind(outcome, names, command)
    warn_of(result, command)
    return result
