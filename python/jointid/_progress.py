"""Progress of a run."""

from __future__ import annotations

import atexit
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from . import _jointid
from .errors import InputError, short

Watch = Callable[[str, int, int], None]


class Bar:
    """A line on standard error: "planning", "assemble ████░░░░ 120 of 300"; of terminals and notebooks."""

    WIDTH = 24

    def __init__(self) -> None:
        self._length = 0

    def __call__(self, stage: str, done: int, total: int) -> None:
        text = stage
        if total > 0:
            full = min(self.WIDTH, self.WIDTH * done // total)
            text += f" {'█' * full}{'░' * (self.WIDTH - full)} {done} of {total}"
        self._show(text)
        self._length = len(text)

    def _show(self, text: str) -> None:
        sys.stderr.write("\r" + text.ljust(self._length))
        sys.stderr.flush()

    def close(self) -> None:
        if self._length:
            self._show("")
            sys.stderr.write("\r")
            sys.stderr.flush()


def _someone_looks() -> bool:
    """Whether standard error is a terminal, or a notebook's."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return type(shell).__name__ == "ZMQInteractiveShell" or (hasattr(sys.stderr, "isatty") and sys.stderr.isatty())


@contextmanager
def watcher(progress: Any) -> Iterator[Watch | None]:
    """None: a bar on a terminal and in a notebook, else nothing; True: a bar; False: nothing; a function: (stage, done, total)."""
    if progress is None:
        progress = _someone_looks()
    if progress is False:
        yield None
    elif progress is True:
        bar = Bar()
        try:
            yield bar
        finally:
            bar.close()
    elif callable(progress):
        yield progress
    else:
        raise InputError(f"{short(progress)} is no function", place="progress", remedy="give True, False or a function of (stage, done, total)")


@atexit.register
def _leave() -> None:
    """Ends the process where a run that Ctrl-C did not stop still goes on: it must not meet the end of what it uses."""
    if _jointid.runs_left() > 0:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(130)
