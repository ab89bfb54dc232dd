"""json_keys.py JOINTID OUT.md: the keys of `--json` of each command, from what the commands write of built-in problems."""

import json
import pathlib
import subprocess
import sys
import tempfile
from dataclasses import dataclass

HEAD = """# JSON

What `--json` of each command writes: its keys, what they hold, and the value of the example above each table. Numbers are in SI units. `[]` stands
for any element of a list, `*` for the names of what was measured or sought. Keys that another problem adds stand in the page of the command.
Keys stay from version to version ([what compatible means](../project/contributing.md)).
"""
MOST_WORDS = 30  #: keys of an object; those of more are names
DIGITS = 4


@dataclass
class Example:
    command: str
    problem: str
    arguments: list[str]
    page: str
    method: str = ""


EXAMPLES = [
    Example("solve", "A1", ["{p}/A1.toml"], "report", "likelihood"),
    Example("check", "A1", ["{p}/A1.toml"], "checking-data"),
    Example("plan", "A1", ["{p}/A1.toml"], "scene"),
    Example("plan", "A1", ["{p}/A1.toml", "--bound"], "first-test"),
    Example("study", "A1", ["{p}/A1.toml", "--trials", "20", "--out", "study.h5"], "choosing-a-method"),
    Example("compare", "A1", ["{p}/A1.toml", "--trials", "3"], "choosing-a-method"),
    Example("couple", "coupling-A", ["{p}/coupling-A.toml", "--out", "coupled.h5"], "coupling"),
    Example("modalfit", "A1", ["{p}/A1_assembly.h5"], "modal-models"),
    Example("correlate", "A1", ["{p}/A1_substructure_1.h5", "{p}/A1_assembly.h5"], "correlation"),
    Example("loading-curve", "table2.1-1", ["{p}/table2.1-1.csv"], "loading-curves"),
    Example("equivalent", "rig2", ["{p}/rig2.toml"], "loading-curves"),
    Example("response", "beams-A", ["{p}/beams-A.toml"], "response"),
    Example("oscillate", "chain-3", ["{p}/chain-3.toml"], "oscillations"),
]


def kind(value: object) -> str:
    if isinstance(value, bool):
        return "true or false"
    return {type(None): "null", str: "text", int: "number", float: "number"}.get(type(value), "list, empty" if value == [] else "object")


def is_named(value: dict) -> bool:
    """Whether the keys are names, of DOFs or unknowns, not words of jointid."""
    return bool(value) and (len(value) > MOST_WORDS or not all(key.replace("_", "").isalnum() and key.islower() for key in value))


def collect(value: object, path: str, into: dict[str, tuple[set[str], object]]) -> None:
    """Every path with its kinds of values and the first of them."""
    if isinstance(value, dict) and value:
        for key, inner in value.items():
            name = "*" if is_named(value) else key
            collect(inner, f"{path}.{name}".lstrip("."), into)
    elif isinstance(value, list) and value:
        for inner in value:
            collect(inner, f"{path}[]", into)
    else:
        kinds, first = into.setdefault(path, (set(), value))
        kinds.add(kind(value))
        if first is None:
            into[path] = (kinds, value)


def shown(path: str, value: object) -> str:
    if "per_second" in path or any(part.endswith("_s") for part in path.split(".")):
        return ""  # another each time
    if isinstance(value, float):
        value = float(f"{value:.{DIGITS}g}")
    text = json.dumps(value, ensure_ascii=False)
    text = text if len(text) <= 60 else text[:57] + "…"
    return f"`{text}`".replace("|", "\\|")


def run(command: str, folder: str, words: list[str]) -> str:
    done = subprocess.run([command, *words], cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 4):
        raise SystemExit(f"jointid {' '.join(words)}: exit code {done.returncode}: {done.stderr}")
    return done.stdout


def section(command: str, folder: str, example: Example) -> list[str]:
    where = "-".join(filter(None, [example.problem, example.method]))
    write = ["problem", "write", example.problem, where, *(["--method", example.method] if example.method else [])]
    if not (pathlib.Path(folder) / where).exists():
        run(command, folder, write)
    words = [example.command, *(word.replace("{p}", where) for word in example.arguments), "--json", "-"]
    found: dict[str, tuple[set[str], object]] = {}
    collect(json.loads(run(command, folder, words)), "", found)
    title = f"jointid {example.command}" + (" --bound" if "--bound" in words else "")
    lines = [f"## {title}, JSON", "", f"    jointid {' '.join(write)} && jointid {' '.join(words)}", "",
             f"The command is described in [{example.page}](../{example.page}.md).", "", "| key | holds | here |", "|---|---|---|"]
    for path, (kinds, first) in found.items():
        lines.append(f"| `{path}` | {', '.join(sorted(kinds))} | {shown(path, first)} |")
    return [*lines, ""]


def main(command: str, out: str) -> None:
    command = str(pathlib.Path(command).resolve())
    with tempfile.TemporaryDirectory() as folder:
        lines = [line for example in EXAMPLES for line in section(command, folder, example)]
    pathlib.Path(out).write_text(HEAD + "\n" + "\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
