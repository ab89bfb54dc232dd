"""What the tests of the package have in common."""

import os

import jointid
import pytest


@pytest.fixture(scope="session")
def a1(tmp_path_factory):
    """The scene of problem A1, without noise."""
    return jointid.write_problem("A1", tmp_path_factory.mktemp("a1"), clean=True)


@pytest.fixture(scope="session")
def noisy_a1(tmp_path_factory):
    return jointid.write_problem("A1", tmp_path_factory.mktemp("a1noisy"))


@pytest.fixture()
def sets(a1):
    """Substructures and assembly of A1, in memory."""
    folder = os.path.dirname(a1)
    read = lambda part: jointid.read(os.path.join(folder, f"A1_{part}.h5"))
    return [read("substructure_1"), read("substructure_2")], read("assembly")


JOINT = {"dofs": ["4:+Y", "4:+RZ", "5:+Y", "5:+RZ"], "stiffness": "symmetric", "hysteretic_damping": "symmetric"}


@pytest.fixture()
def joint():
    return dict(JOINT)


def needs(module):
    """Skips where a package is missing; fails with JOINTID_REQUIRE_ALL=1."""
    if os.environ.get("JOINTID_REQUIRE_ALL") == "1":
        return __import__(module)
    return pytest.importorskip(module)
