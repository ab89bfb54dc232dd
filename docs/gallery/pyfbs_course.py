"""The course of a pyFBS notebook, shorter: load A, B and AB, couple, compare, identify what joins them?

Below the steps stands the same by hand, as such notebooks write it: Boolean matrix, LM-FBS, inverse substructuring, one line after the
other. It has the joint's stiffness at every line, and neither one value, nor an interval, nor a verdict.
"""

import inspect

import jointid
import numpy as np
from jointid.bridges.pyfbs import from_pyfbs

frequency = np.arange(5.0, 120.0, 0.5)


def chain(masses, springs, ground=0.0):
    """Accelerances [line, output, input] of masses on springs."""
    k = np.diag([ground, *[0.0] * (len(masses) - 1)]) * (1 + 0.01j)
    for at, spring in enumerate(springs):
        k[at : at + 2, at : at + 2] += spring * np.array([[1, -1], [-1, 1]])
    omega = 2 * np.pi * frequency.reshape(-1, 1, 1)
    return -(omega**2) * np.linalg.inv(k - omega**2 * np.diag(masses))


def table(*places):
    """Rows of df_chn or df_imp: all along +z."""
    columns = {f"Position_{k}": [place if k == 1 else 0.0 for place in places] for k in (1, 2, 3)}
    return {**columns, **{f"Direction_{k}": [float(k == 3)] * len(places) for k in (1, 2, 3)}}


mount, soft = 7e4 * (1 + 0.05j), 1 + 0.01j
y_a, y_b = chain([1.0, 2.0], [3e4 * soft], 1e4), chain([1.5, 0.5], [2e4 * soft])
y_ab = chain([1.0, 2.0, 1.5, 0.5], [3e4 * soft, mount, 2e4 * soft], 1e4)


def with_jointid():
    a = from_pyfbs(frequency, y_a, table(0.0, 0.1), table(0.0, 0.1), name="A")
    b = from_pyfbs(frequency, y_b, table(0.2, 0.3), table(0.2, 0.3), responses=["3:+Z", "4:+Z"], references=["3:+Z", "4:+Z"], name="B")
    ab = from_pyfbs(frequency, y_ab, table(0.0, 0.1, 0.2, 0.3), table(0.0, 0.1, 0.2, 0.3), name="AB")
    rigid = jointid.couple([a, b], join=[["2:+Z", "3:+Z"]]).frfs()
    spring = {"springs": {"k": ["2:+Z", "3:+Z"]}}
    return rigid, jointid.identify([a, b], ab, {"dofs": ["2:+Z", "3:+Z"], "stiffness": spring, "hysteretic_damping": spring})


def by_hand():
    y = np.zeros((len(frequency), 4, 4), complex)
    y[:, :2, :2] = y_a
    y[:, 2:, 2:] = y_b
    boolean = np.zeros((1, 4))
    boolean[0, 1], boolean[0, 2] = 1, -1
    gap = boolean @ y @ boolean.T
    rigid = y - y @ boolean.T @ np.linalg.inv(gap) @ boolean @ y
    receptance = -1 / (2 * np.pi * frequency.reshape(-1, 1, 1)) ** 2
    uncoupled = np.linalg.inv(y * receptance)
    coupled = np.linalg.inv(y_ab * receptance)
    joint = (coupled - uncoupled)[:, 1:3, 1:3]
    stiffness = joint[:, 0, 0].real
    damping = joint[:, 0, 0].imag
    return rigid, np.median(stiffness), np.median(damping)


ours, solution = with_jointid()
theirs, stiffness, damping = by_hand()
for name, unknown in solution.unknowns.items():
    print(f"{name} = {unknown.value:.6g} {unknown.unit}")
print(f"by hand, the median over the lines: {stiffness:.6g}, {damping:.6g} N/m; status here: {solution.status}, "
      f"FRFs of the assembly met to {solution['fit']['asm_frf_error']:.1e} dB")
lines = [len(inspect.getsource(way).splitlines()) - 1 for way in (with_jointid, by_hand)]
print(f"{lines[0]} lines with jointid, with a verdict; {lines[1]} by hand, without")
assert np.allclose(ours.to("accelerance")["1:+Z", "1:+Z"], theirs[:, 0, 0], rtol=1e-9)
assert abs(solution.unknowns["K.k"].value / stiffness - 1) < 1e-6
