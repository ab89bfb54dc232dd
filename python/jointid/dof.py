"""Degrees of freedom."""

from __future__ import annotations

import functools

from . import _jointid


class Dof(str):
    """A degree of freedom as text, ``node:direction``, with the directions ±X ±Y ±Z ±RX ±RY ±RZ; a missing sign is +.

    A minus sign means that the sensor pointed the other way. It flips the sign of the FRF.
    Other text raises InputError.

    >>> Dof("4:Y"), Dof("4:-RZ").node, Dof("4:-RZ").direction, Dof("4:-RZ").sign
    ('4:+Y', 4, 'RZ', -1)
    """

    node: int
    direction: str
    sign: int

    def __new__(cls, text: str) -> "Dof":
        if isinstance(text, Dof):
            return text
        if not isinstance(text, str):
            from .errors import InputError, short

            raise InputError(f"{short(text)} is no DOF", place="dofs", remedy="write text such as '4:+Y'")
        name, node, direction, sign = _parts(str(text))
        self = super().__new__(cls, name)
        self.node, self.direction, self.sign = node, direction, sign
        return self

    def __reduce__(self):
        return Dof, (str(self),)

    @property
    def coordinate(self) -> str:
        """The DOF with a plus sign, whatever the sign of the sensor."""
        return f"{self.split(':')[0]}:+{self.direction}"

    @property
    def is_rotation(self) -> bool:
        """Whether its motion is an angle, rad, and its force a moment, N·m."""
        return self.direction.startswith("R")


@functools.lru_cache(maxsize=65536)
def _parts(text: str):
    return _jointid.dof_parts(text)
