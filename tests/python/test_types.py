"""The package is typed, and the stubs name what the extension module has."""

import ast
import importlib
import inspect
import os
import pkgutil
import re
import subprocess
import sys

import jointid
import pytest
from jointid import _jointid, bridges

HERE = os.path.dirname(__file__)


def run(*arguments, folder):
    environment = {**os.environ, "MYPYPATH": os.path.dirname(os.path.dirname(jointid.__file__))}
    return subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, env=environment, cwd=folder)


def stubs():
    """Names at the top of _jointid.pyi, of classes with those of their members."""
    path = os.path.join(os.path.dirname(jointid.__file__), "_jointid.pyi")
    with open(path, encoding="utf-8") as stream:
        tree = ast.parse(stream.read())
    found = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            found[node.name] = {each.target.id if isinstance(each, ast.AnnAssign) else each.name for each in node.body
                                if isinstance(each, (ast.AnnAssign, ast.FunctionDef))}
        elif isinstance(node, ast.FunctionDef):
            found[node.name] = None
    return found


def test_the_stubs_name_what_is_there():
    found = stubs()
    public = {name for name in dir(_jointid) if not name.startswith("_")}
    assert set(found) == public
    for name, members in found.items():
        if members is not None:
            assert members - {"__init__"} == {each for each in dir(getattr(_jointid, name)) if not each.startswith("_")}, name


@pytest.mark.skipif(os.environ.get("JOINTID_REQUIRE_ALL") != "1", reason="half a minute; JOINTID_REQUIRE_ALL=1 asks for it")
def test_mypy_and_stubtest(tmp_path):
    checked = run("mypy", "--python-version", "3.11", "--ignore-missing-imports", "--follow-imports", "skip", "--cache-dir",
                  str(tmp_path / "cache"), os.path.dirname(jointid.__file__), folder=tmp_path)
    assert checked.returncode == 0, checked.stdout + checked.stderr
    stubs = run("mypy.stubtest", "jointid._jointid", "--allowlist", os.path.join(HERE, "stubtest_allowlist.txt"),
                "--ignore-unused-allowlist", folder=tmp_path)
    assert stubs.returncode == 0, stubs.stdout + stubs.stderr


def test_the_package_says_that_it_is_typed():
    assert os.path.exists(os.path.join(os.path.dirname(jointid.__file__), "py.typed"))


def test_the_reference_has_every_public_name():
    with open(os.path.join(HERE, "../../docs/reference/python-api.rst"), encoding="utf-8") as page:
        listed = set(re.findall(r"^\.\. auto(?:function|class|exception):: (\w+)$", page.read(), re.MULTILINE))
    assert listed == set(jointid.__all__) - {"__version__"}


def documented():
    """Public functions and classes by name: those of the package and of its bridges."""
    yield from ((name, getattr(jointid, name)) for name in jointid.__all__ if name != "__version__")
    for module in pkgutil.iter_modules(bridges.__path__):
        if module.name.startswith("_"):
            continue
        found = importlib.import_module(f"jointid.bridges.{module.name}")
        yield from ((f"{module.name}.{name}", each) for name, each in vars(found).items()
                    if inspect.isfunction(each) and each.__module__ == found.__name__ and not name.startswith("_"))


def test_docstrings_have_an_example_and_the_errors():
    without_errors = {"problems", "pandas.to_pandas", "xarray.to_xarray", "pyfbs.to_pyfbs"}  # there is nothing that a caller could do wrong
    checked = dict(documented())
    assert len(checked) > 50
    for name, each in checked.items():
        text = inspect.getdoc(each) or ""
        if not (inspect.isclass(each) and issubclass(each, jointid.JointidWarning) and each is not jointid.JointidWarning):
            assert ">>> " in text, f"{name} has no example"
        if inspect.isfunction(each) and name not in without_errors:
            assert "InputError" in text, f"{name} does not state its errors"


def test_members_of_public_classes_are_documented():
    for name, each in documented():
        members = vars(each).items() if inspect.isclass(each) else ()
        for member, value in members:
            if not member.startswith("_") and (inspect.isfunction(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{member} has no docstring"
