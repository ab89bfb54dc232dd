"""Harmonic balance with sampled friction forces (AFT) in numpy: 1024 samples of a period, the same condensed equations, the same exact
derivative of each branch, the same Newton steps as bench_response.

response.py FILE SAMPLES: FILE is JSON with M, C, K, W, force (coordinate), amplitude, harmonics (odd), omegas, law ("bilinear", "iwan"), parameters.
Prints the seconds of processor time of the sweep, the number of frequencies that did not converge, then |X_1| at the force's coordinate.
"""
import json
import sys
import time

import numpy as np


def curve(law, p):
    if law == "bilinear":
        a, k = p
        return lambda u: (np.minimum(k * u, k * a), np.where(u < a, k, 0.0))
    f, k, chi, beta = p
    end = f * (1 + beta) / (k * (beta + (chi + 1) / (chi + 2)))

    def iwan(u):
        loss = (np.minimum(u, end) / end) ** (chi + 1) / (1 + beta)
        return np.where(u < end, k * u * (1 - loss / (chi + 2)), f), np.where(u < end, k * (1 - loss), 0.0)

    return iwan


class Aft:
    """F_n and dF_n/d(Re Q, Im Q) from samples of a half period's odd motion, its other half being the negative."""

    def __init__(self, harmonics, samples, law):
        self.law = law
        theta = 2 * np.pi * np.arange(samples) / samples
        e = np.exp(1j * np.outer(theta, harmonics))
        self.basis = np.empty((samples, 2 * len(harmonics)))
        self.basis[:, 0::2], self.basis[:, 1::2] = e.real, -e.imag
        self.transform = 2 / samples * e.conj().T

    def __call__(self, y):
        q = self.basis @ y
        start = int(np.argmax(np.abs(q)))
        basis, q = np.roll(self.basis, -start, axis=0), np.roll(q, -start)
        d = np.sign(np.diff(np.append(q, q[0])))
        turns = [0] + [i for i in range(1, len(q)) if d[i] != d[i - 1]] + [len(q)]
        f, df = np.empty_like(q), np.empty_like(basis)
        s = 1.0 if q[0] > 0 else -1.0
        t, slope = self.law(np.array([abs(q[0])]))
        stack = [(q[0], s * t[0], basis[0], slope[0] * basis[0])]
        f[0], df[0] = stack[0][1], stack[0][3]
        for begin, end in zip(turns[:-1], turns[1:]):
            if begin > 0:
                stack.append((q[begin], f[begin], basis[begin], df[begin]))
            sign, i = d[begin], begin + 1
            last = end + 1 if end < len(q) else end
            while i < last:
                j = last
                if len(stack) >= 3:
                    passed = np.nonzero(sign * (q[i:last] - stack[-2][0]) > 0)[0]
                    if len(passed):
                        j = i + passed[0]
                qr, fr, dqr, dfr = stack[-1]
                t, slope = self.law(np.maximum(0.0, sign * (q[i:j] - qr) / 2))
                f[i:j] = fr + 2 * sign * t
                df[i:j] = dfr + slope[:, None] * (basis[i:j] - dqr)
                if j < last:
                    stack = stack[:-2]
                i = j
        return np.roll(f, start), np.roll(df, start, axis=0)

    def harmonics(self, y):
        f, df = self(y)
        return self.transform @ f, self.transform @ df


def solve(case, aft, omega, start):
    m, c, k, w = (np.array(case[x]) for x in "MCKW")
    harmonics, joints = case["harmonics"], len(case["W"][0])
    p = np.zeros(len(m), dtype=complex)
    p[case["force"]] = case["amplitude"]
    size = 2 * len(harmonics)
    g, b, lines = [], [], []
    for n in harmonics:
        h = np.linalg.solve(k - (n * omega) ** 2 * m + 1j * n * omega * c, np.column_stack([w, p if n == 1 else 0 * p]))
        g.append(w.T @ h[:, :-1])
        b.append(w.T @ h[:, -1])
        lines.append(h[case["force"]])

    def evaluate(y):
        r, jacobian = y.copy(), np.eye(len(y))
        forces = []
        for i, bn in enumerate(b):
            for j in range(joints):
                r[j * size + 2 * i] -= bn[j].real
                r[j * size + 2 * i + 1] -= bn[j].imag
        for j in range(joints):
            f, df = aft.harmonics(y[j * size : (j + 1) * size])
            forces.append(f)
            for i, gn in enumerate(g):
                for l in range(joints):
                    row, moved = l * size + 2 * i, gn[l, j] * df[i]
                    r[row] += (gn[l, j] * f[i]).real
                    r[row + 1] += (gn[l, j] * f[i]).imag
                    jacobian[row, j * size : (j + 1) * size] += moved.real
                    jacobian[row + 1, j * size : (j + 1) * size] += moved.imag
        return r, jacobian, forces

    y = start
    if y is None:
        y = np.zeros(joints * size)
        for i, bn in enumerate(b):
            y[2 * i :: size], y[2 * i + 1 :: size] = bn.real, bn.imag
    r, jacobian, forces = evaluate(y)
    for _ in range(60):
        step = -np.linalg.solve(jacobian, r)
        share = 1.0
        for _ in range(12):
            after = evaluate(y + share * step)
            if np.linalg.norm(after[0]) < np.linalg.norm(r):
                break
            share /= 2
        y, (r, jacobian, forces) = y + share * step, after
        if np.linalg.norm(step) <= 1e-10 * np.linalg.norm(y):
            x = lines[0][-1] - sum(lines[0][j] * forces[j][0] for j in range(joints))
            return y, abs(x)
    return None, np.nan


def main():
    with open(sys.argv[1]) as file:
        case = json.load(file)
    aft = Aft(np.array(case["harmonics"]), int(sys.argv[2]), curve(case["law"], case["parameters"]))
    begin, y, sizes = time.process_time(), None, []
    for omega in case["omegas"]:
        y, size = solve(case, aft, omega, y)
        sizes.append(size)
    print(repr(time.process_time() - begin))
    print(sum(np.isnan(sizes)))
    print("\n".join(repr(float(size)) for size in sizes))


if __name__ == "__main__":
    main()
