"""How do I take a fixture out of what was measured: A = AB − B?

decouple() joins the fixture with a minus sign: dual decoupling at the interface, or at an extended one with a threshold.
"""

import jointid
import numpy as np

frequency = np.arange(5.0, 60.0, 0.5)


def chain(nodes, masses, springs, ground=0.0, name=""):
    k = np.diag([ground, *[0.0] * (len(masses) - 1)])
    for at, spring in enumerate(springs):
        k[at : at + 2, at : at + 2] += spring * np.array([[1.0, -1.0], [-1.0, 1.0]])
    omega = 2 * np.pi * frequency.reshape(-1, 1, 1)
    return jointid.FrfSet(np.linalg.inv(k * (1 + 0.01j) - omega**2 * np.diag(masses)), frequency, [f"{n}:+X" for n in nodes], name=name)


fixture = chain([1, 2], [1.0, 2.0], [3e4], 1e4, name="fixture")
whole = chain([1, 2, 3], [1.0, 3.5, 0.5], [3e4, 2e4], 1e4, name="on fixture")
alone = chain([2, 3], [1.5, 0.5], [2e4], name="alone")

left = jointid.decouple(whole, fixture, ["2:+X"]).frfs()
extended = jointid.decouple(whole, fixture, ["1:+X", "2:+X"], threshold="fixed", epsilon=1e-6).frfs()
for name, frfs in (("interface", left), ("extended interface", extended)):
    error = np.abs(frfs["3:+X", "3:+X"] / alone["3:+X", "3:+X"] - 1).max()
    print(f"{name}: largest relative error {error:.1e}")
    assert error < 1e-4
