"""command_files.py JOINTID DATE OUT: man pages and completion of the command, from its own description (`--help` of every command).

OUT/man/man1/jointid.1.gz, jointid-solve.1.gz, …; OUT/bash-completion/completions/jointid; OUT/zsh/vendor-completions/_jointid;
OUT/fish/vendor_completions.d/jointid.fish. DATE: of the man pages, as 2026-11-29."""

import gzip
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "docs/site"))
from command_line import Help, helps  # noqa: E402

EXIT_CODES = (("0", "done"), ("2", "wrong use or a wrong scene"), ("3", "unreadable, unwritable or inconsistent data, or not enough memory"),
              ("4", "the numbers are not usable; results are written and marked"), ("70", "a bug"), ("130", "interrupted"))
FILES = {"SCENE", "FILE", "FILES", "OUT", "PATH", "FOLDER"}


def options(of: Help) -> list[tuple[list[str], str, str]]:
    """Its options: flags ("-o", "--out"), what follows them or "", what they do."""
    found = []
    for name, text in of.rows.get("Options", []):
        words = name.split(" ", 1)
        found.append((words[0].split(","), words[1] if len(words) > 1 else "", text))
    return found


def commands(of: Help) -> list[list[str]]:
    return of.rows.get("Subcommands", [])


def roff(text: str) -> str:
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^([.'])", r"\\&\1", text, flags=re.MULTILINE)


def man_page(of: Help, date: str, version: str) -> str:
    name = "-".join(["jointid", *of.path])
    lines = [f'.TH "{name.upper()}" "1" "{date}" "jointid {version}" "User Commands"', ".SH NAME",
             f"{roff(name)} \\- {roff(of.text.rstrip('.'))}", ".SH SYNOPSIS", f".B {roff(of.usage)}"]
    for title, key in (("ARGUMENTS", "Positionals"), ("OPTIONS", "Options"), ("COMMANDS", "Subcommands")):
        if of.rows.get(key):
            lines.append(f".SH {title}")
            for row, text in of.rows[key]:
                lines += [".TP", f".B {roff(row)}", roff(text) or "\\&"]
    if of.examples:
        lines += [".SH EXAMPLES", ".nf", *(roff(each) for each in of.examples), ".fi"]
    lines.append(".SH EXIT STATUS")
    for code, meaning in EXIT_CODES:
        lines += [".TP", f".B {code}", roff(meaning)]
    see = sorted({"jointid", *(f"jointid-{name}" for name, _ in commands(of))} - {name}) if not of.path else ["jointid"]
    lines += [".SH SEE ALSO", ",\n".join(f".BR {roff(each)} (1)" if each == see[-1] else f".BR {roff(each)} (1)" for each in see)
              .replace("(1),", "(1),")]
    return "\n".join(lines) + "\n"


def quoted(text: str) -> str:
    return "'" + text.replace("'", "'\\''") + "'"


def bash(found: list[Help]) -> str:
    cases = []
    for of in found:
        words = " ".join([*(name for name, _ in commands(of)), *(flag for flags, _, _ in options(of) for flag in flags)])
        cases.append(f"    {quoted(' '.join(of.path))}) words={quoted(words)} ;;")
    known = "|".join(quoted(" ".join(of.path)) for of in found if of.path)
    return "\n".join([
        "# Completion of jointid for bash: commands, options, files.",
        "_jointid() {",
        "  local current=${COMP_WORDS[COMP_CWORD]} path= words= i",
        "  for ((i = 1; i < COMP_CWORD; ++i)); do",
        "    case \"${path:+$path }${COMP_WORDS[i]}\" in",
        f"    {known}) path=\"${{path:+$path }}${{COMP_WORDS[i]}}\" ;;",
        "    esac",
        "  done",
        "  case $path in",
        *cases,
        "  esac",
        "  if [[ $current == -* || -z $path ]]; then",
        "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")",
        "  else",
        "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -f -- \"$current\")",
        "  fi",
        "}",
        "complete -o filenames -F _jointid jointid", ""])


def zsh_text(text: str) -> str:
    return re.sub(r"([\[\]:\\])", r"\\\1", text).replace("'", "’")


def zsh_function(of: Help) -> list[str]:
    rows = []
    for flags, value, text in options(of):
        for flag in flags:
            rows.append(f"    '{flag}[{zsh_text(text)}]{':value:_files' if value else ''}' \\")
    name = "_".join(["_jointid", *of.path]).replace("-", "_")
    lines = [f"{name}() {{"]
    if commands(of):
        inner = [f"      {each}) {name}_{each.replace('-', '_')} ;;" for each, _ in commands(of)]
        listed = [f"      '{each}:{zsh_text(text)}'" for each, text in commands(of)]
        lines += ["  local context state line", "  _arguments -C \\", *rows, "    '1: :->command' '*:: :->rest'", "  case $state in",
                  "  command)", "    local -a found=(", *listed, "    )", "    _describe command found ;;", "  rest)", "    case $line[1] in",
                  *inner, "    esac ;;", "  esac"]
    else:
        lines += ["  _arguments \\", *rows, "    '*:file:_files'"]
    return [*lines, "}", ""]


def zsh(found: list[Help]) -> str:
    return "\n".join(["#compdef jointid", "# Completion of jointid for zsh: commands, options, files.",
                      *(line for of in found for line in zsh_function(of)), '_jointid "$@"', ""])


def fish(found: list[Help]) -> str:
    lines = ["# Completion of jointid for fish: commands, options, files."]
    for of in found:
        seen = " and ".join(f"__fish_seen_subcommand_from {name}" for name in of.path)
        below = " ".join(name for name, _ in commands(of))
        here = f"{seen}; and not __fish_seen_subcommand_from {below}" if seen and below else seen or "__fish_use_subcommand"
        here = here.replace(" and __fish", "; and __fish")
        for name, text in commands(of):
            lines.append(f"complete -c jointid -f -n {quoted(here)} -a {name} -d {quoted(text)}")
        for flags, value, text in options(of):
            named = " ".join(f"-l {flag[2:]}" if flag.startswith("--") else f"-s {flag[1:]}" for flag in flags)
            lines.append(f"complete -c jointid -n {quoted(here)} {named}{' -r' if value else ''} -d {quoted(text)}")
    return "\n".join(lines) + "\n"


def write(path: pathlib.Path, text: str, packed: bool = False) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    data = text.encode()
    path.write_bytes(gzip.compress(data, 9, mtime=0) if packed else data)


def main(command: str, date: str, out: str) -> None:
    found = helps(str(pathlib.Path(command).resolve()), [])
    version = subprocess.run([command, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
    folder = pathlib.Path(out)
    for of in found:
        write(folder / "man/man1" / ("-".join(["jointid", *of.path]) + ".1.gz"), man_page(of, date, version), packed=True)
    (folder / "man/man1/jointid-all.1.gz").symlink_to("jointid.1.gz")
    write(folder / "bash-completion/completions/jointid", bash(found))
    write(folder / "zsh/vendor-completions/_jointid", zsh(found))
    write(folder / "fish/vendor_completions.d/jointid.fish", fish(found))


if __name__ == "__main__":
    main(*sys.argv[1:])
