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

from ._commands import (
    bound,
    check,
    compare,
    couple,
    decouple,
    equivalent,
    frf,
    friction_laws,
    identify,
    loading_curve,
    modalfit,
    oscillate,
    plan,
    pod,
    problems,
    response,
    study,
    virtual_points,
    write_problem,
)
from ._jointid import __version__
from .dof import Dof
from .errors import DataWarning, DoubtfulWarning, InputError, JointidWarning, UnusableWarning
from .frf_set import FrfSet, read, write
from .results import Finding, Result, Solution, Unknown

__all__ = [
    "DataWarning",
    "Dof",
    "DoubtfulWarning",
    "Finding",
    "FrfSet",
    "InputError",
    "JointidWarning",
    "Result",
    "Solution",
    "Unknown",
    "UnusableWarning",
    "__version__",
    "bound",
    "check",
    "compare",
    "couple",
    "decouple",
    "equivalent",
    "frf",
    "friction_laws",
    "identify",
    "loading_curve",
    "modalfit",
    "oscillate",
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
