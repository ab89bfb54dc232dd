"""command_line.py JOINTID OUT.md: the command line as the command itself describes it, from `--help` of every command."""

import pathlib
import re
import subprocess
import sys
from dataclasses import dataclass, field

HEAD = """# Command line

All commands and options, as `jointid --help` of this version describes them. 

| exit code | |
|---|---|
| 0 | done |
| 2 | wrong use or a wrong scene |
| 3 | unreadable, unwritable or inconsistent data, or not enough memory for them |
| 4 | the numbers are not usable; results are written and marked |
| 70 | a bug: please [report it](../project/contributing.md) |
| 130 | interrupted |
"""
SECTION = re.compile(r"^(Positionals|Options|Subcommands|Examples?):$")
ROW = re.compile(r"^  (\S.*?)(?:\s{2,}(\S.*)|\s*)$")


@dataclass
class Help:
    path: list[str]
    text: str
    usage: str
    rows: dict[str, list[list[str]]] = field(default_factory=dict)
    examples: list[str] = field(default_factory=list)


def parse(path: list[str], text: str) -> Help:
    lines = text.splitlines()
    usage = next(i for i, line in enumerate(lines) if line.startswith("Usage: "))
    found = Help(path, " ".join(lines[:usage]), lines[usage].removeprefix("Usage: "))
    section = ""
    for line in lines[usage + 1:]:
        if match := SECTION.match(line):
            section = match[1]
        elif section.startswith("Example") and line.strip():
            found.examples.append(line.strip())
        elif line.startswith(" " * 20) and section:
            found.rows[section][-1][1] = f"{found.rows[section][-1][1]} {line.strip()}".strip()
        elif line.startswith("  ") and section:
            # a name of 28 characters or more stands alone, or its text follows one blank
            name, text = line[2:30].rstrip(), line[30:].strip()
            if len(line) > 29 and line[29] != " ":
                match = ROW.match(line)
                name, text = match[1], match[2] or ""
            found.rows.setdefault(section, []).append([name, text])
        elif line.strip():
            raise SystemExit(f"jointid {' '.join(path)} --help: what is the line {line!r}?")
    return found


def helps(command: str, path: list[str]) -> list[Help]:
    done = subprocess.run([command, *path, "--help"], capture_output=True, text=True, check=True)
    here = parse(path, done.stdout)
    below = [helps(command, [*path, name]) for name, _ in here.rows.get("Subcommands", [])]
    return [here, *(each for group in below for each in group)]


def cell(text: str) -> str:
    return text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*")


def table(title: str, rows: list[list[str]]) -> list[str]:
    lines = [f"| {title} | |", "|---|---|"]
    return [*lines, *(f"| `{name}` | {cell(text)} |".replace("`|", "`\\|") for name, text in rows), ""]


def section(found: Help) -> list[str]:
    """Of one command."""
    words = ["jointid", *found.path]
    lines = [f"{'#' * min(len(words), 3)} {' '.join(words)}" if found.path else "## jointid", "", cell(found.text).rstrip(".") + ".", "",
             f"    {found.usage}", ""]
    for title, name in (("argument", "Positionals"), ("option", "Options"), ("command", "Subcommands")):
        if name in found.rows:
            lines += table(title, found.rows[name])
    return [*lines, "```text", *found.examples, "```", ""] if found.examples else lines


def main(command: str, out: str) -> None:
    found = helps(str(pathlib.Path(command).resolve()), [])
    pathlib.Path(out).write_text(HEAD + "\n" + "\n".join(line for each in found for line in section(each)), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
