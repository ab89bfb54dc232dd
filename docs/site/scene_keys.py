"""scene_keys.py SCENE_ANSWERS OUT.md [OUT.json]: the keys of all kinds of scenes as the reader itself names them. It is asked: given a key that
is none, it names all that are; given a date, which it takes nowhere, it says what it expects. What a key means is from the pages of docs/."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass

from scene_meanings import Meanings
from scene_tables import KINDS, MODELS, SOLVE, Kind, Lines, SceneTable

NO_WORD = "this-is-surely-no-word"
DATE = "1979-05-27"
MODEL_SCENE = '[data]\nsubstructures = ["m.toml"]\nassembly = ["c.csv"]\n[joint]\ndofs = ["1:+X", "2:+X"]\nstiffness = { pattern = "full" }\n'
ASSEMBLY = "# quantity = receptance\n# unit = m/N\nfrequency_hz,1:+X/1:+X re,1:+X/1:+X im,2:+X/1:+X re,2:+X/1:+X im\n1,1,0,1,0\n2,1,0,1,0\n3,1,0,1,0\n"
#: What the reader expects, in the words of the page.
SINGLE = {"[lo, hi]": "`[lo, hi]`"}
SEVERAL = {"a string": "strings", "a number": "numbers", "an array": "lists", "a table": "tables", "[lo, hi]": "`[lo, hi]`"}


@dataclass
class Key:
    name: str
    takes: str
    variants: list[str]  #: where it is valid only with one of several choices


def scene_text(kind: Kind, asked: SceneTable, own: Lines, more: Lines) -> str:
    """The least scene with `own` lines of the table asked, and `more` in place of those of the same key."""
    text = ""
    tables = [table for table in kind.tables if (table.always and table.path not in asked.without) or table is asked]
    parents = [table for table in kind.tables if table.path and asked.path.startswith(table.path + ".") and table.path not in asked.without]
    for table in tables + [parent for parent in parents if parent not in tables]:
        lines = {**own, **more} if table is asked else dict(table.lines)
        if table is not asked and not table.path:
            lines.pop(asked.path.split(".")[0], None)
        if table.path and asked.path.startswith(table.path + "."):
            lines.pop(asked.path[len(table.path) + 1:].split(".")[0], None)
            if table.path == "joints":
                lines |= {"law": '"generalised"'} if asked.path.endswith("parameters") else {"law": '"series"'}
        body = "".join(f"{key} = {value}\n" for key, value in lines.items())
        text += f"{table.header}\n{body}" if table.path else body
    return in_order(text)


def in_order(text: str) -> str:
    """Tables below others after them, as TOML wants."""
    top, *blocks = re.split(r"^(?=\[)", text, flags=re.MULTILINE)
    headers = {re.match(r"\[+([^\]]+)", block)[1]: block for block in blocks}
    places = {path: min(i for i, other in enumerate(headers) if (other + ".").startswith(path + ".")) for path in headers}
    order = sorted(headers, key=lambda path: (places[path], path.count(".")))
    return top + "".join(headers[path] for path in order)


class Reader:
    """The readers of all commands in one process (tests/docs/scene_answers.cpp), which is asked scene after scene."""

    def __init__(self, program: str) -> None:
        self._folder = tempfile.TemporaryDirectory()
        self._process = subprocess.Popen([str(pathlib.Path(program).resolve())], cwd=self._folder.name, stdin=subprocess.PIPE,
                                         stdout=subprocess.PIPE, text=True, encoding="utf-8")

    def __enter__(self) -> "Reader":
        return self

    def __exit__(self, *_error: object) -> None:
        self._process.communicate()
        self._folder.cleanup()

    def answer(self, kind: Kind, text: str) -> str:
        files = {"s.toml": MODEL_SCENE, "m.toml": text, "c.csv": ASSEMBLY} if kind is MODELS else {"s.toml": text}
        question = {"arguments": [kind.command[0], "s.toml", *kind.command[1:]], "files": files}
        self._process.stdin.write(json.dumps(question) + "\n")
        self._process.stdin.flush()
        return json.loads(self._process.stdout.readline())

    def keys(self, kind: Kind, table: SceneTable, own: Lines) -> list[str]:
        said = self.answer(kind, scene_text(kind, table, own, {NO_WORD: "1"}))
        if f"the key '{NO_WORD}' is not known here" not in said:
            raise SystemExit(f"{kind.word} {table.title}: the reader names no keys: {said}")
        return listed(said)

    def takes(self, kind: Kind, table: SceneTable, key: str) -> str:
        """Asked beside the lines of the table, those of each variant, those that other keys need, and alone: some keys exclude each other.
        What the reader does not say is stated by the table."""
        several = (table.lines, *table.variants.values(), *table.companions, {})
        beside = (self._takes_beside(kind, table, own, key) for own in several)
        return next((takes for takes in beside if takes), table.stated.get(key, ""))

    def _takes_beside(self, kind: Kind, table: SceneTable, own: Lines, key: str) -> str:
        def said(value: str) -> str:
            return self.answer(kind, scene_text(kind, table, own, {key: value}))

        if (kind.word, table.path, key) == ("response", "curves", "along"):
            return "a string"  # the reader lists the parameters of one joint
        for value, several in ((f'"{NO_WORD}"', ""), (f'["{NO_WORD}"]', "list of ")):
            if (found := said(value)) and f"'{NO_WORD}' is not a valid word" in found and not file_names(words := listed(found)):
                return several + ", ".join(f'`"{word}"`' for word in words)
        expected = re.search(r": expected ([^:]*?), found a date", said(DATE))
        if expected and expected[1] == "an array":
            inner = re.search(r": expected ([^:]*?), found a date", said(f"[{DATE}]"))
            return f"list of {SEVERAL.get(inner[1], inner[1])}" if inner else "list"
        return SINGLE.get(expected[1], expected[1]) if expected else ""


def file_names(words: list[str]) -> bool:
    """Whether they are files and joints of the least scene, not words of the reader."""
    return set(words) <= {"a", "b", "c", "1–2"}


def listed(said: str) -> list[str]:
    """The words of "…; use a, b or c" or "Valid: a, b or c"."""
    tail = re.split(r"; use |Valid: ", said)[-1].removesuffix(")")
    return [word for word in re.split(r", | or ", tail) if word]


def table_keys(reader: Reader, kind: Kind, table: SceneTable) -> list[Key]:
    choices = {"": table.lines, **table.variants}
    found = {word: reader.keys(kind, table, own) for word, own in choices.items()}
    names = list(dict.fromkeys(key for keys in found.values() for key in keys))
    out = []
    for name in names:
        of = [word for word, keys in found.items() if name in keys]
        only = [] if len(of) == len(choices) else [word or first_word(table) for word in of]
        out.append(Key(name, reader.takes(kind, table, name), only))
    return out


def first_word(table: SceneTable) -> str:
    first = next(iter(table.lines.values()), "")
    return "matrices" if first.startswith("[[") else "FRFs" if first.startswith("[") else first.strip('"') if first.startswith('"') else ""


def all_keys(program: str) -> dict[tuple[str, str], list[Key]]:
    with Reader(program) as reader:
        return {(kind.word, table.path): table_keys(reader, kind, table) for kind in KINDS for table in kind.tables}


def page(keys: dict[tuple[str, str], list[Key]], meanings: Meanings) -> str:
    lines = ["# Scene keys", "", "All keys of all scenes, as the reader of this version names them. A key that is not here is an error.",
             "What a key means is from the pages that describe its section.", ""]
    for kind in KINDS:
        lines += [f"## {kind.title}", "", "Described in " + ", ".join(f"[{name}](../{name}.md)" for name in kind.pages) + ".", ""]
        for table in kind.tables:
            title = table.title if table.title.startswith("`") or not table.path else f"`{table.title}`"
            lines += [f"### {title[0].upper()}{title[1:]}, {kind.word}", "", "| key | takes | meaning |", "|---|---|---|"]
            for key in keys[kind.word, table.path]:
                only = f" (of {', '.join(key.variants)})" if key.variants else ""
                below = next((each for each in kind.tables if each.path == f"{table.path}.{key.name}".strip(".")), None)
                meaning = f"the table `{below.header}`" if below else meanings.of(kind, table.path, key.name)
                takes = key.takes or ("" if not below else "list of tables" if below.several else "a table")
                lines.append(f"| `{key.name}`{only} | {takes} | {meaning} |")
            lines.append("")
    return "\n".join(lines)


def main(program: str, out: str, as_json: str | None = None) -> None:
    keys = all_keys(program)
    meanings = Meanings(pathlib.Path(__file__).resolve().parents[1])
    pathlib.Path(out).write_text(page(keys, meanings), encoding="utf-8")
    if as_json:
        plain = {f"{kind} [{path}]": {key.name: key.takes for key in found} for (kind, path), found in keys.items()}
        pathlib.Path(as_json).write_text(json.dumps(plain, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    if meanings.missing:
        raise SystemExit("no page of docs/ names these keys: " + ", ".join(meanings.missing))


if __name__ == "__main__":
    main(*sys.argv[1:])
