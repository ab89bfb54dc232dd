"""Coupling of two parts in numpy: H_asm = H - X S^-1 X^T (docs/formulas.md §8, 5.36a), all lines at once in pieces of 50.

coupling.py FILE LINES N M: FILE holds complex128 [line, part, N, N]; coordinate k of part 0 is coordinate k of part 1 for k < M.
Prints the seconds of processor time of the best of three rounds, then for each line the sum of |H| over the coordinates of the assembly.
"""
import sys
import time

import numpy as np


def couple(parts, m):
    one, two = parts[:, 0], parts[:, 1]
    lines, n = one.shape[0], one.shape[1]
    h = np.zeros((lines, 2 * n - m, 2 * n - m), dtype=complex)
    h[:, :n, :n] = one
    h[:, n:, n:] = two[:, m:, m:]
    x = np.concatenate([one[:, :, :m], -two[:, m:, :m]], axis=1)
    y = np.concatenate([one[:, :m, :], -two[:, :m, m:]], axis=2)
    s = one[:, :m, :m] + two[:, :m, :m]
    return h - x @ np.linalg.solve(s, y)


def main():
    lines, n, m = (int(word) for word in sys.argv[2:5])
    parts = np.fromfile(sys.argv[1], dtype=np.complex128).reshape(lines, 2, n, n)
    best = np.inf
    for _ in range(3):
        start = time.process_time()
        coupled = [couple(parts[i : i + 50], m) for i in range(0, lines, 50)]
        best = min(best, time.process_time() - start)
        sums = [float(total) for piece in coupled for total in np.abs(piece).sum(axis=(1, 2))]
    print(repr(best))
    print("\n".join(repr(total) for total in sums))


if __name__ == "__main__":
    main()
