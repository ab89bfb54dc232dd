"""The checkers of the documentation find what is wrong: test_check_docs.py JOINTID."""

import importlib.machinery
import importlib.util
import os
import pathlib
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"


def load(name):
    loader = importlib.machinery.SourceFileLoader(name.replace("-", "_"), str(SCRIPTS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


commands, language = load("check-docs-commands"), load("check-docs-language")
jointid = pathlib.Path(sys.argv.pop()).resolve()


class Commands(unittest.TestCase):
    def blocks_run(self, page):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "page.md")
            path.write_text(page, encoding="utf-8")
            environment = {**os.environ, "PATH": f"{jointid.parent}{os.pathsep}{os.environ['PATH']}"}
            return commands.check(path, environment, None)

    def fails(self, page, expected):
        with self.assertRaisesRegex(commands.Mismatch, expected):
            self.blocks_run(page)

    def test_a_page_that_is_right(self):
        page = "<!-- file a.txt -->\n```text\none 1.000e3\ntwo\n```\n\n<!-- run -->\n```console\n$ cat a.txt\none 1.001e3\n...\n```\n"
        self.assertEqual(self.blocks_run(page), 2)
        self.assertEqual(self.blocks_run("<!-- run -->\n```console\n$ jointid --version\njointid ...\n...\n```\n"), 1)
        self.assertEqual(self.blocks_run("```console\n$ false\n```\n"), 0)
        self.assertEqual(self.blocks_run("<!-- run exit=2 -->\n```console\n$ jointid sovle\n...\n```\n"), 1)

    def test_exit_codes(self):
        self.fails("<!-- run -->\n```console\n$ false\n```\n", "exit code 1, not 0")
        self.fails("<!-- run exit=4 -->\n```console\n$ true\n```\n", "exit code 0, not 4")
        self.fails("<!-- run exit=4 -->\n```console\n$ exit 4\n$ exit 4\n```\n", "exit code 4, not 0")

    def test_lines(self):
        self.fails("<!-- run -->\n```console\n$ echo 100\n102\n```\n", "shown: +102")
        self.fails("<!-- run -->\n```console\n$ printf 'a\\nb\\nc\\n'\na\nc\n```\n", "printed: b")
        self.fails("<!-- run -->\n```console\n$ printf 'a\\nb\\n'\n...\nb\n...\na\n```\n", "printed: .nothing.")
        self.fails("<!-- run -->\n```console\n$ echo status poor\nstatus ok\n```\n", "shown: +status ok")

    def test_pages_that_are_no_pages(self):
        self.fails("<!-- run -->\n\n```console\n$ true\n```\n", "no block after the mark")
        self.fails("<!-- run -->\n```console\n$ true\n", "has no end")
        self.fails("<!-- run -->\n```console\ntrue\n```\n", "no command before")

    def test_marked_pages_are_found_in_every_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "docs/how-to/deep").mkdir(parents=True)
            for name, text in (("A.md", "<!-- run -->\n"), ("docs/b.md", "<!-- run exit=2 -->\n"), ("docs/how-to/deep/c.md", "<!-- file x -->\n"),
                               ("docs/d.md", "no `<!-- run -->` of its own\n")):
                (root / name).write_text(text, encoding="utf-8")
            self.assertEqual([str(page.relative_to(root)) for page in commands.marked_pages(root)],
                             ["A.md", "docs/b.md", "docs/how-to/deep/c.md"])


class Language(unittest.TestCase):
    def test_sentences(self):
        text = "# A title of some words\n\nOne two three. Four five six seven!\n\n- an item `code with words` here\n\n| a b c d | e f g |\n"
        self.assertEqual([len(words) for words in language.sentences(text)], [3, 4, 4])
        self.assertEqual(list(language.sentences("```text\none two three four\n```\n")), [])

    def test_words(self):
        for text, word in (("The joint gives energy away: K", "gives energy away"), ("5 outlying lines", "outlying"),
                           ("it did not settle.", "settle"), ("   to mend it:", "mend"), ("a second blow", "blow")):
            self.assertIn(word, [found for found, _ in language.forbidden(text)], text)
        self.assertEqual(list(language.forbidden("shorten `settle`; see docs/unreachable-joints.md")), [])

    def test_texts_of_sources(self):
        source = '// "a comment of words"\nfail("two words "\n     "and more", "key", R"(raw of words)");\n'
        self.assertEqual(list(language.texts(source)), [(2, "two words and more")])


if __name__ == "__main__":
    unittest.main()
