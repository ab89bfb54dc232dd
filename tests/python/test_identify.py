"""Joints of FRFs in memory and of files."""

import json
import os
import pickle

import jointid
import numpy as np
import pytest


def test_sets_files_and_scenes_give_one_answer(a1, sets, joint):
    """To the last bit: it is the same work."""
    of_file = jointid.identify(a1)
    names = [str(name) for name in of_file["dofs"]]
    assert names == joint["dofs"]
    scene = jointid._scene.Scene.table_of(a1)
    parts, assembly = sets
    in_memory = jointid.identify(parts, assembly, scene=a1)
    of_dict = jointid.identify({**scene, "data": {**scene["data"], "substructures": parts, "assembly": [assembly]}})
    for other in (in_memory, of_dict):
        assert np.array_equal(other.values, of_file.values)
        assert other.status == of_file.status == "ok"


def test_the_truth_is_found(a1, sets, joint):
    truth = np.array(jointid._scene.Scene.table_of(a1)["truth"]["stiffness"])
    solution = jointid.identify(*sets, joint, frequency=(400.0, 1000.0))
    np.testing.assert_allclose(solution.matrices["stiffness"], truth, rtol=1e-6, atol=1e-6 * truth.max())
    assert solution.dofs == tuple(joint["dofs"]) and solution.dofs[1].is_rotation


def test_any_quantity_will_do(sets, joint):
    parts, assembly = sets
    one = jointid.identify(parts, assembly, joint)
    other = jointid.identify([part.to("accelerance") for part in parts], assembly.to("mobility"), joint)
    np.testing.assert_allclose(other.values, one.values, rtol=1e-7, atol=1e-7 * np.abs(one.values).max())


def test_files_and_sets_can_stand_side_by_side(a1, sets, joint):
    parts, assembly = sets
    mixed = jointid.identify([a1.replace("A1.toml", "A1_substructure_1.h5"), parts[1]], assembly, joint)
    assert np.array_equal(mixed.values, jointid.identify(parts, assembly, joint).values)


def test_virtual_points_apply_to_sets(tmp_path):
    """A bolted flange: as of its files, though accelerances went through arrays."""
    scene = jointid.write_problem("flange", tmp_path)
    table = jointid._scene.Scene.table_of(scene)
    data = {key: [jointid.read(tmp_path / name) for name in table["data"][key]] for key in ("substructures", "assembly")}
    assert data["assembly"][0].quantity == "accelerance"
    table["identify"], table["frequency"] = {"method": "one"}, {"range": [100.0, 400.0]}
    in_memory, of_files = jointid.identify({**table, "data": data}), jointid.identify(scene=scene, frequency=(100, 400), method="one")
    assert "VP1:+RZ" in in_memory.dofs and in_memory.status == of_files.status
    np.testing.assert_allclose(in_memory.values, of_files.values, rtol=1e-9, atol=1e-9 * np.abs(of_files.values).max())


def test_runs_of_one_test_are_averaged(sets, joint):
    parts, assembly = sets
    random = np.random.default_rng(1)
    runs = [assembly._like(frfs=assembly.frfs * (1 + 1e-3 * random.normal(size=assembly.shape)), name=f"run {k}") for k in range(4)]
    scene = {"data": {"substructures": parts, "assembly": [runs]}, "joint": jointid._joint._joint_table(joint)["joint"]}
    solution = jointid.identify(scene, method="likelihood")
    assert any("repeat" in each["origin"] or "scatter" in each["origin"] for each in solution["variances"])
    assert solution.unknowns["K(1,1)"].value == pytest.approx(662400, rel=0.02)


def test_corrections_apply_to_sets(sets, joint):
    """A sensor that pointed the other way is flipped by [data.files], under the set's name."""
    parts, assembly = sets
    wrong = assembly.copy()
    wrong.frfs[:, 0, :] *= -1.0
    wrong.name = "flipped"
    dof = str(assembly.responses[0])
    right = jointid.identify(parts, assembly, joint)
    mended = jointid.identify(parts, wrong, joint, data={"files": {"flipped": {"flip": [dof]}}})
    np.testing.assert_allclose(mended.values, right.values, rtol=1e-12)


def test_a_wrong_sign_is_found_with_its_remedy(sets, joint):
    parts, assembly = sets
    assert jointid.check(parts, assembly, joint).status == "clean"
    wrong = assembly.copy()
    wrong.frfs[:, 0, :] *= -1.0
    found = jointid.check(parts, wrong, joint)
    first = found.findings[0]
    assert found.status != "clean" and first.kind == "sign"
    assert assembly.responses[0].coordinate in [dof.coordinate for dof in first.dofs]
    assert "flip" in first.remedy and "memory" not in first.remedy and "memory" not in found.text()


def test_intervals(noisy_a1):
    solution = jointid.identify(scene=noisy_a1, method="likelihood")
    interval = solution.intervals
    assert solution["used"]["method"] == "likelihood"
    assert interval.shape == (len(solution.unknowns), 2)
    assert (interval[:, 0] < solution.values).all() and (solution.values < interval[:, 1]).all()
    unknown = next(iter(solution.unknowns.values()))
    assert unknown.std_error > 0 and float(unknown) == unknown.value and unknown.determined


def test_the_plan_and_the_bound(a1):
    assert jointid.plan(a1)["method"] == "one"
    bound = jointid.bound(scene=a1, noise={"model": "gaussian", "level": 0.01})
    assert "bound" in bound.text().lower() or bound.to_dict()


def test_status_is_warned_of(sets, joint):
    parts, assembly = sets
    noise = np.random.default_rng(1).normal(size=(2, *assembly.shape)) * np.abs(assembly.frfs)
    poor = assembly._like(frfs=assembly.frfs + 3.0 * (noise[0] + 1j * noise[1]))
    with pytest.warns(jointid.JointidWarning) as caught:
        solution = jointid.identify(parts, poor, joint)
    assert solution.status != "ok" and solution.message
    assert solution.status in str(caught[0].message)
    assert caught[0].filename == __file__


def test_predicted_frfs_meet_the_measured_ones(sets, joint):
    parts, assembly = sets
    predicted = jointid.identify(parts, assembly, joint).predicted()
    dof = str(predicted.responses[0])
    column = str(predicted.references[0])
    np.testing.assert_allclose(predicted[dof, column], assembly.sel(band=(predicted.frequency[0], predicted.frequency[-1]))[dof, column],
                               rtol=1e-5)


def test_the_dynamic_stiffness_is_that_of_the_matrices(sets, joint):
    solution = jointid.identify(*sets, joint)
    stiffness = solution.dynamic_stiffness(500.0)[0]
    assert np.array_equal(stiffness, solution.matrices["stiffness"] + 1j * solution.matrices["hysteretic_damping"])


def test_texts_pages_and_files(sets, joint, tmp_path):
    solution = jointid.identify(*sets, joint, title="two beams")
    assert "two beams" in repr(solution) and "K(1,1)" in repr(solution) and len(repr(solution).splitlines()) == 50
    assert solution.text().startswith(repr(solution).rsplit("\n", 1)[0]) and repr(solution).endswith("more lines: print(result.text())")
    page = solution.page()
    assert page.startswith("<!DOCTYPE html>") and "two beams" in page and "/jointid-memory/" not in page
    assert solution._repr_html_().startswith("<iframe srcdoc=") and "two beams" in solution._repr_html_()
    for ending in ("json", "csv", "html", "txt"):
        solution.save(tmp_path / f"a.{ending}")
    assert json.loads((tmp_path / "a.json").read_text()) == solution.to_dict()
    assert (tmp_path / "a.csv").read_text().startswith("name,")
    with pytest.raises(jointid.InputError, match="ending"):
        solution.save(tmp_path / "a.xlsx")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.csv", "a.html", "a.json", "a.txt"]
    with pytest.raises(KeyError, match="there are status"):
        solution["stat"]


def test_results_pickle(sets, joint):
    solution = jointid.identify(*sets, joint)
    again = pickle.loads(pickle.dumps(solution))
    assert again.to_dict() == solution.to_dict() and repr(again) == repr(solution)
    assert again.status == "ok" and again.usable and again.page() is None and "<pre>" in again._repr_html_()
    solution.page()
    assert pickle.loads(pickle.dumps(solution)).page() == solution.page()
    with pytest.raises(jointid.InputError, match="gone"):
        again.predicted()
    solution.release()
    assert solution.unknowns and solution.text()


def test_plots(sets, joint):
    from conftest import needs

    needs("matplotlib")
    parts, assembly = sets
    solution = jointid.identify(parts, assembly, joint)
    solution.plot_matrix("stiffness")
    axes = solution.plot_frf(assembly.responses[0], assembly.references[0], assembly)
    assert len(axes[0].get_lines()) == 2
    with pytest.raises(jointid.InputError, match="it has stiffness"):
        solution.plot_matrix("mass")


class OfManyDofs(jointid.Solution):
    """What the JSON of a joint of more than 300 DOFs has in place of whole matrices."""

    def __init__(self, table):
        self.table = table

    def _numbers(self):
        return self.table

    def __getitem__(self, key):
        return self.table[key]


def test_matrices_of_many_dofs_are_put_together_of_blocks():
    blocks = [{"dofs": ["1:+X", "3:+X"], "matrices": {"stiffness": [[2.0, -2.0], [-2.0, 2.0]]}},
              {"dofs": ["2:+X"], "matrices": {"stiffness": [[None]]}}]
    expected = [[2.0, 0.0, -2.0], [0.0, np.nan, 0.0], [-2.0, 0.0, 2.0]]
    dofs = ["1:+X", "2:+X", "3:+X"]
    whole = OfManyDofs({"dofs": dofs, "matrices": None, "blocks": blocks})
    np.testing.assert_array_equal(whole.matrices["stiffness"], expected)
    np.testing.assert_array_equal(whole.bands[0][1]["stiffness"], expected)
    banded = OfManyDofs({"dofs": dofs, "matrices": None, "bands": [{"band_hz": [1.0, 2.0], "blocks": blocks}]})
    np.testing.assert_array_equal(banded.bands[0][1]["stiffness"], expected)
    with pytest.raises(jointid.InputError, match="several frequency bands"):
        banded.matrices


CONSTRAINTS = {
    # name: (keys of [identify], whether the stiffness is definite, what the answer keeps)
    "bounds": (dict(bounds={"K(1,1)": np.array([0.0, 1e5])}), False, lambda k, d: 0 <= k[0, 0] <= 1e5 * (1 + 1e-9)),
    "ties": (dict(ties=["D(1,1) = 0.01*K(1,1)"]), False, lambda k, d: np.isclose(d[0, 0], 0.01 * k[0, 0], rtol=1e-9)),
    "a ratio": (dict(inequalities=("0.02*K(1,1) <= D(1,1) <= 0.1*K(1,1)",)), False,
                lambda k, d: 0.02 * (1 - 1e-6) <= d[0, 0] / k[0, 0] <= 0.1 * (1 + 1e-6)),
    "passive": (dict(passive=(np.float32(400), 1000)), False, lambda k, d: np.linalg.eigvalsh(d)[0] >= -1e-6 * np.abs(d).max()),
    "definite": ({}, np.bool_(True), lambda k, d: np.linalg.eigvalsh(k)[0] >= -1e-6 * np.abs(k).max()),
}


@pytest.mark.filterwarnings("ignore::jointid.JointidWarning")
@pytest.mark.parametrize("name", CONSTRAINTS)
def test_constraints_of_arguments_hold(name, noisy_a1, joint):
    """Arrays, tuples and numbers of NumPy serve as lists and numbers of a scene do."""
    keys, definite, kept = CONSTRAINTS[name]
    if definite:
        joint["stiffness"] = {"pattern": "symmetric", "definite": definite}
    data = jointid._scene.Scene.table_of(noisy_a1)["data"]
    folder = os.path.dirname(noisy_a1)
    parts, assembly = ([jointid.read(os.path.join(folder, file)) for file in data[key]] for key in ("substructures", "assembly"))
    solution = jointid.identify(parts, assembly, joint, method="one", identify=keys, frequency=(400, 1000))
    assert kept(solution.matrices["stiffness"], solution.matrices["hysteretic_damping"])
    assert solution["admissibility"]["constraints"]
