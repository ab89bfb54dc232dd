"""lint.py CONTAINERFILE: mistakes that reading it shows, for places where no container can be built."""

import pathlib
import re
import sys

KNOWN = {"FROM", "RUN", "CMD", "LABEL", "EXPOSE", "ENV", "ADD", "COPY", "ENTRYPOINT", "VOLUME", "USER", "WORKDIR", "ARG", "SHELL"}
COMPILERS = re.compile(r"\b(gcc|g\+\+|clang|cmake|ninja-build|build-essential|make)\b")


def instructions(text: str) -> list[tuple[str, str]]:
    whole = re.sub(r"\\\n", " ", "\n".join(line for line in text.splitlines() if not line.lstrip().startswith("#")))
    return [(word.upper(), rest.strip()) for word, _, rest in (line.strip().partition(" ") for line in whole.splitlines() if line.strip())]


def mistakes(text: str, root: pathlib.Path) -> list[str]:
    found, stages, names = [], [], set()
    for word, rest in instructions(text):
        if word not in KNOWN:
            found.append(f"{word} is no instruction")
        if word == "FROM":
            stages.append([])
            names.update(re.findall(r"\bAS (\w+)", rest, re.IGNORECASE))
        elif not stages:
            found.append(f"{word} comes before FROM")
        else:
            stages[-1].append((word, rest))
        source = re.search(r"--from=(\w+)", rest)
        if word == "COPY" and source and source[1] not in names:
            found.append(f"there is no stage {source[1]}")
        for script in re.findall(r"\bscripts/[\w-]+", rest if word == "RUN" else ""):
            if not (root / script).is_file():
                found.append(f"there is no {script}")
    last = stages[-1] if stages else []
    if len(stages) != 2:
        found.append(f"it has {len(stages)} stages, not 2")
    found += [f"the result has a compiler: {rest}" for word, rest in last if word == "RUN" and COMPILERS.search(rest)]
    if not any(word == "ENTRYPOINT" for word, _ in last):
        found.append("the result starts nothing")
    found += ["lists of packages stay in the result" for word, rest in last
              if word == "RUN" and "apt-get update" in rest and "rm -rf" not in rest]
    return found


def main(file: str) -> None:
    path = pathlib.Path(file).resolve()
    found = mistakes(path.read_text(encoding="utf-8"), path.parents[2])
    if found:
        raise SystemExit("\n".join(f"{file}: {each}" for each in found))


if __name__ == "__main__":
    main(*sys.argv[1:])
