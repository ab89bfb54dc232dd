"""The two large steps of a modal fit the plain way in numpy: polyreference poles, and weighted residues with poles given.

modalfit.py FILE OUTPUTS INPUTS LINES ENTRIES MODES ORDER: FILE holds float64: lines (Hz); the inputs' FRFs complex [output, input, line] and
their weights 1/sigma [output, input, line, 2]; all entries' FRFs [entry, line] and weights [entry, line, 2]; MODES pairs of Hz and eta.
Prints seconds of the poles, of the residues, then the poles of the highest order in the band (Hz, one line), then the residues of the
first entry.
"""
import sys
import time

import numpy as np

SHARE, RIDGE = 0.95, 1e-13


def toeplitz(lags):
    """[k, m] -> lags[m - k + n] for k, m = 0..n; lags has 2n+1 in its first axis."""
    n = (lags.shape[0] - 1) // 2
    k = np.arange(n + 1)
    return lags[k[None, :] - k[:, None] + n]


def poles(f, h, w, order, orders):
    outputs, inputs, lines = h.shape
    width = (f[-1] - f[0]) / SHARE
    start, rate = 0.5 * (f[-1] + f[0] - width), np.pi / width
    phi = rate * (f - start)
    turn = np.exp(1j * np.outer(np.arange(-order, order + 1), phi))
    size = (order + 1) * inputs
    m = np.zeros((size, size))
    for o in range(outputs):
        v = np.sqrt(2.0 * inputs / (1.0 / w[o] ** 2).sum(axis=(0, 2)))
        g = h[o] * v
        r = toeplitz((turn @ (v * v)).real)
        s = -toeplitz((turn @ (g * v).T).real)                      # [k, m, c]
        t = toeplitz((turn @ (g.conj()[:, None] * g[None, :]).reshape(-1, lines).T).real.reshape(-1, inputs, inputs))
        s = s.reshape(order + 1, size)
        t = t.transpose(0, 2, 1, 3).reshape(size, size)
        r[np.diag_indices(order + 1)] += RIDGE * np.trace(r)
        m += t - s.T @ np.linalg.solve(r, s)
    rest = m[inputs:, inputs:] + RIDGE * np.trace(m[inputs:, inputs:]) * np.eye(size - inputs)
    for n in orders:
        k = n * inputs
        alpha = -np.linalg.solve(rest[:k, :k], m[inputs:inputs + k, :inputs])
        companion = np.zeros((k, k))
        for j in range(n):
            companion[:inputs, j * inputs:(j + 1) * inputs] = -alpha[j * inputs:(j + 1) * inputs]
        companion[inputs:, :k - inputs] = np.eye(k - inputs)
        y = np.linalg.eigvals(companion)
    y = y[y.imag < 0]
    found = np.log(1.0 / y) / (1j * rate) + start
    return np.sort(np.abs(found[(found.real >= f[0]) & (found.real <= f[-1]) & (found.imag > 0)]))


def residues(f, h, w, modes):
    x = f / f[-1]
    columns = [1.0 / ((fr / f[-1]) ** 2 * (1 + 1j * eta) - x * x) for fr, eta in modes]
    columns += [-1.0 / x**2, -1j / x**2, np.ones_like(x) + 0j, 1j * np.ones_like(x)]
    basis = np.stack(columns, axis=1)
    real = np.stack([basis.real, basis.imag], axis=1).reshape(2 * len(f), -1)
    out = np.empty((len(h), real.shape[1]))
    for e in range(len(h)):
        weight = w[e].reshape(-1)
        a = real * weight[:, None]
        out[e] = np.linalg.solve(a.T @ a, a.T @ (h[e].view(np.float64) * weight))
    return out


def main():
    outputs, inputs, lines, entries, modes, order = map(int, sys.argv[2:8])
    orders = list(map(int, sys.argv[8].split(",")))
    data = np.fromfile(sys.argv[1])
    at = 0

    def take(*shape, dtype=np.float64):
        nonlocal at
        count = int(np.prod(shape)) * (2 if dtype is np.complex128 else 1)
        part = data[at:at + count].view(dtype).reshape(shape)
        at += count
        return part

    f = take(lines)
    h, w = take(outputs, inputs, lines, dtype=np.complex128), take(outputs, inputs, lines, 2)
    all_h, all_w = take(entries, lines, dtype=np.complex128), take(entries, lines, 2)
    given = take(modes, 2)
    start = time.perf_counter()
    found = poles(f, h, w, order, orders)
    middle = time.perf_counter()
    c = residues(f, all_h, all_w, given)
    print(repr(middle - start), repr(time.perf_counter() - middle))
    print(" ".join(repr(float(p)) for p in found))
    print(" ".join(repr(float(v)) for v in c[0]))


if __name__ == "__main__":
    main()
