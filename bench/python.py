"""What Python costs beside the C++ call and the command. PYTHONPATH=build/release/python bench/python.py build/release/cli/jointid

Handing over 226 MB of FRFs; what identify() of A1 does besides the library's work; a study of 1,000 trials beside the command's, by
processor time of all threads, which other work on the machine changes little.
"""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import jointid
import numpy as np
from jointid import _jointid
from jointid._joint import _joint_scene

JOINT = {"dofs": ["4:+Y", "4:+RZ", "5:+Y", "5:+RZ"], "stiffness": "symmetric", "hysteretic_damping": "symmetric"}


def best(work, rounds, clock=time.perf_counter):
    """Seconds, the least of so many rounds."""
    times = []
    for _ in range(rounds):
        start = clock()
        work()
        times.append(clock() - start)
    return min(times)


def of_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def handing_over():
    frfs = np.zeros((2400, 77, 77), complex)
    made = jointid.FrfSet(frfs, np.arange(1.0, 2401.0), [f"{k}:+X" for k in range(1, 78)])
    print(f"{frfs.nbytes / 1e6:.0f} MB handed over: {1e3 * best(lambda: _jointid.MemoryFile(made._parts()), 30):.3f} ms")


def around_identify(folder):
    parts = [jointid.read(f"{folder}/A1_substructure_{k}.h5") for k in (1, 2)]
    assembly = jointid.read(f"{folder}/A1_assembly.h5")

    def make_scene():
        return _joint_scene(parts, assembly, JOINT, "one", ["nn", "nj"], "WA", None, None, {"frequency": (400, 1000)})

    line = jointid.FrfSet(np.ones((1, 1, 1)), [1.0], ["1:+X"])
    coupled = jointid.couple([line, line._like(name="other", responses=(jointid.Dof("2:+X"),), references=(jointid.Dof("2:+X"),))],
                             join=[["1:+X", "2:+X"]])
    scene, thread = best(make_scene, 200), best(lambda: coupled._outcome.frfs(None), 200)
    print(f"around identify(A1): scene and arrays {1e3 * scene:.3f} ms, watched thread {1e3 * thread:.3f} ms")


FIRST_STUDY = """
import time, sys, jointid
start = time.process_time()
jointid.study(sys.argv[1], trials=1000, out=sys.argv[2]).to_json()
print(time.process_time() - start)
"""


def study_beside_command(scene, command, pairs=15):
    """In turn: the command with its start, and the first call of a new Python after its imports."""
    out = os.path.join(os.path.dirname(scene), "study.h5")

    def of_command():
        before = of_children()
        subprocess.run([command, "study", scene, "--trials", "1000", "--out", out, "--json", "-"], check=True, capture_output=True)
        os.remove(out)
        return of_children() - before

    def of_python():
        done = subprocess.run([sys.executable, "-c", FIRST_STUDY, scene, out], check=True, capture_output=True, text=True)
        os.remove(out)
        return float(done.stdout)

    def of_import():
        subprocess.run([sys.executable, "-c", "import jointid"], check=True)

    times = [(of_command(), of_python()) for _ in range(pairs)]
    command_s, python_s = (statistics.median(each) for each in zip(*times))
    ratio = statistics.median(python / own for own, python in times)
    print(f"study of 1,000 trials, processor time, medians of {pairs} in turn: first call of Python {python_s:.3f} s, command {command_s:.3f} s, "
          f"ratio of pairs {ratio:.2f}; Python with imports starts in {best(of_import, 9, of_children):.3f} s")


if __name__ == "__main__":
    handing_over()
    with tempfile.TemporaryDirectory() as folder:
        a1 = jointid.write_problem("A1", folder, clean=True)
        around_identify(folder)
        study_beside_command(a1, sys.argv[1])
