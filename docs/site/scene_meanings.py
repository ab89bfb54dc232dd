"""What the pages of docs/ say of the keys of scenes: rows of their tables."""

import pathlib
import re
from dataclasses import dataclass

from scene_tables import Kind

#: Sections whose heading does not name the table that they describe.
SECTIONS = {("scene", "Putting a file right"): "data.files.a", ("scene", "Everywhere"): "", ("virtual-points", "Keys"): "virtual_points",
            ("model-parts", "Keys of a model"): "", ("friction-from-vibration", "Time records"): "data.levels"}
TABLE = re.compile(r"`\[+([a-z_.]+)\]+`")
CODE = re.compile(r"`([^`]+)`")
LINK = re.compile(r"\]\(([^)#]*)(#[^)]*)?\)")


@dataclass
class Row:
    page: str
    table: str
    keys: list[str]
    meaning: str


def cells(line: str) -> list[str]:
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))]


def rows_of(page: pathlib.Path) -> list[Row]:
    rows, table = [], ""
    for line in page.read_text(encoding="utf-8").splitlines():
        if heading := re.match(r"#+ (.*)", line):
            named = TABLE.search(heading[1])
            table = SECTIONS.get((page.stem, heading[1]), named[1] if named else table)
        if not line.startswith("|") or line.startswith("|---"):
            continue
        first, *rest = cells(line)
        if named := TABLE.search(first):
            table = named[1]
        keys = [key.split(".")[0] if '"NAME"' in key else key for key in CODE.findall(first) if not key.startswith("[")]
        if keys and rest:
            rows.append(Row(page.stem, table, keys, rest[-1]))
    return rows


class Meanings:
    def __init__(self, docs: pathlib.Path) -> None:
        self._docs = docs
        self._rows: dict[str, list[Row]] = {}
        self.missing: list[str] = []

    def of(self, kind: Kind, table: str, key: str) -> str:
        """The row of this table, else a row of the same key, else the page that names it."""
        rows = [row for page in kind.pages for row in self._of_page(page) if key in row.keys]
        rows = rows or [row for row in self._of_page("scene") if key in row.keys and row.table == table]
        same = [row for row in rows if row.table == table] or [row for row in rows if table.startswith(row.table + ".")] or rows[:1]
        if same:
            return self._linked(same[0])
        for page in [*kind.pages, "scene"]:
            if re.search(rf"(?<![\w.-]){re.escape(key)}(?![\w-])", self._code(page)):
                return f"see [{page}](../{page}.md)"
        self.missing.append(f"{kind.word} [{table}] {key}")
        return ""

    def _of_page(self, page: str) -> list[Row]:
        if page not in self._rows:
            self._rows[page] = rows_of(self._docs / f"{page}.md")
        return self._rows[page]

    def _code(self, page: str) -> str:
        """What stands as code in a page."""
        text = (self._docs / f"{page}.md").read_text(encoding="utf-8")
        return "\n".join(re.findall(r"^```.*?^```|`[^`\n]+`", text, re.MULTILINE | re.DOTALL))

    @staticmethod
    def _linked(row: Row) -> str:
        return LINK.sub(lambda link: f"](../{link[1] or row.page + '.md'}{link[2] or ''})", row.meaning)
