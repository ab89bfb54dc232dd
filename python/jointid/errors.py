"""Errors and warnings."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

__all__ = ["InputError", "JointidWarning", "DoubtfulWarning", "UnusableWarning", "DataWarning"]


def short(value: Any) -> str:
    """Of any argument for a message: what it is, on one line."""
    text = repr(value)
    return text if len(text) < 60 and "\n" not in text else f"an object of type {type(value).__name__}"


class InputError(ValueError):
    """Wrong input: the problem, its place, its value and the remedy.

    Attributes
    ----------
    what : str
        The whole message in one line.
    file : str
        The file or the set of FRFs, or "".
    place : str
        Its place: ``"[joint] dofs"``, ``"line 12"``, the name of an argument; or "".
    problem, value : str
        The problem, with the wrong value.
    remedy : str
        The remedy, or "".
    kind : str
        ``"usage"``: wrong use or a wrong scene. ``"data"``: unreadable or inconsistent data.

    >>> import jointid
    >>> try:
    ...     jointid.Dof("4:+Q")
    ... except jointid.InputError as error:
    ...     print(error.kind, error.remedy != "")
    usage True
    """

    def __init__(self, problem: str, *, file: str = "", place: str = "", remedy: str = "", kind: str = "usage",
                 what: str | None = None) -> None:
        if what is None:
            what = ": ".join(part for part in (file, place, problem) if part) + (f" ({remedy})" if remedy else "")
        super().__init__(what)
        self.what = what
        self.file = file
        self.place = place
        self.problem = problem
        self.value = problem
        self.remedy = remedy
        self.kind = kind

    def with_texts(self, change: Callable[[str], str]) -> "InputError":
        """The same error with changed texts."""
        return InputError(change(self.problem), file=change(self.file), place=change(self.place), remedy=change(self.remedy),
                          kind=self.kind, what=change(self.what))

    def __reduce__(self):
        return _made_again, (self.problem, self.file, self.place, self.remedy, self.kind, self.what)


def _made_again(problem, file, place, remedy, kind, what) -> InputError:
    return InputError(problem, file=file, place=place, remedy=remedy, kind=kind, what=what)


class JointidWarning(UserWarning):
    """Base class of all warnings of jointid. A filter makes one of them an error:

    >>> import jointid, warnings
    >>> with warnings.catch_warnings():
    ...     warnings.simplefilter("error", jointid.UnusableWarning)  # stop where numbers may not be used
    """


class DoubtfulWarning(JointidWarning):
    """The numbers may be used, but the data speak against them (status ``doubtful``)."""


class UnusableWarning(JointidWarning):
    """The numbers may not be used (status ``poor_fit``, ``rank_deficient``, ``not_converged``, …)."""


class DataWarning(JointidWarning):
    """A file looks wrong."""
