"""What is the dynamic stiffness Z_J(ω) of a rubber mount over frequency, and which law does it follow?

identify_lines() finds Z_J at every line with 95 % bands, and fits laws to the lines. FRFs need variances: here 1 % noise.
"""

import jointid
import numpy as np

frequency = np.arange(20.0, 200.0, 4.0)
omega, random = 2 * np.pi * frequency, np.random.default_rng(1)
s = 1j * omega / 400.0  # Zener's law: 50 kN/m at rest, 90 kN/m far above 64 Hz
rubber = (5e4 + 9e4 * s) / (1 + s)


def receptances(joint):
    k = np.zeros((len(frequency), 4, 4), complex)
    for at, spring in enumerate([3e5 * (1 + 0.01j), joint, 2e5 * (1 + 0.01j)]):
        k[:, at : at + 2, at : at + 2] += np.reshape(spring, (-1, 1, 1)) * np.array([[1, -1], [-1, 1]])
    return np.linalg.inv(k - omega.reshape(-1, 1, 1) ** 2 * np.diag([1.0, 2.0, 1.5, 0.5]))


def measured(frfs, names, name):
    error = 0.01 * np.abs(frfs)  # standard deviation of real and imaginary part each
    noise = error * (random.normal(size=frfs.shape) + 1j * random.normal(size=frfs.shape))
    return jointid.FrfSet(frfs + noise, frequency, names, variance=error**2, averages=100, name=name)


free, names = receptances(0.0), ["1:+Z", "2:+Z", "3:+Z", "4:+Z"]
parts = [measured(free[:, :2, :2], names[:2], "frame"), measured(free[:, 2:, 2:], names[2:], "engine")]
mount = jointid.identify_lines(parts, measured(receptances(rubber), names, "assembly"), ["2:+Z", "3:+Z"], lines="massless", laws="all")

for at in (0, 22, 44):
    low, high = mount.band[at, 0, 0]
    print(f"{frequency[at]:g} Hz: Re Z_J = {mount.z[at, 0].real:.0f} N/m, 95 % from {low:.0f} to {high:.0f}; "
          f"loss factor {mount.result.loss_factor[at, 0]:.3f}")
law, parameters = next(iter(mount.laws.items()))
print(f"law by AIC: {law}; " + "; ".join(f"{each.name} = {each.value:.4g} {each.unit}" for each in parameters.values()))
mount.plot(law=law)

inside = (mount.band[..., 0] <= np.stack([rubber.real, rubber.imag], -1)[:, None]) & (
    mount.band[..., 1] >= np.stack([rubber.real, rubber.imag], -1)[:, None])
assert inside.mean() > 0.85 and law == "zener"
