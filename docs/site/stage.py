"""stage.py OUT: lays out the sources of the site in OUT: the pages of docs/, those of the root of the tree as project/, the programs of the
gallery with titles. Links follow. docs/reference has its generated pages from others of this folder."""

import ast
import os
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
#: Pages of the root, and where they are in the site.
PROJECT = {"README.md": "project/readme.md", "CHANGELOG.md": "project/changelog.md", "CONTRIBUTING.md": "project/contributing.md",
           "SECURITY.md": "project/security.md"}
PAGES = re.compile(r"^<!-- pages: (.*) -->$", re.MULTILINE)
LINK = re.compile(r"(!?\[[^\]\n]*(?:\n[^\]\n]+)?\]\()([^)\s]+)(\))")
CODE = re.compile(r"^ *(`{3,}|~{3,}).*?^ *\1 *$", re.MULTILINE | re.DOTALL)


def named(page: pathlib.Path, entries: list[str], taken: set[pathlib.Path]) -> list[str]:
    """The pages that entries of a list stand for: names, `*` for all others of the folder. What is not there is left out."""
    found = []
    for entry in entries:
        if entry.endswith("*"):
            folder = (page.parent / entry).resolve().parent
            candidates = [each for each in sorted(folder.glob("*.md")) if each.name != "index.md" and each not in taken]
        else:
            candidates = [(page.parent / f"{entry}.md").resolve()]
        for each in candidates:
            if each.exists():
                taken.add(each)
                found.append(os.path.relpath(each.with_suffix(""), page.parent))
    return found


def with_contents(page: pathlib.Path, text: str, elsewhere: set[pathlib.Path]) -> str:
    """`<!-- pages: a, b, * -->` as a table of contents."""
    taken: set[pathlib.Path] = {page} | elsewhere

    def contents(match: re.Match) -> str:
        entries = named(page, [entry.strip() for entry in match[1].split(",")], taken)
        return "```{toctree}\n:maxdepth: 1\n\n" + "\n".join(entries) + "\n```" if entries else ""

    return PAGES.sub(contents, text)


def site_place(path: pathlib.Path) -> pathlib.Path | None:
    """Where a file of the tree is in the site, relative to its root; None: it is not."""
    if not path.is_relative_to(ROOT) or not path.exists():
        return None
    relative = path.relative_to(ROOT)
    if str(relative) in PROJECT:
        return pathlib.Path(PROJECT[str(relative)])
    if path.is_dir():
        path = path / "index.md"
    if path.is_relative_to(DOCS / "gallery"):
        return pathlib.Path("gallery") / ("index.rst" if path.name == "index.md" else f"{path.stem}.rst")
    return path.relative_to(DOCS) if path.is_relative_to(DOCS) and path.is_file() else None


def with_links(page: pathlib.Path, place: pathlib.Path, text: str) -> str:
    """Links as the site has them: to the places of pages there; to files that it has not, none: their paths stay as text."""

    def target(match: re.Match) -> str:
        link, _, anchor = match[2].partition("#")
        if not link or re.match(r"[a-z]+:", link):
            return match[0]
        file = (page.parent / link).resolve()
        found = site_place(file)
        if found is None:
            if not file.exists():
                raise SystemExit(f"{page.relative_to(ROOT)}: the link to {match[2]} leads nowhere")
            return f"{match[1].lstrip('!')[1:-2]} (`{file.relative_to(ROOT)}`)"
        new = os.path.relpath(found, place.parent)
        return match[1] + new + (f"#{anchor}" if anchor else "") + match[3]

    parts, last = [], 0
    for code in CODE.finditer(text):
        parts += [LINK.sub(target, text[last:code.start()]), code[0]]
        last = code.end()
    return "".join([*parts, LINK.sub(target, text[last:])])


def contents_of_reference() -> set[pathlib.Path]:
    """Pages that the reference lists: the explanation's list of all others leaves them out."""
    page = DOCS / "reference/index.md"
    lists = PAGES.findall(page.read_text(encoding="utf-8"))
    return {(page.parent / f"{entry.strip()}.md").resolve() for entries in lists for entry in entries.split(",")}


def glossary_entries() -> dict[pathlib.Path, list[str]]:
    """Words of the field by the page that treats them: rows "| words | ours | sentence ([page](link)). |" of docs/glossary.md."""
    page = DOCS / "glossary.md"
    entries: dict[pathlib.Path, list[str]] = {}
    for row in page.read_text(encoding="utf-8").splitlines() if page.exists() else []:
        cells = row.strip("| ").split(" | ")
        link = LINK.search(cells[-1])
        if row.startswith("|") and link and not link[2].startswith("http"):
            words = re.sub(r"\([^)]*\)", "", cells[0]).replace("`", "").replace("*", "")
            target = (page.parent / link[2].partition("#")[0]).resolve()
            entries.setdefault(target, []).extend(word.strip() for word in words.split(",") if word.strip())
    return entries


def with_entries(text: str, words: list[str]) -> str:
    """The words as entries of the index below the title, where the search finds them."""
    if not words:
        return text
    entries = "".join(f"   single: {word}\n" for word in dict.fromkeys(words))
    title, _, rest = text.partition("\n")
    return f"{title}\n\n```{{eval-rst}}\n.. index::\n{entries}```\n{rest}"


def stage_page(page: pathlib.Path, out: pathlib.Path) -> None:
    place = pathlib.Path(PROJECT[page.name]) if page.parent == ROOT else page.relative_to(DOCS)
    elsewhere = {DOCS / "index.md"}
    if place.parts[0] == "explanation":
        elsewhere |= contents_of_reference()
    text = with_contents(page, page.read_text(encoding="utf-8"), elsewhere)
    to = out / place
    to.parent.mkdir(parents=True, exist_ok=True)
    to.write_text(with_entries(with_links(page, place, text), glossary_entries().get(page, [])), encoding="utf-8")


def with_title(program: str) -> str:
    """The question that opens a program of the gallery, underlined as a title."""
    docstring = ast.get_docstring(ast.parse(program)) or ""
    question = docstring.splitlines()[0]
    return program.replace(question, f"{question}\n{'=' * len(question)}", 1)


def stage_gallery(out: pathlib.Path) -> None:
    folder = out / "gallery-source"
    folder.mkdir(parents=True)
    title = "Gallery"
    (folder / "README.txt").write_text(f"{title}\n{'=' * len(title)}\n\nPrograms of a few lines, each with the question that it answers. "
                                       "The tests run them.\n", encoding="utf-8")
    for program in sorted((DOCS / "gallery").glob("*.py")):
        (folder / program.name).write_text(with_title(program.read_text(encoding="utf-8")), encoding="utf-8")


def main(out: pathlib.Path) -> None:
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    for page in [*sorted(DOCS.rglob("*.md")), *(ROOT / name for name in PROJECT)]:
        stage_page(page, out)
    for file in [*sorted(DOCS.rglob("*.png")), *sorted(DOCS.rglob("*.rst"))]:
        (to := out / file.relative_to(DOCS)).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(file, to)
    shutil.copy2(DOCS / "conf.py", out / "conf.py")
    stage_gallery(out)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
