"""Results of commands."""

from __future__ import annotations

import html
import json
import os
import time
from dataclasses import dataclass, field
from typing import Any, Iterator

import numpy as np

from ._progress import watcher
from ._provenance import provenance
from ._scene import path_of, write_text
from .dof import Dof
from .errors import InputError

__all__ = ["BoundResult", "Finding", "FrfResult", "Result", "Solution", "Unknown"]

_SCREEN = 50  # lines


@dataclass(frozen=True)
class Finding:
    """A finding of the data against a result, or against the data themselves.

    >>> import jointid
    >>> print(jointid.Finding("sign", "all its FRFs have the other sign", remedy='flip = ["2:+Y"]', file="b.h5", dofs=(jointid.Dof("2:+Y"),)))
    sign (b.h5, 2:+Y): all its FRFs have the other sign
      remedy: flip = ["2:+Y"]
    """

    kind: str  #: "sign", "label", "gain", "warning", …
    text: str  #: what was seen, with its numbers
    remedy: str = ""  #: lines of a scene that put it right, or what to do
    file: str = ""  #: the file or set it is in
    dofs: tuple[Dof, ...] = ()
    confidence: float | None = None  #: 0 to 1, of suspects

    def __str__(self) -> str:
        where = ", ".join(part for part in (self.file, ", ".join(self.dofs)) if part)
        return f"{self.kind}{f' ({where})' if where else ''}: {self.text}" + (f"\n  remedy: {self.remedy}" if self.remedy else "")


@dataclass(frozen=True)
class Unknown:
    """An unknown of the joint, SI units.

    >>> import jointid, tempfile
    >>> unknown = jointid.identify(jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)).unknowns["K(1,1)"]
    >>> round(float(unknown)), unknown.unit, unknown.determined
    (662400, 'N/m', True)
    """

    name: str
    value: float  #: NaN where it is not finite
    unit: str
    std_error: float | None  #: None where the method has no honest one
    ci95: tuple[float, float] | None  #: 95 % interval
    determined: bool  #: False: the data do not fix it
    details: dict[str, Any] = field(default_factory=dict, repr=False, compare=False)  #: all that the JSON says of it

    def __float__(self) -> float:
        return self.value


def _pair(numbers: Any) -> tuple[float, float] | None:
    """Two numbers of JSON, NaN where they are null; None for null."""
    if numbers is None:
        return None
    low, high = (float("nan") if number is None else number for number in numbers)
    return low, high


def _suspects(check: dict[str, Any] | None) -> Iterator[Finding]:
    for each in (check or {}).get("suspects", []):
        yield Finding(each["kind"], each["evidence"], each["remedy"] or "", each["file"], tuple(Dof(dof) for dof in each["dofs"]),
                      each["confidence"])


class Result:
    """Result of a command: its JSON as a dict, its text, its tables and its page.

    ``print(result)`` is one screen, at most 50 lines; ``result.text()`` is all. A notebook shows the report page. ``result["key"]`` is an entry of ``result.to_dict()``.
    Results can be pickled with their texts and numbers. FRFs that a page would read again are left out, unless the page exists.

    >>> import jointid, pickle, tempfile
    >>> result = jointid.plan(jointid.write_problem("A1", tempfile.mkdtemp(), clean=True))
    >>> result["method"], result.to_dict() == pickle.loads(pickle.dumps(result)).to_dict()
    ('one', True)
    """

    def __init__(self, outcome: Any, scene: Any, command: str) -> None:
        self._outcome = outcome
        self._scene = scene  # keeps the FRFs in memory that the outcome may read again
        self._command = command
        self._ended_ns = time.time_ns()
        self._made: dict[str, Any] = {}

    def _once(self, what: str, make: Any) -> Any:
        if what not in self._made:
            self._made[what] = make()
        return self._made[what]

    def _text(self, what: str) -> str | None:
        def make() -> str | None:
            text = getattr(self._outcome, what)() if self._outcome is not None else None
            return None if text is None else self._scene.named(text)

        return self._once(what, make)

    @property
    def status(self) -> str:
        """The word of the JSON: "ok", "doubtful", "poor_fit" …; "" where the command has none."""
        return self._once("status", lambda: self._outcome.status)

    @property
    def message(self) -> str:
        """The reason of the status and the remedy. Empty if the status is "ok"."""
        return self._once("message", lambda: self._scene.named(self._outcome.message))

    @property
    def usable(self) -> bool:
        """Whether the numbers may be used."""
        return self._once("usable", lambda: self._outcome.usable)

    @property
    def provenance(self) -> dict[str, Any]:
        """How the result was made: version and commit, the function, every input with its size and SHA-256, the loaded libraries.

        Inputs are read for their sums when this is asked for first. A file that was written since then has no sum.
        """
        return self._once("provenance", lambda: provenance(self._command, self._scene.inputs(self._ended_ns)))

    def to_json(self) -> str:
        """The command's ``--json``, with `provenance` as its last key."""
        text = self._text("json") or "null"
        if not text.startswith("{"):
            return text
        made = json.dumps(self.provenance, indent=2, ensure_ascii=False).replace("\n", "\n  ")
        before = text[:text.rindex("}")].rstrip()
        return f'{before}{"" if before == "{" else ","}\n  "provenance": {made}\n}}\n'

    def to_dict(self) -> dict[str, Any]:
        """The command's JSON as lists and numbers of Python, with `provenance`. None where a value is not computed or not finite."""
        found = self._numbers()
        return {**found, "provenance": self.provenance} if isinstance(found, dict) else found

    def _numbers(self) -> dict[str, Any]:
        """The same without `provenance`."""
        return self._once("dict", lambda: json.loads(self._text("json") or "null"))

    def __getitem__(self, key: str) -> Any:
        found = self._numbers()
        if key not in found:
            raise KeyError(f"{key!r}; there are {', '.join(found)}")
        return found[key]

    def text(self) -> str:
        """The text that the command prints."""
        return self._text("text") or ""

    def csv(self) -> str | None:
        """The command's ``--csv``, or None where it has none."""
        return self._text("csv")

    def page(self, progress: Any = False) -> str | None:
        """The command's ``--report``: one page of HTML that loads nothing. None if the command has none, or after pickling."""
        if "page" not in self._made and self._outcome is not None:
            with watcher(progress) as watch, self._scene.errors():
                page = self._outcome.page(watch)
            self._made["page"] = None if page is None else self._scene.named(page)
        return self._made.get("page")

    @property
    def plots(self) -> dict[str, list[str]]:
        """The plots of the report page: sections, and the choices of each. Empty if the command has none."""
        return {section: list(choices) for section, choices in self._page_plots().items()}

    def _page_plots(self) -> dict[str, Any]:
        from ._page_plots import groups_of

        return self._once("plots", lambda: groups_of(self.page() or ""))

    def plot_page(self, section: str | None = None, choice: str | None = None, *, axes: Any = None) -> list[Any]:
        """Draws plots of the report page, by matplotlib. Returns their axes.

        Parameters
        ----------
        section, choice : str
            As listed by `plots`: ``result.plot_page("Predicted FRFs", "4:+Y/1:+Y")``. The first ones by default.
        axes
            As many axes as there are plots. None makes a figure.

        Raises
        ------
        InputError
            If the page has no plots, or no such section or choice.

        >>> import numpy as np, jointid, matplotlib
        >>> matplotlib.use("Agg")
        >>> u = np.linspace(1e-6, 60e-6, 60)
        >>> result = jointid.loading_curve((u, np.minimum(1e7 * u, 200.0)), law=["bilinear"])
        >>> "Curves and residuals" in result.plots
        True
        >>> len(result.plot_page("Curves and residuals"))
        2
        """
        from ._page_plots import chosen, draw

        title, plots = chosen(self._page_plots(), section, choice, self._command)
        return draw(title, plots, axes)

    @property
    def findings(self) -> list[Finding]:
        """Findings of the data against the result."""
        found = self._numbers()
        if not isinstance(found, dict):
            return []
        findings = list(_suspects(found if "suspects" in found else found.get("check")))
        for each in (found.get("identifiability") or {}).get("findings", []):
            findings.append(Finding(each["kind"], each["text"]))
        return findings + [Finding("warning", each) for each in found.get("warnings", [])]

    def _frfs(self, progress: Any) -> Any:
        from .frf_set import FrfSet

        if self._outcome is None:
            raise InputError("the FRFs are gone: the result was pickled, or released", place="result",
                             remedy="ask for them where the result was made")
        with watcher(progress) as watch, self._scene.errors():
            parts = self._outcome.frfs(watch)
        if parts is None:
            raise InputError(f"{self._command} makes no FRFs", place="result", remedy="see to_dict()")
        return FrfSet._of({**parts, "name": self._scene.named(parts["name"])})

    def release(self) -> None:
        """Releases the FRFs that page and predictions would read again. Texts and numbers stay."""
        for what in ("json", "text", "csv"):
            self._text(what)
        self.status, self.message, self.usable  # noqa: B018
        self._outcome = None

    def _page_with_provenance(self) -> str | None:
        page = self.page()
        footer = -1 if page is None else page.rfind("</footer>")
        if page is None or footer < 0:
            return page
        made = html.escape(json.dumps(self.provenance, indent=2, ensure_ascii=False))
        return f"{page[:footer]}<details><summary>How this page was made</summary><pre>{made}</pre></details>\n{page[footer:]}"

    def save(self, path: str | os.PathLike) -> None:
        """Writes .json, .csv, .txt, or the page as .html, by the ending of the name. JSON and page have `provenance`.

        Raises InputError for another ending, and for one that the command does not have.
        """
        path = path_of(path, "path")
        ending = os.path.splitext(path)[1].lower()
        makers = {".json": self.to_json, ".csv": self.csv, ".html": self._page_with_provenance, ".txt": self.text}
        if ending not in makers:
            raise InputError(f"{ending!r} is the ending of no result", file=path, remedy="write .json, .csv, .txt or .html")
        text = makers[ending]()  # type: ignore[operator]
        if text is None:
            raise InputError(f"{self._command} has no {ending}", file=path, remedy="write .json or .txt")
        write_text(path, text)

    def __repr__(self) -> str:
        """The text, as far as one screen has lines."""
        lines = self.text().rstrip("\n").split("\n")
        if len(lines) <= _SCREEN:
            return "\n".join(lines)
        return "\n".join([*lines[:_SCREEN - 1], f"… {len(lines) - _SCREEN + 1} more lines: print(result.text())"])

    __str__ = __repr__

    def _repr_html_(self) -> str:
        page = self.page()
        if page is None:
            return f"<pre>{html.escape(self.text())}</pre>"
        return (f'<iframe srcdoc="{html.escape(page)}" sandbox="allow-scripts allow-downloads" title="{html.escape(self._command)}" '
                'style="width: 100%; height: 40em; border: 1px solid #ccc"></iframe>')

    def __getstate__(self) -> dict[str, Any]:
        kept = dict(self._made)
        for what in ("json", "text", "csv"):
            kept[what] = self._text(what)
        kept.update(status=self.status, message=self.message, usable=self.usable, provenance=self.provenance)
        for made in ("dict", "plots"):
            kept.pop(made, None)
        return {"_made": kept, "_command": self._command, "_ended_ns": self._ended_ns}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state, _outcome=None, _scene=None)


class Solution(Result):
    """An identified joint.

    >>> import jointid, tempfile
    >>> solution = jointid.identify(jointid.write_problem("A1", tempfile.mkdtemp(), clean=True))
    >>> solution.unknowns["K(1,1)"].unit, solution.matrices["stiffness"].shape, solution.dofs[0]
    ('N/m', (4, 4), '4:+Y')
    """

    @property
    def unknowns(self) -> dict[str, Unknown]:
        """The unknowns by name, SI units, with standard errors and 95 % intervals if the method states them."""
        return self._once("unknowns", self._unknowns)

    def _unknowns(self) -> dict[str, Unknown]:
        out = {}
        for each in self["unknowns"]:
            value = float("nan") if each["value"] is None else each["value"]
            out[each["name"]] = Unknown(each["name"], value, each["unit"], each["std_error"], _pair(each["ci95"]), each["determined"],
                                        each)
        return out

    @property
    def joints(self) -> dict[str, dict[str, Unknown]]:
        """The unknowns of each joint of a scene with ``[[joints]]``, by its name and without it: ``joints["left"]["K(1,2)"]``.

        Empty for one ``[joint]``, whose unknowns have no joint's name.
        """
        out: dict[str, dict[str, Unknown]] = {}
        for name, unknown in self.unknowns.items():
            joint, dot, own = name.partition(".")
            if dot and joint not in ("K", "M", "C", "D"):
                out.setdefault(joint, {})[own] = unknown
        return out

    @property
    def values(self) -> np.ndarray:
        """Values of the unknowns, [unknown], SI units."""
        return np.array([each.value for each in self.unknowns.values()])

    @property
    def intervals(self) -> np.ndarray:
        """95 % intervals, [unknown, 2], SI units. NaN where there is none."""
        return np.array([each.ci95 or (np.nan, np.nan) for each in self.unknowns.values()]).reshape(-1, 2)

    @property
    def dofs(self) -> tuple[Dof, ...]:
        """Rows and columns of the matrices."""
        return tuple(Dof(name) for name in self["dofs"])

    @property
    def matrices(self) -> dict[str, np.ndarray]:
        """"stiffness" (N/m), "mass" (kg), "viscous_damping" (N·s/m), "hysteretic_damping" (N/m), those that the joint has.

        Scenes with several bands raise InputError; see `bands`.
        """
        if self["matrices"] is None and "blocks" not in self._numbers():
            raise InputError("the joint has several frequency bands", place="matrices", remedy="see solution.bands")
        return self._whole(self._numbers())

    @property
    def bands(self) -> list[tuple[tuple[float, float] | None, dict[str, np.ndarray]]]:
        """(band in Hz or None, matrices) of each band of the scene."""
        bands = self._numbers().get("bands") or [{"band_hz": None, **{key: self._numbers().get(key) for key in ("matrices", "blocks")}}]
        return [(_pair(band["band_hz"]), self._whole(band)) for band in bands]

    def _whole(self, band: dict[str, Any]) -> dict[str, np.ndarray]:
        """Matrices as they are, or put together of blocks, which joints of many DOFs have."""
        if band.get("matrices") is not None:
            return {kind: np.array(rows, dtype=float) for kind, rows in band["matrices"].items()}
        place = {name: at for at, name in enumerate(self["dofs"])}
        out: dict[str, np.ndarray] = {}
        for block in band["blocks"]:
            at = [place[name] for name in block["dofs"]]
            for kind, rows in block["matrices"].items():
                out.setdefault(kind, np.zeros((len(place), len(place))))[np.ix_(at, at)] = np.array(rows, dtype=float)
        return out

    def dynamic_stiffness(self, frequency: Any) -> np.ndarray:
        """Z_J(ω) = K − ω²M + i(ωC + D) of the joint, [line, DOF, DOF], N/m, at frequencies in Hz.

        >>> import jointid, tempfile
        >>> solution = jointid.identify(jointid.write_problem("A1", tempfile.mkdtemp(), clean=True))
        >>> solution.dynamic_stiffness([100.0, 200.0]).shape
        (2, 4, 4)
        """
        from .frf_set import real_numbers

        frequency = np.atleast_1d(real_numbers(frequency, "frequency"))
        out = np.full((len(frequency), len(self.dofs), len(self.dofs)), np.nan, dtype=complex)
        for band, matrices in self.bands:
            inside = np.ones(len(frequency), bool) if band is None else (frequency >= band[0]) & (frequency <= band[1])
            omega = 2.0 * np.pi * frequency[inside].reshape(-1, 1, 1)
            zero = np.zeros((len(self.dofs), len(self.dofs)))
            of = lambda kind: matrices.get(kind, zero)  # noqa: E731, B023
            out[inside] = (of("stiffness") - omega**2 * of("mass")
                           + 1j * (omega * of("viscous_damping") + of("hysteretic_damping")))
        return out

    def predicted(self, progress: Any = False) -> Any:
        """FrfSet of the assembly, synthesised from the substructures and the identified joint, at all lines that both have."""
        return self._frfs(progress)

    def plot_unknowns(self, axes: Any = None) -> Any:
        """Plots the values of the unknowns relative to their size with 95 % intervals, by matplotlib. Returns the axes."""
        from ._plots import plot_unknowns

        return plot_unknowns(self, axes)

    def plot_matrix(self, kind: str = "stiffness", axes: Any = None) -> Any:
        """Plots a joint matrix, by matplotlib. Returns the axes."""
        from ._plots import plot_matrix

        return plot_matrix(self, kind, axes)

    def plot_frf(self, response: str, reference: str, measured: Any = None, axes: Any = None) -> Any:
        """Plots a predicted FRF of the assembly, over that of the FrfSet `measured` if given, by matplotlib."""
        from ._plots import plot_predicted

        return plot_predicted(self, response, reference, measured, axes)


class FrfResult(Result):
    """A result with FRFs: of couple, modalfit, frf, expand and decouple.

    >>> import jointid, tempfile
    >>> whole = jointid.couple(jointid.write_problem("coupling-A", tempfile.mkdtemp(), clean=True))
    >>> whole.frfs().quantity
    'receptance'
    """

    def frfs(self, progress: Any = False) -> Any:
        """FrfSet of the predicted (couple), synthesised (modalfit) or estimated (frf) FRFs, [line, response, reference].

        Raises InputError if the FRFs are gone: the result was pickled, or released.
        """
        return self._frfs(progress)

    def plot_frf(self, response: str | None = None, reference: str | None = None, axes: Any = None) -> Any:
        """Plots magnitude and phase of one of these FRFs, or of all if they are up to 16, by matplotlib. Returns the two axes."""
        return self.frfs().plot(response, reference, axes=axes)


class BoundResult(Result):
    """Predicted standard errors of a test: of bound(). ``result["bound"]["unknowns"]`` has them, SI units and relative.

    >>> import jointid, tempfile
    >>> scene = jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)
    >>> result = jointid.bound(scene=scene, noise={"model": "gaussian", "level": 0.02})
    >>> len(result["bound"]["unknowns"])
    20
    """

    def plot_bound(self, axes: Any = None) -> Any:
        """Plots the smallest relative standard error of each unknown, by matplotlib. Returns the axes."""
        from ._plots import plot_bound

        return plot_bound(self, axes)
