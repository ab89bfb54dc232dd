"""The pages of the gallery run, each by itself, and say what they answer."""

import ast
import pathlib
import subprocess
import sys

import pytest

GALLERY = sorted((pathlib.Path(__file__).parents[2] / "docs/gallery").glob("*.py"))


@pytest.mark.parametrize("page", GALLERY, ids=lambda page: page.stem)
def test_page(page, tmp_path):
    question = ast.get_docstring(ast.parse(page.read_text(encoding="utf-8")))
    assert "?" in question or ":" in question.splitlines()[0]
    done = subprocess.run([sys.executable, "-W", "ignore", page], capture_output=True, text=True, timeout=30,
                          cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout


def test_there_are_pages():
    assert len(GALLERY) >= 12
