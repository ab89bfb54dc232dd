"""FRFs pair by pair, as in files and lists, into one array."""

from __future__ import annotations

from typing import Any, Iterable

import numpy as np

from ..dof import Dof
from ..errors import InputError
from ..frf_set import FrfSet

DIRECTIONS = ("X", "Y", "Z", "RX", "RY", "RZ")  # numbers 1 to 6 of UFF and of SDynPy


def dof_of(node: Any, direction: Any, place: str) -> Dof:
    """The DOF of a node and a signed number from 1 to 6."""
    number = int(direction)
    if not 1 <= abs(number) <= 6:
        raise InputError(f"node {node} has the direction {number}", place=place, kind="data",
                         remedy="give a direction from 1 to 6, minus for the other way")
    return Dof(f"{int(node)}:{'-' if number < 0 else '+'}{DIRECTIONS[abs(number) - 1]}")


def numbers_of(dof: Dof) -> tuple[int, int]:
    """Node and signed number of a DOF."""
    if not dof.split(":")[0].lstrip("-").isdigit():
        raise InputError(f"{dof} has no node number", place="dofs", kind="data",
                         remedy="name it by a number, as the other package needs one")
    return int(dof.split(":")[0]), dof.sign * (DIRECTIONS.index(dof.direction) + 1)


def set_of_pairs(pairs: Iterable[tuple[Dof, Dof, Any, Any]], **options: Any) -> FrfSet:
    """One set from (response, reference, frequency, FRF) of each pair. Missing pairs are NaN."""
    pairs = list(pairs)
    if not pairs:
        raise InputError("there are no FRFs", place="bridge", kind="data", remedy="give at least one")
    frequency = np.asarray(pairs[0][2], dtype=float)
    responses = list(dict.fromkeys(pair[0] for pair in pairs))
    references = list(dict.fromkeys(pair[1] for pair in pairs))
    frfs = np.full((len(frequency), len(responses), len(references)), np.nan + 1j * np.nan)
    seen = set()
    for response, reference, lines, frf in pairs:
        if not np.array_equal(np.asarray(lines, dtype=float), frequency):
            raise InputError(f"{response}/{reference} has other lines than {pairs[0][0]}/{pairs[0][1]}", place="bridge", kind="data",
                             remedy="give FRFs of the same frequencies")
        if (response, reference) in seen:
            raise InputError(f"{response}/{reference} is there twice", place="bridge", kind="data", remedy="leave one out")
        seen.add((response, reference))
        frfs[:, responses.index(response), references.index(reference)] = frf
    return FrfSet(frfs, frequency, responses, references, **options)
