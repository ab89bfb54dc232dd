"""The likelihood of docs/likelihood.md the plain way in numpy: Gauss-Newton in the joint and all FRFs that it explains, steps
halved where they do not help, a dense QR per line.

likelihood.py FILE LINES COORDINATES JOINT: FILE holds float64 frequencies [line], then complex128 [system, line, C, C], system 0 the
substructures, 1 the assembly, then float64 variances of either part; reciprocal, and 0 with variance 0 across the parts. JOINT names
the joint coordinates, 0,1,14,15. K and D are symmetric and start from 0.8 of those that the file ends with. Prints the seconds it took, the
iterations, and the unknowns, upper triangles of K and D, in a line.
"""
import sys
import time

import numpy as np


class Line:
    """Measured blocks and weights of one line, and the state (X, Y) of its FRFs."""

    def __init__(self, sub, asm, sub_variance, asm_variance, others, joint):
        def block(matrix, rows, columns):
            return matrix[np.ix_(rows, columns)]

        self.n, self.j = len(others), len(joint)
        self.x, self.y = block(sub, joint, others), block(sub, joint, joint)
        self.x_at = np.argwhere(self.x != 0)
        self.y_at = np.array([(p, q) for p in range(self.j) for q in range(p, self.j) if self.y[p, q] != 0])
        self.upper_j, self.upper_n = np.triu_indices(self.j), np.triu_indices(self.n)
        values = [self.x[tuple(self.x_at.T)], self.y[tuple(self.y_at.T)], block(asm, joint, others).ravel(),
                  block(asm, joint, joint)[self.upper_j], (block(sub, others, others) - block(asm, others, others))[self.upper_n]]
        variances = [block(sub_variance, joint, others)[tuple(self.x_at.T)], block(sub_variance, joint, joint)[tuple(self.y_at.T)],
                     block(asm_variance, joint, others).ravel(), block(asm_variance, joint, joint)[self.upper_j],
                     (block(sub_variance, others, others) + block(asm_variance, others, others))[self.upper_n]]
        self.measured, self.weight = np.concatenate(values), 1.0 / np.sqrt(np.concatenate(variances))

    def reduced(self, z, bases):
        """QR of the weighted rows in (X, Y, theta, residual): what is left of theta, and what gives X and Y back."""
        p = np.linalg.inv(np.eye(self.j) + self.y @ z)
        a, b = p @ self.x, p @ self.y
        za, h = z @ a, self.x.T @ z @ p
        vx, vy = len(self.x_at), len(self.y_at)
        parts = [np.zeros((m, vx + vy + 2 * len(bases)), complex)
                 for m in (vx + vy, self.j * self.n, len(self.upper_j[0]), len(self.upper_n[0]))]
        parts[0][:, :vx + vy] = np.eye(vx + vy)
        for v, (row, column) in enumerate(self.x_at):
            da, dd = np.zeros_like(a), np.zeros((self.n, self.n), complex)
            da[:, column] = p[:, row]
            dd[column, :] += za[row]
            dd[:, column] += h[:, row]
            parts[1][:, v], parts[3][:, v] = da.ravel(), dd[self.upper_n]
        rest = np.eye(self.j) - z @ b
        for v, (row, column) in enumerate(self.y_at):
            e = np.zeros((self.j, self.j))
            e[row, column] = e[column, row] = 1.0
            parts[1][:, vx + v] = -(p @ e @ za).ravel()
            parts[2][:, vx + v] = (p @ e @ rest)[self.upper_j]
            parts[3][:, vx + v] = -(h @ e @ za)[self.upper_n]
        py, left = p @ self.y, self.x.T - h @ self.y
        for t, e in enumerate(bases + [1j * e for e in bases]):
            parts[1][:, vx + vy + t] = -(py @ e @ a).ravel()
            parts[2][:, vx + vy + t] = -(py @ e @ b)[self.upper_j]
            parts[3][:, vx + vy + t] = (left @ e @ a)[self.upper_n]
        jacobian = np.vstack(parts) * self.weight[:, None]
        residual = self.residual(z)
        frfs, theta = jacobian[:, :vx + vy], jacobian[:, vx + vy:]
        rows = np.block([[frfs.real, -frfs.imag, theta.real, residual.real[:, None]],
                         [frfs.imag, frfs.real, theta.imag, residual.imag[:, None]]])
        r = np.linalg.qr(rows, mode="r")
        v = 2 * (vx + vy)
        self.back = r[:v]
        return r[v:, v:]

    def answer(self, step):
        """The part of the FRFs in a step of theta."""
        v = self.back.shape[0]
        own = np.linalg.solve(self.back[:, :v], self.back[:, -1] - self.back[:, v:-1] @ step)
        self.step = own[:v // 2] + 1j * own[v // 2:]

    def move(self, part):
        self.x[tuple(self.x_at.T)] += part * self.step[:len(self.x_at)]
        for (row, column), value in zip(self.y_at, self.step[len(self.x_at):]):
            self.y[row, column] += part * value
            if row != column:
                self.y[column, row] += part * value

    def residual(self, z):
        a = np.linalg.solve(np.eye(self.j) + self.y @ z, self.x)
        b = np.linalg.solve(np.eye(self.j) + self.y @ z, self.y)
        predicted = np.concatenate([self.x[tuple(self.x_at.T)], self.y[tuple(self.y_at.T)], a.ravel(), b[self.upper_j],
                                    (self.x.T @ z @ a)[self.upper_n]])
        return (self.measured - predicted) * self.weight


def main():
    count, size = int(sys.argv[2]), int(sys.argv[3])
    joint = [int(word) for word in sys.argv[4].split(",")]
    others = [c for c in range(size) if c not in joint]
    data = np.fromfile(sys.argv[1])
    block = count * size * size
    frfs = data[count:count + 4 * block].view(complex).reshape(2, count, size, size)
    variance = data[count + 4 * block:count + 6 * block].reshape(2, count, size, size)
    upper = [(i, j) for i in range(len(joint)) for j in range(i, len(joint))]
    theta = 0.8 * data[count + 6 * block:]
    scale = np.abs(theta).max()
    start = time.perf_counter()
    lines = [Line(frfs[0, i], frfs[1, i], variance[0, i], variance[1, i], others, joint) for i in range(count)]
    bases = []
    for i, j in upper:
        e = np.zeros((len(joint), len(joint)))
        e[i, j] = e[j, i] = scale
        bases.append(e)

    def impedance(unknowns):
        stiffness, damping = (sum(x * e for x, e in zip(half / scale, bases)) for half in np.split(unknowns, 2))
        return stiffness + 1j * damping

    def cost(unknowns):
        z = impedance(unknowns)
        return sum(np.vdot(r, r).real for r in (line.residual(z) for line in lines))

    iterations, last = 0, cost(theta)
    while iterations < 200:
        iterations += 1
        stacked = np.vstack([line.reduced(impedance(theta), bases) for line in lines])
        step = np.linalg.lstsq(stacked[:, :-1], stacked[:, -1], rcond=None)[0]
        for line in lines:
            line.answer(step)
            line.move(1.0)
        part, now = 1.0, cost(theta + scale * step)
        while not now < last * (1.0 + 1e-12) and part > 1e-6:  # halved until it is better
            for line in lines:
                line.move(-0.5 * part)
            part *= 0.5
            now = cost(theta + part * scale * step)
        theta, last = theta + part * scale * step, now
        if part == 1.0 and np.linalg.norm(stacked[:, :-1] @ step) < 1e-4:
            break
    print(repr(time.perf_counter() - start), iterations)
    print(" ".join(repr(float(value)) for value in theta))


if __name__ == "__main__":
    main()
