"""package_texts.py DATE OUT: the copyright and the changelog that every Debian package carries. DATE as in mails."""

import gzip
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]


def paragraph(text: str) -> str:
    """As the text of a licence in a copyright file: indented, empty lines are dots."""
    return "\n".join(f" {line.strip()}" if line.strip() else " ." for line in text.strip().splitlines())


def licence_text(path: str) -> str:
    """Of a licence file what follows its title and copyright line."""
    text = (ROOT / path).read_text(encoding="utf-8")
    return paragraph(re.split(r"^Copyright.*$", text, maxsplit=1, flags=re.MULTILINE)[1])


def maintainer() -> str:
    """As cmake/JointidPackages.cmake has it."""
    if "DEBEMAIL" in os.environ:
        return f"{os.environ.get('DEBFULLNAME', '')} <{os.environ['DEBEMAIL']}>"
    return "The jointid authors <jointid@localhost>"


def changelog(date: str) -> str:
    version = re.search(r"project\(jointid VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    return (f"jointid ({version}-1) unstable; urgency=medium\n\n  * Version {version}: CHANGELOG.md of the sources.\n\n"
            f" -- {maintainer()}  {date}\n")


def main(date: str, out: str) -> None:
    folder = pathlib.Path(out)
    copyright_file = (ROOT / "packaging/copyright").read_text(encoding="utf-8")
    copyright_file = copyright_file.replace("@BSD@", licence_text("LICENSE")).replace("@MIT@", licence_text("report/page/vendor/uplot/LICENSE"))
    (folder / "copyright").write_text(copyright_file, encoding="utf-8")
    (folder / "changelog.Debian.gz").write_bytes(gzip.compress(changelog(date).encode(), 9, mtime=0))


if __name__ == "__main__":
    main(*sys.argv[1:])
