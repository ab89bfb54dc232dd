"""The answers are the command's, to the last bit, on ten problems."""

import json
import os
import subprocess

import jointid
import pytest

PROBLEMS = ["A1", "A2", "B", "C1", "D1", "E1", "H1", "rig1", "G1", "F1"]


def command(*arguments):
    done = subprocess.run([os.environ["JOINTID_COMMAND"], *arguments], capture_output=True, text=True, timeout=120)
    assert done.returncode in (0, 4), done.stderr
    found = json.loads(done.stdout)
    assert found.pop("provenance")["command"][1] == arguments[0]  # how the command was called
    return found


def numbers(result):
    """Its JSON without how it was made."""
    found = result.to_dict()
    assert found.pop("provenance")["version"] == jointid.__version__
    return found


def without_times(found):
    """JSON without what takes another time at each run."""
    if isinstance(found, dict):
        return {key: without_times(value) for key, value in found.items() if key not in ("runtime_s", "accumulator_bytes")}
    return [without_times(each) for each in found] if isinstance(found, list) else found


@pytest.mark.filterwarnings("ignore::jointid.JointidWarning")
@pytest.mark.parametrize("name", PROBLEMS)
def test_solve(name, tmp_path):
    scene = jointid.write_problem(name, tmp_path)
    assert without_times(numbers(jointid.identify(scene))) == without_times(command("solve", scene, "--json", "-"))


def test_check(noisy_a1):
    assert numbers(jointid.check(noisy_a1)) == command("check", noisy_a1, "--json", "-")


def test_plan(noisy_a1):
    assert numbers(jointid.plan(noisy_a1)) == command("plan", noisy_a1, "--json", "-")


def test_bound(noisy_a1):
    assert numbers(jointid.bound(noisy_a1)) == command("plan", noisy_a1, "--bound", "--json", "-")


def test_study(a1, tmp_path):
    ours = numbers(jointid.study(a1, trials=40, seed=3, out=tmp_path / "ours.h5"))
    theirs = command("study", a1, "--trials", "40", "--seed", "3", "--out", str(tmp_path / "theirs.h5"), "--json", "-")
    for found in (ours, theirs):
        found.pop("file"), found.pop("runtime_s")
    assert ours == theirs


def test_text_and_csv(noisy_a1):
    done = subprocess.run([os.environ["JOINTID_COMMAND"], "check", noisy_a1], capture_output=True, text=True, timeout=60)
    assert jointid.check(noisy_a1).text() == done.stdout
