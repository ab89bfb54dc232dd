"""FRFs from and to files."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Sequence
from typing import Any

from . import _jointid
from ._progress import watcher
from ._scene import path_of, paths_of, text_of, with_arguments
from .errors import DataWarning, InputError
from .frf_set import FrfSet, at_zero, dofs_of

__all__ = ["read", "write"]


def open_options(quantity, unit, responses=None, references=None, variable=None, frequency_variable=None, frequency_unit=None):
    options = _jointid.OpenOptions()
    options.quantity = None if quantity is None else text_of(quantity, "quantity", "write receptance, mobility or accelerance")
    options.unit = "" if unit is None else text_of(unit, "unit", "write e.g. m/N or g/N")
    options.responses = [str(dof) for dof in dofs_of(responses, "responses")] if responses is not None else []
    options.references = [str(dof) for dof in dofs_of(references, "references")] if references is not None else []
    options.variable = "" if variable is None else text_of(variable, "variable", "give the name of an array in the file")
    options.frequency_variable = "" if frequency_variable is None else \
        text_of(frequency_variable, "frequency_variable", "give the name of an array in the file")
    options.frequency_unit = "" if frequency_unit is None else text_of(frequency_unit, "frequency_unit", "write e.g. kHz or rad/s")
    return options


def read(path: str | os.PathLike | Sequence[str | os.PathLike], *, quantity: str | None = None, unit: str | None = None,
         responses: Iterable[str] | None = None, references: Iterable[str] | None = None, variable: str | None = None,
         frequency_variable: str | None = None, frequency_unit: str | None = None, progress: Any = None) -> FrfSet:
    """FRFs of a file, or of several files of one structure: UFF 55/58/58b, HDF5, MATLAB, CSV, npy, npz, text of analysers.

    Parameters
    ----------
    path : path, or several
    quantity, unit, responses, references, variable, frequency_variable, frequency_unit
        Information that the file does not have. Each is an error if it contradicts the file.

    Returns
    -------
    FrfSet
        In the quantity of the file, SI units, NaN where not measured. A line at 0 Hz of mobilities and accelerances is NaN, too, as it
        determines no receptance. This gives a DataWarning.

    Raises
    ------
    InputError
        With file, place, value and remedy.

    >>> import numpy as np, tempfile, os
    >>> file = os.path.join(tempfile.mkdtemp(), "beam.uff")
    >>> write(file, FrfSet(np.full((3, 1, 1), 2e-6 + 0j), [10.0, 11.0, 12.0], ["1:+Z"], quantity="mobility"))
    >>> read(file).frfs.ravel()
    array([2.e-06+0.j, 2.e-06+0.j, 2.e-06+0.j])
    """
    paths = paths_of(path, "path")
    if not all(paths):
        raise InputError("'' is no path", place="path", remedy="give the path of a file, or a list of them")
    if not paths:
        raise InputError("there is no file", place="path", remedy="name at least one")
    options = open_options(quantity, unit, responses, references, variable, frequency_variable, frequency_unit)
    try:
        with watcher(progress) as watch:
            parts = _jointid.read(paths, options, watch)
    except InputError as error:
        raise error.with_texts(with_arguments) from None
    for doubt in parts["doubts"]:
        warnings.warn(f"{parts['name']}: {doubt}", DataWarning, stacklevel=2)
    frfs = FrfSet._of(parts)
    if frfs.quantity != "receptance" and frfs.frequency[0] == 0.0:
        warnings.warn(at_zero(frfs.name, frfs.quantity, "receptance"), DataWarning, stacklevel=2)
    return frfs


def write(path: str | os.PathLike, frfs: FrfSet, format: str = "") -> None:
    """Writes FRFs in the format of the name's ending, or of `format`: h5 (with errors), uff, mat, csv.

    The file is written under another name first. So it is complete or not there.

    Raises
    ------
    InputError
        For an unknown ending, an object that is not a set, or a missing folder.

    >>> import numpy as np, os, tempfile
    >>> file = os.path.join(tempfile.mkdtemp(), "beam.csv")
    >>> write(file, FrfSet(np.full((3, 1, 1), 2e-6 + 0j), [10.0, 11.0, 12.0], ["1:+Z"]))
    >>> os.path.exists(file)
    True
    """
    if not isinstance(frfs, FrfSet):
        hint = " (the path comes first)" if isinstance(path, FrfSet) else ""
        raise InputError(f"{type(frfs).__name__} is no FrfSet{hint}", place="frfs",
                         remedy="jointid.FrfSet(array, frequency, dofs) makes one")
    _jointid.write(frfs._parts(), path_of(path, "path"), text_of(format, "format", "write h5, uff, mat or csv"))
