"""The course of a pyFBS notebook, shorter: load A, B and AB, virtual points, couple, compare, identify what joins them?

Two blocks with three triaxial sensors around their interface are joined by a mount of six stiffnesses. The steps are written twice: with
jointid, and by hand as such notebooks do (virtual point transformation, LM-FBS, inverse substructuring, one line after the other). By hand
there is a stiffness at every line, and neither one value, nor an interval, nor a verdict.
"""

import inspect

import jointid
import numpy as np
from jointid.bridges import pyfbs

frequency, random = np.arange(20.0, 400.0, 8.0), np.random.default_rng(1)
omega = 2 * np.pi * frequency.reshape(-1, 1, 1)
sensors = {"A": [[0.05, 0, 0.01], [-0.04, 0.03, 0.01], [-0.03, -0.05, 0.02]],
           "B": [[0.06, 0, -0.01], [-0.03, 0.04, -0.02], [-0.04, -0.03, -0.01]]}
inner = {"A": [0.0, 0.1, 0.2], "B": [0.1, 0.0, -0.2]}
mount = np.diag([2e6, 2e6, 6e6, 3e3, 3e3, 5e3]) * (1 + 0.04j)  # N/m and N·m/rad, from A to B at the origin


def motion(place):
    """Of a point of a rigid body by the six motions of the origin."""
    x, y, z = place
    return np.array([[1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x], [0, 0, 1, y, -x, 0]], float)


def stiffness(body):
    """Dynamic stiffness of a block, six motions of the interface and three of an inner mass on springs."""
    to_mass = np.hstack([motion(inner[body]), -np.eye(3)])
    mass = np.zeros((9, 9))
    mass[:6, :6] = np.diag([2, 2, 2, 0.004, 0.004, 0.005]) * (1.0 if body == "A" else 0.6)
    mass[6:, 6:] = 0.5 * np.eye(3)
    ground = np.diag([4e5, 5e5, 6e5, 800, 700, 900, 0, 0, 0]) * (body == "A")
    return (1 + 0.01j) * (ground + to_mass.T @ np.diag([9e5, 7e5, 8e5]) @ to_mass) - omega**2 * mass


def measured(receptance, bodies):
    """Accelerances at all sensors and inner masses of the bodies, hit there too, with 1 % noise."""
    see = np.vstack([np.hstack([motion(place), np.zeros((3, 3))]) for place in sensors[bodies[0]]] + [np.eye(9)[6:]])
    if len(bodies) == 2:
        other = np.vstack([np.hstack([motion(place), np.zeros((3, 3))]) for place in sensors["B"]] + [np.eye(9)[6:]])
        see = np.block([[see, np.zeros((12, 9))], [np.zeros((12, 9)), other]])
    y = -(omega**2) * (see @ receptance @ see.T)
    return y * (1 + 0.01 / np.sqrt(2) * (random.normal(size=y.shape) + 1j * random.normal(size=y.shape)))


def table(*bodies, quantity="Acceleration"):
    """df_chn or df_imp: triaxial rows; Grouping 1 and 2 are the interfaces of A and B."""
    rows = [(place, axis, number + 1 if place != inner[body] else 100) for number, body in enumerate("AB") if body in bodies
            for place in [*sensors[body], inner[body]] for axis in np.eye(3)]
    columns = {f"Position_{k + 1}": [row[0][k] for row in rows] for k in range(3)}
    columns |= {f"Direction_{k + 1}": [row[1][k] for row in rows] for k in range(3)}
    return {**columns, "Grouping": [row[2] for row in rows], "Quantity": [quantity] * len(rows)}


def points(*groups):
    """df_vp: six motions of each interface, at the origin."""
    words = ["ux", "uy", "uz", "rx", "ry", "rz"]
    return {"Grouping": np.repeat(groups, 6).tolist(), "Description": words * len(groups),
            **{f"Position_{k}": [0.0] * 6 * len(groups) for k in (1, 2, 3)}}


z_a, z_b = stiffness("A"), stiffness("B")
z_ab = np.zeros((len(frequency), 18, 18), complex)
z_ab[:, :9, :9], z_ab[:, 9:, 9:] = z_a, z_b
z_ab[:, :6, :6] += mount
z_ab[:, 9:15, 9:15] += mount
z_ab[:, :6, 9:15] -= mount
z_ab[:, 9:15, :6] -= mount
y_a, y_b, y_ab = measured(np.linalg.inv(z_a), "A"), measured(np.linalg.inv(z_b), "B"), measured(np.linalg.inv(z_ab), "AB")
channels = {name: table(*name) for name in ("A", "B", "AB")}


def with_jointid():
    ab = pyfbs.from_pyfbs(frequency, y_ab, channels["AB"], channels["AB"], name="AB")
    a = pyfbs.from_pyfbs(frequency, y_a, channels["A"], channels["A"], like=ab, name="A")
    b = pyfbs.from_pyfbs(frequency, y_b, channels["B"], channels["B"], like=ab, name="B")
    interfaces = pyfbs.virtual_points(ab, channels["AB"], channels["AB"], points(1, 2))
    pairs = [[f"VP1:+{axis}", f"VP2:+{axis}"] for axis in ("X", "Y", "Z", "RX", "RY", "RZ")]
    rigid = jointid.couple([a, b], join=pairs, virtual_points=interfaces).frfs()
    springs, sides = {"springs": {f"k{n}": pair for n, pair in enumerate(pairs)}}, [dof for side in zip(*pairs) for dof in side]
    solution = jointid.identify([a, b], ab, {"dofs": sides, "stiffness": springs, "hysteretic_damping": springs},
                                virtual_points=interfaces, noise={"model": "circular", "level": 0.01}, method="likelihood")
    return rigid, jointid.virtual_points(ab, interfaces), solution


def by_hand():
    transformed = []
    for y, bodies in ((y_a, "A"), (y_b, "B"), (y_ab, "AB")):
        blocks = []
        for body in bodies:
            r = np.zeros((12, 9))
            for n, place in enumerate(sensors[body]):
                x, yy, z = place
                r[3 * n, :6] = [1, 0, 0, 0, z, -yy]
                r[3 * n + 1, :6] = [0, 1, 0, -z, 0, x]
                r[3 * n + 2, :6] = [0, 0, 1, yy, -x, 0]
            r[9:, 6:] = np.eye(3)
            blocks.append(r)
        r = np.zeros((12 * len(blocks), 9 * len(blocks)))
        for n, block in enumerate(blocks):
            r[12 * n : 12 * n + 12, 9 * n : 9 * n + 9] = block
        t_u = np.linalg.pinv(r.T @ r) @ r.T
        t_f = r @ np.linalg.pinv(r.T @ r)
        transformed.append(t_u @ y @ t_f)
    a, b, ab = transformed
    y = np.zeros((len(frequency), 18, 18), complex)
    y[:, :9, :9] = a
    y[:, 9:, 9:] = b
    boolean = np.zeros((6, 18))
    for n in range(6):
        boolean[n, n] = 1
        boolean[n, 9 + n] = -1
    gap = boolean @ y @ boolean.T
    rigid = y - y @ boolean.T @ np.linalg.inv(gap) @ boolean @ y
    to_receptance = -1 / omega**2
    z_uncoupled = np.linalg.inv(y * to_receptance)
    z_coupled = np.linalg.inv(ab * to_receptance)
    z_joint = (z_coupled - z_uncoupled)[:, :6, :6]
    stiffness = np.median(z_joint.real, axis=0)
    damping = np.median(z_joint.imag, axis=0)
    return rigid, ab, np.diag(stiffness), np.diag(damping)


ours, assembly, solution = with_jointid()
theirs, assembly_by_hand, by_lines, _ = by_hand()
print(f"status: {solution.status} {solution.message}")
for n, name in enumerate(["X", "Y", "Z", "RX", "RY", "RZ"]):
    unknown = solution.unknowns[f"K.k{n}"]
    print(f"{name}: {unknown.value:.4g} {unknown.unit}, 95 % from {unknown.ci95[0]:.4g} to {unknown.ci95[1]:.4g}; "
          f"by hand, the median over the lines: {by_lines[n]:.4g}; truth: {mount[n, n].real:.4g}")
node = next(dof for dof in assembly.responses if not dof.startswith("VP"))
apart = 20 * np.log10(np.abs(ours.to("accelerance")[node, node] / assembly[node, node]))
print(f"assembly coupled rigidly, off the measured one at {node} by {np.sqrt(np.mean(apart**2)):.1f} dB; with the joint found, all FRFs: "
      f"{solution['fit']['asm_frf_error']:.2f} dB")
lines = [len(inspect.getsource(way).splitlines()) - 1 for way in (with_jointid, by_hand)]
print(f"{lines[0]} lines with jointid, with intervals and a verdict; {lines[1]} by hand, without")
assert np.allclose(ours.to("accelerance")["VP1:+X", "VP1:+X"], theirs[:, 0, 0], rtol=1e-6)
assert np.allclose(assembly["VP1:+RZ", "VP2:+Z"], assembly_by_hand[:, 5, 11], rtol=1e-6)
assert all(unknown.ci95[0] < mount[n, n].real < unknown.ci95[1] for n, unknown in enumerate(list(solution.unknowns.values())[:6]))
