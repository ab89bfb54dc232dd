"""Mistakes of laboratories on simulated rigs: what `jointid check` and `jointid solve` say. An independent simulation in NumPy.

    bench/rig_mistakes.py JOINTID [SEEDS [KIND ...]]      (SEEDS of each kind, 200 unless told; needs numpy and h5py)

A seed draws two steel beams with three bolts, the places of 14 sensors, 3 to 10 hits, the noise of sensors and the size of the
mistake; files are HDF5 with coherences. The last kind has two mistakes at once. Printed for each kind: verdicts of the check; for each
method the statuses, and how many answers with status ok have a stiffness more than three standard errors from the truth. Ends with 1
where a promise of docs/checking-data.md is broken: no more such answers than chance gives to right intervals (99.9 % of a binomial law), at most 1 in 100
clean scenes worse than clean or ok, no mistake of the kinds below ALWAYS_TOLD that is called clean.
"""

import collections
import json
import math
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import h5py
import numpy as np

ELEMENTS, SENSORS, BOLTS = 18, 7, 3
METHODS = ("likelihood", "one")
ALWAYS_TOLD = ("bolts slacken", "cables of day two", "same run twice", "all in g", "one part in g", "sign", "label", "mass of a sensor")
CLEAN = ("clean", "clean, proportional noise")


def beam(length, stiffness, mass):
    """Matrices of an Euler–Bernoulli beam: deflection and slope of each node."""
    step = length / ELEMENTS
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


class Rig:
    """Two beams drawn at random; the last three sensors of the first and the first three of the second are at bolts."""

    def __init__(self, rng):
        sizes = [(rng.uniform(0.4, 1.0), rng.uniform(0.02, 0.06), rng.uniform(0.006, 0.02)) for _ in range(2)]
        losses = rng.uniform(0.001, 0.01, 2)
        self.bolts = 10 ** rng.uniform(5.5, 7.5) * 10 ** rng.uniform(-0.4, 0.4, BOLTS)
        self.bolt_losses = rng.uniform(0.01, 0.1, BOLTS)
        self.lines = np.arange(rng.uniform(15, 60), rng.uniform(700, 1500), 16.0)
        self.masses = [7850 * w * h * length for length, w, h in sizes]
        self.parts = []
        for (length, w, h), loss in zip(sizes, losses):
            stiff, heavy = beam(length, 2.07e11 * w * h**3 / 12, 7850 * w * h)
            self.parts.append((stiff * (1 + 1j * loss), heavy))
        free = SENSORS - BOLTS
        self.places = [sorted(rng.choice(12, free, replace=False)) + [13, 15, 17], [0, 2, 4] + sorted(6 + rng.choice(13, free, replace=False))]
        self.dofs = [[f"{first + k}:+Z" for k in range(SENSORS)] for first in (1, 101)]

    def accelerances(self, softer=1.0, bolts=None):
        """Of the two parts and the assembly [line, response, force]; Young's modulus and bolts times a factor."""
        omega = 2 * np.pi * self.lines[:, None, None]
        parts = [(softer * k, m) for k, m in self.parts]
        size = parts[0][0].shape[0]
        stiff, heavy = np.zeros((2 * size, 2 * size), complex), np.zeros((2 * size, 2 * size))
        for i, (k, m) in enumerate(parts):
            at = slice(i * size, (i + 1) * size)
            stiff[at, at], heavy[at, at] = k, m
        for b, spring in enumerate((self.bolts if bolts is None else bolts) * (1 + 1j * self.bolt_losses)):
            ends = [2 * self.places[0][SENSORS - BOLTS + b], size + 2 * self.places[1][b]]
            stiff[np.ix_(ends, ends)] += spring * np.array([[1, -1], [-1, 1]])
        at = [[2 * n for n in places] for places in self.places]
        out = []
        for (k, m), dofs in zip(parts + [(stiff, heavy)], at + [at[0] + [size + d for d in at[1]]]):
            forces = np.zeros((len(omega), k.shape[0], len(dofs)))
            forces[:, dofs, range(len(dofs))] = 1
            out.append(-omega**2 * np.linalg.solve(k - omega**2 * m, forces)[:, dofs])
        return out


def hit(rng, frf, hits, sensors, force=0.0, proportional=0.0):
    """H1 and coherence of so many hits: noise of sensors by the rms of a response, of the force, and in proportion to the FRF."""
    lines, responses, forces = frf.shape
    floor = sensors * np.sqrt(np.mean(np.abs(frf) ** 2, axis=(0, 2)))[None, :, None]

    def circular(*shape):
        return (rng.standard_normal(shape) + 1j * rng.standard_normal(shape)) / np.sqrt(2)

    cross, force_power, power = np.zeros(frf.shape, complex), np.zeros((lines, 1, forces)), np.zeros(frf.shape)
    for _ in range(hits):
        f = 1 + force * circular(lines, 1, forces)
        x = frf + floor * circular(*frf.shape) + proportional * np.abs(frf) * circular(*frf.shape)
        cross += x * np.conj(f)
        force_power += np.abs(f) ** 2
        power += np.abs(x) ** 2
    return cross / force_power, np.abs(cross) ** 2 / (power * force_power)


def write(path, lines, frf, coherence, hits, responses, forces):
    with h5py.File(path, "w") as file:
        file.attrs["format"], file.attrs["version"] = "jointid-frf", np.int32(1)
        file.create_dataset("frequency", data=lines).attrs["unit"] = "Hz"
        data = file.create_dataset("frf", data=frf)
        data.attrs["quantity"], data.attrs["unit"] = "accelerance", "m/(s^2*N)"
        for name, dofs in (("response_dof", responses), ("reference_dof", forces)):
            file.create_dataset(name, data=np.array(dofs, dtype=object), dtype=h5py.string_dtype("utf-8"))
        if coherence is not None:
            file.create_dataset("coherence", data=coherence).attrs["averages"] = float(hits)


def sign(rng):
    return rng.choice([-1, 1])


def gain_of(rng, low, high):
    return 1 + sign(rng) * 10 ** rng.uniform(low, high)


class Session:
    """The files of a seed: exact FRFs on which a mistake is made before they are measured (`before`) or after (`after`)."""

    def __init__(self, kind, seed):
        self.rng = rng = np.random.default_rng([seed, sum(map(ord, kind))])
        self.kinds = [kind] if kind != MIXED else [KINDS[k] for k in sorted(rng.choice(range(len(CLEAN), len(KINDS)), 2, replace=False))]
        self.rig = Rig(rng)
        self.hits, self.noise = int(rng.integers(3, 11)), 10 ** rng.uniform(-3.5, -1.8)
        self.force_noise, self.mass = 0.0, False
        self.names = [*self.rig.dofs, self.rig.dofs[0] + self.rig.dofs[1]]
        self.labels = [list(names) for names in self.names]
        self.count = 2 * SENSORS
        self.later = rng.permutation(self.count)[: self.count // 2] if rng.random() < 0.5 else np.arange(self.count // 2, self.count)
        if "all in g, mass known" in self.kinds:
            self.rig.lines = np.arange(2.0, 100.0, 2.0)
        self.exact = self.rig.accelerances()
        for each in self.kinds:
            self.before(each)
        if kind == "clean, proportional noise":
            self.files = [hit(rng, frf, 1, 0.0, 0.0, self.noise) for frf in self.exact]
        else:
            self.files = [hit(rng, frf, self.hits, self.noise, self.force_noise) for frf in self.exact]
        for each in self.kinds:
            self.after(each)

    def before(self, kind):
        rng, assembly = self.rng, self.exact[2]
        one, other = rng.choice(self.count, 2, replace=False)
        if kind == "bolts slacken":
            assembly[:, :, self.later] = self.rig.accelerances(bolts=self.rig.bolts * rng.uniform(0.2, 0.6))[2][:, :, self.later]
        elif kind == "warm on day two":
            assembly[:, :, self.later] = self.rig.accelerances(softer=0.99)[2][:, :, self.later]
        elif kind == "cables of day two":
            cells = np.ix_(range(len(self.rig.lines)), [one, other], self.later)
            assembly[cells] = assembly[cells][:, ::-1].copy()
        elif kind == "gain of 0.5 to 2 %":
            assembly *= 1 + sign(rng) * rng.uniform(0.005, 0.02)
        elif kind == "noise of the force":
            self.force_noise = rng.uniform(0.05, 0.2)
        elif kind == "sign":
            assembly[:, one] *= -1
        elif kind == "sign of response and force":
            assembly[:, one] *= -1
            assembly[:, :, one] *= -1
        elif kind == "label":
            self.labels[2][one] = "77:+Z"
        elif kind == "all in g":
            assembly /= 9.80665
        elif kind == "one part in g":
            self.exact[0] /= 9.80665
        elif kind == "all in g, mass known":
            for frf in self.exact:
                frf /= 9.80665
            self.mass = True
        elif kind == "mass of a sensor":  # it moves from response to response
            added = rng.uniform(0.005, 0.05) * np.mean(self.rig.masses)
            for i in range(self.count):
                assembly[:, i] /= 1 + added * assembly[:, i, i][:, None].copy()
        elif kind == "gain of a sensor":
            assembly[:, one] *= gain_of(rng, -1.7, -0.5)
        elif kind == "gain of a sensor of a part":
            self.exact[0][:, one % SENSORS] *= gain_of(rng, -1.7, -0.5)
        elif kind == "gain of one FRF":
            assembly[:, one, other] *= gain_of(rng, -1.0, 0.3)

    def after(self, kind):
        rng = self.rng
        frf, coherence = self.files[2]
        if kind == "dropouts":
            for line in rng.choice(len(self.rig.lines), int(rng.integers(1, 5)), replace=False):
                for force in range(self.count):
                    size = np.abs(frf[line, :, force]) * rng.uniform(0.5, 2)
                    frf[line, :, force] += size * (rng.standard_normal(self.count) + 1j * rng.standard_normal(self.count))
                    if rng.random() < 0.5:
                        coherence[line, :, force] = 0.3
        elif kind == "one wild value":
            frf = self.files[int(rng.integers(3))][0]
            frf[tuple(int(rng.integers(n)) for n in frf.shape)] *= 10 ** rng.uniform(1, 6)

    def write(self, folder):
        known = "clean, proportional noise" not in self.kinds
        for name, (frf, coherence), responses, forces in zip("ABS", self.files, self.labels, self.names):
            write(f"{folder}/{name}.h5", self.rig.lines, frf, coherence if known else None, self.hits, responses, forces)
        twice = "same run twice" in self.kinds
        if twice:
            os.link(f"{folder}/S.h5", f"{folder}/T.h5")
        springs = list(zip(self.rig.dofs[0][SENSORS - BOLTS:], self.rig.dofs[1]))
        assembly = [["S.h5", "T.h5"]] if twice else ["S.h5"]
        text = f'[data]\nsubstructures = ["A.h5", "B.h5"]\nassembly = {json.dumps(assembly)}\n'
        if self.mass:
            text += f'[data.files."A.h5"]\nmass = {self.rig.masses[0]:.4g}\n'
        text += f"[frequency]\nrange = [{max(0.0, self.rig.lines[0] - 1):g}, {self.rig.lines[-1] + 1:g}]\n"
        text += f"[joint]\ndofs = {json.dumps([a for a, _ in springs] + [b for _, b in springs])}\n"
        for matrix in ("stiffness", "hysteretic_damping"):
            text += f"[joint.{matrix}]\nsprings = {json.dumps(springs)}\n"
        noise = "" if known else f'[noise]\nmodel = "circular"\nlevel = {self.noise:.3g}\n'
        for method in METHODS:
            with open(f"{folder}/{method}.toml", "w") as file:
                file.write(f'{text}[identify]\nmethod = "{method}"\n{noise}')


def asked(command, folder):
    subprocess.run([*command, "--json", "out.json"], cwd=folder, capture_output=True, timeout=300, check=False)
    path = f"{folder}/out.json"
    if not os.path.exists(path):
        return None
    with open(path) as file:
        answer = json.load(file)
    os.remove(path)
    return answer


def deviation(answer, truth):
    """The largest error of a stiffness over its standard error."""
    errors = []
    for unknown in answer["unknowns"]:
        if unknown["name"].startswith("K"):
            expected = truth[len(errors)]
            errors.append(abs(unknown["value"] - expected) / (unknown.get("std_error") or unknown.get("error_estimate") or 0.01 * expected))
    return max(errors)


def outcome(jointid, kind, seed):
    """Verdict of the check, and of each method its status and, where ok, the largest error over its standard error."""
    with tempfile.TemporaryDirectory() as folder:
        session = Session(kind, seed)
        session.write(folder)
        check = asked([jointid, "check", "likelihood.toml"], folder)
        out = {"seed": seed, "kinds": session.kinds, "check": check["verdict"] if check else "refused"}
        for method in METHODS:
            answer = asked([jointid, "solve", f"{method}.toml"], folder)
            status = answer["status"] if answer else "refused"
            out[method] = (status, deviation(answer, session.rig.bolts) if status == "ok" else 0.0)
        return out


def chance(count):
    """As many of `count` right answers lie outside as chance allows in 999 of 1,000 tables: three stiffnesses, 3 standard errors each."""
    p = 1 - (1 - math.erfc(3 / math.sqrt(2))) ** BOLTS
    at_most, likely = 0, (1 - p) ** count
    total = likely
    while total < 0.999:
        at_most += 1
        likely *= (count - at_most + 1) / at_most * p / (1 - p)
        total += likely
    return at_most


KINDS = (*CLEAN, "bolts slacken", "warm on day two", "cables of day two", "gain of 0.5 to 2 %", "noise of the force", "dropouts", "one wild value",
         "same run twice", "all in g, mass known", "all in g", "one part in g", "sign", "sign of response and force", "label", "mass of a sensor",
         "gain of a sensor", "gain of a sensor of a part", "gain of one FRF")
MIXED = "two at once"  # of the kinds that are no clean ones


def table_row(kind, outcomes):
    """Prints a row; the promises that it breaks."""
    broken = []
    verdicts = collections.Counter(o["check"] for o in outcomes)
    clean = verdicts["clean"]
    cells = [f"{clean}", f"{len(outcomes) - clean - verdicts['refused']}", f"{verdicts['refused']}"]
    if kind in ALWAYS_TOLD and clean:
        broken.append(f"{kind}: {clean} called clean: seeds {[o['seed'] for o in outcomes if o['check'] == 'clean']}")
    if kind in CLEAN and len(outcomes) - clean > max(1, len(outcomes) // 100):
        broken.append(f"{kind}: {len(outcomes) - clean} not called clean: seeds {[o['seed'] for o in outcomes if o['check'] != 'clean']}")
    for method in METHODS:
        ok = [o for o in outcomes if o[method][0] == "ok"]
        far = [o for o in ok if o[method][1] > 3]
        cells += [f"{len(ok)}", f"{len(far)}"]
        if len(far) > chance(len(ok)):
            seeds = [(o["seed"], round(o[method][1], 1)) for o in far]
            broken.append(f"{kind}, {method}: {len(far)} of {len(ok)} ok answers are more than 3 standard errors off: {seeds}")
        if kind in CLEAN and len(outcomes) - len(ok) > max(1, len(outcomes) // 100):
            broken.append(f"{kind}, {method}: {len(outcomes) - len(ok)} not ok")
    print(f"| {kind} | {len(outcomes)} | " + " | ".join(cells) + " |", flush=True)
    return broken


def main(jointid, seeds="200", *kinds):
    print("| mistake | seeds | check: clean | told | refused | " + " | ".join(f"{m}: ok | of these > 3 σ off" for m in METHODS) + " |")
    print("|---|" + "---|" * (4 + 2 * len(METHODS)))
    unknown = [kind for kind in kinds if kind not in (*KINDS, MIXED)]
    if unknown:
        raise SystemExit(f"rig_mistakes: no kind is called {unknown[0]!r}; the kinds are {', '.join((*KINDS, MIXED))}")
    broken = []
    with ThreadPoolExecutor(os.cpu_count()) as team:
        for kind in kinds or (*KINDS, MIXED):
            broken += table_row(kind, list(team.map(lambda seed: outcome(os.path.abspath(jointid), kind, seed), range(1, int(seeds) + 1))))
    print("\n".join(broken) or "all promises hold")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
