"""Which friction law has a joint that I can only shake: FRFs of the parts, and vibration at a few force levels?"""

import tempfile

import jointid

scene = jointid.write_problem("sdof-iwan", tempfile.mkdtemp())  # a scene with [[data.levels]] and [[joint.friction]]
result = jointid.friction_laws(scene)
print(result)
assert result.usable
