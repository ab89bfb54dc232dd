"""site_test.py JOINTID: what the site is made of: the keys that the reader names are all that its sources read, every page is found from the
front page, every link leads somewhere. Needs neither Sphinx nor a network."""

import contextlib
import io
import os
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))

import command_line
import json_keys
import links
import scene_keys
import scene_meanings
import scene_tables
import stage

COMMAND = os.environ.get("JOINTID_COMMAND", "")
ANSWERS = os.environ.get("JOINTID_SCENE_ANSWERS", "")
READERS = ("ident/scene/*.cpp", "laws/scene/*.cpp", "impedance/scene/*.cpp", "impedance/decouple/*_scene.cpp", "tasks/response/*.cpp",
           "tasks/oscillate/*.cpp", "tasks/joint_history/read_*.cpp", "models/*.cpp")
#: Read by `find()`, but no keys of scenes: parts of JSON, of results, names of variables in files.
LITERALS = re.compile(r"\b(?:find|require)\(\s*\"([a-z_]+)\"\s*\)")
TABLES = re.compile(r"\.table\(\s*\{((?:\s*\"[a-z_]+\"\s*,?)+)\}\s*\)")


def sources() -> str:
    return "\n".join(path.read_text(encoding="utf-8") for pattern in READERS for path in sorted(ROOT.glob(pattern)))


class SceneKeys(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.found = scene_keys.all_keys(ANSWERS)
        cls.keys = {table: {key.name for key in keys} for table, keys in cls.found.items()}

    def test_every_table_that_the_sources_read_is_asked(self) -> None:
        """A list of keys in a source is that of a table, or of one of its variants."""
        literal = [set(re.findall(r'"([a-z_]+)"', keys)) for keys in TABLES.findall(sources())]
        self.assertGreater(len(literal), 25)
        for keys in literal:
            self.assertTrue(any(keys <= found for found in self.keys.values()), sorted(keys))

    def test_every_key_that_the_sources_read_is_named(self) -> None:
        every = set().union(*self.keys.values())
        read = set(LITERALS.findall(sources()))
        self.assertGreater(len(read), 150)
        self.assertEqual(read - every, set())

    def test_a_page_of_the_docs_names_every_key(self) -> None:
        meanings = scene_meanings.Meanings(ROOT / "docs")
        for kind in scene_tables.KINDS:
            below = {table.path for table in kind.tables}
            for table in kind.tables:
                for key in self.keys[kind.word, table.path]:
                    if f"{table.path}.{key}".strip(".") not in below:
                        meanings.of(kind, table.path, key)
        self.assertEqual(meanings.missing, [])

    def test_every_key_has_a_meaning(self) -> None:
        """A row of a page, not the name of a page alone."""
        meanings, without = scene_meanings.Meanings(ROOT / "docs"), []
        for kind in scene_tables.KINDS:
            below = {table.path for table in kind.tables}
            for table in kind.tables:
                for key in self.keys[kind.word, table.path]:
                    if f"{table.path}.{key}".strip(".") in below:
                        continue
                    of = meanings.of(kind, table.path, key)
                    if not of or of.startswith("see ["):
                        without.append((kind.word, table.title, key))
        self.assertEqual(without, [("lines", "at the top", "joints")])  # refused there

    def test_what_a_key_takes(self) -> None:
        takes = {(kind, path, key.name): key.takes for (kind, path), keys in self.found.items() for key in keys}
        for where, expected in ((("solve", "frequency", "range"), "`[lo, hi]`"), (("solve", "data", "reciprocity"), "true or false"),
                                (("solve", "identify", "equations"), 'list of `"nn"`, `"nj"`, `"jj"`, `"jn"`'),
                                (("solve", "joint", "dofs"), "list of strings"), (("history", "history", "forces"), "list of numbers"),
                                (("history", "history", "steps"), "a number"), (("history", "history", "algorithm"), '`"A"`, `"B"`')):
            self.assertEqual(takes[where], expected, where)

    def test_every_key_has_a_type(self) -> None:
        """Its own, or it is a table of the page."""
        for kind in scene_tables.KINDS:
            below = {table.path for table in kind.tables}
            untyped = [f"{table.title} {key.name}" for table in kind.tables for key in self.found[kind.word, table.path]
                       if not key.takes and f"{table.path}.{key.name}".strip(".") not in below]
            self.assertEqual(untyped, [], kind.word)

    def test_types_are_stated_where_the_reader_says_none(self) -> None:
        """A stated type that the reader contradicts, or that it says by itself, is a fault."""
        for kind in scene_tables.KINDS:
            for table in kind.tables:
                found = {key.name: key.takes for key in self.found[kind.word, table.path]}
                self.assertEqual({key: found[key] for key in table.stated}, table.stated, f"{kind.word} {table.title}")


class CommandLine(unittest.TestCase):
    def test_every_command_and_option(self) -> None:
        found = {" ".join(each.path): each for each in command_line.helps(COMMAND, [])}
        self.assertIn("series delay", found)
        self.assertIn("problem write", found)
        for name in ("solve", "plan", "check", "couple", "frf", "response"):
            options = {row[0].split()[0].split(",")[0] for row in found[name].rows["Options"]}
            self.assertIn("--json", options, name)
        self.assertIn(["SCENE TEXT REQUIRED", "Scene file (TOML)"], found["solve"].rows["Positionals"])
        for name, each in found.items():
            for rows in each.rows.values():
                for option, text in rows:
                    self.assertTrue(text, f"{name} {option} has no text")

    def test_what_it_does_not_understand_fails(self) -> None:
        with self.assertRaises(SystemExit):
            command_line.parse([], "Does it\nUsage: jointid\n\nno section\n")


class JsonKeys(unittest.TestCase):
    def test_paths_of_values(self) -> None:
        found = {}
        json_keys.collect({"a": [{"b": None, "c": []}, {"b": 1.5}], "dofs": {"1:+Y": 1, "2:+Y": True}, "e": {}}, "", found)
        self.assertEqual({path: sorted(kinds) for path, (kinds, _) in found.items()},
                         {"a[].b": ["null", "number"], "a[].c": ["list, empty"], "dofs.*": ["number", "true or false"], "e": ["object"]})
        self.assertEqual(found["a[].b"][1], 1.5)
        self.assertEqual(json_keys.shown("x", 687318.7451), "`687300.0`")

    def test_those_of_a_command(self) -> None:
        check = next(each for each in json_keys.EXAMPLES if each.command == "check")
        with tempfile.TemporaryDirectory() as folder:
            page = "\n".join(json_keys.section(COMMAND, folder, check))
        self.assertIn("| `verdict` | text | `\"clean\"` |", page)


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = tempfile.TemporaryDirectory()
        cls.site = pathlib.Path(cls.folder.name) / "site"
        stage.main(cls.site)  # fails where a link leads nowhere

    @classmethod
    def tearDownClass(cls) -> None:
        cls.folder.cleanup()

    def test_every_page_is_found_from_the_front_page(self) -> None:
        pages = {str(path.relative_to(self.site).with_suffix("")) for path in self.site.rglob("*.md")}
        self.assertGreater(len(pages), 40)
        found, left = {"index"}, ["index"]
        while left:
            page = left.pop()
            text = (self.site / f"{page}.md").read_text(encoding="utf-8")
            for block in re.findall(r"```\{toctree\}\n(.*?)```", text, re.DOTALL):
                for line in (re.sub(r".*<(.*)>", r"\1", line.strip()) for line in block.splitlines()):
                    name = os.path.normpath(os.path.join(os.path.dirname(page), line)) if line and not line.startswith(":") else ""
                    if name in pages and name not in found:
                        found.add(name)
                        left.append(name)
        self.assertEqual(pages - found, set())

    def test_programs_of_the_gallery_have_titles(self) -> None:
        programs = sorted((self.site / "gallery-source").glob("*.py"))
        self.assertGreaterEqual(len(programs), 12)
        for program in programs:
            title, line = program.read_text(encoding="utf-8").splitlines()[:2]
            self.assertEqual(line.removesuffix('"""'), "=" * len(title.removeprefix('"""')), program.name)

    def test_words_of_the_glossary_are_entries(self) -> None:
        text = stage.with_entries("# Coupling\n\nText.\n", ["LM-FBS", "dual coupling", "LM-FBS"])
        self.assertTrue(text.startswith("# Coupling\n\n```{eval-rst}\n.. index::\n   single: LM-FBS\n   single: dual coupling\n```\n"))

    def test_links_of_the_readme_lead_into_the_site(self) -> None:
        readme = (self.site / "project/readme.md").read_text(encoding="utf-8")
        self.assertNotIn("](docs/", readme)
        self.assertIn("](../file-formats.md", readme)


class Joining(unittest.TestCase):
    @staticmethod
    def first(pattern: str, file: str) -> str:
        found = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)
        return found[1] if found else f"none in {file}"

    def test_one_version(self) -> None:
        version = self.first(r"project\(jointid VERSION (\S+)", "CMakeLists.txt")
        self.assertEqual(self.first(r"^version: (\S+)$", "CITATION.cff"), version)
        self.assertEqual(self.first(r'<release version="([^"]+)"', "gui/share/org.jointid.workbench.metainfo.xml"), version)
        self.assertIn(f"## {version}\n", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))

    def test_a_fault_comes_with_version_and_check(self) -> None:
        template = (ROOT / ".github/ISSUE_TEMPLATE/fault.yml").read_text(encoding="utf-8")
        for command in ("jointid --version", "jointid check SCENE --json check.json"):
            self.assertIn(command, template)
        self.assertIn("run: .ci/run\n", (ROOT / ".github/workflows/ci.yml").read_text(encoding="utf-8"))

    def test_commands_of_contributing_are_there(self) -> None:
        text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
        scripts = set(re.findall(r"(scripts/[a-z-]+|\.ci/run)", text))
        self.assertGreaterEqual(len(scripts), 6)
        for script in scripts:
            self.assertTrue(os.access(ROOT / script, os.X_OK), script)


class Links(unittest.TestCase):
    def found(self, **pages: str) -> tuple[int, str]:
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                (pathlib.Path(folder) / f"{name}.html").write_text(text, encoding="utf-8")
            said = io.StringIO()
            with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
                code = links.main(pathlib.Path(folder).resolve())
            return code, said.getvalue()

    def test_those_that_lead_somewhere(self) -> None:
        code, said = self.found(a='<a href="b.html#x">b</a><a href="https://example.org/">e</a>', b='<p id="x">')
        self.assertEqual(code, 0)
        self.assertIn("1 inside of 2 pages, 0 dead; others, not followed: example.org 1", said)

    def test_dead_ones(self) -> None:
        for link in ('<a href="c.html">', '<a href="b.html#y">', '<a href="#y">', '<img src="picture.png">', '<script src="https://example.org/x.js">'):
            with self.subTest(link):
                code, said = self.found(a=link, b='<p id="x">')
                self.assertEqual(code, 1)
                self.assertIn("1 dead", said)


if __name__ == "__main__":
    unittest.main()
