"""How do I take a fixture out of what was measured: B = AB − A, with uncertainty?

decouple() with a `way` finds B at the interface with variances. Exact FRFs, of models, need no way: dual decoupling, LM-FBS.
"""

import jointid
import numpy as np

frequency, random = np.arange(5.0, 60.0, 0.5), np.random.default_rng(1)


def chain(nodes, masses, springs, ground=0.0, name=""):
    k = np.diag([ground, *[0.0] * (len(masses) - 1)])
    for at, spring in enumerate(springs):
        k[at : at + 2, at : at + 2] += spring * np.array([[1.0, -1.0], [-1.0, 1.0]])
    omega = 2 * np.pi * frequency.reshape(-1, 1, 1)
    return jointid.FrfSet(np.linalg.inv(k * (1 + 0.01j) - omega**2 * np.diag(masses)), frequency, [f"{n}:+X" for n in nodes], name=name)


def measured(exact):
    error = 0.01 * np.abs(exact.frfs)  # standard deviation of real and imaginary part each
    noise = error * (random.normal(size=error.shape) + 1j * random.normal(size=error.shape))
    return jointid.FrfSet(exact.frfs + noise, frequency, exact.dofs, variance=error**2, averages=100, name=exact.name)


fixture = chain([1, 2], [1.0, 2.0], [3e4], 1e4, name="fixture")
whole = chain([1, 2, 3], [1.0, 3.5, 0.5], [3e4, 2e4], 1e4, name="on fixture")
alone = chain([2, 3], [1.5, 0.5], [2e4], name="alone")

left = jointid.decouple(measured(whole), measured(fixture), ["2:+X"], way="likelihood")
found, truth = left.frfs(), alone["2:+X", "2:+X"]
variance = found.variance[:, 0, 0]  # of the real part + i · that of the imaginary part
error = np.sqrt(variance.real + variance.imag)  # of real and imaginary part together
normalised = np.abs(found["2:+X", "2:+X"] - truth) / error
print(f"measured, likelihood: status {left.status}, median error {np.median(np.abs(found['2:+X', '2:+X'] / truth - 1)):.1e}, "
      f"stated {np.median(error / np.abs(truth)):.1e}")
assert 0.5 < np.sqrt(np.nanmean(normalised**2)) < 1.5
left.plot_frf("2:+X", "2:+X")

exact = jointid.decouple(whole, fixture, ["2:+X"]).frfs()
extended = jointid.decouple(whole, fixture, ["1:+X", "2:+X"], threshold="fixed", epsilon=1e-6).frfs()
for name, frfs in (("exact, interface", exact), ("exact, extended interface", extended)):
    error = np.abs(frfs["3:+X", "3:+X"] / alone["3:+X", "3:+X"] - 1).max()
    print(f"{name}: largest relative error {error:.1e}")
    assert error < 1e-4
