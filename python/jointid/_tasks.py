"""The other commands: of friction and motion, of files and arrays; built-in problems."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np

from . import _jointid
from ._records import save_record
from ._run import NoScene, run_scene, run_task, with_options
from ._scene import Scene, as_list, list_of, path_of, paths_of, text_of, whole_number
from .errors import InputError
from .files import open_options
from .frf_set import FrfSet, real_numbers
from .results import FrfResult, Result


def equivalent(scene: Any, *, threads: int = 0, progress: Any = None) -> Result:
    """Stiffness and damping of a friction joint over its relative displacement: ``jointid equivalent``. Takes a path or dict.

    Raises
    ------
    InputError
        For a wrong scene or file, with file, place, value and remedy.

    >>> import jointid, tempfile
    >>> levels = jointid.equivalent(jointid.write_problem("rig2", tempfile.mkdtemp()))["levels"]
    >>> len(levels)
    8
    """
    return run_scene(Scene(scene), "equivalent", _jointid.equivalent, threads=threads, progress=progress)


def friction_laws(scene: Any, *, threads: int = 0, progress: Any = None) -> Result:
    """Friction laws of joints from vibration at several force levels: ``jointid solve`` of scenes with ``[[joint.friction]]``.

    Takes a path, or a dict in which sets replace files: FrfSets for ``data.parts``, phasors() for responses and forces of
    ``data.levels``, or arrays [sample, channel] of time histories for ``records``, with ``channels`` and ``rate``.

    Raises
    ------
    InputError
        For a wrong scene or file, with file, place, value and remedy.

    >>> import jointid, numpy as np
    >>> f, omega = np.array([95.0, 100.0, 105.0]), 2 * np.pi * np.array([95.0, 100.0, 105.0])
    >>> part = jointid.FrfSet(-1 / (0.5 * omega**2).reshape(-1, 1, 1), f, ["1:+Y"], name="mass")  # 0.5 kg, free
    >>> def level(newton):  # on a spring that does not slip, 2e5 N/m
    ...     motion = newton / (2e5 - 0.5 * omega**2).reshape(-1, 1)
    ...     return {"responses": jointid.phasors(motion, f, ["1:+Y"], name=f"{newton} N"), "amplitude": newton,
    ...             "force_dofs": ["1:+Y"], "name": f"{newton} N"}
    >>> found = jointid.friction_laws({
    ...     "data": {"parts": [part], "levels": [level(1.0), level(2.0)]}, "frequency": {"range": [95.0, 105.0]},
    ...     "joint": {"friction": [{"name": "joint", "dofs": ["1:+Y"], "law": "spring"}]}, "errors": {"relative": 0.01}})
    >>> round(found["joints"][0]["stiffness"]["value"])
    200000
    """
    return run_scene(Scene(scene), "friction_laws", _jointid.solve, threads=threads, progress=progress)


def response(scene: Any, *, compare: bool = False, threads: int = 0, progress: Any = None) -> Result:
    """Periodic response of structures with friction joints (harmonic balance): ``jointid response``. Takes a path or dict.

    `compare`: the error over the run time of all methods instead, ``--compare``.

    Raises
    ------
    InputError
        For a wrong scene or file, with file, place, value and remedy.

    >>> import jointid, numpy as np
    >>> result = jointid.response({
    ...     "structure": {"mass": np.eye(2), "stiffness": [[300.0, -100.0], [-100.0, 100.0]], "damping": 0.5 * np.eye(2)},
    ...     "joints": [{"dofs": [1, 2], "law": "ren", "parameters": {"a": 0.004, "b": 1.5, "k": 150.0}}],
    ...     "force": {"dof": 1, "amplitudes": [1.0]}, "frequency": {"range": [1.0, 2.0], "points": 5}, "response": {"dofs": [1]}})
    >>> result.status
    'ok'
    """
    function = _jointid.response_ways if compare else _jointid.response
    return run_scene(Scene(scene), "response", function, threads=threads, progress=progress)


def oscillate(scene: Any, *, threads: int = 0, progress: Any = None) -> Result:
    """Exact stick–slip motion, orbits, exponents, reduced models: ``jointid oscillate``. Takes a path or dict.

    Raises
    ------
    InputError
        For a wrong scene or file, with file, place, value and remedy.

    >>> import jointid, tempfile
    >>> jointid.oscillate(jointid.write_problem("chain-10-orbit", tempfile.mkdtemp())).status
    'ok'
    """
    return run_scene(Scene(scene), "oscillate", _jointid.oscillate, threads=threads, progress=progress)


def modalfit(frfs: Any, *, range: tuple[float, float] | None = None, modes: int | None = None,
             poles: Sequence[tuple[float, float]] | None = None, real: bool = False, damping: str = "viscous",
             quantity: str | None = None, unit: str | None = None, progress: Any = None) -> FrfResult:
    """Modes of one structure from its FRFs (modal analysis), and the FRFs synthesised from them: ``jointid modalfit``.

    Parameters
    ----------
    frfs : FrfSet, path, or several paths
    range : (low, high), Hz
    modes : int
        Number of modes to keep, the most significant ones.
    poles : list of (Hz, damping ratio)
        Modes to refine, in place of a search.
    real : bool
        Real modes.
    damping : "viscous" (ratios) or "hysteretic" (loss factors)

    Returns
    -------
    FrfResult
        ``result["modes"]`` and the rest of the command's JSON. ``result.frfs()`` has the synthesised FRFs.

    Raises
    ------
    InputError
        For a range without lines, poles outside of it, and files that cannot be read.

    >>> import jointid, numpy as np
    >>> f = np.arange(30.0, 50.0, 0.1)
    >>> ratio = f / 40.0
    >>> frfs = jointid.FrfSet((1e-6 / (1 - ratio**2 + 0.02j * ratio)).reshape(-1, 1, 1), f, ["1:+Z"], name="beam")
    >>> mode = jointid.modalfit(frfs)["modes"][0]
    >>> round(mode["frequency_hz"], 6), round(mode["damping"], 6)
    (40.0, 0.01)
    """
    scene = Scene({})
    files = [scene.add(each) if isinstance(each, FrfSet) else path_of(each, "frfs") for each in as_list(frfs)]
    task = with_options(_jointid.ModalTask(), {"range": range, "modes": modes, "poles": poles, "real": real, "damping": damping},
                         "modalfit")
    options = open_options(quantity, unit)
    return run_task(NoScene(scene, files=files), "modalfit", progress, lambda watch: _jointid.modalfit(files, options, task, watch), FrfResult)


def loading_curve(curves: Any, *, progress: Any = None, **options: Any) -> Result:
    """Friction laws fitted to loading curves (hysteresis backbones) or loops: ``jointid loading-curve``.

    Parameters
    ----------
    curves : path or paths; or (displacement, force), or a list of these or {name: (displacement, force)}
        Arrays in m and N, loaded once from rest. One array of two columns is a curve.
    options : law, ring, limit, normal_load, friction_coefficient, shared, weighting, minimiser
        As those of the command. Of files also displacement, force, time, energy, stiffness, damping, unit, force_unit, time_unit,
        sign, velocity, kind, specimen_stiffness, specimen.

    Raises
    ------
    InputError
        For an unknown law or option, arrays of different lengths, and files that cannot be read.

    >>> import numpy as np, jointid
    >>> u = np.linspace(1e-6, 60e-6, 60)
    >>> jointid.loading_curve((u, np.minimum(1e7 * u, 200.0)), law=["bilinear"])["best_law"]
    'bilinear'
    """
    if isinstance(options.get("law"), str):
        options["law"] = [options["law"]]
    if isinstance(options.get("normal_load"), (int, float)):
        options["normal_load"] = [float(options["normal_load"])]
    task = with_options(_jointid.LoadingCurveTask(), options, "loading_curve")
    arrays = _curves(curves)
    if arrays is not None:
        names = NoScene(arrays={name: columns for name, *columns in arrays})
        return run_task(names, "loading_curve", progress, lambda watch: _jointid.loading_curve_arrays(arrays or [], task, watch))
    task.files = paths_of(curves, "curves", ", or arrays (displacement, force)")
    return run_task(NoScene(files=task.files), "loading_curve", progress, lambda watch: _jointid.loading_curve(task, watch))


def _curves(curves: Any) -> list[tuple[str, np.ndarray, np.ndarray]] | None:
    """Name, displacement, force of curves in memory; None of files."""
    if isinstance(curves, Mapping):
        named = list(curves.items())
    elif hasattr(curves, "columns"):
        raise InputError("a table has no order of displacement and force", place="curves", kind="data",
                         remedy='give (table["displacement"], table["force"])')
    elif not isinstance(curves, (list, tuple, np.ndarray)) or all(isinstance(each, (str, os.PathLike)) for each in curves):
        return None
    elif isinstance(curves, np.ndarray) and curves.ndim == 2 and curves.shape[1] == 2 and len(curves) != 2:
        named = [("curve", curves.T)]
    elif len(curves) == 2 and not any(_is_pair(each) for each in curves):
        named = [("curve", curves)]
    else:
        named = [(f"curve {k + 1}", curve) for k, curve in enumerate(curves)]
    return [(str(name), *_two_columns(curve, str(name))) for name, curve in named]


def _is_pair(curve: Any) -> bool:
    """Of arrays, not of numbers."""
    return isinstance(curve, (list, tuple, np.ndarray)) and len(curve) == 2 and all(np.iterable(each) for each in curve)


def _two_columns(curve: Any, name: str) -> tuple[np.ndarray, np.ndarray]:
    try:
        displacement, force = curve
    except (TypeError, ValueError):
        raise InputError(f"{name} is no pair of arrays", place="curves", remedy="give (displacement, force)", kind="data") from None
    return real_numbers(displacement, f"displacement of {name}"), real_numbers(force, f"force of {name}")


def frf(files: Any, *, progress: Any = None, **options: Any) -> FrfResult:
    """FRFs with coherences, variances and covariances of time records: ``jointid frf``.

    Parameters
    ----------
    files : path or paths, an array [sample, channel], several of these (one a hit), [hit, sample, channel], or a DataFrame
        Files are .npy, CSV or text, MATLAB, HDF5, UFF 58. A DataFrame has a column for each channel.
    options : channel (["2=1:+Z N", ...]), time, rate, reference, shaker, block, pretrigger, trigger, second_blow, force_window,
        exponential, overlap, window, remove_mean, reject, keep_faulty, estimator, variances, highest: as those of the command

    Returns
    -------
    FrfResult
        ``result.frfs()`` has the FRFs.

    Raises
    ------
    InputError
        For an unknown option, a channel that no record has, no force or several, and files that cannot be read.

    >>> import jointid, numpy as np
    >>> t = np.arange(1000) / 1000.0
    >>> def hit(size):  # force of a hammer, N, and acceleration of a mode at 80 Hz, m/s²
    ...     force = size * np.exp(-0.5 * ((t - 0.02) / 0.0008) ** 2)
    ...     return np.column_stack([force, np.convolve(force, np.exp(-8 * t) * np.sin(2 * np.pi * 80 * t))[:1000]])
    >>> frfs = jointid.frf([hit(1.0), hit(1.2)], channel=["1=1:+Z N", "2=4:+Z m/s^2"], rate=1000.0).frfs()
    >>> float(frfs.frequency[np.nanargmax(abs(frfs["4:+Z", "1:+Z"]))])
    80.0
    """
    rate = options.get("rate")
    if isinstance(rate, (int, float)) and not 0.0 < rate < np.inf:
        raise InputError(f"{rate:g} Hz is no rate of samples", place="rate", remedy="give the samples per second, above 0")
    task = with_options(_jointid.FrfTask(), options, "frf")
    with _record_files(files) as (paths, names):
        task.files = paths
        arrays = {name: [np.load(path, mmap_mode="r")] for path, name in names.items()}
        return run_task(NoScene(names=names, files=paths, arrays=arrays), "frf", progress, lambda watch: _jointid.frf(task, watch), FrfResult)


@contextmanager
def _record_files(records: Any) -> Iterator[tuple[list[str], dict[str, str]]]:
    """The paths of records, and names of those that are arrays, which are written to a folder that ends with the block."""
    if hasattr(records, "columns"):  # a DataFrame
        records = np.asarray(records)
    arrays = ([records] if records.ndim != 3 else list(records)) if isinstance(records, np.ndarray) else records
    if not isinstance(arrays, (list, tuple)) or not all(isinstance(each, np.ndarray) for each in arrays):
        yield paths_of(records, "files", ", or arrays [sample, channel]"), {}
        return
    with tempfile.TemporaryDirectory(prefix="jointid-") as folder:
        paths = [os.path.join(folder, f"record_{k + 1}.npy") for k in np.arange(len(arrays))]
        for path, array in zip(paths, arrays):
            save_record(path, array, f"record {paths.index(path) + 1}")
        yield paths, {path: f"record {k + 1}" for k, path in enumerate(paths)}


def _texts(value: Any, place: str) -> list[str]:
    remedy = "give a text for each channel"
    return [text_of(each, place, remedy) for each in list_of(value, place, remedy)]


def pod(record: Any, *, names: Sequence[str] | None = None, units: Sequence[str] | None = None, threads: int = 0,
        progress: Any = None, **options: Any) -> Result:
    """Proper orthogonal modes of time records of many channels: ``jointid pod``.

    Parameters
    ----------
    record : path or paths, or an array [sample, channel], or a DataFrame of channels
        Rows with NaN count as missing samples.
    names, units : of the channels of an array
    options : channels (of files), mass, stiffness, compare (files), keep_mean

    Raises
    ------
    InputError
        For arrays with other axes, names that are not as many as the channels, and files that cannot be read.

    >>> import numpy as np, jointid
    >>> t = np.arange(500) / 50
    >>> record = np.column_stack([0.6 * np.cos(2 * np.pi * t), 0.8 * np.cos(2 * np.pi * t)])
    >>> round(jointid.pod(record)["values"][0], 9)
    0.5
    """
    task = with_options(_jointid.PodTask(), options, "pod")
    if hasattr(record, "columns"):
        names = [str(column) for column in record.columns] if names is None else names
        record = np.asarray(record)
    if isinstance(record, np.ndarray):
        array = real_numbers(record, "record")
        if array.ndim != 2 or array.shape[1] == 0:
            raise InputError(f"its shape is {array.shape}", place="record", remedy="the axes are [sample, channel]", kind="data")
        channels = [str(k + 1) for k in np.arange(array.shape[1])] if names is None else _texts(names, "names")
        of_channels = [""] * array.shape[1] if units is None else _texts(units, "units")
        if not len(channels) == len(of_channels) == array.shape[1]:
            raise InputError(f"{len(channels)} names and {len(of_channels)} units for {array.shape[1]} channels", place="names",
                             remedy="give one for each channel", kind="data")
        return run_task(NoScene(arrays={"record": [array]}), "pod", progress, lambda watch: _jointid.pod_array(array, channels, of_channels, task, watch))
    task.files = paths_of(record, "record", ", or an array [sample, channel]")
    return run_task(NoScene(files=task.files), "pod", progress, lambda watch: _jointid.pod(task, threads, watch))


def problems() -> dict[str, str]:
    """Names and descriptions of the built-in problems with known answers: ``jointid problem list``.

    >>> problems()["A1"]
    'reference: two beams joined by a beam element without mass, 31 lines (§6.6.2)'
    """
    return _jointid.problems()


def write_problem(name: str, directory: str | os.PathLike, *, format: str = "h5", seed: int = 1, clean: bool = False) -> str:
    """Writes the files, the scene and the truth of a built-in problem into a folder: ``jointid problem write``.

    Returns the path of the scene; of loading curves and modal sets, that of the file.

    `format` is "h5" or "uff". `seed` is that of the noise. `clean` leaves out the noise.

    Raises
    ------
    InputError
        For a name or format that there is not, and a folder that cannot be written.

    >>> import os, tempfile
    >>> os.path.basename(write_problem("A1", tempfile.mkdtemp(), format="uff"))
    'A1.toml'
    """
    return _jointid.write_problem(str(name), path_of(directory, "directory"), str(format), whole_number(seed, "seed"), bool(clean))
