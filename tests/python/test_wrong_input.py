"""One clear error for each wrong argument, or its right use."""

import io
import os
import warnings

import jointid
import numpy as np
import pytest
from conftest import needs
from jointid.bridges import pyfbs, pyuff, sdynpy
from jointid.bridges.pandas import from_pandas
from jointid.bridges.xarray import from_xarray

F = np.arange(1.0, 6.0)
H = np.ones((5, 2, 2), complex) * 1e-6
DOFS = ["1:+X", "2:+X"]


def made(frfs=H, frequency=F, responses=DOFS, references=None, **options):
    return jointid.FrfSet(frfs, frequency, responses, references, **options)


WRONG = {
    # name: (arguments, place, what the message has)
    "two axes": (dict(frfs=H[:, :, 0]), "frfs", "2 axes"),
    "lines last": (dict(frfs=np.moveaxis(np.ones((5, 2, 3)), 0, -1), responses=DOFS, references=["1:+X", "2:+X", "3:+X"]), "frfs",
                   "moveaxis"),
    "another shape": (dict(frfs=np.ones((4, 2, 2))), "frfs", "(4, 2, 2)"),
    "too few DOFs": (dict(responses=["1:+X"], references=DOFS), "frfs", "1 responses"),
    "text": (dict(frfs=np.full((5, 2, 2), "1")), "frfs", "<U1"),
    "objects": (dict(frfs=np.full((5, 2, 2), None)), "frfs", "object"),
    "complex frequency": (dict(frequency=F * 1j), "frequency", "complex128"),
    "lines that go down": (dict(frequency=F[::-1]), None, ""),
    "a line twice": (dict(frequency=[1.0, 1.0, 2.0, 3.0, 4.0]), None, ""),
    "a line that is NaN": (dict(frequency=[1.0, np.nan, 2.0, 3.0, 4.0]), None, ""),
    "a negative line": (dict(frequency=F - 2.0), None, ""),
    "no DOF": (dict(responses=["1:+X", "2:+Q"]), "responses", "2:+Q"),
    "a number for a DOF": (dict(responses=["1:+X", 2]), "responses", "2"),
    "a DOF twice": (dict(responses=["1:+X", "1:+X"]), None, "1:+X"),
    "a DOF twice, with signs": (dict(references=["1:+X", "1:-X"]), None, "1:"),
    "one DOF as text": (dict(responses="1:+X"), "frfs", "1 responses"),
    "no quantity": (dict(quantity="receptence"), None, "receptance"),
    "impedance": (dict(quantity="impedance"), None, ""),
    "no unit": (dict(unit="furlong/N"), None, "furlong"),
    "unit of rotations": (dict(responses=["1:+X", "1:+RZ"], unit="mm/N"), "unit", "RZ"),
    "variance of another shape": (dict(variance=np.ones((5, 2))), "variance", "(5, 2)"),
    "variance of text": (dict(variance=np.full((5, 2, 2), "1")), "variance", "<U1"),
    "coherence of another shape": (dict(coherence=np.ones((2, 2, 5))), "coherence", "(2, 2, 5)"),
    "averages that are none": (dict(averages="many"), "averages", "'many'"),
    "a position of two numbers": (dict(nodes={1: (0.0, 0.0)}), "nodes", "2 coordinates"),
    "positions of names": (dict(nodes={"a": (0, 0, 0)}), "nodes", "node numbers"),
    "positions without nodes": (dict(nodes=[(0, 0, 0)]), "nodes", "node numbers"),
    "a quantity that is no text": (dict(quantity=None), "quantity", "None"),
    "covariance of another shape": (dict(covariance=np.ones((5, 4, 2))), "covariance", "(5, 3, 2)"),
    "rows of other lengths": (dict(frfs=[[[1, 2], [3, 4]], [[1, 2]]]), "frfs", "different lengths"),
    "nothing": (dict(frfs=np.empty((0, 2, 2)), frequency=[]), None, "no lines"),
    "no DOFs": (dict(frfs=np.empty((5, 0, 0)), responses=[]), None, "no DOFs"),
    "a mapping": (dict(frfs={"a": 1}), "frfs", "object"),
    "a generator": (dict(frfs=(row for row in H)), "frfs", "object"),
    "dates": (dict(frequency=np.array(["2020-01-01"] * 5, "datetime64[D]")), "frequency", "datetime64"),
    "masked lines": (dict(frequency=np.ma.masked_array(F, mask=F == 3.0)), None, "nan"),
    "numbers for DOFs": (dict(responses=np.array([1, 2])), "responses", "1 is no DOF"),
    "small letters": (dict(responses=["1:+x", "2:+x"]), "responses", "did you mean 1:+X"),
    "a unit that is no text": (dict(unit=3), "unit", "3 is no text"),
    "a unit upside down": (dict(unit="N/m"), "unit", "no motion over a force"),
    "averages below zero": (dict(coherence=np.ones((5, 2, 2)), averages=-2), "averages", "-2"),
    "averages that are NaN": (dict(coherence=np.ones((5, 2, 2)), averages=np.nan), "averages", "nan"),
    "half a node": (dict(nodes={1.5: (0, 0, 0)}), "nodes", "node numbers"),
    "a position that is NaN": (dict(nodes={1: (0, 0, np.nan)}), "nodes", "node 1 is not finite"),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_arrays(name):
    arguments, place, text = WRONG[name]
    with pytest.raises(jointid.InputError) as caught:
        made(**arguments)
    error = caught.value
    assert text in error.what, error.what
    assert error.problem and "\n" not in error.what
    if place is not None:
        assert error.place == place
        assert error.remedy


RIGHT = {
    "float64": H.real,
    "complex64": H.astype(np.complex64),
    "whole numbers": np.ones((5, 2, 2), int),
    "Fortran order": np.asfortranarray(H),
    "every second line": np.repeat(H, 2, axis=0)[::2],
    "turned round": H[::-1],
    "lists": H.tolist(),
    "big-endian": H.astype(">c16"),
    "half precision": H.real.astype(np.float16),
    "long double": H.astype(np.clongdouble),
    "a masked axis": np.broadcast_to(H[:, :1, :1], (5, 2, 2)),
}


@pytest.mark.parametrize("name", RIGHT)
def test_right_arrays(name):
    frfs = made(RIGHT[name])
    assert frfs.frfs.dtype == np.complex128 and frfs.frfs.flags.c_contiguous
    np.testing.assert_allclose(frfs.frfs, np.asarray(RIGHT[name], complex), rtol=1e-15)


@pytest.mark.parametrize("frfs", [np.abs(H), H.real.tolist(), np.ones((5, 2, 2), int)], ids=["magnitudes", "lists", "whole numbers"])
def test_real_arrays_warn(frfs):
    with pytest.warns(jointid.DataWarning, match="arrays: the array is real"):
        made(frfs)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        made(np.asarray(frfs) + 0j)


def test_what_is_masked_was_not_measured():
    frfs = made(np.ma.masked_array(H, mask=np.arange(20).reshape(5, 2, 2) == 3)).frfs
    assert np.isnan(frfs.ravel()[3]) and np.isnan(frfs).sum() == 1


def test_axes_with_names_are_put_in_order():
    xarray = needs("xarray")
    frfs = np.random.default_rng(0).normal(size=(5, 2, 2)) + 1j
    array = xarray.DataArray(frfs, dims=("frequency", "output", "input"))
    for order in (("frequency", "input", "output"), ("input", "output", "frequency")):
        assert np.array_equal(made(array.transpose(*order), variance=abs(array.transpose(*order))).frfs, frfs)
        assert np.array_equal(made(frfs, variance=abs(array.transpose(*order))).variance.real, abs(frfs))


def test_coherences_without_averages_warn():
    with pytest.warns(jointid.DataWarning, match="averages=") as caught:
        made(coherence=np.full((5, 2, 2), 0.9))
    assert caught[0].filename == __file__


def test_covariances_alone_give_the_variances():
    factor = np.random.default_rng(1).normal(size=(5, 2, 3, 2)) + 1j
    diagonal = np.full((5, 2, 2), 0.5)
    of_factor = made(covariance_factor=factor, covariance_diagonal=diagonal)
    expected = np.einsum("lrkc,lrkc->lrc", factor, factor.conj()).real + 0.5
    np.testing.assert_allclose(of_factor.variance, expected * (0.5 + 0.5j), rtol=1e-12)
    np.testing.assert_allclose(made(covariance=of_factor.covariance).variance, of_factor.variance, rtol=1e-12)
    assert made(covariance=of_factor.covariance, variance=np.ones((5, 2, 2))).variance[0, 0, 0] == 1 + 1j


def test_nodes_in_any_form():
    for node in (2, 2.0, "2", [2], np.array([2]), {2}, range(2, 3)):
        assert made().sel(node=node).responses == ("2:+X",)


def test_tables_and_series():
    pandas = needs("pandas")
    table = pandas.DataFrame({"x": [0.0, 1.0], "y": 0.0, "z": 0.5}, index=[1, 2])
    of_table = made(frequency=pandas.Series(F), responses=pandas.Index(DOFS), nodes=table)
    assert of_table == made() and of_table.nodes == {1: (0.0, 0.0, 0.5), 2: (1.0, 0.0, 0.5)}
    assert of_table.sel(node=np.int64(2)).responses == ("2:+X",)


def test_channels_of_a_table():
    pandas = needs("pandas")
    samples = np.random.default_rng(0).normal(size=(50, 2))
    assert jointid.pod(pandas.DataFrame(samples, columns=["left", "right"])).text() == jointid.pod(samples, names=["left", "right"]).text()
    options = dict(channel=["1=1:+Z N", "2=4:+Z m/s^2"], rate=100.0, shaker=True, block=0.1)
    assert jointid.frf(pandas.DataFrame(samples), **options).frfs() == jointid.frf(samples, **options).frfs()


def test_read_only_arrays_are_used_as_they_are(tmp_path):
    frfs = H.copy()
    frfs.setflags(write=False)
    made(frfs).save(tmp_path / "a.h5")
    assert made(frfs).frfs is frfs
    assert np.array_equal(jointid.read(tmp_path / "a.h5").frfs, frfs)


def test_arrays_that_became_discontiguous_are_handed_over_right(tmp_path):
    frfs = made()
    frfs.frfs = np.asfortranarray(np.arange(20.0).reshape(5, 2, 2) + 1j)
    frfs.save(tmp_path / "a.h5")
    assert np.array_equal(jointid.read(tmp_path / "a.h5").frfs, frfs.frfs)


def test_arrays_that_became_another_length_are_refused(tmp_path):
    frfs = made()
    frfs.frfs = frfs.frfs[:3]
    with pytest.raises(jointid.InputError, match="12 numbers"):
        frfs.save(tmp_path / "a.h5")


@pytest.mark.parametrize("key", ["1:+X", ("1:+X",), 3, ("1:+X", "7:+X"), ("1:+Q", "1:+X")])
def test_frfs_that_are_not_there(key):
    with pytest.raises(jointid.InputError):
        made()[key]


def test_parts_that_are_not_there():
    with pytest.raises(jointid.InputError, match="no line from 7"):
        made().sel(band=(7, 9))
    with pytest.raises(jointid.InputError, match="nothing is left"):
        made().sel(node=5)


def test_files_that_are_not_there(tmp_path):
    with pytest.raises(jointid.InputError) as caught:
        jointid.read(tmp_path / "none.uff")
    assert caught.value.file.endswith("none.uff") and caught.value.kind == "data"
    with pytest.raises(jointid.InputError, match="there is no file"):
        jointid.read([])
    with pytest.raises(jointid.InputError, match="format"):
        jointid.write(tmp_path / "a.xyz", made())
    with pytest.raises(jointid.InputError, match="path comes first"):
        jointid.write(made(), tmp_path / "a.h5")


def scene(**changes):
    return {"data": {"substructures": [made(name="one")], "assembly": [made(name="two")]},
            "joint": {"dofs": DOFS, "stiffness": {"pattern": "symmetric"}}, **changes}


WRONG_SCENES = {
    "no scene": (3, "identify", "or a scene"),
    "an unknown table": (scene(identifi={}), "identif", "identify"),
    "an unknown key": (scene(identify={"methode": "one"}), "[identify]", "method"),
    "a wrong word": (scene(identify={"method": "tow"}), "[identify] method", "two"),
    "a wrong type": (scene(frequency={"range": "all"}), "[frequency] range", ""),
    "an object": (scene(title=object()), "[title]", "number, text"),
    "bytes": (scene(title=b"x"), "[title]", "number, text"),
    "a number for a key": (scene(nodes={4: [0, 0, 0]}), "[nodes]", "text"),
    "half of a letter": (scene(title="\ud800"), "[title]", "letters"),
    "no joint": ({"data": scene()["data"]}, "", "joint"),
    "a bound of a missing unknown": (scene(identify={"bounds": {"Q(1,1)": [0, 1]}}), "[identify] bounds", "did you mean K(1,1)"),
    "bounds turned round": (scene(identify={"bounds": {"K(1,1)": [2, 1]}}), "[identify.bounds]", "lowest < highest"),
    "a bound that is NaN": (scene(identify={"bounds": {"K(1,1)": [np.nan, 1]}}), "[identify.bounds]", "finite"),
    "no inequality": (scene(identify={"inequalities": ["K(1,1) < 2"]}), "[identify] inequalities", "<= or >="),
    "frequencies of likelihood": (scene(identify={"method": "likelihood", "frequencies": [2.0]}), "[identify] frequencies", '"one"'),
    "loose without a nominal stiffness": (scene(identify={"loose": True}), "[identify] loose", "nominal stiffness"),
    "a joint with a wrong key": (scene(joint={"dofs": DOFS, "stifness": "symmetric"}), "[joint]", "stiffness"),
    "a matrix with a wrong word": (scene(joint={"dofs": DOFS, "stiffness": {"pattern": "symetric"}}), "[joint.stiffness]", "symmetric"),
    "numbers for joint DOFs": (scene(joint={"dofs": [1, 2], "stiffness": {"pattern": "full"}}), "[joint] dofs", "string"),
    "a table in place of a word": (scene(identify={"method": {"a": 1}}), "identify", "string"),
    "a complex number": (scene(title=3 + 4j), "[title]", "of type complex"),
    "a list in place of a table": (scene(identify={"bounds": [1, 2]}), "[identify] bounds", "table"),
    "no files": (scene(data={"substructures": [], "assembly": [made()]}), "[data] substructures", "empty"),
    "a wrong key of data": (scene(data={"substructures": [made()], "asembly": [made()]}), "[data]", "assembly"),
    "a DOF that no set has": (scene(joint={"dofs": ["1:+X", "9:+Z"], "stiffness": {"pattern": "full"}}), "", "9:+Z"),
}


@pytest.mark.parametrize("name", WRONG_SCENES)
def test_wrong_scenes(name):
    given, place, text = WRONG_SCENES[name]
    with pytest.raises(jointid.InputError) as caught:
        jointid.identify(given)
    error = caught.value
    assert place in error.place, error.place
    assert text in error.what, error.what
    assert "line " not in error.place and "memory" not in error.what


def test_errors_of_a_file_name_its_line(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text('title = "x"\n[data]\nsubstructures = ["a.h5"]\nassembly = ["b.h5"]\n[joynt]\n')
    with pytest.raises(jointid.InputError) as caught:
        jointid.identify(path)
    assert "line 5" in caught.value.what and "joint" in caught.value.what and caught.value.file == str(path)


def test_missing_and_unknown_arguments(joint):
    with pytest.raises(jointid.InputError, match="no such"):
        jointid.identify("none.txt")
    with pytest.raises(jointid.InputError, match="assembly, joint is missing"):
        jointid.identify([made()])
    with pytest.raises(jointid.InputError, match="substructures, assembly is missing"):
        jointid.identify(joint=joint)
    with pytest.raises(jointid.InputError, match="did you mean 'weighting'"):
        jointid.identify([made()], made(), joint, wieghting="WB")
    with pytest.raises(jointid.InputError, match="no number of threads"):
        jointid.identify(scene(), threads=-1)
    with pytest.raises(jointid.InputError, match="did you mean 'normal_load'"):
        jointid.loading_curve((F, F), normal_loads=3.0)
    with pytest.raises(jointid.InputError, match="no function"):
        jointid.identify(scene(), progress="yes")
    with pytest.raises(jointid.InputError, match="no joint"):
        jointid.identify([made()], made(), "4:+Y")


@pytest.mark.parametrize("call, place", [
    (lambda: jointid.read(3), "path"),
    (lambda: made().sel(band=3), "band"),
    (lambda: made().sel(band=("a", 3)), "band"),
    (lambda: jointid.identify(scene=scene(), frequency=400), "frequency"),
    (lambda: jointid.study(scene(), trials=-1), "trials"),
    (lambda: jointid.study(scene(), trials=2.5), "trials"),
    (lambda: jointid.study(scene(), seed=2**64), "seed"),
    (lambda: jointid.modalfit(made(), range=(1, 2, 3)), "range"),
    (lambda: jointid.modalfit(3), "data"),
    (lambda: jointid.loading_curve(3), "curves"),
    (lambda: jointid.frf(3), "files"),
    (lambda: jointid.pod(3), "record"),
    (lambda: jointid.couple(3), "data"),
    (lambda: jointid.check(3), "identify"),
    (lambda: jointid.decouple(made(), made(), ["7:+X"]), "interface"),
    (lambda: jointid.decouple(H, made(), ["1:+X"]), "path"),
    (lambda: jointid.identify(H, H, {"dofs": DOFS, "stiffness": "full"}), "data"),
    (lambda: jointid.modalfit(H), "data"),
    (lambda: jointid.virtual_points(H, {}), "frfs"),
    (lambda: jointid.read(io.BytesIO(b"1")), "path"),
    (lambda: jointid.read(b"a.uff"), "path"),
    (lambda: made().to(None), "quantity"),
    (lambda: jointid.pod(np.ones((9, 2), complex)), "record"),
    (lambda: jointid.pod(np.full((9, 2), "a")), "record"),
    (lambda: jointid.loading_curve({"rig": (F, F, F)}), "curves"),
    (lambda: jointid.loading_curve((["a"] * 5, ["b"] * 5)), "displacement of curve"),
    (lambda: jointid.write_problem("A1", ".", seed=-1), "seed"),
    (lambda: pyuff.from_pyuff(None), "datasets"),
    (lambda: pyuff.from_pyuff([{"type": 58}]), "datasets"),
    (lambda: sdynpy.from_sdynpy(H, quantity="accelerance"), "data"),
    (lambda: pyfbs.from_pyfbs(F, H, {"Position_1": [0, 1]}, {}), "channels, impacts"),
    (lambda: from_xarray(H), "array"),
    (lambda: from_pandas(H), "table"),
    (lambda: made().sel(node=object()), "node"),
    (lambda: made().values_in(3), "unit"),
    (lambda: made().to("g/N"), "quantity"),
    (lambda: jointid.read("", unit="m/N"), "path"),
    (lambda: jointid.read("a.h5", quantity=3), "quantity"),
    (lambda: jointid.read("a.h5", unit=3), "unit"),
    (lambda: jointid.read("a.h5", variable=3), "variable"),
    (lambda: jointid.read("a.h5", frequency_unit=3), "frequency_unit"),
    (lambda: jointid.write(3, made()), "path"),
    (lambda: jointid.write("a.h5", made(), 3), "format"),
    (lambda: jointid.identify([made()], made(), {"dofs": DOFS, "stiffness": "full"}, identify=3), "identify"),
    (lambda: jointid.identify([made()], made(), {"dofs": DOFS, "stiffness": "full"}, data=3), "data"),
    (lambda: jointid.identify([made()], made(), {"dofs": DOFS, "stiffness": "full"}, scene=3), "scene"),
    (lambda: jointid.identify([made()], made(), scene=scene(data=3)), "[data]"),
    (lambda: jointid.identify([H, H], made(), {"dofs": DOFS, "stiffness": "full"}), "data"),
    (lambda: jointid.identify([made(), None], made(), {"dofs": DOFS, "stiffness": "full"}), "data"),
    (lambda: jointid.identify(scene(), threads=2**70), "threads"),
    (lambda: jointid.identify_lines([made()], made(), 3), "joint"),
    (lambda: jointid.bound(scene(), candidates=3), "candidates"),
    (lambda: jointid.study(scene(), out=3), "out"),
    (lambda: jointid.compare(scene(), methods=["oen"]), "compare"),
    (lambda: jointid.couple([made()], join=[DOFS], out=3), "out"),
    (lambda: jointid.couple([made()], join=[DOFS], data=3), "data"),
    (lambda: jointid.decouple(made(), made(), 3), "interface"),
    (lambda: jointid.decouple(made(), made(), ["1:+X"], out=3), "out"),
    (lambda: jointid.virtual_points(made(), 3), "points"),
    (lambda: jointid.virtual_points(made(), [3]), "points"),
    (lambda: jointid.virtual_points(made(), {"name": "VP1"}, nodes=3), "nodes"),
    (lambda: jointid.correlate(made(), made(), fdac=3), "fdac"),
    (lambda: jointid.correlate([made()], made()), "one"),
    (lambda: jointid.export(3, to="nastran"), "of"),
    (lambda: jointid.export("A1.toml", to="nastrn"), "export"),
    (lambda: jointid.phasors(np.ones((5, 1)), F, 3), "dofs"),
    (lambda: jointid.phasors([[1], [1, 2]], F, ["1:+X"]), "values"),
    (lambda: jointid.frf(np.ones((9, 2)), channel=["1=1:+Z N", "2=4:+Z m/s^2"], rate=-1.0), "rate"),
    (lambda: jointid.pod(np.ones((9, 2)), names=3), "names"),
    (lambda: jointid.loading_curve(([1.0, [2.0]], [1.0, 2.0])), "displacement of curve"),
    (lambda: jointid.write_problem("A1", 3), "directory"),
], ids=lambda value: value if isinstance(value, str) else "")
def test_arguments_of_another_kind(call, place):
    with pytest.raises(jointid.InputError) as caught:
        call()
    assert caught.value.place == place and caught.value.remedy


def test_tables_of_others_are_named_with_the_bridge():
    pandas = needs("pandas")
    for wrong in (pandas.DataFrame({"a": [1.0]}), needs("xarray").DataArray(H)):
        with pytest.raises(jointid.InputError, match="from_pandas") as caught:
            jointid.identify([made()], wrong, {"dofs": DOFS, "stiffness": "full"})
        assert caught.value.place == "data"


def test_folders_that_are_not_there(tmp_path, a1):
    solution = jointid.identify(a1)
    for write in (lambda path: solution.save(path / "a.json"), lambda path: jointid.export(solution, path / "a", to="nastran", way="matrix"),
                  lambda path: made().save(path / "a.h5")):
        with pytest.raises(jointid.InputError, match="cannot be written") as caught:
            write(tmp_path / "none")
        assert caught.value.remedy and "none" in caught.value.file


def test_errors_name_arguments_for_options_of_the_command(a1):
    with pytest.raises(jointid.InputError) as caught:
        jointid.bound(a1, noise={"model": "gaussian", "level": 0.02}, candidates="99:+Y")
    assert caught.value.place == "candidates" and "--" not in caught.value.what
    with pytest.raises(jointid.InputError) as caught:
        jointid.read(os.path.join(os.path.dirname(a1), "A1_assembly.h5"), unit="g/N")
    assert "--" not in caught.value.what


def test_one_word_is_a_list_of_one(a1):
    ways = jointid.compare(a1, noise={"model": "gaussian", "level": 0.02}, trials=2, methods="one", weightings="WA")["combinations"]
    assert [way["method"] for way in ways] == ["one"]


def test_a_scene_file_that_is_not_there_has_one_error():
    with pytest.raises(jointid.InputError) as caught:
        jointid.identify([made()], made(), scene="none.toml")
    assert caught.value.what.count("none.toml") == 1


def test_errors_of_arrays_name_arguments_and_no_files():
    for call, texts in ((lambda: jointid.frf(np.ones((100, 2)), channel=["1=1:+Z N", "2=4:+Z m/s^2"]), ("record 1", "rate=")),
                        (lambda: jointid.frf([np.ones((100, 2))] * 2, channel=["1=1:+Z N"], rate=1.0), ("record 1", "channel"))):
        with pytest.raises(jointid.InputError) as caught:
            call()
        assert all(text in caught.value.what for text in texts) and "/tmp" not in caught.value.what and "--" not in caught.value.what


@pytest.mark.parametrize("call, remedy", [
    (lambda: jointid.pod([[1.0, 2.0], [2.0, 3.0]]), "or an array [sample, channel]"),
    (lambda: jointid.frf([[1.0, 2.0]]), "or arrays [sample, channel]"),
    (lambda: jointid.loading_curve(3.0), "or arrays (displacement, force)"),
    (lambda: jointid.frf(np.ones((100, 2)), rate=10.0), "channel=['2=1:+Z N', '3=4:+Z m/s^2']"),
], ids=["pod", "frf", "loading_curve", "channels"])
def test_remedies_are_of_python(call, remedy):
    with pytest.raises(jointid.InputError) as caught:
        call()
    assert remedy in caught.value.remedy and "--" not in caught.value.what


def test_errors_pickle_and_are_value_errors():
    import pickle

    with pytest.raises(ValueError) as caught:
        jointid.Dof("x")
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.__dict__ == caught.value.__dict__ and str(again) == caught.value.what


def test_a_folder_for_a_scene(tmp_path):
    for path in (tmp_path / "none.toml", tmp_path):
        with pytest.raises(jointid.InputError) as caught:
            jointid.check(scene=path)
        assert caught.value.file == os.fspath(path)
