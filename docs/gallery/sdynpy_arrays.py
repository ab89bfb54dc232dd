"""How do I hand over what SDynPy has?

A TransferFunctionArray has no quantity, so you name it. Its .npz is read and written without SDynPy.
"""

import os
import tempfile

import jointid
import numpy as np
from jointid.bridges import sdynpy

frequency = np.arange(10.0, 20.0)
frfs = jointid.FrfSet(np.ones((10, 2, 1)) * (1 + 1j), frequency, ["101:+X", "102:-Y"], ["101:+X"], quantity="accelerance", name="beam")
path = os.path.join(tempfile.mkdtemp(), "beam.npz")
sdynpy.save_sdynpy(path, frfs)
back = sdynpy.from_sdynpy(path, quantity="accelerance")
print(back)
assert back == frfs
