"""Sums and multiples of sets, with variances and coherences."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import InputError

if TYPE_CHECKING:
    from .frf_set import FrfSet


def _factor(value: Any) -> np.ndarray | None:
    """A number, or one number per line; None for other objects."""
    array = np.asarray(value)
    return array.astype(complex) if array.dtype.kind in "biufc" and array.ndim <= 1 else None


def scaled(frfs: FrfSet, by: Any) -> Any:
    """The set times a number, or times one number per line. Variances scale with its square; coherences stay."""
    factor = _factor(by)
    if factor is None:
        return NotImplemented
    if factor.ndim == 1 and len(factor) != len(frfs):
        raise InputError(f"{len(factor)} numbers for {len(frfs)} lines", place="product", remedy="give one number, or one for each line",
                         kind="data")
    factor = factor.reshape(-1, 1, 1) if factor.ndim else factor
    size = np.abs(factor)
    real, imaginary = factor.real**2, factor.imag**2
    variance = frfs.variance
    if variance is not None:
        variance = real * variance + imaginary * (variance.imag + 1j * variance.real)
    return frfs._like(frfs=frfs.frfs * factor, variance=variance, _covariance=frfs._times(frfs._covariance, size**2),
                      covariance_factor=frfs._times(frfs.covariance_factor, size[..., None] if size.ndim else size),
                      covariance_diagonal=frfs._times(frfs.covariance_diagonal, size**2))


def summed(first: FrfSet, second: Any, sign: float) -> Any:
    """The sum of sets with the same lines and DOFs, in any order and quantity. Errors are taken as independent; coherences are dropped."""
    if not isinstance(second, type(first)):
        return NotImplemented
    if not np.array_equal(first.frequency, second.frequency):
        raise InputError(f"{first.name} and {second.name} have other lines", place="sum", kind="data",
                         remedy="take the same lines of both: sel(band=...)")
    for own, others in ((first.responses, second.responses), (first.references, second.references)):
        if {dof.coordinate for dof in own} != {dof.coordinate for dof in others}:
            raise InputError(f"{first.name} and {second.name} have other DOFs", place="sum", kind="data",
                             remedy="take the same DOFs of both: sel(responses, references)")
    other = second.to(first.quantity).sel(first.responses, first.references)
    both = lambda a, b: None if a is None or b is None else a + b  # noqa: E731
    return first._like(frfs=first.frfs + sign * other.frfs, variance=both(first.variance, other.variance),
                       _covariance=both(first.covariance, other.covariance), covariance_factor=None, covariance_diagonal=None,
                       reference_correlation=None, coherence=None, averages=0.0)
