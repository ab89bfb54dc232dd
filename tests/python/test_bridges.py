"""To other packages and back, against small imitations of their conventions."""

import pathlib
import re
import sys
import types

import jointid
import numpy as np
import pytest
from conftest import needs
from jointid.bridges import pyema, pyfbs, pyuff, sdynpy, sep005


def sample(quantity="accelerance", rows=("1:+X", "2:-Y", "3:+Z"), columns=("1:+X", "9:-Z")):
    random = np.random.default_rng(1)
    frfs = random.normal(size=(5, len(rows), len(columns))) + 1j * random.normal(size=(5, len(rows), len(columns)))
    return jointid.FrfSet(frfs, np.arange(10.0, 15.0), rows, columns, quantity=quantity, name="beam",
                          nodes={1: (0, 0, 0), 2: (0.5, 0, 0), 3: (1, 0, 0), 9: (0.2, 0.1, 0)})


@pytest.mark.parametrize("quantity", ["receptance", "mobility", "accelerance"])
def test_pyuff(quantity):
    made = sample(quantity)
    datasets = pyuff.to_pyuff(made)
    first = datasets[2]  # 2:-Y / 1:+X
    assert (first["type"], first["func_type"]) == (58, 4)
    assert (first["rsp_node"], first["rsp_dir"], first["ref_node"], first["ref_dir"]) == (2, -2, 1, 1)
    assert first["ordinate_spec_data_type"] == {"receptance": 8, "mobility": 11, "accelerance": 12}[quantity]
    assert pyuff.from_pyuff([{"type": 15, "node_nums": [1], "x": [0.5], "y": [0], "z": [0]}, *datasets]) == made
    assert pyuff.from_pyuff([{"type": 15, "node_nums": [1], "x": [0.5], "y": [0], "z": [0]}, *datasets]).nodes == {1: (0.5, 0.0, 0.0)}


def test_pyuff_leaves_gaps():
    made = sample()
    made.frfs[:, 1, 1] = np.nan
    datasets = pyuff.to_pyuff(made)
    assert len(datasets) == 5 and pyuff.from_pyuff(datasets) == made


def test_pyuff_errors():
    datasets = pyuff.to_pyuff(sample())
    datasets[0]["ordinate_spec_data_type"] = 0
    with pytest.raises(jointid.InputError, match="quantity"):
        pyuff.from_pyuff(datasets)
    assert pyuff.from_pyuff(datasets, quantity="accelerance") == sample()
    with pytest.raises(jointid.InputError, match="twice"):
        pyuff.from_pyuff([datasets[1], datasets[1]])
    with pytest.raises(jointid.InputError, match="other lines"):
        pyuff.from_pyuff([datasets[1], {**datasets[2], "x": datasets[2]["x"] + 1}])
    with pytest.raises(jointid.InputError, match="direction 7"):
        pyuff.from_pyuff([{**datasets[1], "rsp_dir": 7}])
    with pytest.raises(jointid.InputError, match="no FRFs"):
        pyuff.from_pyuff([{"type": 151}])


def test_sdynpy_array_and_npz(tmp_path):
    made = sample()
    array = sdynpy.structured(made)
    assert array.shape == (3, 2) and array["coordinate"][1, 0]["direction"].tolist() == [-2, 1]
    assert array.dtype.names == ("abscissa", "ordinate", "comment1", "comment2", "comment3", "comment4", "comment5", "coordinate")
    as_object = types.SimpleNamespace(**{key: array[key] for key in ("abscissa", "ordinate", "coordinate")})
    assert sdynpy.from_sdynpy(as_object, quantity="accelerance") == made
    sdynpy.save_sdynpy(tmp_path / "a.npz", made)
    assert sdynpy.from_sdynpy(tmp_path / "a.npz", quantity="accelerance") == made
    np.savez(tmp_path / "time.npz", data=array, function_type=1)
    with pytest.raises(jointid.InputError, match="no FRFs"):
        sdynpy.from_sdynpy(tmp_path / "time.npz", quantity="accelerance")


def test_pyfbs():
    made = sample()
    frequency, frfs, channels, impacts = pyfbs.to_pyfbs(made)
    assert frfs is made.frfs and channels["Direction_2"] == [0.0, -1.0, 0.0] and impacts["Position_1"] == [0.0, 0.2]
    back = pyfbs.from_pyfbs(frequency, frfs, channels, impacts)
    assert [dof.split(":")[1] for dof in back.responses] == ["+X", "-Y", "+Z"] and back.frfs is made.frfs
    assert back.responses[0].node == back.references[0].node  # one place, one node
    assert set(back.nodes.values()) == {(0, 0, 0), (0.5, 0, 0), (1, 0, 0), (0.2, 0.1, 0)}
    channels["Direction_1"][1], channels["Direction_2"][1] = 0.6, 0.8
    with pytest.raises(jointid.InputError, match="along no axis") as caught:
        pyfbs.from_pyfbs(frequency, frfs, channels, impacts)
    assert "virtual_points" in caught.value.remedy
    named = pyfbs.from_pyfbs(frequency, frfs, channels, impacts, responses=made.responses)
    assert named.responses == made.responses


def test_pyfbs_rotations():
    """Channels of angular acceleration and impacts that are moments; one tuple of DOFs may be responses and references."""
    made = sample(rows=("1:+Z", "1:-RX"), columns=("1:+Z", "1:-RX"))
    made = made._like(references=made.responses)
    frequency, frfs, channels, impacts = pyfbs.to_pyfbs(made)
    assert channels["Quantity"] == ["Acceleration", "Angular Acceleration"] and impacts["Quantity"] == ["Force", "Moment"]
    assert channels["Direction_1"] == [0.0, -1.0]
    back = pyfbs.from_pyfbs(frequency, frfs, channels, impacts)
    assert back.responses == back.references == ("1:+Z", "1:-RX")


def test_pyfbs_tables_of_pandas():
    pandas = needs("pandas")
    made = sample()
    frequency, frfs, channels, impacts = pyfbs.to_pyfbs(made)
    back = pyfbs.from_pyfbs(frequency, frfs, pandas.DataFrame(channels), pandas.DataFrame(impacts))
    assert back.shape == made.shape and back.quantity == "accelerance"


def test_pyfbs_positions_of_a_spreadsheet(tmp_path):
    pandas = needs("pandas")
    needs("openpyxl")
    frequency, frfs, channels, impacts = pyfbs.to_pyfbs(sample())
    with pandas.ExcelWriter(tmp_path / "positions.xlsx") as book:
        pandas.DataFrame(channels).to_excel(book, sheet_name="Channels_A")
        pandas.DataFrame(impacts).to_excel(book, sheet_name="Impacts_A")
    tables = [pyfbs.read_positions(tmp_path / "positions.xlsx", sheet) for sheet in ("Channels_A", "Impacts_A")]
    assert pyfbs.from_pyfbs(frequency, frfs, *tables) == pyfbs.from_pyfbs(frequency, frfs, channels, impacts)
    with pytest.raises(jointid.InputError, match="Channels_A, Impacts_A"):
        pyfbs.read_positions(tmp_path / "positions.xlsx", "Channels_B")


def test_pyema_and_pyfrf():
    made = sample(columns=("9:+Z",))
    frequency, frf = pyema.to_pyema(made)
    assert frf.shape == (3, 5)
    assert pyema.from_pyema(frequency, frf, made.responses, "9:+Z") == made
    with pytest.raises(jointid.InputError, match="name one"):
        pyema.to_pyema(sample())


def pyfrf(h1, coherence, count):
    """As pyFRF's objects are: H1 is a receptance [response, excitation, line], whatever was measured."""
    return types.SimpleNamespace(get_H1=lambda: h1, get_coherence=lambda: coherence, get_f_axis=lambda: np.arange(5.0), total_meas=count)


def test_pyfrf():
    frfs = sample("receptance").frfs
    h1 = np.moveaxis(frfs, 0, -1).copy()
    h1[:, :, 0] = np.inf  # 0 Hz of an acceleration
    one = pyema.from_pyfrf(pyfrf(h1[:, :1], np.full((3, 5), 0.9), 4), ["1:+X", "2:-Y", "3:+Z"], "9:+Z")
    assert one.quantity == "receptance" and one.averages == 4 and one.coherence.shape == (5, 3, 1) and one.coherence[2, 1, 0] == 0.9
    assert np.isnan(one.frfs[0]).all() and np.array_equal(one.frfs[1:, :, 0], frfs[1:, :, 0])
    both = pyema.from_pyfrf(pyfrf(h1, np.full((3, 5), 0.9), 4), one.responses, ["9:+Z", "9:+X"])
    assert both.coherence is None and np.array_equal(both.frfs[1:], frfs[1:])
    old = pyema.from_pyfrf(types.SimpleNamespace(get_H1=lambda: h1[0, 0], get_coherence=lambda: np.full(5, 0.9),
                                                 get_f_axis=lambda: np.arange(5.0), curr_meas=2), "1:+X", "9:+Z")
    assert old.averages == 2 and np.array_equal(old.frfs[1:, 0, 0], frfs[1:, 0, 0])
    with pytest.raises(jointid.InputError, match="6 FRFs for 3 × 1 DOFs"):
        pyema.from_pyfrf(pyfrf(h1, None, 4), one.responses, "9:+Z")


def test_xarray():
    xarray = needs("xarray")
    from jointid.bridges.xarray import from_xarray

    made = sample()
    array = made.to_xarray()
    assert isinstance(array, xarray.DataArray) and np.shares_memory(array.values, made.frfs)
    assert array.attrs == {"quantity": "accelerance", "units": made.unit} and array.dims == ("frequency", "output", "input")
    assert from_xarray(array.transpose("input", "frequency", "output")) == made


def test_pandas():
    needs("pandas")
    from jointid.bridges.pandas import from_pandas

    made = sample()
    table = made.to_pandas()
    assert table.shape == (5, 6) and np.array_equal(table["2:-Y", "9:-Z"].values, made.frfs[:, 1, 1])
    assert from_pandas(table) == made
    gaps = from_pandas(table.drop(columns=[("1:+X", "1:+X")]))
    assert np.isnan(gaps["1:+X", "1:+X"]).all() and not np.isnan(gaps["1:+X", "9:+Z"]).any()


def test_sep005():
    rate, count = 1000.0, 1000
    t = np.arange(count) / rate
    force = np.exp(-0.5 * ((t - 0.02) / 0.001) ** 2)
    motion = np.convolve(force, np.exp(-30 * t) * np.sin(2 * np.pi * 50 * t))[:count]
    channels = [{"name": "hammer", "data": force, "fs": rate, "unit_str": "N", "start_timestamp": "2024"},
                {"name": "acc", "data": motion, "fs": rate, "unit_str": "m/s^2", "start_timestamp": "2024"}]
    frfs = sep005.frf_of_sep005(channels, {"hammer": "1:+Z", "acc": "4:+Z"}).frfs()
    assert frfs.frequency[np.nanargmax(np.abs(frfs["4:+Z", "1:+Z"][:200]))] == pytest.approx(50.0, abs=2.0)
    assert sep005.pod_of_sep005(channels)["samples"] == count
    with pytest.raises(jointid.InputError, match="no channel 'acx'"):
        sep005.frf_of_sep005(channels, {"hammer": "1:+Z", "acx": "4:+Z"})
    with pytest.raises(jointid.InputError, match="sampled together"):
        sep005.pod_of_sep005([channels[0], {**channels[1], "fs": 500.0}])
    timed = [{**{key: each[key] for key in each if key != "fs"}, "time": t + 3.0} for each in channels]
    again = sep005.frf_of_sep005(timed, {"hammer": "1:+Z", "acc": "4:+Z"}).frfs()
    np.testing.assert_allclose(again.frequency, frfs.frequency, rtol=1e-9)
    np.testing.assert_allclose(again.frfs[1:], frfs.frfs[1:], rtol=1e-6)


@pytest.mark.parametrize("change, text", [
    ({"data": None}, "has no 'data'"),
    ({"unit_str": None}, "has no 'unit_str'"),
    ({"fs": None}, "neither fs nor a time"),
    ({"fs": None, "time": np.array([0.0, 1.0, 3.0, 4.0])}, "differ"),
    ({"name": "hammer"}, "two channels"),
    ({"start_timestamp": "2025"}, "from"),
])
def test_sep005_channels_that_are_wrong(change, text):
    good = {"name": "hammer", "data": np.arange(4.0), "fs": 10.0, "unit_str": "N", "start_timestamp": "2024"}
    wrong = {key: value for key, value in {**good, "name": "acc", **change}.items() if value is not None}
    with pytest.raises(jointid.InputError, match=text):
        sep005.pod_of_sep005([good, wrong])


def test_nothing_of_others_is_imported():
    import subprocess
    import sys

    program = ("import sys, jointid, jointid.bridges.pyuff, jointid.bridges.sdynpy, jointid.bridges.pyfbs, jointid.bridges.pyema, "
               "jointid.bridges.sep005, jointid.bridges.xarray, jointid.bridges.pandas\n"
               "print([name for name in ('matplotlib', 'pandas', 'xarray', 'scipy', 'sdynpy', 'pyuff') if name in sys.modules])")
    assert subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout.strip() == "[]"


def vp_table(words, groups=(1,)):
    return {"Grouping": [group for group in groups for _ in words], "Description": [*words] * len(groups),
            **{f"Position_{k}": [0.1 * k] * len(words) * len(groups) for k in (1, 2, 3)}}


def test_pyfbs_virtual_points():
    """Groupings become the sensors and impacts of virtual points; answers are those of the same points by hand."""
    places = [(0.1, 0.0, 0.0), (-0.1, 0.0, 0.0), (0.0, 0.1, 0.0)]
    channels = {**{f"Position_{k + 1}": [place[k] for place in places for _ in range(3)] for k in range(3)},
                **{f"Direction_{k + 1}": [float(axis == k) for _ in places for axis in range(3)] for k in range(3)},
                "Grouping": [1] * 9, "Quantity": ["Acceleration"] * 9}
    channels["Direction_1"][1], channels["Direction_2"][1] = 0.6, 0.8
    random = np.random.default_rng(2)
    frfs = random.normal(size=(4, 9, 9)) + 1j * random.normal(size=(4, 9, 9))
    names = [f"{node}:+{axis}" for node in (1, 2, 3) for axis in "XYZ"]
    made = pyfbs.from_pyfbs(np.arange(1.0, 5.0), frfs, channels, channels, responses=names, references=names)
    points = pyfbs.virtual_points(made, channels, channels, vp_table(["ux", "uy", "uz", "rx", "ry", "rz"]))
    skew = {"1:+Y": [0.6, 0.8, 0.0]}
    assert points == [{"name": "VP1", "position": [0.1, 0.2, 0.30000000000000004], "sensors": names, "directions": skew, "impacts": names,
                       "impact_directions": skew}]
    reached = np.vstack([np.array(each["d"]) @ np.array([[1, 0, 0, 0, z, -y], [0, 1, 0, -z, 0, x], [0, 0, 1, y, -x, 0]]) for each, (x, y, z)
                         in ((dict(d=[channels[f"Direction_{j}"][k] for j in (1, 2, 3)]),
                              np.array(places[k // 3]) - np.array([0.1, 0.2, 0.3])) for k in range(9))])
    inverse = np.linalg.pinv(reached)
    np.testing.assert_allclose(jointid.virtual_points(made, points).frfs, inverse @ frfs @ inverse.T, rtol=1e-9)
    assert pyfbs.virtual_points(made, channels, channels, vp_table(["rz", "ux", "uy"]))[0]["plane"] == "XY"
    assert pyfbs.virtual_points(made, channels, channels, vp_table(["ux", "uy", "uz", "rx", "ry", "rz", "ex"]))[0]["flexible"] == ["ex"]
    with pytest.raises(jointid.InputError, match="motions of grouping 1 are ux, uy"):
        pyfbs.virtual_points(made, channels, channels, vp_table(["ux", "uy"]))


def test_pyfbs_nodes_keep_their_numbers():
    made = sample(rows=("1:+X", "2:+X"), columns=("9:+Z",))
    frequency, frfs, channels, impacts = pyfbs.to_pyfbs(made)
    ab = pyfbs.from_pyfbs(frequency, frfs, channels, impacts)
    part = {key: values[1:] for key, values in channels.items()}
    alone = pyfbs.from_pyfbs(frequency, frfs[:, 1:], part, impacts)
    like = pyfbs.from_pyfbs(frequency, frfs[:, 1:], part, impacts, like=ab)
    assert alone.responses == ("1:+X",) and like.responses == ab.responses[1:] and like.references == ab.references
    assert set(like.nodes) == {2, 3}


def block_of(page):
    """The program of a page "coming from …"."""
    text = (pathlib.Path(__file__).parents[2] / f"docs/from-other-tools/{page}.md").read_text(encoding="utf-8")
    found = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    assert len(found) == 1
    return found[0]


def beam(rows, columns, **options):
    """Accelerances of one mode at 200 Hz."""
    f = np.arange(20.0, 400.0)
    mode = -(f**2) / (200.0**2 - f**2 + 2j * 0.01 * 200.0 * f)
    frfs = np.einsum("f,ij->fij", mode, np.ones((len(rows), len(columns))))
    return jointid.FrfSet(frfs, f, rows, columns, quantity="accelerance", **options)


def test_the_program_of_the_page_on_pyema():
    frequency, frf = pyema.to_pyema(beam(["1:+Z", "2:+Z"], ["1:+Z"]))
    ran = {"freq": frequency, "frf": frf, "jointid": jointid}
    exec(block_of("pyema-testlab"), ran)
    assert ran["fit"]["modes"][0]["frequency_hz"] == pytest.approx(200.0, rel=1e-6)


def test_the_program_of_the_page_on_pyfbs():
    places = {1: (0.1, 0, 0), 2: (-0.1, 0, 0), 3: (0, 0.1, 0), 4: (0, 0, 0.3)}
    dofs = [f"{node}:+{axis}" for node in places for axis in "XYZ"]
    frequency, whole, channels, impacts = pyfbs.to_pyfbs(beam(dofs, dofs, nodes=places))
    for table in (channels, impacts):
        table["Grouping"] = [2 if place == 0.3 else 1 for place in table["Position_3"]]
    points = {"Grouping": [1] * 6, "Description": ["ux", "uy", "uz", "rx", "ry", "rz"], **{f"Position_{k}": [0.0] * 6 for k in (1, 2, 3)}}
    ran = {"freq": frequency, "Y_AB": whole, "Y_A": whole, "df_chn_AB": channels, "df_imp_AB": impacts, "df_chn_A": channels,
           "df_imp_A": impacts, "df_vp": points}
    exec(block_of("pyfbs"), ran)
    assert ran["a"].responses == ran["ab"].responses and ran["points"][0]["name"] == "VP1"
    assert "VP1:+RX" in jointid.virtual_points(ran["ab"], ran["points"]).responses


def test_the_program_of_the_page_on_sdynpy(monkeypatch):
    """With a module in place of SDynPy, whose data_array() keeps what it gets."""
    kept = types.ModuleType("sdynpy")
    kept.data = types.SimpleNamespace(FunctionTypes=types.SimpleNamespace(FREQUENCY_RESPONSE_FUNCTION=4))
    kept.coordinate_array = lambda node, direction: (node, direction)
    kept.data_array = lambda *arguments: arguments
    monkeypatch.setitem(sys.modules, "sdynpy", kept)
    made = sample()
    ran = {"transfer_function_array": sdynpy.structured(made)}
    exec(block_of("sdynpy"), ran)
    assert ran["frfs"] == made
    kind, abscissa, ordinate, (node, direction) = ran["back"]
    assert kind == 4 and abscissa.shape == ordinate.shape == (3, 2, 5)
    assert node[1, 0].tolist() == [2, 1] and direction[1, 0].tolist() == [-2, 1]


def test_decoupling_of_the_page_on_sdynpy():
    """Masses 1, 2 and 6, 7 on springs and dampers; 2 is joined with 6, and 7 is an internal DOF of what is removed."""
    f = np.arange(1, 601) * 0.1
    omega = 2 * np.pi * f.reshape(-1, 1, 1)

    def chain(mass, stiffness, names, name):
        frfs = np.linalg.inv(stiffness * (1 + 1e-4j * omega) - omega**2 * np.diag(mass))
        return jointid.FrfSet(frfs, f, names, name=name)

    k_a, k_c = np.array([[3e4, -2e4], [-2e4, 2e4]]), np.array([[6e4, -6e4], [-6e4, 13e4]])
    k_ac = np.zeros((3, 3))
    k_ac[:2, :2] += k_a
    k_ac[1:, 1:] += k_c
    a, c = chain([1, 1], k_a, ["1:+X", "2:+X"], "a"), chain([1, 1], k_c, ["6:+X", "7:+X"], "c")
    whole = chain([1, 2, 1], k_ac, ["1:+X", "6:+X", "7:+X"], "ac")
    np.testing.assert_allclose(jointid.couple([a, c], join=[["2:+X", "6:+X"]]).frfs().frfs, whole.frfs, rtol=1e-9)
    page = (pathlib.Path(__file__).parents[2] / "docs/from-other-tools/sdynpy.md").read_text(encoding="utf-8")
    call = re.search(r"`(jointid\.decouple\(.*?\))`", page)[1]
    left = eval(call, {"jointid": jointid, "abc": whole, "c": c}).frfs()
    np.testing.assert_allclose(left["1:+X", "1:+X"], a["1:+X", "1:+X"], rtol=1e-9)
