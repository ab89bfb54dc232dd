"""Threads, Ctrl-C, progress, other processes."""

import concurrent.futures
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import jointid
import numpy as np
import pytest

#: Seconds: LONG takes a quarter of an hour.
WELL_BEFORE = 30.0
LONG = dict(trials=10_000_000, method="one", noise={"model": "gaussian", "level": 0.01})


def value_of(scene):
    return jointid.identify(scene)


def test_results_come_back_from_other_processes(a1):
    here = jointid.identify(a1)
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        for solution in pool.map(value_of, [a1, a1]):
            assert np.array_equal(solution.values, here.values) and solution.status == "ok"


def test_sets_go_to_other_processes(sets, joint):
    parts, assembly = sets
    here = jointid.identify(parts, assembly, joint)
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        assert np.array_equal(pool.submit(jointid.identify, parts, assembly, joint).result().values, here.values)


def test_errors_come_back_from_other_processes():
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        with pytest.raises(jointid.InputError, match="no such"):
            pool.submit(value_of, "none.toml").result()


def test_threads_identify_at_the_same_time(sets, joint):
    here = jointid.identify(*sets, joint)
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        for solution in pool.map(lambda _: jointid.identify(*sets, joint, threads=1), range(12)):
            assert np.array_equal(solution.values, here.values)


def test_other_threads_run_meanwhile(a1):
    """While the study computes, Python goes on in another thread."""
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    jointid.study(scene=a1, trials=1000, method="one", noise={"model": "gaussian", "level": 0.01})
    seconds = time.perf_counter() - start
    done.set()
    thread.join()
    assert counted > 50 * seconds


@pytest.mark.parametrize("stage", [0.05, 0.6])
def test_ctrl_c_ends_long_before_the_work(a1, stage):
    timer = threading.Timer(stage, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        jointid.study(scene=a1, **LONG)
    assert time.perf_counter() - start < stage + WELL_BEFORE


def test_ctrl_c_of_a_program(a1):
    """The process ends, too, with what a shell expects of SIGINT."""
    program = ("import jointid, sys\nprint('started', flush=True)\n"
               f"jointid.study(scene={a1!r}, trials=10**7, method='one', noise={{'model': 'gaussian', 'level': 0.01}})")
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.readline()
    time.sleep(0.5)
    start = time.perf_counter()
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert time.perf_counter() - start < WELL_BEFORE
    assert process.returncode in (-signal.SIGINT, 130) and b"KeyboardInterrupt" in errors


STUBBORN = """
import os, signal, sys, threading, time
import jointid
threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
start = time.perf_counter()
try:
    jointid.bound(sys.argv[1])
except KeyboardInterrupt:
    print(time.perf_counter() - start, flush=True)
"""


def test_ctrl_c_ends_work_that_does_not_look(tmp_path):
    """A step that takes longer than there is time goes on by itself, and ends with the process."""
    start = time.perf_counter()
    scene = jointid.write_problem("frame-laws", tmp_path)  # whose bound does not look for Ctrl-C
    done = subprocess.run([sys.executable, "-c", STUBBORN, scene], capture_output=True, text=True, timeout=60)
    assert float(done.stdout) < 0.3 + WELL_BEFORE, done.stderr
    assert done.returncode in (0, 130) and not done.stderr
    assert time.perf_counter() - start < 2.0 * WELL_BEFORE


def test_what_progress_raises_comes_back(a1):
    class Enough(Exception):
        pass

    def stop(stage, done, total):
        assert isinstance(stage, str) and 0 <= done <= total
        raise Enough

    start = time.perf_counter()
    with pytest.raises(Enough):
        jointid.study(scene=a1, progress=stop, **LONG)
    assert time.perf_counter() - start < WELL_BEFORE


def test_an_interrupted_study_goes_on(a1, tmp_path):
    class Enough(Exception):
        pass

    def stop(stage, done, total):
        raise Enough

    options = dict(trials=1500, method="one", noise={"model": "gaussian", "level": 0.01})
    with pytest.raises(Enough):
        jointid.study(scene=a1, out=tmp_path / "one.h5", progress=stop, **options)
    assert not (tmp_path / "one.h5").exists() and (tmp_path / "one.h5.partial").exists()
    one = jointid.study(scene=a1, out=tmp_path / "one.h5", resume=True, **options)
    two = jointid.study(scene=a1, out=tmp_path / "two.h5", **options)
    assert one["unknowns"] == two["unknowns"]
    assert (tmp_path / "one.h5").read_bytes() == (tmp_path / "two.h5").read_bytes()


def test_a_bar(a1, capsys):
    from jointid._progress import Bar

    bar = Bar()
    bar("trial", 5, 10)
    bar.close()
    shown = capsys.readouterr().err
    assert "5 of 10" in shown and shown.count("█") == 12 and shown.endswith(" " * 30 + "\r")
    jointid.study(scene=a1, trials=400, method="one", noise={"model": "gaussian", "level": 0.01}, progress=True)
    jointid.identify(a1)  # no terminal: nothing is told
    assert "jointid" not in capsys.readouterr().out


def test_nothing_is_left_in_memory(sets, joint):
    """Arrays are let go with the result."""
    import gc
    import weakref

    parts, assembly = sets
    solution = jointid.identify(parts, assembly, joint)
    parts, assembly, sets = None, None, None
    kept = weakref.ref(solution._scene)
    del solution
    gc.collect()
    assert kept() is None
