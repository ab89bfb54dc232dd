"""Which modes has a lightly damped beam, and how sure are frequency and damping?"""

import jointid
import numpy as np

frequency = np.arange(20.0, 80.0, 0.1)
omega = 2 * np.pi * frequency
frfs = np.zeros((len(frequency), 3, 1), complex)
for hz, damping, shape in ((40.0, 0.002, (0.5, 0.8, 0.3)), (55.0, 0.003, (0.6, -0.2, -0.7))):
    natural = 2 * np.pi * hz
    modal = 1 / (natural**2 - omega**2 + 2j * damping * natural * omega)
    frfs[:, :, 0] += np.outer(modal, np.multiply(shape, shape[0]))
random = np.random.default_rng(1)
frfs += 1e-3 * np.abs(frfs).max() * 0.05 * (random.normal(size=frfs.shape) + 1j * random.normal(size=frfs.shape))

fit = jointid.modalfit(jointid.FrfSet(frfs, frequency, ["1:+Z", "2:+Z", "3:+Z"], ["1:+Z"], name="beam"))
print(fit)
found = sorted(mode["frequency_hz"] for mode in fit["modes"])
assert abs(found[0] - 40) < 0.01 and abs(found[-1] - 55) < 0.01
