"""Random structures with friction joints: `jointid response` against harmonic balance by sampling (response.py beside this file).

    python3 bench/peer/random_responses.py build/dev/cli/jointid [STRUCTURES [SEED]]

Chains of one to six masses with one or two joints of one law, any level, frequency and list of harmonics. Both solve the same condensed
equations; Fourier integrals are event-exact there and sampled 16,384 times here. Prints the errors of |X_1| at the force; exit code 1 where
one is above 1e-6, or where a structure is refused.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import response as peer

SAMPLES, LIMIT = 16384, 1e-6


def curve(law, p):
    """Initial loading curve and its slope."""
    a, b = p[:2]
    if law == "shoukry":
        return lambda u: (a * (1 - np.exp(-b * u)), a * b * np.exp(-b * u))
    if law == "burdekin":
        end = -a / (2 * b)
        return lambda u: (np.where(u < end, a * u + b * u * u, a * end + b * end * end), np.where(u < end, a + 2 * b * u, 0.0))
    return peer.curve(law, p)


def parameters(law, rng):
    slip, stiffness = 10 ** rng.uniform(-2.7, -1.5), 10 ** rng.uniform(1.5, 2.7)
    return {
        "bilinear": [slip, stiffness],
        "iwan": [stiffness * slip, stiffness, rng.uniform(-0.7, 0.3), rng.uniform(0, 2)],
        "shoukry": [stiffness * slip, 1 / slip],
        "burdekin": [stiffness, -0.25 * stiffness / slip],
    }[law]


def structure(rng):
    n = int(rng.integers(1, 7))
    k = np.zeros((n, n))
    for i in range(n):
        s = rng.uniform(300, 900)
        k[i, i] += s
        if i:
            k[i - 1, i - 1] += s
            k[i, i - 1] = k[i - 1, i] = -s
    m = np.diag(rng.uniform(0.5, 2, n))
    return m, rng.uniform(5e-4, 3e-3) * k + rng.uniform(0, 0.2) * m, k


def joints(n, rng):
    """Coordinates of the joints' ends, from 0; one where it is to ground."""
    ends = [rng.integers(0, n, 2) for _ in range(int(rng.integers(1, 3)) if n > 1 else 1)]
    return [[int(a)] if a == b else [int(a), int(b)] for a, b in ends]


def case(rng):
    m, c, k = structure(rng)
    ends, law = joints(len(m), rng), str(rng.choice(["bilinear", "iwan", "shoukry", "burdekin"]))
    w = np.zeros((len(m), len(ends)))
    for column, end in enumerate(ends):
        for place, sign in zip(end, (1, -1)):
            w[place, column] += sign
    return {
        "M": m.tolist(), "C": c.tolist(), "K": k.tolist(), "W": w.tolist(), "ends": ends, "law": law,
        "parameters": [float(p) for p in parameters(law, rng)], "harmonics": [int(h) for h in range(1, 2 * rng.integers(1, 6), 2)],
        "omegas": [float(rng.uniform(5, 40))], "amplitude": float(10 ** rng.uniform(-0.3, 1.7)), "force": int(rng.integers(0, len(m))),
    }


def scene(of):
    text = "[structure]\n" + "".join(f"{key} = {json.dumps(of[name])}\n" for key, name in (("mass", "M"), ("damping", "C"), ("stiffness", "K")))
    for end in of["ends"]:
        text += f'[[joints]]\ndofs = {[place + 1 for place in end]}\nlaw = "{of["law"]}"\nparameters = {of["parameters"]}\n'
    dof = of["force"] + 1
    return (text + f"[force]\ndof = {dof}\namplitudes = [{of['amplitude']}]\n[frequency]\nvalues = [{of['omegas'][0] / (2 * np.pi)}]\n"
            f"[response]\ndofs = [{dof}]\nharmonics = {of['harmonics']}\n")


def main():
    program, count, seed = sys.argv[1], int((sys.argv[2:] or [150])[0]), int((sys.argv[3:] or [1])[0])
    rng, errors, refused = np.random.default_rng(seed), [], 0
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.toml"
        for number in range(count):
            of = case(rng)
            _, expected = peer.solve(of, peer.Aft(np.array(of["harmonics"]), SAMPLES, curve(of["law"], of["parameters"])), of["omegas"][0], None)
            file.write_text(scene(of))
            run = subprocess.run([program, "response", str(file), "--csv", "-"], capture_output=True, text=True)
            if run.returncode != 0 or not np.isfinite(expected):
                refused += 1
                print(f"structure {number} ({of['law']}): exit code {run.returncode}, {expected}: {run.stderr.strip()}")
                continue
            row = run.stdout.split("\n")[1].split(",")
            errors.append(abs(abs(complex(float(row[4]), float(row[5]))) - expected) / expected)
    print(f"{len(errors)} of {count} structures compared: error of |X_1| {np.median(errors):.2g} in the median, {max(errors):.2g} at most")
    return int(refused > 0 or max(errors) > LIMIT)


if __name__ == "__main__":
    sys.exit(main())
