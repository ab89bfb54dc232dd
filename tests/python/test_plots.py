"""Plots of results: what the report page of each command draws, by matplotlib."""

import json
import pickle
import re

import jointid
import numpy as np
import pytest
from conftest import needs

LINES = np.arange(5.0, 60.0, 0.5)
U = np.linspace(1e-6, 60e-6, 60)


def mass(kg, dof):
    return jointid.FrfSet(-1 / (kg * (2 * np.pi * LINES) ** 2).reshape(-1, 1, 1), LINES, [dof], name=dof)


def hit(size):
    t = np.arange(1000) / 1000.0
    force = size * np.exp(-0.5 * ((t - 0.02) / 0.0008) ** 2)
    return np.column_stack([force, np.convolve(force, np.exp(-8 * t) * np.sin(2 * np.pi * 80 * t))[:1000]])


def mode():
    ratio = np.arange(30.0, 50.0, 0.1) / 40.0
    return jointid.FrfSet((1e-6 / (1 - ratio**2 + 0.02j * ratio)).reshape(-1, 1, 1), 40.0 * ratio, ["1:+Z"], name="beam")


def response():
    return jointid.response({
        "structure": {"mass": np.eye(2), "stiffness": [[300.0, -100.0], [-100.0, 100.0]], "damping": 0.5 * np.eye(2)},
        "joints": [{"dofs": [1, 2], "law": "ren", "parameters": {"a": 0.004, "b": 1.5, "k": 150.0}}],
        "force": {"dof": 1, "amplitudes": [1.0]}, "frequency": {"range": [1.0, 2.0], "points": 5}, "response": {"dofs": [1]}})


def mount():
    """A spring between two masses, with 1 % errors as stated."""
    omega = 2 * np.pi * LINES.reshape(-1, 1, 1)
    both = np.linalg.inv(1e4 * (1 + 0.1j) * np.array([[1, -1], [-1, 1]]) - omega**2 * np.diag([1.0, 2.0]))
    assembly = jointid.FrfSet(both, LINES, ["1:+X", "2:+X"], name="both")
    sets = [mass(1.0, "1:+X"), mass(2.0, "2:+X"), assembly]
    for each in sets:
        each.variance = (0.01 * np.abs(each.frfs)) ** 2 * (1 + 1j)
    return jointid.identify_lines(sets[:2], assembly, ["1:+X", "2:+X"], way=["primal", "dual"])


def laws(folder):
    table = jointid._scene.Scene.table_of(jointid.write_problem("sdof-iwan", folder))
    table["joint"]["friction"][0]["law"], table["frequency"]["range"] = "iwan", [90.0, 100.0]
    data = table["data"]
    data["parts"] = [f"{folder}/{name}" for name in data["parts"]]
    data["levels"] = [{**level, "responses": f"{folder}/{level['responses']}", "forces": f"{folder}/{level['forces']}"} for level in data["levels"]]
    return jointid.friction_laws(table)


RESULTS = {
    "identify": lambda folder: jointid.identify(jointid.write_problem("A1", folder)),
    "identify_lines": lambda folder: mount(),
    "study": lambda folder: jointid.study(jointid.write_problem("A1", folder, clean=True), trials=20, method="one"),
    "compare": lambda folder: jointid.compare(jointid.write_problem("A1", folder, clean=True), trials=3, methods=["one", "two"]),
    "couple": lambda folder: jointid.couple([mass(1.0, "1:+X"), mass(2.0, "2:+X")], join=[["1:+X", "2:+X"]]),
    "modalfit": lambda folder: jointid.modalfit(mode()),
    "frf": lambda folder: jointid.frf([hit(1.0), hit(1.2)], channel=["1=1:+Z N", "2=4:+Z m/s^2"], rate=1000.0),
    "loading_curve": lambda folder: jointid.loading_curve((U, np.minimum(1e7 * U, 200.0)), law=["bilinear"]),
    "pod": lambda folder: jointid.pod(np.random.default_rng(1).normal(size=(200, 3))),
    "friction_laws": laws,
    "equivalent": lambda folder: jointid.equivalent(jointid.write_problem("rig2", folder)),
    "response": lambda folder: response(),
    "oscillate": lambda folder: jointid.oscillate(jointid.write_problem("chain-3", folder)),
}


def on_page(result):
    """The plots of the page, as its program reads them."""
    return json.loads(re.search(r'id="plots">(.*?)</script>', result.page(), re.DOTALL)[1])


@pytest.mark.filterwarnings("ignore::jointid.JointidWarning")
@pytest.mark.parametrize("command", RESULTS)
def test_every_plot_of_the_page(command, tmp_path):
    needs("matplotlib.pyplot")
    import matplotlib.pyplot as pyplot

    result = RESULTS[command](tmp_path)
    groups = on_page(result)
    assert len(result.plots) == len(groups) >= 1
    for section, group in zip(result.plots, groups):
        assert result.plots[section] == [choice["name"] for choice in group["choices"]]
        for choice in group["choices"][:2]:
            axes = result.plot_page(section, choice["name"])
            assert len(axes) == len(choice["plots"])
            for axis, plot in zip(axes, choice["plots"]):
                assert axis.get_xlabel() == plot["x"]["label"] and axis.has_data()
                if plot["kind"] == "curves":
                    shown = [line for line in axis.get_lines() if line.get_label() == plot["series"][0]["name"]]
                    values = np.array(plot["series"][0]["y"], dtype=float)
                    drawn = np.asarray(shown[0].get_ydata(), dtype=float)
                    there = ~np.isnan(drawn)
                    assert len(drawn) == len(values) and np.array_equal(drawn[there], values[there])
            pyplot.close("all")


def test_wrong_plots_are_one_error(tmp_path):
    needs("matplotlib.pyplot")
    result = RESULTS["loading_curve"](tmp_path)
    for arguments, remedy in ((("Curve",), "Curves and residuals"), (("Curves and residuals", "none"), "curve")):
        with pytest.raises(jointid.InputError) as caught:
            result.plot_page(*arguments)
        assert remedy in caught.value.remedy
    with pytest.raises(jointid.InputError, match="1 axes for 2 plots"):
        import matplotlib.pyplot as pyplot

        result.plot_page("Curves and residuals", axes=pyplot.subplots()[1])
    again = pickle.loads(pickle.dumps(result))
    assert again.plots == result.plots  # its page was made before
    with pytest.raises(jointid.InputError, match="has no plots"):
        jointid.check(jointid.write_problem("A1", tmp_path, clean=True)).plot_page()


def test_plots_of_their_own(tmp_path):
    needs("matplotlib.pyplot")
    bound = jointid.bound(scene=jointid.write_problem("A1", tmp_path, clean=True), noise={"model": "gaussian", "level": 0.02})
    axes = bound.plot_bound()
    widths = [bar.get_width() for bar in axes.patches]
    np.testing.assert_allclose(widths, [100 * each["relative"] for each in bound["bound"]["unknowns"]])
    solution = jointid.identify(jointid.write_problem("A1", tmp_path), method="likelihood")
    rows = solution.plot_unknowns().get_yticklabels()
    assert len(rows) == len(solution.unknowns) and rows[0].get_text().startswith("K(1,1) = ")
    magnitude, phase = RESULTS["modalfit"](tmp_path).plot_frf("1:+Z", "1:+Z")
    assert len(magnitude.get_lines()) == 1 and phase.get_ylabel() == "phase, °"
