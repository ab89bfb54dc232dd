"""The pages of the gallery run, each by itself, and say what they answer."""

import ast
import pathlib
import runpy
import subprocess
import sys

import pytest

GALLERY = sorted((pathlib.Path(__file__).parents[2] / "docs/gallery").glob("*.py"))


@pytest.mark.parametrize("page", GALLERY, ids=lambda page: page.stem)
@pytest.mark.filterwarnings("ignore")
def test_page(page, tmp_path, monkeypatch, capsys):
    text = page.read_text(encoding="utf-8")
    question = ast.get_docstring(ast.parse(text))
    assert "?" in question or ":" in question.splitlines()[0]
    if "multiprocessing" in text:  # whose processes begin with the page itself
        done = subprocess.run([sys.executable, "-W", "ignore", page], capture_output=True, text=True, timeout=30, cwd=tmp_path)
        assert done.returncode == 0, done.stdout + done.stderr
        assert done.stdout
        return
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(page), run_name="__main__")
    assert capsys.readouterr().out


def test_there_are_pages():
    assert len(GALLERY) >= 12


def test_notebooks(tmp_path):
    """Each a question and a program that Python takes."""
    import json

    subprocess.run([sys.executable, GALLERY[0].parents[2] / "scripts/notebooks", tmp_path], check=True)
    books = sorted(tmp_path.glob("*.ipynb"))
    assert [book.stem for book in books] == [page.stem for page in GALLERY]
    for book in books:
        question, program = json.loads(book.read_text(encoding="utf-8"))["cells"]
        assert question["cell_type"] == "markdown" and program["cell_type"] == "code"
        ast.parse("".join(program["source"]))
