"""Which friction law has a joint whose loading curve I measured?"""

import jointid
import numpy as np

u = np.linspace(1e-6, 60e-6, 60)  # m
force = np.minimum(1e7 * u, 200.0) + 0.5 * np.sin(1.7 * np.arange(60))  # N, with what the sensor adds

result = jointid.loading_curve({"rig": (u, force)}, law=["bilinear", "ren", "spring"])
print(result)
assert result["best_law"] == "bilinear"
