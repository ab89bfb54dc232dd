"""Joints of structures from measured frequency response functions: arrays in, joint with uncertainty out.

>>> import jointid, tempfile
>>> scene = jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)
>>> solution = jointid.identify(scene)
>>> solution.status
'ok'
>>> round(solution.matrices["stiffness"][0, 0])
662400
"""

from __future__ import annotations

from ._correlation import Correlation, correlate, expand
from ._coupling import couple, decouple, virtual_points
from ._export import export
from ._joint import bound, check, compare, identify, identify_lines, plan, study
from ._jointid import __version__
from ._lines import DecoupledResult, LineSolution, LineValues
from ._phasors import phasors
from ._tasks import (
    equivalent,
    frf,
    friction_laws,
    loading_curve,
    modalfit,
    oscillate,
    pod,
    problems,
    response,
    write_problem,
)
from .dof import Dof
from .errors import DataWarning, DoubtfulWarning, InputError, JointidWarning, UnusableWarning
from .files import read, write
from .frf_set import FrfSet
from .results import BoundResult, Finding, FrfResult, Result, Solution, Unknown

__all__ = [
    "BoundResult",
    "Correlation",
    "DataWarning",
    "DecoupledResult",
    "Dof",
    "DoubtfulWarning",
    "Finding",
    "FrfResult",
    "FrfSet",
    "InputError",
    "JointidWarning",
    "LineSolution",
    "LineValues",
    "Result",
    "Solution",
    "Unknown",
    "UnusableWarning",
    "__version__",
    "bound",
    "check",
    "compare",
    "correlate",
    "couple",
    "decouple",
    "equivalent",
    "expand",
    "export",
    "frf",
    "friction_laws",
    "identify",
    "identify_lines",
    "loading_curve",
    "modalfit",
    "oscillate",
    "phasors",
    "plan",
    "pod",
    "problems",
    "read",
    "response",
    "study",
    "virtual_points",
    "write",
    "write_problem",
]
