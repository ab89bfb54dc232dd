"""Criteria of agreement, and FRFs where nothing was measured."""

import jointid
import numpy as np
import pytest

F = np.linspace(10.0, 100.0, 60)


def chain(stiffness, name, size=4):
    """FRFs of masses on springs, each to the next and the first to ground."""
    matrix = stiffness * (2 * np.eye(size) - np.eye(size, k=1) - np.eye(size, k=-1))
    omega = 2 * np.pi * F.reshape(-1, 1, 1)
    return jointid.FrfSet(np.linalg.inv(matrix * (1 + 0.02j) - omega**2 * np.eye(size)), F, [f"{k + 1}:+X" for k in range(size)], name=name)


TRUTH, MODEL = chain(3e4, "truth"), chain(4e4, "model")


def frac(a, b):
    return abs(np.vdot(a, b)) ** 2 / (np.vdot(a, a).real * np.vdot(b, b).real)


def test_criteria_are_those_of_numpy():
    found = jointid.correlate(TRUTH, MODEL, fdac="2:+X")
    for each in found["frfs"]:
        a, b = TRUTH[each["response"], each["reference"]], MODEL[each["response"], each["reference"]]
        assert each["frac"] == pytest.approx(frac(a, b), abs=1e-12)
        assert each["lac"] == pytest.approx(np.mean(2 * abs(a) * abs(b) / (abs(a) ** 2 + abs(b) ** 2)), abs=1e-12)
    assert found.frac.shape == (16,) and np.isnan(found.chi_square_ratio)
    column = lambda of: of.frfs[:, :, 1].T
    expected = [[frac(column(TRUTH)[:, i], column(MODEL)[:, j]) for j in range(60)] for i in range(60)]
    np.testing.assert_allclose(found.fdac, expected, atol=1e-12)
    assert "FRAC" in str(found)


@pytest.mark.parametrize("way", ["extended", "semm"])
def test_expansion_holds_what_was_measured(way):
    b = ["1:+X", "3:+X"]
    found = jointid.expand(MODEL, TRUTH.sel(b, b), way=way).frfs()
    for row in b:
        for column in b:
            np.testing.assert_allclose(found[row, column], TRUTH[row, column], rtol=1e-8)
    inverse = lambda of: np.linalg.inv(of.frfs)
    if way == "semm":  # the dynamic stiffness changes at b alone
        change = abs(inverse(found) - inverse(MODEL)).max(axis=0)
        assert change[1, :].max() < 1e-6 * change.max() and change[3, :].max() < 1e-6 * change.max()


@pytest.mark.parametrize(("call", "what"), [
    (lambda: jointid.correlate(TRUTH, jointid.FrfSet(np.ones((60, 1, 1)) + 0j, F, ["9:+X"], name="other")), "other.*none is that of"),
    (lambda: jointid.correlate(TRUTH, MODEL, modes=True), "no mode shapes"),
    (lambda: jointid.correlate(TRUTH, MODEL, fdac="9:+X"), "is no reference of both"),
    (lambda: jointid.correlate(3, MODEL), "one"),
    (lambda: jointid.expand(MODEL, TRUTH, way="semmm"), "no way"),
    (lambda: jointid.expand(MODEL, TRUTH, modes=2), "no modes"),
    (lambda: jointid.expand(MODEL, TRUTH, way="serep"), "parent|model"),
])
def test_errors_name_what_is_wrong(call, what):
    with pytest.raises(jointid.InputError, match=what):
        call()
