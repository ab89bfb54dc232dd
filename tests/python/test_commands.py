"""The other commands, in memory where they can be."""

import os

import jointid
import numpy as np
import pytest


def springs(name, nodes, masses, stiffness, frequency, ground=None):
    """FRFs of a chain of masses on springs, receptances."""
    size = len(masses)
    matrix = np.zeros((size, size))
    for k, spring in enumerate(stiffness):
        matrix[k : k + 2, k : k + 2] += spring * np.array([[1, -1], [-1, 1]])
    if ground is not None:
        matrix[0, 0] += ground
    omega = 2 * np.pi * frequency.reshape(-1, 1, 1)
    return jointid.FrfSet(np.linalg.inv(matrix * (1 + 0.01j) - omega**2 * np.diag(masses)), frequency, [f"{node}:+X" for node in nodes],
                          name=name)


F = np.arange(5.0, 60.0, 0.5)
A = springs("A", [1, 2], [1.0, 2.0], [3e4], F, ground=1e4)
B = springs("B", [2, 3], [1.5, 0.5], [2e4], F)
AB = springs("AB", [1, 2, 3], [1.0, 3.5, 0.5], [3e4, 2e4], F, ground=1e4)


def test_couple():
    result = jointid.couple([A, B], join=[["A/2:+X", "B/2:+X"]])
    frfs = result.frfs()
    assert result.status == "ok" and frfs.frequency.tolist() == F.tolist()
    for out in AB.responses:
        np.testing.assert_allclose(frfs[out, "1:+X"], AB[out, "1:+X"], rtol=1e-9)
    assert result.page().startswith("<!DOCTYPE html>")


def test_one_pair_may_be_joined_as_it_is():
    paired = jointid.couple([A, B], join=["A/2:+X", "B/2:+X"]).frfs()
    assert paired == jointid.couple([A, B], join=[["A/2:+X", "B/2:+X"]]).frfs()


def test_arrays_as_they_come():
    """[hit, sample, channel], and a curve of two columns."""
    t = np.arange(400) / 400.0
    hits = np.stack([np.column_stack([size * np.exp(-0.5 * ((t - 0.1) / 0.004) ** 2), np.sin(200 * t) * np.exp(-9 * t)]) for size in (1, 2)])
    channels = ["1=1:+Z N", "2=4:+Z m/s^2"]
    assert jointid.frf(hits, channel=channels, rate=400.0).frfs() == jointid.frf(list(hits), channel=channels, rate=400.0).frfs()
    u = np.linspace(1e-6, 60e-6, 60)
    force = np.minimum(1e7 * u, 200.0)
    columns, pair = (jointid.loading_curve(curves, law="bilinear") for curves in (np.column_stack([u, force]), (u, force)))
    assert columns.usable and columns["fits"] == pair["fits"]


def test_couple_to_a_file(tmp_path):
    result = jointid.couple([A, B], join=[["A/2:+X", "B/2:+X"]], out=tmp_path / "ab.h5")
    assert np.array_equal(jointid.read(tmp_path / "ab.h5").frfs, result.frfs().frfs)


def test_no_output_replaces_an_input(tmp_path, a1):
    for part in (A, B):
        part.save(tmp_path / f"{part.name}.h5")
    with pytest.raises(jointid.InputError, match="would replace"):
        jointid.couple([tmp_path / "A.h5", tmp_path / "B.h5"], join=[["2:+X", "3:+X"]], out=tmp_path / "A.h5")
    with pytest.raises(jointid.InputError, match="would replace"):
        jointid.study(a1, trials=3, out=a1)
    assert jointid.read(tmp_path / "A.h5") == A


def test_decouple():
    frfs = jointid.decouple(AB, A, ["2:+X"]).frfs()
    for out in ("2:+X", "3:+X"):
        np.testing.assert_allclose(frfs[out, "3:+X"], B[out, "3:+X"], rtol=1e-6)
    with pytest.raises(jointid.InputError, match="AB has no DOF 8:"):
        jointid.decouple(AB, springs("C", [8, 9], [1.0, 1.0], [1e4], F), ["8:+X"])


def test_decouple_at_an_extended_interface():
    extended = jointid.decouple(AB, A, ["1:+X", "2:+X"], threshold="fixed", epsilon=1e-6).frfs()
    np.testing.assert_allclose(extended["3:+X", "3:+X"], B["3:+X", "3:+X"], rtol=1e-6)
    with pytest.warns(jointid.UnusableWarning, match="conditions are redundant") as caught:
        jointid.decouple(AB, A, ["1:+X", "2:+X"])
    assert caught[0].filename == __file__


def test_decouple_a_part_of_the_same_name():
    left = jointid.decouple(AB, A._like(name="AB"), ["2:+X"]).frfs()
    np.testing.assert_allclose(left["3:+X", "3:+X"], B["3:+X", "3:+X"], rtol=1e-6)


def test_modalfit():
    result = jointid.modalfit(AB, real=True, damping="hysteretic")
    modes = result["modes"]
    stiffness = np.array([[4e4, -3e4, 0], [-3e4, 5e4, -2e4], [0, -2e4, 2e4]])
    natural = np.sqrt(np.linalg.eigvals(np.diag([1 / 1.0, 1 / 3.5, 1 / 0.5]) @ stiffness).real)
    expected = sorted(f for f in natural / (2 * np.pi) if F[0] < f < F[-1])
    found = sorted(mode["frequency_hz"] for mode in modes if F[0] < mode["frequency_hz"] < F[-1])
    np.testing.assert_allclose(found, expected, rtol=1e-3)
    assert result.frfs().shape == AB.shape and "AB" in result.text() and "memory" not in result.text()


def test_a_part_of_three_springs_is_identified():
    """The joint between 2 of A and 12 of B: a spring."""
    b = springs("B", [12, 13], [1.5, 0.5], [2e4], F)
    omega = 2 * np.pi * F.reshape(-1, 1, 1)
    k, m = np.zeros((4, 4), complex), np.diag([1.0, 2.0, 1.5, 0.5])
    for at, spring in enumerate([3e4 * (1 + 0.01j), 7e4, 2e4 * (1 + 0.01j)]):
        k[at : at + 2, at : at + 2] += spring * np.array([[1, -1], [-1, 1]])
    k[0, 0] += 1e4 * (1 + 0.01j)
    assembly = jointid.FrfSet(np.linalg.inv(k - omega**2 * m), F, ["1:+X", "2:+X", "12:+X", "13:+X"], name="assembly")
    joint = {"dofs": ["2:+X", "12:+X"], "stiffness": {"springs": {"k": ["2:+X", "12:+X"]}}}
    assert jointid.identify([A, b], assembly, joint).unknowns["K.k"].value == pytest.approx(7e4, rel=1e-8)


def test_compare(a1):
    result = jointid.compare(scene=a1, trials=3, methods=["one", "two"], weightings=["WA", "WB"], noise={"model": "uniform", "level": 0.05})
    assert len(result["combinations"]) == 4
    with pytest.raises(jointid.InputError, match="one"):
        jointid.compare(a1, methods=["oen"])


def test_study_in_memory(sets, joint):
    stages = []
    result = jointid.study(*sets, joint, trials=20, frequency=(400, 1000), noise={"model": "gaussian", "level": 0.01}, method="one",
                           progress=lambda *told: stages.append(told))
    assert result["trials"] and len(result["unknowns"]) == 20
    folder = os.path.dirname(result["file"])
    assert os.path.isdir(folder)
    assert result.page().startswith("<!DOCTYPE html>")
    del result
    assert not os.path.exists(folder)


def test_loading_curves():
    u = np.linspace(1e-6, 60e-6, 60)
    force = np.minimum(1e7 * u, 200.0) + 0.5 * np.sin(1.7 * np.arange(60))
    result = jointid.loading_curve({"rig": (u, force)}, law=["bilinear", "ren"])
    assert result.status == "ok" and "bilinear" in result.text() and result.page()
    with pytest.raises(jointid.InputError):
        jointid.loading_curve((u, force[:-1]))
    with pytest.raises(jointid.InputError):
        jointid.loading_curve((u, force), law="bilinera")


def test_pod_of_an_array_and_of_a_file(tmp_path):
    t = np.arange(500) / 50.0
    one, two = np.cos(2 * np.pi * t), 0.5 * np.cos(6 * np.pi * t)
    record = np.column_stack([0.6 * one + 0.8 * two, 0.8 * one - 0.6 * two, 2.0 + 0 * t])
    result = jointid.pod(record, names=["a", "b", "c"], units=["m", "m", "m"])
    assert result["values"][:2] == pytest.approx([0.5, 0.125], abs=1e-12)
    np.save(tmp_path / "record.npy", record)
    assert jointid.pod(tmp_path / "record.npy")["values"] == pytest.approx(result["values"], abs=1e-12)
    with pytest.raises(jointid.InputError, match="sample, channel"):
        jointid.pod(record[:, 0])


def test_frfs_of_records(tmp_path):
    rate, count = 1000.0, 1000
    t = np.arange(count) / rate
    force = np.exp(-0.5 * ((t - 0.02) / 0.001) ** 2)
    h = np.exp(-30 * t) * np.sin(2 * np.pi * 50 * t)
    for k in range(3):
        motion = np.convolve(force * (1 + 0.1 * k), h)[:count]
        np.save(tmp_path / f"hit{k}.npy", np.column_stack([t, force * (1 + 0.1 * k), motion]))
    result = jointid.frf([tmp_path / f"hit{k}.npy" for k in range(3)], channel=["2=1:+Z N", "3=4:+Z m/s^2"], time="1")
    frfs = result.frfs()
    assert frfs.quantity == "accelerance" and frfs.responses == ("4:+Z",) and frfs.references == ("1:+Z",)
    assert frfs.frequency[np.nanargmax(np.abs(frfs["4:+Z", "1:+Z"][:200]))] == pytest.approx(50.0, abs=2.0)


def test_records_in_memory(tmp_path):
    rate, count = 1000.0, 1000
    t = np.arange(count) / rate
    force = np.exp(-0.5 * ((t - 0.02) / 0.001) ** 2)
    hits = [np.column_stack([size * force, np.convolve(size * force, np.exp(-30 * t) * np.sin(2 * np.pi * 50 * t))[:count]])
            for size in (1.0, 1.1)]
    options = dict(channel=["1=1:+Z N", "2=4:+Z m/s^2"], rate=rate)
    in_memory = jointid.frf(hits, **options).frfs()
    for k, hit in enumerate(hits):
        np.save(tmp_path / f"{k}.npy", hit)
    assert in_memory == jointid.frf([tmp_path / "0.npy", tmp_path / "1.npy"], **options).frfs()
    with pytest.raises(jointid.InputError, match="sample, channel"):
        jointid.frf(hits[0][:, 0], **options)


def test_equivalent_in_memory(tmp_path):
    """A scene whose files are sets gives what it gives of the files."""
    path = jointid.write_problem("rig2", tmp_path)
    scene = jointid._scene.Scene.table_of(path)

    def in_memory(value):
        if isinstance(value, str) and (tmp_path / value).is_file():
            return jointid.read(tmp_path / value)
        if isinstance(value, dict):
            return {key: in_memory(item) for key, item in value.items()}
        return [in_memory(item) for item in value] if isinstance(value, list) else value

    of_file, of_sets = jointid.equivalent(path).to_dict(), jointid.equivalent(in_memory(scene)).to_dict()
    assert str(of_sets["status"]) == of_file["status"]
    numbers = lambda found: [[value for value in level.values() if isinstance(value, float)] for level in found["levels"]]
    np.testing.assert_allclose(np.array(numbers(of_sets)), np.array(numbers(of_file)), rtol=1e-9)


def test_response_and_oscillate():
    scene = {"structure": {"mass": np.diag([1.0, 1.2, 0.9]), "stiffness": [[500, -200, 0], [-200, 250, -50], [0, -50, 150]],
                           "damping": [[0.5, -0.2, 0], [-0.2, 0.25, -0.05], [0, -0.05, 0.15]]},
             "joints": [{"dofs": [2, 3], "law": "ren", "parameters": {"a": 0.004, "b": 1.5, "k": 150.0}}],
             "force": {"dof": 1, "amplitudes": [1.0]}, "frequency": {"range": [2.0, 5.0], "points": 21}, "response": {"dofs": [1]}}
    result = jointid.response(scene)
    assert result.status == "ok" and result.usable and result.page()
    with pytest.raises(jointid.InputError):
        jointid.response({**scene, "joints": [{"dofs": [2, 9], "law": "ren"}]})


def test_virtual_points():
    """A rigid disc on three translations: the virtual point moves as it does."""
    corners = {11: (0.1, 0.0, 0.0), 12: (0.0, 0.1, 0.0), 13: (-0.1, -0.1, 0.05)}
    names = [f"{node}:+{axis}" for node in corners for axis in "XYZ"]
    rows = []
    for x, y, z in corners.values():
        rows += [[1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x], [0, 0, 1, y, -x, 0]]
    shape = np.array(rows, float)
    inertia = np.diag([2.0, 2.0, 2.0, 0.01, 0.01, 0.02])
    f = np.arange(10.0, 15.0)
    at_point = np.stack([-np.linalg.inv(inertia) / (2 * np.pi * hz) ** 2 for hz in f])
    measured = jointid.FrfSet(shape @ at_point @ shape.T + 0j, f, names, nodes=corners, name="disc")
    made = jointid.virtual_points(measured, {"name": "VP1", "position": [0, 0, 0], "sensors": names, "impacts": names})
    assert made.responses == ("VP1:+X", "VP1:+Y", "VP1:+Z", "VP1:+RX", "VP1:+RY", "VP1:+RZ")
    np.testing.assert_allclose(made.frfs, at_point, atol=1e-12 * np.abs(at_point).max())


def test_problems(tmp_path):
    assert "A1" in jointid.problems()
    with pytest.raises(jointid.InputError, match="A1"):
        jointid.write_problem("A1x", tmp_path / "none")


def level_of_records(newton, hertz, random, stiffness, mass):
    """Steady vibration of a mass on a spring, a record [sample, (force, displacement)] for each line."""
    t = np.arange(0.0, 1.0, 1 / 2000)
    records = []
    for f in hertz:
        motion = newton / (stiffness - mass * (2 * np.pi * f) ** 2)
        both = np.column_stack([newton * np.cos(2 * np.pi * f * t), motion * np.cos(2 * np.pi * f * t)])
        records.append(both + 1e-3 * np.abs(both).max(axis=0) * random.normal(size=both.shape))
    return {"name": f"{newton} N", "records": records, "channels": ["1=1:+Y N", "2=1:+Y m"], "rate": 2000.0, "force_dofs": ["1:+Y"],
            "harmonics": [1]}


@pytest.mark.filterwarnings("ignore::jointid.JointidWarning")
def test_friction_laws_of_records_in_memory():
    hertz, mass, random = np.array([95.0, 100.0, 105.0]), 0.5, np.random.default_rng(2)
    part = jointid.FrfSet(-1 / (mass * (2 * np.pi * hertz) ** 2).reshape(-1, 1, 1) + 0j, hertz, ["1:+Y"], name="mass")
    scene = {"data": {"parts": [part], "levels": [level_of_records(newton, hertz, random, 2.5e5, mass) for newton in (1.0, 2.0)]},
             "frequency": {"range": [94.0, 106.0]}, "joint": {"friction": [{"name": "joint", "dofs": ["1:+Y"], "law": "spring"}]}}
    found = jointid.friction_laws(scene)["joints"][0]["stiffness"]
    assert abs(found["value"] - 2.5e5) < 4 * found["std_error"] < 2.5e3
    scene["data"]["levels"][0]["records"] = [np.zeros((5, 2, 2))]
    with pytest.raises(jointid.InputError):
        jointid.friction_laws(scene)
