"""What is the dynamic stiffness Z_J(ω) of a rubber mount over frequency?

Bands: the unknowns are identified in each, and dynamic_stiffness() puts Z_J = K + iD together again.
"""

import jointid
import numpy as np

frequency = np.arange(20.0, 200.0, 0.5)
omega = 2 * np.pi * frequency
rubber = 5e4 * (1 + frequency / 400) * (1 + 0.15j)  # stiffer with frequency, loss factor 0.15


def receptances(joint):
    k = np.zeros((len(frequency), 4, 4), complex)
    for at, spring in enumerate([3e5 * (1 + 0.01j), joint, 2e5 * (1 + 0.01j)]):
        k[:, at : at + 2, at : at + 2] += np.reshape(spring, (-1, 1, 1)) * np.array([[1, -1], [-1, 1]])
    return np.linalg.inv(k - omega.reshape(-1, 1, 1) ** 2 * np.diag([1.0, 2.0, 1.5, 0.5]))


free, names = receptances(0.0), ["1:+Z", "2:+Z", "3:+Z", "4:+Z"]
parts = [jointid.FrfSet(free[:, :2, :2], frequency, names[:2], name="frame"),
         jointid.FrfSet(free[:, 2:, 2:], frequency, names[2:], name="engine")]
spring = {"springs": {"z": ["2:+Z", "3:+Z"]}}
joint = {"dofs": ["2:+Z", "3:+Z"], "bands": [[low, low + 20.0] for low in range(20, 200, 20)], "stiffness": spring,
         "hysteretic_damping": spring}
solution = jointid.identify(parts, jointid.FrfSet(receptances(rubber), frequency, names, name="assembly"), joint, method="one")

for hz in (30.0, 110.0, 190.0):
    found = solution.dynamic_stiffness(hz)[0, 0, 0]
    print(f"Z_J at {hz:g} Hz: {found.real:.0f} + {found.imag:.0f}i N/m, loss factor {found.imag / found.real:.3f}")
    assert abs(found / rubber[np.searchsorted(frequency, hz)] - 1) < 0.1
