"""How does a structure answer whose joint slips, at several force levels?"""

import jointid
import numpy as np

stiffness = np.array([[500.0, -200.0, 0.0], [-200.0, 250.0, -50.0], [0.0, -50.0, 150.0]])
result = jointid.response({
    "structure": {"mass": np.diag([1.0, 1.2, 0.9]), "stiffness": stiffness, "damping": 1e-3 * stiffness},
    "joints": [{"dofs": [2, 3], "law": "ren", "parameters": {"a": 0.004, "b": 1.5, "k": 150.0}}],
    "force": {"dof": 1, "amplitudes": [1.0, 3.0]},
    "frequency": {"range": [2.0, 5.0], "points": 61},
    "response": {"dofs": [1]},
})
print(result)
assert result.status == "ok"
