"""What Ctrl-C leaves: the best values so far, and no work that goes on."""

import pickle
import signal
import threading
import time
from contextlib import contextmanager

import jointid
import numpy as np
import pytest
from jointid import _jointid


class Stop:
    """Raises KeyboardInterrupt, as Ctrl-C does, where `when` holds of what is told of the progress."""

    def __init__(self, when):
        self.when = when

    def __call__(self, stage, done, total):
        if self.when(stage, done, total):
            raise KeyboardInterrupt


def nothing_goes_on():
    """Loops look for a stop every few milliseconds of work, which other work on the machine may stretch."""
    end = time.perf_counter() + 30.0
    while _jointid.runs_left() > 0 and time.perf_counter() < end:
        time.sleep(0.01)
    return _jointid.runs_left() == 0


def stopped(work, when):
    with pytest.raises(KeyboardInterrupt) as caught:
        work(Stop(when))
    assert type(caught.value) is KeyboardInterrupt  # of another class Python would not end by SIGINT
    return caught.value


@contextmanager
def interrupted_after(seconds):
    """A signal of Ctrl-C so much later."""
    timer = threading.Timer(seconds, signal.raise_signal, [signal.SIGINT])
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def beams(lines, dofs, modes):
    """FRFs of as many modes, with noise."""
    f = np.linspace(1, 2000, lines)
    omega, random = 2 * np.pi * f, np.random.default_rng(0)
    frfs = np.zeros((lines, dofs, dofs), complex)
    for hz in np.linspace(20, 1900, modes):
        shape = random.normal(size=dofs)
        frfs += (1 / ((2 * np.pi * hz) ** 2 - omega**2 + 0.04j * np.pi * hz * omega))[:, None, None] * np.outer(shape, shape)
    frfs += 1e-3 * np.abs(frfs).mean() * random.normal(size=frfs.shape)
    return jointid.FrfSet(frfs, f, [f"{k}:+X" for k in range(1, dofs + 1)], name="beam")


def test_the_best_joint_so_far(noisy_a1):
    """The fit is there, and the bootstrap of its intervals goes on and on."""
    work = lambda progress: jointid.identify(scene=noisy_a1, method="likelihood", identify={"bootstrap": 100_000}, progress=progress)
    partial = stopped(work, lambda stage, done, total: "bootstrap" in stage).partial
    whole = jointid.identify(scene=noisy_a1, method="likelihood")
    assert isinstance(partial, jointid.Solution)
    assert partial.status == "not_converged" and partial.message.startswith("Interrupted") and not partial.usable
    np.testing.assert_allclose(partial.values, whole.values, rtol=1e-6)
    assert partial.matrices["stiffness"].shape == (4, 4) and "Interrupted" in partial.text() and partial.page() is None
    assert "memory" not in partial.text()


def test_the_ways_that_were_finished(a1):
    work = lambda progress: jointid.compare(a1, trials=400, methods=["one", "two"], weightings=["none", "WA"], progress=progress)
    partial = stopped(work, lambda stage, done, total: done > 0.6 * total).partial
    assert 1 <= len(partial["combinations"]) < 4 and partial["interrupted"] and "finished" in partial.message


def test_the_bound_that_was_predicted(tmp_path):
    """The bound of the data as planned is there, and what a candidate is worth goes on."""
    scene = jointid.write_problem("rig1", tmp_path)
    work = lambda progress: jointid.bound(scene, progress=progress)
    partial = stopped(work, lambda stage, done, total: "data set" in stage and "data set 1 " not in stage).partial
    whole = jointid.bound(scene)
    assert not partial.usable and "Interrupted" in partial.message
    assert partial["bound"]["unknowns"] == whole["bound"]["unknowns"]
    assert len(partial["bound"]["without_coordinate"]) < len(whole["bound"]["without_coordinate"])


def test_the_motion_that_was_found(tmp_path):
    """The motion is there, and its exponents go on."""
    scene = jointid._joint.Scene.table_of(jointid.write_problem("chain-3", tmp_path))
    scene["exponents"] = {"count": 2, "length": 9e5, "interval": 1.0}
    work = lambda progress: jointid.oscillate(scene, progress=progress)
    partial = stopped(work, lambda stage, done, total: stage == "exponents").partial
    scene.pop("exponents")
    assert "Interrupted" in partial.message and not partial.usable
    assert partial.csv() == jointid.oscillate(scene).csv() and "INTERRUPTED" in partial.text()


def test_work_that_hands_on_no_interruption_ends(tmp_path):
    """Reading and writing of large text look for themselves."""
    frfs = beams(3000, 24, 10)
    path = tmp_path / "large.csv"
    frfs.save(path)
    for work in (lambda: jointid.read(path), lambda: frfs.save(tmp_path / "again.csv")):
        with interrupted_after(0.1), pytest.raises(KeyboardInterrupt):
            work()
        assert nothing_goes_on()


def test_the_laws_that_were_fitted():
    u = np.linspace(1e-6, 60e-6, 30_000)
    force = np.minimum(1e7 * u, 200.0) + 0.5 * np.sin(1.7 * np.arange(30_000))
    work = lambda progress: jointid.loading_curve((u, force), law=["bilinear", "iwan", "ren", "shoukry"], progress=progress)
    partial = stopped(work, lambda stage, done, total: "bilinear" not in stage).partial
    assert "bilinear" in partial.text() and len(partial["fits"]) < 4
    assert nothing_goes_on()


def test_the_modes_so_far():
    small = beams(1000, 3, 14)
    work = lambda progress: jointid.modalfit(small, progress=progress)
    partial = stopped(work, lambda stage, done, total: "peaks" in stage or "refining" in stage).partial
    assert partial.status == "not_converged" and "Interrupted" in partial.message and 1 <= len(partial["modes"])
    assert partial.frfs().shape == (1000, 3, 3)


def test_a_large_modal_fit_ends():
    """Too large for its modes to be worked out in time: nothing is kept, and nothing goes on."""
    large = beams(2000, 30, 40)
    start = time.perf_counter()
    raised = stopped(lambda progress: jointid.modalfit(large, progress=progress), lambda *told: time.perf_counter() - start > 0.3)
    assert raised.partial is None or raised.partial.status == "not_converged"
    assert nothing_goes_on()


def test_nothing_so_far(a1):
    raised = stopped(lambda progress: jointid.study(a1, trials=10_000_000, method="one", progress=progress), lambda *told: True)
    assert raised.partial is None and str(raised) == "interrupted"


def test_a_study_says_how_it_goes_on(a1, tmp_path):
    work = lambda progress: jointid.study(a1, trials=10_000_000, method="one", out=tmp_path / "s.h5", progress=progress)
    raised = stopped(work, lambda stage, done, total: done > 200)
    assert "resume=True" in str(raised) and "s.h5" in str(raised)


def test_what_is_left_pickles(noisy_a1):
    work = lambda progress: jointid.identify(scene=noisy_a1, method="likelihood", identify={"bootstrap": 100_000}, progress=progress)
    raised = stopped(work, lambda stage, done, total: "bootstrap" in stage)
    again = pickle.loads(pickle.dumps(raised))
    assert "partial" in str(again) and again.partial.to_dict() == raised.partial.to_dict()
