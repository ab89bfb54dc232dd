"""Frequency response functions as arrays."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from . import _jointid
from ._arithmetic import scaled, summed
from ._scene import pair_of, text_of
from .dof import Dof
from .errors import DataWarning, InputError, short

__all__ = ["FrfSet"]

_DOUBLE = 2.0**-53  # the largest relative rounding error of float64
_SINGLE = 2.0**-24


def _refuse(place: str, problem: str, remedy: str) -> InputError:
    return InputError(problem, place=place, remedy=remedy, kind="data")


def _numbers(value: Any, dtype: type, place: str) -> np.ndarray:
    """As a contiguous array of float64 or complex128: the array itself where it is one."""
    if isinstance(value, np.ma.MaskedArray):  # what is masked was not measured
        value = value.astype(dtype).filled(np.nan)
    try:
        array = np.asarray(value)
    except ValueError:
        raise _refuse(place, "it makes no array: its rows have different lengths", "give rows of the same length") from None
    valid = "biufc" if dtype is complex else "biuf"
    if array.dtype.kind not in valid:
        raise _refuse(place, f"an array of {array.dtype} holds no {'complex' if dtype is complex else 'real'} numbers",
                      f"convert it to numbers of {dtype.__name__}")
    return np.ascontiguousarray(array, dtype=dtype)


def complex_numbers(value: Any, place: str) -> np.ndarray:
    """As a contiguous array of complex128."""
    return _numbers(value, complex, place)


def real_numbers(value: Any, place: str) -> np.ndarray:
    """As a contiguous array of float64."""
    return _numbers(value, float, place)


AXES = ("frequency", "output", "input")  # of to_xarray()


def _in_order(value: Any) -> Any:
    """A DataArray with named axes in the order of a set."""
    axes = tuple(getattr(value, "dims", ()))
    return value.transpose(*AXES) if axes != AXES and set(axes) == set(AXES) else value


def _shaped(value: Any, dtype: type, shape: tuple, place: str) -> np.ndarray | None:
    if value is None:
        return None
    array = _numbers(_in_order(value), dtype, place)
    if array.shape != shape:
        raise _refuse(place, f"its shape is {array.shape}, not {shape}", "the axes are [line, response, reference]")
    return array


def dofs_of(names: Iterable[str] | str, place: str) -> tuple[Dof, ...]:
    if isinstance(names, str):
        names = [names]
    try:
        dofs = tuple(Dof(name) for name in names)
    except InputError as error:
        raise InputError(error.problem, place=place, remedy=error.remedy, kind="data") from None
    except TypeError:
        raise _refuse(place, f"{short(names)} is no list of DOFs", 'give e.g. ["4:+Y", "4:+RZ"]') from None
    return dofs


def at_zero(name: str, quantity: str, target: str) -> str:
    return (f"{name}: at 0 Hz the {quantity} fixes no {target}: that line counts as not measured (NaN); "
            "leave it out by sel(band=(lowest, highest))")


def _positions(nodes: Any) -> dict[int, tuple[float, float, float]]:
    """Of a mapping, or of a table whose index are the nodes and whose three columns the coordinates."""
    if nodes is None:
        return {}
    if hasattr(nodes, "itertuples"):
        nodes = {row[0]: row[1:] for row in nodes.itertuples()}
    try:
        found: dict[int, Any] = {_node_number(node): tuple(float(x) for x in place) for node, place in nodes.items()}
    except (AttributeError, TypeError, ValueError):
        raise _refuse("nodes", "they are no positions of node numbers", "give {4: (0.1, 0.0, 0.25)}, in m") from None
    wrong = next((node for node, place in found.items() if len(place) != 3), None)
    if wrong is not None:
        raise _refuse("nodes", f"node {wrong} has {len(found[wrong])} coordinates", "give x, y and z in m")
    wrong = next((node for node, place in found.items() if not np.isfinite(place).all()), None)
    if wrong is not None:
        raise _refuse("nodes", f"the position of node {wrong} is not finite", "give x, y and z in m, or leave the node out")
    return found


def _numbers_of_nodes(node: Any) -> set[int]:
    """Of one number or several."""
    try:
        return {_node_number(each) for each in np.atleast_1d(np.asarray(list(node) if isinstance(node, (set, range)) else node)).tolist()}
    except (TypeError, ValueError):
        raise InputError(f"{short(node)} is no number of a node", place="node", remedy="give e.g. 4 or [4, 5]", kind="data") from None


def _node_number(node: Any) -> int:
    number = int(node)
    if not isinstance(node, str) and number != node:
        raise ValueError(node)
    return number


def _number(value: Any, place: str) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise _refuse(place, f"{short(value)} is no number", "give e.g. 5") from None


def _count_of(averages: Any) -> float:
    number = _number(averages, "averages")
    if not 0.0 <= number < np.inf:
        raise _refuse("averages", f"{number:g} is no number of averages", "give e.g. 5, or 0 where it is not known")
    return number


def _at(place: str, find: Any, *arguments: Any) -> Any:
    """What C++ finds; its errors with the place of an argument."""
    try:
        return find(*arguments)
    except InputError as error:
        raise InputError(error.problem, place=place, remedy=error.remedy, kind="data") from None


def _word(value: Any) -> str:
    return _at("quantity", _jointid.quantity_word, text_of(value, "quantity", "write receptance, mobility or accelerance"))


def _quantity_of_unit(unit: Any) -> str:
    return _at("unit", _jointid.quantity_of_unit, text_of(unit, "unit", "write e.g. m/N, m/s/N or g/N"))


def _precision(array: Any) -> float:
    kind = getattr(array, "dtype", None)
    return _SINGLE if kind is not None and kind in (np.dtype(np.complex64), np.dtype(np.float32)) else _DOUBLE


class FrfSet:
    """FRFs of one structure: lines × responses × references, with variances, covariances or coherences.

    Parameters
    ----------
    frfs : array, complex, [line, response, reference]
        In SI units of `quantity` (rotations in rad, moments in N·m) or in `unit`. NaN where not measured. A contiguous array of
        complex128 is not copied, even a read-only one. Any other array is copied once.
    frequency : array, Hz, [line]
        Strictly increasing.
    responses, references : sequence of DOFs, e.g. ``["4:+Y", "4:+RZ"]``
        Order of the axes, each coordinate once. The references are the responses by default.
    quantity : "receptance", "mobility" or "accelerance"
    unit : str, optional
        Unit of the numbers, such as ``"g/N"`` or ``"mm/N"``. It gives the quantity, too. The numbers are then converted (and copied).
    variance : array, complex, [line, response, reference], optional
        Variance of the real part + i · variance of the imaginary part. A real array is the variance of each.
    coherence : array, [line, response, reference], optional
        0 to 1. It needs `averages`, the number of averages.
    covariance : array, complex, [line, pair, reference], optional
        E[e_r e_s*] of the errors of one line and reference for s ≤ r. Pairs are in the order of the lower triangle, row by row.
        Without variances and coherences its diagonal gives the variances.
    covariance_factor : array, complex, [line, response, column, reference], optional, in place of `covariance`
        L of the covariances L Lᴴ + diag(d). It takes less memory than pairs if there are few hits and many sensors.
        `covariance_diagonal`, [line, response, reference], is d.
    nodes : {node: (x, y, z)}, or a DataFrame with the nodes as index and three columns, optional
        Positions in m.
    name : str
        Name of the set in messages and reports.

    Raises
    ------
    InputError
        For shapes that do not agree, numbers of another kind, wrong or repeated DOFs, lines that do not increase.

    >>> import numpy as np
    >>> f = np.linspace(10.0, 100.0, 4)
    >>> frfs = FrfSet(1.0 / (1e5 - (2 * np.pi * f) ** 2).reshape(-1, 1, 1) + 0j, f, ["1:+Z"], name="mass on a spring")
    >>> frfs
    mass on a spring: receptance (m/N), 4 lines from 10 to 100 Hz, 1 response × 1 reference
    >>> frfs["1:+Z", "1:+Z"].shape, frfs.to("accelerance").unit
    ((4,), 'm/(s^2*N)')
    """

    def __init__(self, frfs: Any, frequency: Any, responses: Iterable[str], references: Iterable[str] | None = None, *,
                 quantity: str = "receptance", unit: str | None = None, variance: Any = None, coherence: Any = None,
                 averages: float = 0.0, covariance: Any = None, covariance_factor: Any = None, covariance_diagonal: Any = None,
                 nodes: Mapping[int, Sequence[float]] | None = None, name: str = "arrays") -> None:
        self.name = str(name)
        self.responses = dofs_of(responses, "responses")
        self.references = self.responses if references is None else dofs_of(references, "references")
        self.quantity = _word(quantity) if unit is None else _quantity_of_unit(unit)
        self.frequency = _numbers(frequency, float, "frequency").reshape(-1)
        self.averages = _count_of(averages)
        self.nodes = _positions(nodes)
        self._axes: dict = {}
        self._repeats = 0
        self._precision = _precision(frfs)
        self.frfs: np.ndarray = self._checked(frfs)
        factor = self._factor(unit)
        if factor != 1.0:
            self.frfs = self.frfs * factor
        self._set_errors(variance, coherence, covariance, factor)
        self._set_factor(covariance_factor, covariance_diagonal, factor)
        self._add_variance_of_covariance()
        self.reference_correlation: np.ndarray | None = None
        self._validate()

    def _checked(self, frfs: Any) -> np.ndarray:
        array = _numbers(_in_order(frfs), complex, "frfs")
        shape = (len(self.frequency), len(self.responses), len(self.references))
        if array.ndim != 3:
            raise _refuse("frfs", f"it has {array.ndim} axes, not 3", "the axes are [line, response, reference]; "
                          "numpy.reshape or numpy.newaxis adds one")
        if array.shape != shape:
            hint = "; numpy.moveaxis(frfs, -1, 0) puts the lines first" if array.shape[-1] == shape[0] != array.shape[0] else ""
            raise _refuse("frfs", f"its shape is {array.shape}, and {shape[0]} lines, {shape[1]} responses and "
                          f"{shape[2]} references make {shape}", "the axes are [line, response, reference]" + hint)
        if array.size > 0 and np.asarray(frfs).dtype.kind != "c":
            warnings.warn(f"{self.name}: the array is real: magnitudes, real parts or spectra are no FRFs; give complex FRFs, or "
                          ".astype(complex) where nothing dissipates energy and they are real", DataWarning, stacklevel=3)
        return array

    def _factor(self, unit: str | None) -> float:
        if unit is None:
            return 1.0
        factor = _jointid.unit_factor(unit, self.quantity)
        rotation = next((dof for dof in (*self.responses, *self.references) if dof.is_rotation), None)
        if rotation and factor != 1.0:
            raise _refuse("unit", f"{unit!r} cannot scale {rotation} and translations alike", "give the numbers in SI units")
        return factor

    def _set_errors(self, variance: Any, coherence: Any, covariance: Any, factor: float) -> None:
        shape = self.frfs.shape
        variance = _in_order(variance)
        if variance is not None and np.asarray(variance).dtype.kind in "biuf":
            variance = np.asarray(variance) * (1 + 1j)
        self.variance = _shaped(variance, complex, shape, "variance")
        self.coherence = _shaped(coherence, float, shape, "coherence")
        if coherence is not None and variance is None and self.averages == 0.0:
            warnings.warn(f"{self.name}: coherences without averages give no errors of FRFs; give averages=, the number of averages",
                          DataWarning, stacklevel=4)
        pairs = len(self.responses) * (len(self.responses) + 1) // 2
        self._covariance = _shaped(covariance, complex, (shape[0], pairs, shape[2]), "covariance")
        if factor != 1.0:
            self.variance = self._times(self.variance, factor**2)
            self._covariance = self._times(self._covariance, factor**2)

    def _set_factor(self, rows: Any, diagonal: Any, factor: float) -> None:
        lines, responses, references = self.frfs.shape
        if rows is not None:
            array = np.asarray(rows)
            if array.ndim != 4:
                raise _refuse("covariance_factor", f"it has {array.ndim} axes, not 4", "the axes are [line, response, column, reference]")
            rows = _shaped(rows, complex, (lines, responses, array.shape[2], references), "covariance_factor")
        self.covariance_factor: np.ndarray | None = self._times(rows, factor) if factor != 1.0 else rows
        diagonal = _shaped(diagonal, float, self.frfs.shape, "covariance_diagonal")
        self.covariance_diagonal: np.ndarray | None = self._times(diagonal, factor**2) if factor != 1.0 else diagonal

    def _add_variance_of_covariance(self) -> None:
        """Of each response, half for the real and half for the imaginary part, where nothing else states it."""
        if self.variance is not None or self.coherence is not None:
            return
        if self.covariance_factor is not None:
            whole = np.sum(np.abs(self.covariance_factor) ** 2, axis=2)
            whole = whole if self.covariance_diagonal is None else whole + self.covariance_diagonal
        elif self._covariance is not None:
            rows = np.arange(len(self.responses))
            whole = self._covariance[:, rows * (rows + 3) // 2, :].real
        else:
            return
        self.variance = whole * (0.5 + 0.5j)

    @staticmethod
    def _times(array: np.ndarray | None, factor: Any) -> np.ndarray | None:
        return None if array is None else array * factor

    def _validate(self) -> None:
        _jointid.MemoryFile(self._parts())

    @classmethod
    def _of(cls, parts: Mapping[str, Any]) -> "FrfSet":
        """What C++ hands over, without a copy."""
        self = cls.__new__(cls)
        array = lambda key: np.asarray(parts[key]) if parts[key] is not None else None  # noqa: E731
        self.name = parts["name"]
        self.responses = tuple(Dof(name) for name in parts["responses"])
        self.references = tuple(Dof(name) for name in parts["references"])
        self.quantity, self.averages = parts["quantity"], parts["averages"]
        self.nodes = {node: tuple(place) for node, place in parts["nodes"].items()}  # type: ignore[misc]
        self._axes, self._repeats, self._precision = parts["axes"], parts["repeats"], parts["precision"]
        self.frequency, self.frfs = np.asarray(parts["frequency"]), np.asarray(parts["frfs"])
        self.variance, self.coherence = array("variance"), array("coherence")
        self._covariance, self.reference_correlation = array("covariance"), array("reference_correlation")
        self.covariance_factor, self.covariance_diagonal = array("factor"), array("factor_diagonal")
        return self

    def _parts(self) -> dict[str, Any]:
        """For C++: the arrays themselves where they are contiguous."""
        array = lambda value, dtype: None if value is None else np.ascontiguousarray(value, dtype=dtype)  # noqa: E731
        return {"name": self.name, "frequency": array(self.frequency, float), "responses": list(self.responses),
                "references": list(self.references), "quantity": self.quantity, "averages": self.averages,
                "precision": self._precision, "repeats": self._repeats, "nodes": self.nodes, "axes": self._axes,
                "frfs": array(self.frfs, complex), "variance": array(self.variance, complex),
                "coherence": array(self.coherence, float), "covariance": array(self._covariance, complex),
                "factor": array(self.covariance_factor, complex), "factor_diagonal": array(self.covariance_diagonal, float),
                "reference_correlation": array(self.reference_correlation, complex)}

    def _like(self, **changes: Any) -> "FrfSet":
        new = type(self).__new__(type(self))
        new.__dict__.update(self.__dict__)
        new.__dict__.update(changes)
        return new

    # What it is.

    @property
    def unit(self) -> str:
        """Unit of translational FRFs."""
        return _jointid.quantity_unit(self.quantity)

    @property
    def covariance(self) -> np.ndarray | None:
        """E[e_r e_s*], [line, pair, reference], or None; formed of `covariance_factor` at each call where the set has that."""
        if self.covariance_factor is None:
            return self._covariance
        rows, columns = np.tril_indices(len(self.responses))
        lines, _, references = self.shape
        pairs = np.empty((lines, len(rows), references), complex)
        for k, (r, s) in enumerate(zip(rows, columns)):
            pairs[:, k] = np.einsum("lkc,lkc->lc", self.covariance_factor[:, r], self.covariance_factor[:, s].conj())
            if r == s and self.covariance_diagonal is not None:
                pairs[:, k] += self.covariance_diagonal[:, r]
        return pairs

    @covariance.setter
    def covariance(self, pairs: np.ndarray | None) -> None:
        self._covariance, self.covariance_factor, self.covariance_diagonal = pairs, None, None

    @property
    def dofs(self) -> tuple[Dof, ...]:
        """Responses, then references that are no responses."""
        return tuple(dict.fromkeys((*self.responses, *self.references)))

    @property
    def shape(self) -> tuple[int, int, int]:
        """(lines, responses, references)"""
        lines, rows, columns = self.frfs.shape
        return lines, rows, columns

    def __len__(self) -> int:
        return len(self.frequency)

    def __repr__(self) -> str:
        def count(number: int, word: str) -> str:
            return f"{number} {word}{'' if number == 1 else 's'}"

        lines, rows, columns = self.shape
        text = (f"{self.name}: {self.quantity} ({self.unit}), {count(lines, 'line')} from {self.frequency[0]:g} to "
                f"{self.frequency[-1]:g} Hz, {count(rows, 'response')} × {count(columns, 'reference')}")
        known = {"variance": self.variance, "coherence": self.coherence,
                 "covariance": self._covariance if self.covariance_factor is None else self.covariance_factor}
        extras = [word for word, array in known.items() if array is not None]
        return text + (", with " + " and ".join(extras) if extras else "")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, FrfSet):
            return NotImplemented
        same = lambda a, b: (a is None and b is None) or (a is not None and b is not None and  # noqa: E731
                                                          np.array_equal(a, b, equal_nan=True))
        return (self.responses == other.responses and self.references == other.references and self.quantity == other.quantity
                and same(self.frequency, other.frequency) and same(self.frfs, other.frfs) and same(self.variance, other.variance)
                and same(self.coherence, other.coherence) and self._same_covariance(other, same))

    def _same_covariance(self, other: "FrfSet", same: Any) -> bool:
        if (self.covariance_factor is None) != (other.covariance_factor is None):
            return same(self.covariance, other.covariance)
        return (same(self._covariance, other._covariance) and same(self.covariance_factor, other.covariance_factor)
                and same(self.covariance_diagonal, other.covariance_diagonal))

    __hash__ = None  # type: ignore[assignment]

    # Parts of it.

    def _place(self, dofs: tuple[Dof, ...], text: str, which: str) -> tuple[int, int]:
        dof = Dof(text)
        for index, own in enumerate(dofs):
            if own.coordinate == dof.coordinate:
                return index, own.sign * dof.sign
        raise InputError(f"{self.name} has no {which} {dof}", place=which, kind="data", remedy="it has " + ", ".join(dofs[:12])
                         + (" …" if len(dofs) > 12 else ""))

    def __getitem__(self, key: Any) -> np.ndarray:
        """``frfs["4:+Y", "1:+Y"]`` is one FRF over the lines, with the signs of these DOFs. ``frfs[f, out, in]`` is the view
        ``frfs.frfs[f, out, in]``; DOFs can replace the indices of responses and references.

        >>> import numpy as np
        >>> frfs = FrfSet(np.arange(12.0).reshape(3, 2, 2), [1.0, 2.0, 3.0], ["1:+X", "2:+X"])
        >>> frfs["2:+X", "1:-X"].real.tolist(), frfs[0, "2:+X", :].real.tolist(), frfs[2, 1, 0].real
        ([-2.0, -6.0, -10.0], [2.0, 3.0], 10.0)
        """
        if isinstance(key, tuple) and len(key) == 2 and all(isinstance(each, str) for each in key):
            key = (slice(None), *key)
        if not (isinstance(key, tuple) and len(key) == 3):
            raise InputError(f"{short(key)} is no pair of DOFs", place="frfs[...]",
                             remedy='write frfs["4:+Y", "1:+Y"], frfs[line, response, reference] or frfs.sel(...)')
        line, response, reference = key
        sign = 1
        if isinstance(response, str):
            response, own = self._place(self.responses, response, "response")
            sign *= own
        if isinstance(reference, str):
            reference, own = self._place(self.references, reference, "reference")
            sign *= own
        try:
            found = self.frfs[line, response, reference]
        except (IndexError, TypeError) as error:
            raise InputError(f"{key!r}: {error}", place="frfs[...]", kind="data",
                             remedy="it has {} lines, {} responses, {} references".format(*self.shape)) from None
        return found if sign == 1 else -found

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        """``numpy.asarray(frfs)`` is ``frfs.frfs``."""
        array = self.frfs if dtype is None else self.frfs.astype(dtype, copy=False)
        return array.copy() if copy else array

    __array_priority__ = 1000  # a number of NumPy times a set is a set
    __array_ufunc__ = None

    def __mul__(self, factor: Any) -> "FrfSet":
        return scaled(self, factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor: Any) -> "FrfSet":
        return scaled(self, 1.0 / np.asarray(divisor)) if np.asarray(divisor).dtype.kind in "biufc" else NotImplemented

    def __neg__(self) -> "FrfSet":
        return scaled(self, -1.0)

    def __add__(self, other: "FrfSet") -> "FrfSet":
        """The sum of sets with the same lines and DOFs. Errors are taken as independent: variances add."""
        return summed(self, other, 1.0)

    def __sub__(self, other: "FrfSet") -> "FrfSet":
        return summed(self, other, -1.0)

    def sel(self, responses: Iterable[str] | None = None, references: Iterable[str] | None = None, *,
            band: tuple[float, float] | None = None, node: int | Iterable[int] | None = None) -> "FrfSet":
        """A part of the set: given DOFs in their order and with their signs, the lines of a band, or the DOFs of nodes.

        For a band alone the arrays are views, not copies.

        Parameters
        ----------
        responses, references : sequence of DOFs
        band : (low, high), Hz, both included
        node : one or several node numbers

        >>> import numpy as np
        >>> frfs = FrfSet(np.ones((5, 2, 2)), np.arange(1.0, 6.0), ["1:+X", "2:+X"])
        >>> frfs.sel(["2:-X"], band=(2, 3)).frfs[:, 0, 0].real.tolist()
        [-1.0, -1.0]
        """
        out = self
        if node is not None:
            nodes = _numbers_of_nodes(node)
            responses = [dof for dof in out.responses if dof.node in nodes] if responses is None else responses
            references = [dof for dof in out.references if dof.node in nodes] if references is None else references
        if responses is not None or references is not None:
            out = out._of_dofs(responses, references)
        return out if band is None else out._of_band(band)

    def _of_dofs(self, responses: Iterable[str] | None, references: Iterable[str] | None) -> "FrfSet":
        rows_of = dofs_of(responses, "responses") if responses is not None else self.responses
        columns_of = dofs_of(references, "references") if references is not None else self.references
        if not rows_of or not columns_of:
            raise InputError("nothing is left", place="sel", remedy="name responses and references that are there", kind="data")
        rows, row_signs = zip(*(self._place(self.responses, dof, "response") for dof in rows_of))
        columns, column_signs = zip(*(self._place(self.references, dof, "reference") for dof in columns_of))
        signs = np.multiply.outer(row_signs, column_signs).astype(float)
        at = np.ix_(range(len(self)), rows, columns)
        part = lambda array: None if array is None else np.ascontiguousarray(array[at])  # noqa: E731
        pair = lambda r, s: max(r, s) * (max(r, s) + 1) // 2 + min(r, s)  # noqa: E731
        covariance = None
        if self._covariance is not None:
            covariance = np.empty((len(self), len(rows) * (len(rows) + 1) // 2, len(columns)), complex)
            for i, r in enumerate(rows):
                for k, s in enumerate(rows[: i + 1]):
                    value = self._covariance[:, pair(r, s), :][:, list(columns)]
                    covariance[:, pair(i, k), :] = (value if r >= s else value.conj()) * row_signs[i] * row_signs[k]
        correlation = None
        if self.reference_correlation is not None:
            correlation = np.ascontiguousarray(self.reference_correlation[np.ix_(range(len(self)), columns, columns)]
                                               * np.multiply.outer(column_signs, column_signs))
        factor = self.covariance_factor
        if factor is not None:
            factor = np.ascontiguousarray(factor[np.ix_(range(len(self)), rows, range(factor.shape[2]), columns)]
                                          * np.reshape(row_signs, (-1, 1, 1)))
        new = self._like(responses=rows_of, references=columns_of, frfs=part(self.frfs) * signs, variance=part(self.variance),
                         coherence=part(self.coherence), _covariance=covariance, covariance_factor=factor,
                         covariance_diagonal=part(self.covariance_diagonal), reference_correlation=correlation)
        new._validate()
        return new

    def _of_band(self, band: tuple[float, float]) -> "FrfSet":
        low, high = pair_of(band, "band")
        first, last = int(np.searchsorted(self.frequency, low, "left")), int(np.searchsorted(self.frequency, high, "right"))
        if first >= last:
            raise InputError(f"there is no line from {low:g} to {high:g} Hz", place="band", kind="data",
                             remedy=f"the lines go from {self.frequency[0]:g} to {self.frequency[-1]:g} Hz")
        part = lambda array: None if array is None else array[first:last]  # noqa: E731
        return self._like(**{key: part(getattr(self, key)) for key in
                             ("frequency", "frfs", "variance", "coherence", "_covariance", "covariance_factor", "covariance_diagonal",
                              "reference_correlation")})

    def copy(self) -> "FrfSet":
        """With arrays of its own."""
        return self._like(**{key: None if value is None else value.copy() for key, value in self.__dict__.items()
                             if isinstance(value, np.ndarray)})

    # Quantities and units.

    def to(self, quantity: str) -> "FrfSet":
        """The set as receptance, mobility or accelerance: FRFs times powers of iω.

        At 0 Hz an accelerance determines no mobility, and neither determines a receptance. The line becomes NaN (not measured), with a
        DataWarning.

        >>> import numpy as np
        >>> FrfSet(np.ones((1, 1, 1)), [1 / (2 * np.pi)], ["1:+X"]).to("mobility").frfs[0, 0, 0]
        1j
        """
        quantity = _word(quantity)
        order = {"receptance": 0, "mobility": 1, "accelerance": 2}
        power = order[quantity] - order[self.quantity]
        if power == 0:
            return self
        omega = 2.0 * np.pi * self.frequency
        if power < 0 and omega[0] == 0.0 and not np.isnan(self.frfs[0]).all():
            warnings.warn(at_zero(self.name, self.quantity, quantity), DataWarning, stacklevel=2)
        with np.errstate(divide="ignore", invalid="ignore"):
            size = np.where((omega == 0.0) & (power < 0), np.nan, omega ** float(power)).reshape(-1, 1, 1)
        turn = [1, 1j, -1, -1j][power % 4]
        swapped = self.variance is not None and power % 2
        variance = None if self.variance is None else (self.variance.imag + 1j * self.variance.real if swapped else self.variance)
        return self._like(quantity=quantity, frfs=self.frfs * (size * turn),
                          variance=self._times(variance, size**2), _covariance=self._times(self._covariance, size**2),
                          covariance_factor=self._times(self.covariance_factor, size[..., None]),
                          covariance_diagonal=self._times(self.covariance_diagonal, size**2))

    def values_in(self, unit: str) -> np.ndarray:
        """A copy of the numbers in another unit, also of another quantity: ``frfs.values_in("g/N")``. For translations only."""
        quantity = _quantity_of_unit(unit)
        return self.to(quantity).frfs / self._like(quantity=quantity)._factor(unit)

    # Elsewhere.

    def save(self, path: str | os.PathLike, format: str = "") -> None:
        """jointid.write(path, self)"""
        from .files import write

        write(path, self, format)

    def to_xarray(self) -> Any:
        """A DataArray with the dimensions frequency, output, input. It shares the numbers (no copy). Needs xarray."""
        from .bridges.xarray import to_xarray

        return to_xarray(self)

    def to_pandas(self) -> Any:
        """A DataFrame with one row per line and one column per (response, reference). Needs pandas."""
        from .bridges.pandas import to_pandas

        return to_pandas(self)

    def plot(self, response: str | None = None, reference: str | None = None, *, axes: Any = None, **style: Any) -> Any:
        """Plots magnitude and phase of one FRF, or of all if they are up to 16, by matplotlib. Returns the two axes."""
        from ._plots import plot_frfs

        return plot_frfs(self, response, reference, axes, style)
