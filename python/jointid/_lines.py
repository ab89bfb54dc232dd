"""The dynamic stiffness of a joint at every line: results of identify_lines() and decouple()."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .dof import Dof
from .errors import InputError
from .results import FrfResult, Result, Unknown

_OF_95_PERCENT = 1.959963984540054  # standard errors on each side of a 95 % interval


def _complex(pairs: Any) -> np.ndarray:
    """Pairs (re, im) of JSON as complex numbers; NaN for null."""
    numbers = np.array(pairs, dtype=float)
    return numbers[..., 0] + 1j * numbers[..., 1]


@dataclass(frozen=True, eq=False)
class LineValues:
    """Elements of Z_J(ω) over frequency, as one way or one law gives them. NaN at lines without a value.

    ``band`` has the 95 % intervals of real and imaginary parts, [line, element, (real, imaginary), (low, high)].

    >>> import jointid, tempfile
    >>> values = jointid.identify_lines(jointid.write_problem("isolator", tempfile.mkdtemp())).result
    >>> shape = (len(values.frequency), len(values.elements))
    >>> values.name, values.z.shape == shape, values.band.shape == (*shape, 2, 2)
    ('likelihood', True, True)
    """

    name: str  #: the way or law, "likelihood", "zener" …
    elements: tuple[str, ...]  #: "z(1,1)" …
    frequency: np.ndarray  #: Hz, [line]
    z: np.ndarray  #: complex, [line, element], unit of the element
    std_error: np.ndarray  #: [line, element, (real, imaginary)]
    chi_square: np.ndarray  #: [line], NaN where the way has none
    degrees_of_freedom: np.ndarray  #: [line]

    @property
    def band(self) -> np.ndarray:
        """95 % intervals, [line, element, (real, imaginary), (low, high)]."""
        middle = np.stack([self.z.real, self.z.imag], axis=-1)
        half = _OF_95_PERCENT * self.std_error
        return np.stack([middle - half, middle + half], axis=-1)

    @property
    def loss_factor(self) -> np.ndarray:
        """Im z / Re z, [line, element]."""
        return self.z.imag / self.z.real


def _values(name: str, elements: tuple[str, ...], frequency: np.ndarray, lines: list) -> LineValues:
    shape = (len(frequency), len(elements))
    z, error = np.full(shape, np.nan, dtype=complex), np.full((*shape, 2), np.nan)
    chi_square, freedom = np.full(shape[0], np.nan), np.full(shape[0], np.nan)
    for at, line in enumerate(lines):
        if line is None:
            continue
        z[at] = _complex(line["z"])
        error[at] = np.array(line["std_error"], dtype=float)
        chi_square[at] = np.nan if line["chi_square"] is None else line["chi_square"]
        freedom[at] = line.get("degrees_of_freedom", np.nan)
    return LineValues(name, elements, frequency, z, error, chi_square, freedom)


class LineSolution(Result):
    """Dynamic stiffness Z_J(ω) of a joint at every line: of identify_lines(), and of identify() for scenes with ``[joint] lines``.

    The first way is the result. Others are for comparison: ``solution.ways["primal"]``.

    >>> import jointid, tempfile
    >>> solution = jointid.identify_lines(jointid.write_problem("isolator", tempfile.mkdtemp()))
    >>> sides = len(solution.dofs)
    >>> list(solution.ways)[0], solution.dynamic_stiffness().shape == (len(solution.frequency), sides, sides)
    ('likelihood', True)
    """

    @property
    def dofs(self) -> tuple[Dof, ...]:
        """Rows and columns of Z_J."""
        return tuple(Dof(name) for name in self["dofs"])

    @property
    def frequency(self) -> np.ndarray:
        """Hz, [line]."""
        return np.array(self["frequency_hz"], dtype=float)

    @property
    def ways(self) -> dict[str, LineValues]:
        """Values of each way, by its name. The first is the result."""
        return self._once("ways", self._ways)

    def _ways(self) -> dict[str, LineValues]:
        return {way["way"]: _values(way["way"], tuple(each["name"] for each in way["elements"]), self.frequency, way["lines"])
                for way in self["ways"]}

    @property
    def result(self) -> LineValues:
        """Values of the first way."""
        return next(iter(self.ways.values()))

    @property
    def elements(self) -> tuple[str, ...]:
        """Names of the elements of the first way, "z(1,1)" …"""
        return self.result.elements

    @property
    def z(self) -> np.ndarray:
        """Elements of the first way, complex, [line, element], N/m (rotations N·m/rad and N/rad). NaN at lines without a value."""
        return self.result.z

    @property
    def std_error(self) -> np.ndarray:
        """Standard errors of real and imaginary part, [line, element, 2]."""
        return self.result.std_error

    @property
    def band(self) -> np.ndarray:
        """95 % intervals, [line, element, (real, imaginary), (low, high)]."""
        return self.result.band

    @property
    def laws(self) -> dict[str, dict[str, Unknown]]:
        """Parameters of the laws with standard errors and 95 % intervals, by AIC, least first. Empty if no law was asked for."""
        return {law["law"]: {each["name"]: Unknown(each["name"], _number(each["value"]), each["unit"], each["std_error"],
                                                   _interval(each["ci95"]), each["std_error"] is not None, each)
                             for each in law["parameters"]}
                for law in self._numbers().get("laws", [])}

    def law_values(self, law: str | None = None) -> LineValues:
        """Values of a law at the lines; the law of the least AIC by default.

        Raises InputError for a law that was not fitted.
        """
        fitted = {each["law"]: each for each in self._numbers().get("laws", [])}
        if not fitted:
            raise InputError("no law was fitted", place="law_values", remedy='ask for laws: joint={..., "laws": "all"}')
        name = law or next(iter(fitted))
        if name not in fitted:
            raise InputError(f"there is no law {name!r}", place="law_values", remedy="it has " + ", ".join(fitted))
        return _values(name, self.elements, self.frequency, fitted[name]["lines"])

    def dynamic_stiffness(self, way: str | None = None) -> np.ndarray:
        """Z_J(ω) over the joint DOFs, [line, DOF, DOF], N/m, complex: the elements of a way put together.

        NaN at lines without a value. Raises InputError for a way that was not asked for.
        """
        name = way or next(iter(self.ways))
        if name not in self.ways:
            raise InputError(f"there is no way {name!r}", place="dynamic_stiffness", remedy="it has " + ", ".join(self.ways))
        values = self.ways[name]
        elements = next(each for each in self["ways"] if each["way"] == name)["elements"]
        out = np.zeros((len(self.frequency), len(self.dofs), len(self.dofs)), dtype=complex)
        for at, element in enumerate(elements):
            for row, column, factor in element["basis"]:
                out[:, row, column] += factor * values.z[:, at]
        return np.where(np.isnan(values.z).any(axis=1)[:, None, None], np.nan, out)

    def plot(self, element: str | None = None, *, ways: Any = None, law: str | None = None, axes: Any = None) -> Any:
        """Real and imaginary part of an element over frequency with 95 % bands, by matplotlib. Returns the two axes.

        `ways`: names; the first way by default. `law`: draws this law, too. Raises InputError for a way or
        a law that the solution does not have.
        """
        from ._plots import plot_lines

        name = element or self.elements[0]
        names = [next(iter(self.ways))] if ways is None else [ways] if isinstance(ways, str) else list(ways)
        chosen = [self.ways[each] for each in names if each in self.ways]
        if len(chosen) < len(names):
            raise InputError(f"there is no such way among {names}", place="plot", remedy="it has " + ", ".join(self.ways))
        units = {each["name"]: each["unit"] for way in self["ways"] for each in way["elements"]}
        return plot_lines(chosen, name, units.get(name, ""), None if law is None else self.law_values(law), axes)


def _number(value: float | None) -> float:
    return float("nan") if value is None else value


def _interval(numbers: Any) -> tuple[float, float] | None:
    if numbers is None or None in numbers:
        return None
    return numbers[0], numbers[1]


class DecoupledResult(FrfResult):
    """Substructure B from an assembly AB and A: of decouple() with a `way`, or of a scene with ``[decouple]``.

    ``result.frfs()`` is the FrfSet of the first way, with variances.

    >>> import jointid, tempfile
    >>> result = jointid.decouple(jointid.write_problem("decoupling-beams", tempfile.mkdtemp()))
    >>> result.frfs().variance is not None, result.stiffness.z.shape[0] == len(result.frequency)
    (True, True)
    """

    @property
    def interface(self) -> tuple[Dof, ...]:
        """The DOFs at which A and B meet."""
        return tuple(Dof(name) for name in self["interface"])

    @property
    def frequency(self) -> np.ndarray:
        """Hz, [line]."""
        return np.array(self["frequency_hz"], dtype=float)

    @property
    def stiffness(self) -> LineValues:
        """Dynamic stiffness of B at the interface, its symmetric elements over frequency, by likelihood."""
        found = self["stiffness_of_b"]
        return _values("likelihood", tuple(found["elements"]), self.frequency, found["lines"])

    def plot_frf(self, response: str | None = None, reference: str | None = None, axes: Any = None) -> Any:
        """Plots an FRF of B, the first by default, with its 95 % band of magnitude, by matplotlib. Returns the two axes."""
        from ._plots import plot_with_band

        return plot_with_band(self.frfs(), response, reference, axes)
