"""Cards of a joint: those of the command, from a scene and from a solution."""

import os
import subprocess

import jointid
import pytest


def test_cards_are_those_of_the_command(a1, tmp_path):
    done = subprocess.run([os.environ["JOINTID_COMMAND"], "export", a1, "--to", "abaqus", "--out", tmp_path / "theirs"],
                          capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    ours = jointid.export(a1, tmp_path / "ours", to="abaqus")
    for ending, text in ours.items():
        assert text == (tmp_path / f"theirs{ending}").read_text() == (tmp_path / f"ours{ending}").read_text()


def test_of_a_solution(a1):
    text = jointid.export(jointid.identify(a1), to="nastran", way="matrix", units="mm")[".bdf"]
    assert text.startswith("$ jointid: joint of a solution of jointid.identify(), status ok\n")
    assert "N, mm, s, t, rad" in text


@pytest.mark.parametrize("wrong, place", [({"to": "nastrn"}, None), ({"to": "ansys", "units": "inch"}, "units")])
def test_wrong_input(a1, wrong, place):
    with pytest.raises(jointid.InputError) as error:
        jointid.export(a1, **wrong)
    assert error.value.remedy
    if place:
        assert error.value.place == place
