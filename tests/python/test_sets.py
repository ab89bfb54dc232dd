"""FRFs as arrays and their files."""

import pickle
import subprocess
import time

import jointid
import numpy as np
import pytest
from jointid import _jointid


def numbers(lines=7, rows=3, columns=2, seed=1):
    random = np.random.default_rng(seed)
    return random.normal(size=(lines, rows, columns)) + 1j * random.normal(size=(lines, rows, columns))


def sample(**options):
    return jointid.FrfSet(numbers() * 1e-6, np.arange(10.0, 17.0), ["1:+X", "2:-Y", "3:+RZ"], ["1:+X", "9:+Z"], name="beam", **options)


def test_arrays_are_not_copied():
    frfs = numbers()
    made = jointid.FrfSet(frfs, np.arange(1.0, 8.0), ["1:+X", "2:+X", "3:+X"], ["1:+X", "2:+X"])
    assert made.frfs is frfs
    assert made._parts()["frfs"] is frfs


def test_what_is_read_is_a_view_of_the_reader(tmp_path):
    jointid.write(tmp_path / "a.h5", sample())
    read = jointid.read(tmp_path / "a.h5")
    base = read.frfs.base
    while isinstance(base, np.ndarray):
        base = base.base
    owner = base.obj if isinstance(base, memoryview) else base
    assert isinstance(owner, _jointid.ComplexNumbers)
    assert np.shares_memory(np.asarray(owner), read.frfs)


def test_226_megabytes_are_handed_over_at_once():
    lines, dofs = 2400, 77
    frfs = np.zeros((lines, dofs, dofs), complex)
    assert frfs.nbytes > 226e6
    names = [f"{k}:+X" for k in range(1, dofs + 1)]
    made = jointid.FrfSet(frfs, np.arange(1.0, lines + 1), names)
    best = min(_seconds(lambda: _jointid.MemoryFile(made._parts())) for _ in range(5))
    assert best < 5e-3, f"{1e3 * best} ms"  # 0.2 ms on a quiet machine


def _seconds(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def test_the_module_calls_no_numpy():
    """Buffers alone cross the border: memoryview reads them, and nothing of NumPy's C API is named."""
    holder = _jointid.read  # exists
    assert callable(holder)
    with open(_jointid.__file__, "rb") as stream:
        content = stream.read()
    for name in (b"numpy.core.multiarray", b"numpy._core", b"_ARRAY_API"):
        assert name not in content
    symbols = subprocess.run(["nm", "-D", "--undefined-only", _jointid.__file__], capture_output=True, text=True).stdout
    assert "PyArray" not in symbols


def test_memoryview_alone_reads_and_gives(tmp_path):
    import array

    values = array.array("d", [1e-6, -2e-6, 3e-6, 4e-6])
    frfs = memoryview(numbers(2, 1, 1))  # of complex128, which array.array lacks
    parts = {"name": "plain", "frequency": array.array("d", [1.0, 2.0]), "responses": ["1:+X"], "references": ["1:+X"],
             "quantity": "receptance", "averages": 0.0, "precision": 2.0**-53, "repeats": 0, "nodes": {}, "axes": {}, "frfs": frfs,
             "variance": None, "coherence": None, "covariance": None, "reference_correlation": None}
    _jointid.write(parts, str(tmp_path / "a.h5"), "")
    back = memoryview(_jointid.read([str(tmp_path / "a.h5")], _jointid.OpenOptions(), None)["frfs"])
    assert (back.format, back.shape, back.nbytes) == ("Zd", (2, 1, 1), 32)
    assert back.tobytes() == frfs.tobytes()
    assert len(values) == 4


@pytest.mark.parametrize("ending", ["h5", "uff", "mat", "csv"])
@pytest.mark.parametrize("quantity", ["receptance", "mobility", "accelerance"])
def test_files_keep_numbers(tmp_path, ending, quantity):
    written = sample(quantity=quantity)
    path = tmp_path / f"a.{ending}"
    jointid.write(path, written)
    read = jointid.read(path)
    assert read.quantity == quantity
    assert read.responses == written.responses and read.references == written.references
    np.testing.assert_allclose(read.frequency, written.frequency, rtol=1e-12)
    np.testing.assert_allclose(read.frfs, written.frfs, rtol=1e-14)


def test_receptances_in_hdf5_keep_every_bit(tmp_path):
    written = sample()
    jointid.write(tmp_path / "a.h5", written)
    assert np.array_equal(jointid.read(tmp_path / "a.h5").frfs, written.frfs)


def test_errors_and_nodes_go_with_it(tmp_path):
    variance = np.abs(numbers(seed=2)) + 1j * np.abs(numbers(seed=3))
    written = sample(variance=variance * 1e-16, nodes={1: (0, 0, 0), 2: (0.5, 0, 0.25)}, quantity="mobility")
    jointid.write(tmp_path / "a.h5", written)
    read = jointid.read(tmp_path / "a.h5")
    np.testing.assert_allclose(read.variance, written.variance, rtol=1e-13)
    assert read.nodes == written.nodes


def test_coherence_goes_with_it(tmp_path):
    written = sample(coherence=np.full((7, 3, 2), 0.9), averages=5)
    jointid.write(tmp_path / "a.h5", written)
    read = jointid.read(tmp_path / "a.h5")
    assert read.averages == 5 and np.array_equal(read.coherence, written.coherence)


def test_covariance_goes_with_it(tmp_path):
    factor = numbers(7, 3, 2)
    covariance = np.empty((7, 6, 2), complex)
    pairs = [(r, s) for r in range(3) for s in range(r + 1)]
    for k, (r, s) in enumerate(pairs):
        covariance[:, k] = factor[:, r] * factor[:, s].conj() + (r == s)
    diagonal = np.stack([covariance[:, pairs.index((r, r))].real for r in range(3)], axis=1)
    written = sample(variance=0.5 * diagonal * (1 + 1j), covariance=covariance, quantity="accelerance")
    jointid.write(tmp_path / "a.h5", written)
    read = jointid.read(tmp_path / "a.h5")
    np.testing.assert_allclose(read.covariance, written.covariance, rtol=1e-12)
    part = read.sel(["3:+RZ", "1:+X"])
    np.testing.assert_allclose(part.covariance[:, 1], covariance[:, pairs.index((2, 0))].conj(), rtol=1e-12)


def test_nan_is_not_measured(tmp_path):
    frfs = numbers()
    frfs[:, 1, 1] = np.nan
    jointid.write(tmp_path / "a.uff", jointid.FrfSet(frfs, np.arange(10.0, 17.0), ["1:+X", "2:+Y", "3:+X"], ["1:+X", "9:+Z"]))
    read = jointid.read(tmp_path / "a.uff")
    assert np.isnan(read["2:+Y", "9:+Z"]).all() and not np.isnan(read["1:+X", "9:+Z"]).any()


def test_quantities_are_powers_of_omega():
    receptance = sample(variance=np.full((7, 3, 2), 2.0 + 3.0j))
    omega = 2 * np.pi * receptance.frequency.reshape(-1, 1, 1)
    mobility, accelerance = receptance.to("mobility"), receptance.to("accelerance")
    np.testing.assert_allclose(mobility.frfs, 1j * omega * receptance.frfs, rtol=1e-14)
    np.testing.assert_allclose(accelerance.frfs, -(omega**2) * receptance.frfs, rtol=1e-14)
    np.testing.assert_allclose(accelerance.to("receptance").frfs, receptance.frfs, rtol=1e-14)
    np.testing.assert_allclose(mobility.variance, omega**2 * np.full((7, 3, 2), 3.0 + 2.0j), rtol=1e-14)
    np.testing.assert_allclose(accelerance.variance, omega**4 * receptance.variance, rtol=1e-14)
    assert receptance.to("receptance") is receptance


def test_units_are_converted():
    made = jointid.FrfSet(np.ones((1, 1, 1)) + 0j, [1.0], ["1:+X"], unit="g/N")
    assert made.quantity == "accelerance" and made.frfs[0, 0, 0] == 9.80665
    assert made.values_in("mm/s^2/N")[0, 0, 0] == pytest.approx(9806.65)
    assert made.values_in("m/N")[0, 0, 0] == pytest.approx(-9.80665 / (2 * np.pi) ** 2)


def test_parts_have_the_signs_that_are_asked_for():
    made = sample()
    assert np.array_equal(made["2:+Y", "1:+X"], -made.frfs[:, 1, 0])
    assert np.array_equal(made["2:-Y", "1:-X"], -made.frfs[:, 1, 0])
    part = made.sel(["3:+RZ", "2:+Y"], ["9:+Z"])
    assert np.array_equal(part.frfs[:, 1, 0], -made.frfs[:, 1, 1])
    assert made.sel(node=[1, 3]).responses == ("1:+X", "3:+RZ")


def test_a_band_is_a_view():
    made = sample()
    band = made.sel(band=(11, 13))
    assert np.shares_memory(band.frfs, made.frfs) and band.frequency.tolist() == [11.0, 12.0, 13.0]


def test_sets_pickle_and_compare():
    made = sample(coherence=np.full((7, 3, 2), 0.5), averages=3)
    again = pickle.loads(pickle.dumps(made))
    assert again == made and again.responses[1].sign == -1
    assert made.copy() == made and made != made.to("mobility")


def test_plots():
    from conftest import needs

    needs("matplotlib")
    axes = sample().plot("1:+X", "9:+Z")
    assert "receptance" not in axes[0].get_ylabel() and "m/N" in axes[0].get_ylabel()
    assert len(sample().plot()[0].get_lines()) == 6


def test_frequencies_of_files_in_other_units(tmp_path):
    np.savez(tmp_path / "a.npz", H=np.full((3, 1, 1), 1e-6 + 0j), f=[0.1, 0.2, 0.3])
    options = dict(quantity="receptance", responses=["1:+Z"], variable="H", frequency_variable="f")
    assert jointid.read(tmp_path / "a.npz", frequency_unit="kHz", **options).frequency == pytest.approx([100.0, 200.0, 300.0])
    with pytest.raises(jointid.InputError, match="furlong"):
        jointid.read(tmp_path / "a.npz", frequency_unit="furlong", **options)
