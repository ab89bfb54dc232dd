"""Writes the records of this folder as numpy, h5py and scipy do: forces 0, 5, 1 and accelerations 0, 1, -2 at 0, 1, 2 ms; in
attributes.h5 and scaled.h5 with their rates, units and factors as attributes, in labels.mat with labels of axes."""
import os

import h5py
import numpy as np
from scipy.io import savemat

os.chdir(os.path.dirname(os.path.abspath(__file__)))
force, acceleration = np.array([0.0, 5.0, 1.0]), np.array([0.0, 1.0, -2.0])
np.savez("record.npz", time=[0.0, 0.001, 0.002], F=force, a=acceleration, gain=2.0)
with h5py.File("attributes.h5", "w") as file:
    file.attrs["fs"] = 1000.0
    file["data"] = np.column_stack([force, acceleration])
    file["data"].attrs["units"] = ["N", "g"]
with h5py.File("scaled.h5", "w") as file:
    file.attrs["dt"] = 0.001
    file["F"], file["a"] = force, acceleration
    file["F"].attrs["scale"] = 0.1
savemat("labels.mat", {"F": force, "a": acceleration, "t": [0.0, 1.0, 2.0], "xlabel": "Time [ms]", "ylabel": "Acceleration [g]"},
        format="4")
