"""Which friction law has a joint that I can only shake: FRFs of the part, and arrays of forces and motions at a few force levels?

phasors() makes sets of arrays [line, DOF]; harmonic n of a force at f is at n·f.
"""

import tempfile

import jointid

folder = tempfile.mkdtemp()
jointid.write_problem("sdof-iwan", folder)  # one mass on a joint to ground, 1 % noise; its files stand for what was measured
part = jointid.read(f"{folder}/sdof-iwan_part_1.h5")


def level(number, newton):
    """Arrays, as a test gives them, of one force level and its harmonics 1 and 3."""
    motion, force = (jointid.read(f"{folder}/sdof-iwan_level_{number}{what}.h5") for what in ("", "_force"))
    return {"name": f"{newton} N", "harmonics": [1, 3], "force_dofs": ["1:+Y"],
            "responses": jointid.phasors(motion.frfs[:, :, 0], motion.frequency, ["1:+Y"], name=f"motion at {newton} N"),
            "forces": jointid.phasors(force.frfs[:, :, 0], force.frequency, ["1:+Y"], kind="force", name=f"force at {newton} N")}


result = jointid.friction_laws({
    "data": {"parts": [part], "levels": [level(1, 0.5), level(2, 2.0), level(3, 5.0), level(4, 12.0)]},
    "joint": {"friction": [{"name": "joint", "dofs": ["1:+Y"], "law": ["spring", "iwan"]}]},
    "frequency": {"range": [80.0, 135.0]}, "errors": {"relative": 0.01}})
print(result)
assert result.status == "ok" and result["joints"][0]["law"] == "iwan"
