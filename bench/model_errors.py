"""Intervals where a part is a model whose stiffness and mass are off. An independent simulation in NumPy.

    bench/model_errors.py JOINTID [SEEDS [KIND ...]]      (SEEDS of each kind, 200 unless told; needs numpy and scipy)

Two steel beams, the first measured, the second a model, joined by two springs with losses; FRFs have noise of 1 %. Each seed draws by
how much stiffness and mass of the model are off, and the noise. Kinds: what is drawn, and what the description states. Printed for
each kind: coverage of the 95 % intervals that are given, of all unknowns, their width over that of exact models, statuses, and how often the error of
the model is named. Ends with 1 where the coverage is not between 0.92 and 0.97 though the error is as stated.
"""

import collections
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import scipy.io
import scipy.sparse

ELEMENTS, LOSS, NOISE = 8, 0.01, 0.01
STIFFNESS, MASS = 0.02, 0.01  # standard deviations that the description states
LINES = np.linspace(30.0, 1500.0, 99)
SPRINGS, LOSSES = np.array([4e7, 3e4]), np.array([0.03, 0.05])
BANDS = "[{ range = [0, 500], error = 0.01 }, { range = [500, 2000], error = 0.03 }]"
# of the deviations that are stated; what is stated; whether each band has an error of its own
KINDS = {
    "exact": (0.0, "", False),
    "as stated": (1.0, f"stiffness_error = {STIFFNESS}\nmass_error = {MASS}\n", False),
    "as stated, in bands": (1.0, f"stiffness_error = {BANDS}\n", True),
    "three times": (3.0, f"stiffness_error = {STIFFNESS}\nmass_error = {MASS}\n", False),
    "not stated": (1.0, "", False),
}
PROMISED = ("as stated", "as stated, in bands")


def beam(length):
    """Matrices of a free Euler–Bernoulli beam: deflection and slope of each node."""
    step, stiffness, mass = length / ELEMENTS, 2.1e11 * 0.03 * 0.012**3 / 12, 7800 * 0.03 * 0.012
    k = stiffness / step**3 * np.array([[12, 6 * step, -12, 6 * step], [6 * step, 4 * step**2, -6 * step, 2 * step**2],
                                        [-12, -6 * step, 12, -6 * step], [6 * step, 2 * step**2, -6 * step, 4 * step**2]])
    m = mass * step / 420 * np.array([[156, 22 * step, 54, -13 * step], [22 * step, 4 * step**2, 13 * step, -3 * step**2],
                                      [54, 13 * step, 156, -22 * step], [-13 * step, -3 * step**2, -22 * step, 4 * step**2]])
    size = 2 * (ELEMENTS + 1)
    stiff, heavy = np.zeros((size, size)), np.zeros((size, size))
    for e in range(ELEMENTS):
        at = slice(2 * e, 2 * e + 4)
        stiff[at, at] += k
        heavy[at, at] += m
    return stiff, heavy


def names(first):
    return [f"{first + n}:+{d}" for n in range(ELEMENTS + 1) for d in ("Y", "RZ")]


A, B = beam(0.55), beam(0.45)
DOFS_A, DOFS_B = names(1), names(101)
END_A, END_B = len(DOFS_A) - 2, 0
KEPT_A = [0, 4, 8, 12, END_A, END_A + 1]
KEPT_B = [END_B, END_B + 1, 4, 8, 12, 16]


def receptance(stiffness, mass):
    omega = 2 * np.pi * LINES
    return np.linalg.inv(stiffness[None] - (omega**2)[:, None, None] * mass[None])


def scales(seed, factor, in_bands):
    """ln of the true stiffness and mass of the model over what it has, on each line."""
    draw = np.random.default_rng(seed)
    if in_bands:
        low, high = draw.normal(size=2) * (0.01, 0.03)
        return factor * np.where(LINES < 500.0, low, high), np.zeros(len(LINES))
    stiffness, mass = draw.normal(size=2) * (STIFFNESS, MASS)
    return np.full(len(LINES), factor * stiffness), np.full(len(LINES), factor * mass)


def assembly(stiffness, mass):
    """On each line, with scales of the second part of their own."""
    n = len(DOFS_A)
    out = []
    for line, frequency in enumerate(LINES):
        k, m = np.zeros((2 * n, 2 * n), complex), np.zeros((2 * n, 2 * n))
        k[:n, :n], m[:n, :n] = A[0] * (1 + 1j * LOSS), A[1]
        k[n:, n:], m[n:, n:] = np.exp(stiffness[line]) * B[0] * (1 + 1j * LOSS), np.exp(mass[line]) * B[1]
        for i, (spring, loss) in enumerate(zip(SPRINGS, LOSSES)):
            ends = np.ix_([END_A + i, n + END_B + i], [END_A + i, n + END_B + i])
            k[ends] += spring * (1 + 1j * loss) * np.array([[1, -1], [-1, 1]])
        out.append(np.linalg.inv(k - (2 * np.pi * frequency) ** 2 * m))
    return np.array(out)


def write(path, frf, dofs, draw):
    deviation = NOISE * np.abs(frf) / np.sqrt(2)
    noisy = frf + deviation * (draw.normal(size=frf.shape) + 1j * draw.normal(size=frf.shape))
    scipy.io.savemat(path, {"frf": noisy, "frequency": LINES, "variance": deviation**2 * (1 + 1j), "axes": "FRC", "quantity": "receptance",
                            "response_dof": np.array(dofs, object), "reference_dof": np.array(dofs, object)})


def scene(folder):
    pairs = [[DOFS_A[END_A + i], DOFS_B[END_B + i]] for i in range(2)]
    springs = json.dumps(pairs)
    return f"""[data]
substructures = ["a.mat", "b.toml"]
assembly = ["ab.mat"]
[joint]
dofs = {json.dumps([pairs[0][0], pairs[1][0], pairs[0][1], pairs[1][1]])}
[joint.stiffness]
springs = {springs}
[joint.hysteretic_damping]
springs = {springs}
[identify]
method = "likelihood"
[[data.gains]]
gain = 0
"""


def run(jointid, kind, seed):
    factor, states, in_bands = KINDS[kind]
    draw = np.random.default_rng([seed, 1])
    with tempfile.TemporaryDirectory() as folder:
        file = lambda name: os.path.join(folder, name)
        own = receptance(A[0] * (1 + 1j * LOSS), A[1])
        write(file("a.mat"), own[:, KEPT_A][:, :, KEPT_A], [DOFS_A[i] for i in KEPT_A], draw)
        n = len(DOFS_A)
        kept = KEPT_A[:-1] + [n + i for i in KEPT_B[2:]]
        both = assembly(*scales(seed, factor, in_bands))
        write(file("ab.mat"), both[:, kept][:, :, kept], [(DOFS_A + DOFS_B)[i] for i in kept], draw)
        for name, matrix in zip("km", B):
            scipy.io.mmwrite(file(name + ".mtx"), scipy.sparse.coo_matrix(matrix), symmetry="general", precision=17)
        with open(file("b.toml"), "w") as out:
            out.write(f'mass = "m.mtx"\nstiffness = "k.mtx"\nloss_factor = {LOSS}\ndofs = {json.dumps(DOFS_B)}\n' + states)
        with open(file("scene.toml"), "w") as out:
            out.write(scene(folder))
        done = subprocess.run([jointid, "solve", file("scene.toml"), "--threads", "1", "--json", file("out.json")], capture_output=True, text=True)
        if done.returncode not in (0, 4):
            raise SystemExit(done.stderr)
        with open(file("out.json")) as result:
            return json.load(result)


def judge(results, widths):
    truth = np.concatenate([SPRINGS, SPRINGS * LOSSES])
    hits, wide, named = [], [], 0
    for result in results:
        ends = np.array([unknown["ci95"] or [np.nan, np.nan] for unknown in result["unknowns"]], float)
        if np.isnan(ends).any():  # a fit that is not usable has no intervals, and counts by its status alone
            named += "times the model's" in result["message"]
            continue
        hits.append((ends[:, 0] <= truth) & (truth <= ends[:, 1]))
        wide.append(ends[:, 1] - ends[:, 0])
        named += "times the model's" in result["message"]
    hits, wide = np.array(hits, float), np.median(np.array(wide), axis=0)
    widths = wide if widths is None else widths
    error = np.std(hits.mean(axis=1)) / np.sqrt(len(hits))
    statuses = dict(collections.Counter(result["status"] for result in results))
    return hits.mean(), error, hits.mean(axis=0).min(), wide / widths, statuses, named, wide


def main():
    jointid, seeds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    kinds = sys.argv[3:] or list(KINDS)
    broken, widths = False, None
    for kind in kinds:
        with ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda seed: run(jointid, kind, seed), range(seeds)))
        coverage, error, least, wide, statuses, named, own = judge(results, widths)
        widths = own if widths is None else widths
        print(f"{kind}: coverage {coverage:.3f} ± {error:.3f}, least {least:.3f}; widths {np.round(wide, 2)}; named {named}; {statuses}", flush=True)
        broken = broken or (kind in PROMISED and not 0.92 <= coverage <= 0.97)
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
