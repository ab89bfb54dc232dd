"""The course of a pyFBS notebook, shorter: load A, B and AB, couple, compare, identify what joins them.

pyFBS needs for the same: a table of channels and one of impacts of each part, a Boolean matrix of the interface built row by row,
H = Y - Y Bᵀ (B Y Bᵀ)⁻¹ B Y written out with numpy, and for the joint a further inversion of the interface's FRFs at each line.
It has no intervals and no verdict.
"""

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
a = from_pyfbs(frequency, chain([1.0, 2.0], [3e4 * soft], 1e4), table(0.0, 0.1), table(0.0, 0.1), name="A")
b = from_pyfbs(frequency, chain([1.5, 0.5], [2e4 * soft]), table(0.2, 0.3), table(0.2, 0.3), name="B", responses=["3:+Z", "4:+Z"],
               references=["3:+Z", "4:+Z"])
ab = from_pyfbs(frequency, chain([1.0, 2.0, 1.5, 0.5], [3e4 * soft, mount, 2e4 * soft], 1e4), table(0.0, 0.1, 0.2, 0.3),
                table(0.0, 0.1, 0.2, 0.3), name="AB")

rigid = jointid.couple([a, b], join=[["2:+Z", "3:+Z"]]).frfs()  # LM-FBS
for name, frfs in (("joined rigidly", rigid), ("as measured", ab)):
    frf = np.abs(frfs.sel(band=(20, 120))["1:+Z", "1:+Z"])
    print(f"assembly {name}: largest accelerance above 20 Hz at {frequency[frequency >= 20][np.argmax(frf)]:g} Hz, "
          f"at 60 Hz {frf[80]:.4f} m/s²/N")
solution = jointid.identify([a, b], ab, {"dofs": ["2:+Z", "3:+Z"], "stiffness": {"springs": {"k": ["2:+Z", "3:+Z"]}},
                                         "hysteretic_damping": {"springs": {"k": ["2:+Z", "3:+Z"]}}})
print({name: f"{unknown.value:.6g} {unknown.unit}" for name, unknown in solution.unknowns.items()})
with open(__file__, encoding="utf-8") as stream:
    print(sum(1 for line in stream if line.startswith(("rigid =", "solution =", "a =", "b =", "ab ="))), "statements from arrays to joint")
assert abs(solution.unknowns["K.k"].value / 7e4 - 1) < 1e-6
