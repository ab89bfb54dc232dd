"""Which method, which weighting?

compare() runs every combination on the same trials with simulated noise and reports error and run time of each.
"""

import tempfile

import jointid

scene = jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)
result = jointid.compare(scene, trials=40, methods=["one", "two"], weightings=["none", "WA", "WBS"], progress=False)
for way in result["combinations"]:
    print(way["method"], way["weighting"], {key: value for key, value in way.items() if key in ("solve_s",)})
print(result.text())
assert len(result["combinations"]) == 6
