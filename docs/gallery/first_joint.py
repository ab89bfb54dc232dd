"""Which stiffness and damping has the joint between two beams, and how sure is that?

FRFs of both beams and of the assembly lead to the joint's matrices with 95 % intervals, and to a verdict on the data.
"""

import tempfile

import jointid

folder = tempfile.mkdtemp()
jointid.write_problem("A1", folder)  # files with 5 % noise, as a test might have given them
beams = [jointid.read(f"{folder}/A1_substructure_{k}.h5") for k in (1, 2)]
assembly = jointid.read(f"{folder}/A1_assembly.h5")

joint = {"dofs": ["4:+Y", "4:+RZ", "5:+Y", "5:+RZ"], "stiffness": "symmetric", "hysteretic_damping": "symmetric"}
noise = {"model": "uniform", "level": 0.05}
solution = jointid.identify(beams, assembly, joint, frequency=(400, 1000), noise=noise, method="likelihood")

for unknown in list(solution.unknowns.values())[:4]:
    low, high = unknown.ci95
    print(f"{unknown.name} = {unknown.value:.4g} {unknown.unit}, 95 % from {low:.4g} to {high:.4g}")
print(f"the answer is {solution.status}; {solution.message}")
assert abs(solution.unknowns["K(1,1)"].value / 662400 - 1) < 0.2
