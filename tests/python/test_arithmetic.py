"""Parts, sums and multiples of sets, covariances as factors, lines at 0 Hz, phasors."""

import os
import pickle
import warnings

import jointid
import numpy as np
import pytest

F = np.arange(10.0, 17.0)


def numbers(*shape, seed=1):
    random = np.random.default_rng(seed)
    return random.normal(size=shape) + 1j * random.normal(size=shape)


def sample(seed=1, **options):
    return jointid.FrfSet(numbers(7, 3, 2, seed=seed), F, ["1:+X", "2:-Y", "3:+RZ"], ["1:+X", "9:+Z"], name=f"run {seed}", **options)


def test_parts_by_line_and_place():
    made = sample()
    assert np.shares_memory(made[:, 1, 0], made.frfs) and np.array_equal(made[:, 1, 0], made.frfs[:, 1, 0])
    assert np.array_equal(made[2:4, "2:+Y", "9:-Z"], made.frfs[2:4, 1, 1]) and made[3, "1:+X", "1:+X"] == made.frfs[3, 0, 0]
    assert np.array_equal(made[:, "2:+Y", :], -made.frfs[:, 1, :]) and made[..., 0, 0].shape == (7,)
    assert np.asarray(made) is made.frfs and np.abs(made.frfs).max() == np.abs(np.asarray(made)).max()
    for key in ((0, 0, 7), (0, "7:+X", 0), (0, 0), ("1:+X", 0), (0.5, 0, 0)):
        with pytest.raises(jointid.InputError):
            made[key]


def test_sums_are_those_of_the_same_dofs():
    one, two = sample(1), sample(2)
    turned = two.sel(["3:+RZ", "2:+Y", "1:+X"], ["9:+Z", "1:+X"]).to("accelerance")
    np.testing.assert_allclose((one + turned).frfs, one.frfs + two.frfs, rtol=1e-12)
    np.testing.assert_allclose((one - turned).frfs, one.frfs - two.frfs, rtol=1e-12)
    assert (one + two).responses == one.responses and (-one + one).frfs.any() is np.False_
    for wrong in (two.sel(band=(11, 14)), two.sel(["1:+X"])):
        with pytest.raises(jointid.InputError, match="other"):
            one + wrong
    with pytest.raises(TypeError):
        one + 1.0


def test_multiples():
    made = sample(variance=np.full((7, 3, 2), 2.0 + 3.0j), coherence=np.full((7, 3, 2), 0.5), averages=4)
    window = np.linspace(0.5, 1.0, 7)
    assert np.array_equal((2 * made).frfs, 2 * made.frfs) and np.array_equal((np.float64(2) * made).frfs, 2 * made.frfs)
    assert np.array_equal((made / 4).variance, made.variance / 16) and (made / 4).coherence is made.coherence
    assert np.array_equal((made * 2j).variance, np.full((7, 3, 2), 12.0 + 8.0j))  # real and imaginary part change places
    np.testing.assert_allclose((made * window).frfs, made.frfs * window[:, None, None])
    np.testing.assert_allclose((window * made).variance, made.variance * window[:, None, None] ** 2)
    with pytest.raises(jointid.InputError, match="3 numbers for 7 lines"):
        made * [1, 2, 3]
    with pytest.raises(TypeError):
        made * "2"


def test_variances_of_sums_add():
    """Against the scatter of many draws."""
    random = np.random.default_rng(3)
    deviation = 1e-3
    one, two = (sample(k, variance=np.full((7, 3, 2), deviation**2 * (1 + 1j))) for k in (1, 2))
    noise = lambda: deviation * (random.normal(size=(7, 3, 2)) + 1j * random.normal(size=(7, 3, 2)))
    draws = np.array([((one * 2 - two).frfs.real + (2 * noise() - noise()).real) for _ in range(4000)])
    np.testing.assert_allclose(draws.var(axis=0), (one * 2 - two).variance.real, rtol=0.15)


def factored(rows=20, columns=2, rank=3, quantity="accelerance"):
    factor = numbers(7, rows, rank, columns, seed=5)
    own = np.abs(numbers(7, rows, columns, seed=6).real)
    variance = 0.5 * ((np.abs(factor) ** 2).sum(axis=2) + own) * (1 + 1j)
    return jointid.FrfSet(numbers(7, rows, columns), F, [f"{k}:+X" for k in range(1, rows + 1)], ["1:+X", "9:+Z"][:columns],
                          quantity=quantity, variance=variance, covariance_factor=factor, covariance_diagonal=own, name="hits")


def test_factors_of_covariances_stay_factors(tmp_path):
    """[line, response, column, reference] through a file and back, and the pairs that they stand for."""
    made = factored()
    made.save(tmp_path / "a.h5")
    read = jointid.read(tmp_path / "a.h5")
    assert read._covariance is None
    np.testing.assert_allclose(np.abs(read.covariance_factor), np.abs(made.covariance_factor), rtol=1e-12)
    np.testing.assert_allclose(read.covariance_diagonal, made.covariance_diagonal, rtol=1e-12)
    pairs = read.covariance
    for r, s, c in ((4, 2, 0), (7, 7, 1), (19, 0, 1)):
        expected = (made.covariance_factor[:, r, :, c] * made.covariance_factor[:, s, :, c].conj()).sum(axis=1)
        expected = expected + (made.covariance_diagonal[:, r, c] if r == s else 0.0)
        np.testing.assert_allclose(pairs[:, r * (r + 1) // 2 + s, c], expected, rtol=1e-12)
    assert read.covariance_factor.nbytes + read.covariance_diagonal.nbytes < 0.4 * pairs.nbytes
    assert "covariance" in repr(read) and pickle.loads(pickle.dumps(read)) == read


@pytest.mark.parametrize("change", [lambda of: of.sel(["3:-X", "1:+X", "7:+X"], ["9:-Z"]), lambda of: of.to("receptance"),
                                    lambda of: of.sel(band=(11, 14)), lambda of: 3j * of, lambda of: of.copy()])
def test_factors_follow_what_is_done_to_the_set(change):
    """As the pairs of the same set do."""
    made = factored()
    of_pairs = made._like(_covariance=made.covariance, covariance_factor=None, covariance_diagonal=None)
    one, two = change(made), change(of_pairs)
    assert one.covariance_factor is not None and two.covariance_factor is None
    np.testing.assert_allclose(one.covariance, two.covariance, rtol=1e-12, atol=1e-12 * np.abs(two.covariance).max())


def test_wrong_factors():
    made = factored()
    with pytest.raises(jointid.InputError, match="not 4"):
        jointid.FrfSet(made.frfs, F, made.responses, made.references, covariance_factor=made.covariance_factor[..., 0])
    with pytest.raises(jointid.InputError, match="without a factor"):
        jointid.FrfSet(made.frfs, F, made.responses, made.references, covariance_diagonal=made.covariance_diagonal)
    with pytest.raises(jointid.InputError, match="both"):
        jointid.FrfSet(made.frfs, F, made.responses, made.references, covariance=made.covariance,
                       covariance_factor=made.covariance_factor)


def test_covariances_may_be_set():
    made = factored()
    pairs = made.covariance
    made.covariance = pairs
    assert made.covariance_factor is None and made.covariance is pairs


def test_hits_give_factors_and_their_answers():
    """Three hits and twelve sensors: the errors that sensors share reach identify() as they come of frf()."""
    rate, count = 1000.0, 400
    random = np.random.default_rng(1)
    force = np.exp(-0.5 * ((np.arange(count) / rate - 0.02) / 0.001) ** 2)
    hits = [np.column_stack([force, *(np.convolve(force, np.exp(-30 * np.arange(count) / rate))[:count] + random.normal(size=count) * 1e-3
                                      for _ in range(12))]) for _ in range(3)]
    frfs = jointid.frf(hits, channel=["1=1:+Z N", *(f"{k}={k}:+Z m/s^2" for k in range(2, 14))], rate=rate).frfs()
    assert frfs.covariance_factor.shape[1:] == (12, 2, 1) and frfs.covariance.shape[1:] == (78, 1)
    diagonal = frfs.covariance[5, [r * (r + 1) // 2 + r for r in range(12)], 0].real
    np.testing.assert_allclose(diagonal, frfs.variance[5, :, 0].real + frfs.variance[5, :, 0].imag, rtol=1e-9)


def test_zero_hertz_is_told(tmp_path):
    """A line at 0 Hz of an accelerance is no receptance, and does not become NaN without a word."""
    made = jointid.FrfSet(np.ones((3, 1, 1)) + 0j, [0.0, 1.0, 2.0], ["1:+X"], quantity="accelerance", name="beam")
    for quantity in ("receptance", "mobility"):
        with pytest.warns(jointid.DataWarning, match="0 Hz the accelerance fixes no " + quantity) as caught:
            turned = made.to(quantity)
        assert np.isnan(turned.frfs[0]).all() and np.isfinite(turned.frfs[1:]).all() and caught[0].filename == __file__
    made.save(tmp_path / "a.uff")
    with pytest.warns(jointid.DataWarning, match="0 Hz") as caught:
        read = jointid.read(tmp_path / "a.uff")
    assert np.isnan(read.frfs[0]).all() and caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        read.to("receptance")  # was told
        receptance = made.sel(band=(1, 2)).to("receptance")
        jointid.FrfSet(np.ones((3, 1, 1)) + 0j, [0.0, 1.0, 2.0], ["1:+X"]).to("accelerance")
    assert np.isfinite(receptance.frfs).all()


def test_friction_laws_of_arrays(tmp_path):
    """Phasors of forces and motions in memory give the answer of their files, to the last bit."""
    path = jointid.write_problem("sdof-iwan", tmp_path)
    table = jointid._scene.Scene.table_of(path)
    table["joint"]["friction"][0]["law"], table["frequency"]["range"] = "iwan", [80.0, 100.0]
    read = lambda name: jointid.read(tmp_path / name)
    folder = os.fspath(tmp_path)
    files = {**table, "data": {"parts": [f"{folder}/{name}" for name in table["data"]["parts"]],
                               "levels": [{**level, **{key: f"{folder}/{level[key]}" for key in ("responses", "forces")}}
                                          for level in table["data"]["levels"]]}}

    def in_memory(name, kind):
        of_file = read(name)
        variance = None if of_file.variance is None else of_file.variance[:, :, 0]
        return jointid.phasors(of_file.frfs[:, :, 0], of_file.frequency, of_file.responses, kind=kind, variance=variance, name=name)

    levels = [{**level, "responses": in_memory(level["responses"], "displacement"), "forces": in_memory(level["forces"], "force")}
              for level in table["data"]["levels"]]
    arrays = {**table, "data": {"parts": [read(name) for name in table["data"]["parts"]], "levels": levels}}
    ours, theirs = jointid.friction_laws(arrays), jointid.friction_laws(files)
    assert ours.usable and ours.to_dict()["joints"] == theirs.to_dict()["joints"] and "memory" not in ours.text()


def test_phasors_of_accelerations():
    omega = 2 * np.pi * F
    made = jointid.phasors(-(omega**2)[:, None] * 2e-6, F, ["1:+Y"], kind="acceleration", variance=np.ones((7, 1)), name="2 N")
    np.testing.assert_allclose(made.to("receptance").frfs, 2e-6)
    assert made.name == "2 N" and np.array_equal(made.variance, np.full((7, 1, 1), 1 + 1j))
    for wrong in (dict(kind="strain"), dict(values=np.ones(7)), dict(dofs=["1:+Y", "2:+Y"])):
        with pytest.raises(jointid.InputError):
            jointid.phasors(**{"values": np.ones((7, 1)), "frequency": F, "dofs": ["1:+Y"], **wrong})
