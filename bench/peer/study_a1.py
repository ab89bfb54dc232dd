"""Case A1 with WBS the plain way in numpy: all equations nn and nj stacked, one numpy.linalg.lstsq per trial.

study_a1.py FILE TRIALS LINES: 14 coordinates, the four of the joint last. FILE holds complex128 [trial, system,
line, 14, 14], system 0 the substructures side by side, 1 the assembly. Prints the seconds per solution (best of three
rounds), then the 20 unknowns of each trial in a line.
"""
import sys
import time

import numpy as np

N = 4  # joint coordinates
UPPER = [(i, j) for i in range(N) for j in range(i, N)]


def restriction():
    """T of a symmetric matrix: 16 elements from 10 unknowns."""
    t = np.zeros((N * N, len(UPPER)))
    for unknown, (i, j) in enumerate(UPPER):
        t[i * N + j, unknown] = t[j * N + i, unknown] = 1.0
    return t


T = restriction()


def solve(sub, asm):
    """K and D (upper triangles) from H_nj Z H_ba = H_aa - H_nn and H_nj Z H_bb = H_ab - H_nj; all lines at once."""
    n = sub.shape[1] - N
    a, b = asm[:, :n, n:], sub[:, n:, :]
    c = sub[:, :n, :] - asm[:, :n, :]
    a_weight = 1.0 / np.abs(a).max(axis=2)
    b_weight = 1.0 / np.abs(b).max(axis=1)
    a = a * a_weight[:, :, None]
    b = b * b_weight[:, None, :]
    c = c * a_weight[:, :, None] * b_weight[:, None, :]
    e = (a[:, :, None, :, None] * b.transpose(0, 2, 1)[:, None, :, None, :]).reshape(-1, N * N) @ T
    rows = np.empty((2 * e.shape[0], 2 * e.shape[1]))
    half, k = e.shape
    rows[:half, :k], rows[:half, k:] = e.real, -e.imag
    rows[half:, :k], rows[half:, k:] = e.imag, e.real
    c = c.reshape(-1)
    return np.linalg.lstsq(rows, np.concatenate([c.real, c.imag]), rcond=None)[0]


def main():
    trials, lines = int(sys.argv[2]), int(sys.argv[3])
    data = np.fromfile(sys.argv[1], dtype=np.complex128).reshape(trials, 2, lines, 14, 14)
    best = np.inf
    for _ in range(3):
        start = time.perf_counter()
        answers = [solve(sub, asm) for sub, asm in data]
        best = min(best, (time.perf_counter() - start) / trials)
    print(repr(best))
    for answer in answers:
        print(" ".join(repr(float(x)) for x in answer))


if __name__ == "__main__":
    main()
