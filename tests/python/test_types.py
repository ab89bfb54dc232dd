"""The package is typed, and the stubs name what the extension module has."""

import os
import subprocess
import sys

import jointid
from conftest import needs

HERE = os.path.dirname(__file__)


def run(*arguments, folder):
    environment = {**os.environ, "MYPYPATH": os.path.dirname(os.path.dirname(jointid.__file__))}
    return subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, env=environment, cwd=folder)


def test_mypy_and_stubtest(tmp_path):
    needs("mypy")
    checked = run("mypy", "--python-version", "3.11", "--ignore-missing-imports", "--follow-imports", "skip", "--cache-dir",
                  str(tmp_path / "cache"), os.path.dirname(jointid.__file__), folder=tmp_path)
    assert checked.returncode == 0, checked.stdout + checked.stderr
    stubs = run("mypy.stubtest", "jointid._jointid", "--allowlist", os.path.join(HERE, "stubtest_allowlist.txt"),
                "--ignore-unused-allowlist", folder=tmp_path)
    assert stubs.returncode == 0, stubs.stdout + stubs.stderr


def test_the_package_says_that_it_is_typed():
    assert os.path.exists(os.path.join(os.path.dirname(jointid.__file__), "py.typed"))
