"""How do I get from the hits of my hammer test to FRFs with their errors?

Three hits as arrays of time samples become one set of FRFs with coherence and variances, which identify() weighs by.
"""

import jointid
import numpy as np

rate, count = 2000.0, 2000
t = np.arange(count) / rate
random = np.random.default_rng(1)


def hit(size):
    """Force in N and acceleration in m/s² of a mode at 80 Hz, with the noise of the sensor."""
    force = size * np.exp(-0.5 * ((t - 0.02) / 0.0008) ** 2)
    motion = np.convolve(force, np.exp(-8 * t) * np.sin(2 * np.pi * 80 * t))[:count]
    return np.column_stack([force, motion + 0.01 * random.normal(size=count)])


made = jointid.frf([hit(size) for size in (0.8, 1.0, 1.2, 1.1)], channel=["1=1:+Z N", "2=4:+Z m/s^2"], rate=rate,
                   highest=300.0)
frfs = made.frfs()
print(frfs)
peak = frfs.frequency[np.nanargmax(np.abs(frfs["4:+Z", "1:+Z"]))]
print(f"largest at {peak:g} Hz; {int(np.isfinite(frfs.variance).sum())} variances")
assert abs(peak - 80) < 2
