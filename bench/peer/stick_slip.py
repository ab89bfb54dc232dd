"""A belt chain (docs/oscillations.md) in numpy: the same Taylor series of order 24, coefficients by products with the matrix, events by
sampling the step's polynomial and bisection.

stick_slip.py MASSES UNTIL: prints the seconds of processor time, the number of events, then the times of the events.
"""
import sys
import time

import numpy as np

ORDER = 24
POWERS = np.arange(ORDER + 1)


def chain(n, c=0.01, v=0.2):
    k = 2.0 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
    k[-1, -1] = 1.0
    a = np.zeros((2 * n + 1, 2 * n + 1))
    a[:n, n : 2 * n] = np.eye(n)
    a[n : 2 * n, :n] = -k
    a[n : 2 * n, n : 2 * n] = -c * k
    b = np.zeros(2 * n + 1)
    b[2 * n - 1] = 1.0
    r = np.zeros(2 * n + 1)
    r[2 * n - 1], r[2 * n] = -1.0, v
    return a, b, r


def expand(a, b, r, z, mode, law):
    mu_k, drop, alpha, normal = law
    c = np.zeros((ORDER + 1, z.size))
    c[0] = z
    vr, e = np.zeros(ORDER + 1), np.zeros(ORDER + 1)
    for k in range(ORDER):
        new = a @ c[k]
        if mode != 0:
            vr[k] = r @ c[k]
            if k == 0:
                e[0] = np.exp(-alpha * mode * vr[0])
                new = new + b * (mode * normal * mu_k)
            else:
                e[k] = -alpha * mode / k * np.dot(POWERS[1 : k + 1] * vr[1 : k + 1], e[k - 1 :: -1][:k])
            new = new + b * (mode * normal * drop * e[k])
        c[k + 1] = new / (k + 1)
    size = np.abs(z[:-1]).max()
    last = np.abs(c[ORDER - 1 :, :-1]).max(axis=1)
    h = min((1e-17 * size / x) ** (1.0 / p) for x, p in zip(last, (ORDER - 1, ORDER)) if x > 0)
    return c, h


def first_root(p, h):
    taus = np.linspace(0.0, h, 33)
    values = np.polynomial.polynomial.polyval(taus, p)
    below = np.nonzero(values[1:] <= 0)[0]
    if below.size == 0:
        return None
    low, high = taus[below[0]], taus[below[0] + 1]
    for _ in range(60):
        middle = 0.5 * (low + high)
        if np.polynomial.polynomial.polyval(middle, p) > 0:
            low = middle
        else:
            high = middle
        if high - low < 1e-16:
            break
    return 0.5 * (low + high)


def run(n, until):
    mu_k, mu_s, alpha, normal = 0.3, 0.5, 2.0, 3.0
    law = (mu_k, mu_s - mu_k, alpha, normal)
    a, b, r = chain(n)
    held = (np.eye(2 * n + 1) - np.outer(b, r) / (r @ b)) @ a
    force = -(a.T @ r) / (r @ b)
    z = np.concatenate([0.9 * np.arange(1, n + 1), np.zeros(n), [1.0]])
    t, mode, zeros, events = 0.0, 1, 0, []
    while t < until:
        c, h = expand(held if mode == 0 else a, b, r, z, mode, law)
        h = min(h, until - t)
        best = None
        if mode == 0:
            for s in (1, -1):
                p = -s * (c @ force)
                p[0] += mu_s * normal
                tau = first_root(p, h)
                if tau is not None and (best is None or tau < best[0]):
                    best = (tau, s)
        else:
            tau = first_root((mode * (c @ r))[zeros:], h)
            if tau is not None:
                best = (tau, None)
        tau = h if best is None else best[0]
        z = (tau**POWERS) @ c
        t += tau
        zeros = 0
        if best is None:
            continue
        if mode == 0:
            mode, zeros = best[1], 2
        else:
            f = force @ z
            if abs(f) <= mu_s * normal:
                z = z - b * (r @ z) / (r @ b)
                mode = 0
            else:
                mode, zeros = int(np.sign(f)), 1
        events.append(t)
    return events


def main():
    n, until = int(sys.argv[1]), float(sys.argv[2])
    start = time.process_time()
    events = run(n, until)
    print(repr(time.process_time() - start))
    print(len(events))
    print("\n".join(repr(event) for event in events))


if __name__ == "__main__":
    main()
