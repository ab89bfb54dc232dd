"""Virtual point transformation and consistency (docs/virtual-points.md) in numpy, with pseudo-inverses as pyFBS has them.

virtual_points.py FILE: the file holds "sensors impacts lines", the names of the modes, a row x y z dx dy dz weight for each sensor and
each impact (positions from the virtual point), and the FRFs [line, sensor, impact], real and imaginary part. Prints, a number a line,
T_u [m,n], T_f [k,m], T_u Y T_f [line,m,m] (real, imaginary), then specific and overall consistency of the sensors and of the impacts.
"""
import sys

import numpy as np

FIELDS = {
    "ux": lambda x, y, z: (1, 0, 0), "uy": lambda x, y, z: (0, 1, 0), "uz": lambda x, y, z: (0, 0, 1),
    "rx": lambda x, y, z: (0, -z, y), "ry": lambda x, y, z: (z, 0, -x), "rz": lambda x, y, z: (-y, x, 0),
    "ex": lambda x, y, z: (x, 0, 0), "ey": lambda x, y, z: (0, y, 0), "ez": lambda x, y, z: (0, 0, z),
    "tx": lambda x, y, z: (0, -x * z, x * y), "ty": lambda x, y, z: (y * z, 0, -y * x), "tz": lambda x, y, z: (-z * y, z * x, 0),
    "sxy": lambda x, y, z: (x * y, 0, 0), "sxz": lambda x, y, z: (x * z, 0, 0), "syz": lambda x, y, z: (0, y * z, 0),
    "syx": lambda x, y, z: (0, y * x, 0), "szx": lambda x, y, z: (0, 0, z * x), "szy": lambda x, y, z: (0, 0, z * y),
}


def modes_of(channels, names):
    return np.array([[np.dot(FIELDS[name](*channel[:3]), channel[3:6]) for name in names] for channel in channels])


def coherence(a, b):
    return np.mean(np.abs(a + b) ** 2 / (2 * (np.abs(a) ** 2 + np.abs(b) ** 2)))


def main():
    words = open(sys.argv[1]).read().split("\n", 2)
    n, k, lines = map(int, words[0].split())
    names = words[1].split()
    numbers = np.array(words[2].split(), dtype=float)
    sensors, impacts = numbers[: 7 * n].reshape(n, 7), numbers[7 * n : 7 * (n + k)].reshape(k, 7)
    y = numbers[7 * (n + k) :].view(complex).reshape(lines, n, k)
    ru, rf = modes_of(sensors, names), modes_of(impacts, names)
    wu, wf = np.diag(sensors[:, 6]), np.diag(1 / impacts[:, 6])  # pyFBS weights impacts by the inverse
    tu = np.linalg.pinv(ru.T @ wu @ ru) @ ru.T @ wu
    tf = np.linalg.pinv(wf) @ rf @ np.linalg.pinv(rf.T @ np.linalg.pinv(wf) @ rf)
    out = [tu.ravel(), tf.ravel(), np.ascontiguousarray(tu @ y @ tf).ravel().view(float)]
    u = y @ np.ones(k)
    uf = u @ (ru @ tu).T
    f = np.ones(n) @ y
    ff = f @ (tf @ rf.T)  # for weights all alike this is pyFBS's rf @ tf.T
    for whole, part in ((u, uf), (f, ff)):
        out.append(np.array([coherence(part[:, i], whole[:, i]) for i in range(whole.shape[1])]))
        out.append(np.linalg.norm(part, axis=1) / np.linalg.norm(whole, axis=1))
    np.savetxt(sys.stdout, np.concatenate(out), fmt="%.17g")


main()
