"""The joint line by line, and decoupling with variances: as the command, and against the truth."""

import json
import os
import pickle
import subprocess

import jointid
import matplotlib.pyplot as pyplot
import numpy as np
import pytest

pytestmark = pytest.mark.filterwarnings("ignore::jointid.JointidWarning")


def command(*arguments):
    done = subprocess.run([os.environ["JOINTID_COMMAND"], *arguments], capture_output=True, text=True, timeout=120)
    assert done.returncode in (0, 4), done.stderr
    return {key: value for key, value in json.loads(done.stdout).items() if key != "provenance"}


def numbers(result):
    return {key: value for key, value in result.to_dict().items() if key != "provenance"}


@pytest.fixture(scope="module")
def isolator(tmp_path_factory):
    return jointid.write_problem("isolator-zener", tmp_path_factory.mktemp("isolator"))


@pytest.fixture(scope="module")
def solution(isolator):
    return jointid.identify_lines(isolator)


@pytest.fixture(scope="module")
def beams(tmp_path_factory):
    return jointid.write_problem("decoupling-beams", tmp_path_factory.mktemp("beams"))


def test_the_answers_are_those_of_the_command(isolator, solution):
    assert numbers(solution) == command("solve", isolator, "--json", "-")
    assert numbers(jointid.identify(isolator)) == numbers(solution)


def test_check_plan_and_bound_are_those_of_the_command(isolator):
    checked, planned, bound = jointid.check(isolator), jointid.plan(isolator), jointid.bound(isolator)
    assert numbers(checked) == command("check", isolator, "--json", "-") and checked.status == "clean"
    assert numbers(planned) == command("plan", isolator, "--json", "-") and "bound" not in planned.to_dict()
    assert numbers(bound) == command("plan", isolator, "--bound", "--json", "-")
    with pytest.raises(jointid.InputError, match="further coordinates"):
        jointid.bound(isolator, candidates=["3:+Y"])
    with pytest.raises(AssertionError, match="--candidates"):
        command("plan", isolator, "--bound", "--candidates", "3:+Y")


def test_the_bound_over_the_lines_is_drawn(isolator):
    bound = jointid.bound(isolator)
    line, = bound.plot_bound().get_lines()
    assert line.get_label() == "z(1,1)"
    np.testing.assert_allclose(line.get_ydata(), [100 * each["relative"][0] for each in bound["bound"]["lines"]])


def test_identify_of_such_a_scene_is_a_solution_by_lines(isolator):
    assert isinstance(jointid.identify(isolator), jointid.LineSolution)


def test_shapes_and_bands(solution):
    lines, elements = solution.z.shape
    assert (lines, elements) == (len(solution.frequency), len(solution.elements))
    assert solution.std_error.shape == (lines, elements, 2) and solution.band.shape == (lines, elements, 2, 2)
    np.testing.assert_allclose(solution.band[..., 1] - solution.band[..., 0], 2 * 1.959963984540054 * solution.std_error)
    covariance = np.array(solution["ways"][0]["lines"][3]["covariance"])
    np.testing.assert_allclose(solution.std_error[3].T.ravel() ** 2, np.diag(covariance), rtol=1e-12)


def test_the_matrix_of_a_massless_joint(solution):
    """T z Tᵀ with T = [I; −I]: minus z between facing DOFs."""
    z = solution.dynamic_stiffness()
    half = len(solution.dofs) // 2
    assert z.shape == (len(solution.frequency), 2 * half, 2 * half)
    np.testing.assert_array_equal(z, np.swapaxes(z, 1, 2))
    np.testing.assert_array_equal(z[:, :half, :half], -z[:, :half, half:])
    np.testing.assert_array_equal(z[:, 0, 0], solution.z[:, solution.elements.index("z(1,1)")])


def test_laws(solution):
    laws = solution.laws
    best = next(iter(laws))
    assert set(laws) == {each["law"] for each in solution["laws"]}
    values = solution.law_values()
    assert values.name == best and values.z.shape == solution.z.shape
    known = ~np.isnan(solution.z)
    assert np.all(values.std_error[known] < 1.01 * solution.std_error[known])  # a law is known better than a line
    parameter = next(iter(laws[best].values()))
    assert parameter.ci95[0] < parameter.value < parameter.ci95[1]


def test_plots(solution):
    axes = solution.plot(law=next(iter(solution.laws)))
    assert len(axes[0].lines) == 2 and len(axes[0].collections) == 2
    np.testing.assert_array_equal(axes[1].lines[0].get_ydata(), solution.z[:, 0].imag)
    pyplot.close("all")


def test_what_is_not_there_is_one_error(solution):
    for wrong in (lambda: solution.plot("z(9,9)"), lambda: solution.plot(ways="dual"), lambda: solution.law_values("ren"),
                  lambda: solution.dynamic_stiffness("dual")):
        with pytest.raises(jointid.InputError) as caught:
            wrong()
        assert "it has" in caught.value.remedy


def test_options_change_a_scene_file(isolator):
    found = jointid.identify_lines(isolator, way=["primal", "likelihood"], laws="zener")
    assert list(found.ways) == ["primal", "likelihood"] and list(found.laws) == ["zener"]


def test_a_scene_without_lines_is_refused(a1):
    with pytest.raises(jointid.InputError) as caught:
        jointid.identify_lines(a1)
    assert "lines" in caught.value.problem and "identify()" in caught.value.remedy


def test_it_pickles(solution):
    again = pickle.loads(pickle.dumps(solution))
    np.testing.assert_array_equal(again.z, solution.z)
    assert again.text() == solution.text()


def test_sets_in_memory(isolator, solution):
    folder = os.path.dirname(isolator)
    table = jointid._joint.Scene.table_of(isolator)
    read = lambda name: jointid.read(os.path.join(folder, name))
    parts = [read(name) for name in table["data"]["substructures"]]
    whole = [read(name) for name in table["data"]["assembly"]]
    rest = {key: table[key] for key in ("noise", "frequency", "identify") if key in table}
    found = jointid.identify_lines(parts, whole, table["joint"], **rest)
    np.testing.assert_array_equal(found.z, solution.z)


def test_decoupling_is_that_of_the_command(beams, tmp_path):
    ours = jointid.decouple(beams, out=tmp_path / "B.h5")
    theirs = command("decouple", beams, "--json", "-", "--out", str(tmp_path / "theirs.h5"))
    assert {**numbers(ours), "file": ""} == {**theirs, "file": ""}
    written, theirs = jointid.read(tmp_path / "B.h5"), jointid.read(tmp_path / "theirs.h5")
    np.testing.assert_array_equal(written.frfs, theirs.frfs)
    np.testing.assert_array_equal(written.variance, theirs.variance)
    np.testing.assert_array_equal(ours.frfs().frfs, written.frfs)


def test_decoupled_masses():
    """A mass of 3 kg less one of 2 kg: 1 kg, with the variance of the inverse of Z_AB − Z_A to first order."""
    f, random = np.linspace(10.0, 20.0, 40), np.random.default_rng(5)
    stiffness = -((2 * np.pi * f) ** 2)

    def mass(m, name):
        exact = (1 / (m * stiffness)).reshape(-1, 1, 1).astype(complex)
        error = 0.001 * np.abs(exact)
        noise = error * (random.normal(size=exact.shape) + 1j * random.normal(size=exact.shape)) / np.sqrt(2)
        return jointid.FrfSet(exact + noise, f, ["1:+X"], variance=error**2 / 2, averages=100, name=name)

    found = jointid.decouple(mass(3.0, "AB"), mass(2.0, "A"), "1:+X", way="likelihood")
    assert isinstance(found, jointid.DecoupledResult) and found.interface == ("1:+X",)
    variance = 0.001**2 * (3.0**2 + 2.0**2) * stiffness**2  # of Z: (0.1 % of 3 kg)² + (0.1 % of 2 kg)²
    np.testing.assert_allclose((found.stiffness.std_error[:, 0] ** 2).sum(axis=1), variance, rtol=0.02)
    normalised = np.abs(found.stiffness.z[:, 0] - stiffness) / np.sqrt(variance)
    assert 0.6 < np.sqrt(np.mean(normalised**2)) < 1.4


def test_wrong_decoupling_is_one_error(beams):
    frfs, part = (jointid.FrfSet(np.ones((3, 1, 1), complex), [1.0, 2.0, 3.0], ["1:+X"], name=name) for name in "ab")
    for wrong, word in ((lambda: jointid.decouple(frfs), "missing"), (lambda: jointid.decouple(frfs, part, "1:+X", noise={}), "way"),
                        (lambda: jointid.decouple(beams, epsilon=1.0), "epsilon"),
                        (lambda: jointid.decouple(frfs, part, "1:+X", way="magic"), "magic")):
        with pytest.raises(jointid.InputError, match=word):
            wrong()
