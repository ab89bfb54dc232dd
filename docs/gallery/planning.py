"""What can a test find out about the joint, before it is made, and what would a further sensor bring?

bound() takes FRFs of a model or of an earlier test, a noise and a guess of the joint: the Cramér–Rao bound of every unknown.
"""

import tempfile

import jointid

scene = jointid.write_problem("A1", tempfile.mkdtemp(), clean=True)
bound = jointid.bound(scene=scene, noise={"model": "gaussian", "level": 0.02})
print(bound.text()[:2500])
assert bound.to_dict()
