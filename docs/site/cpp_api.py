"""cpp_api.py XML OUT: doxygen's description of the headers that docs/library.md lists as XML in XML, and pages for breathe in OUT: one for
each folder of the library."""

import pathlib
import re
import subprocess
import sys
from collections import defaultdict
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROW = re.compile(r"^\| (`[^|]*`) \| ([^|]*) \|$", re.MULTILINE)
DOXYFILE = """
PROJECT_NAME = jointid
OUTPUT_DIRECTORY = {out}
INPUT = {headers}
STRIP_FROM_PATH = {root}
FULL_PATH_NAMES = YES
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_OUTPUT = .
XML_PROGRAMLISTING = NO
QUIET = YES
WARNINGS = NO
EXTRACT_ALL = YES
EXTRACT_STATIC = YES
AUTOLINK_SUPPORT = NO
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
SORT_MEMBER_DOCS = NO
HIDE_UNDOC_RELATIONS = YES
ENABLE_PREPROCESSING = YES
MARKDOWN_SUPPORT = NO
"""


def public_headers() -> dict[str, str]:
    """Header and what it is for."""
    found = {}
    for first, what in ROW.findall((ROOT / "docs/library.md").read_text(encoding="utf-8")):
        for header in re.findall(r"`([a-z_]+/[\w/]+\.hpp)`", first):
            found[header] = what.strip()
    return found


def describe(headers: list[str], xml: pathlib.Path) -> None:
    xml.mkdir(parents=True, exist_ok=True)
    text = DOXYFILE.format(out=xml, root=ROOT, headers=" ".join(str(ROOT / header) for header in headers))
    subprocess.run(["doxygen", "-"], input=text, text=True, check=True, stdout=subprocess.DEVNULL)


def file_of(index: ElementTree.Element, xml: pathlib.Path, header: str) -> ElementTree.Element:
    """Doxygen's description of one header."""
    for compound in index.iter("compound"):
        if compound.get("kind") == "file" and header.endswith("/" + compound.findtext("name", "")):
            found = ElementTree.parse(xml / f"{compound.get('refid')}.xml").getroot().find("compounddef")
            if found is not None and found.find("location").get("file") == header:
                return found
    raise SystemExit(f"doxygen does not describe {header}")


def qualified(member: ElementTree.Element) -> str:
    return member.findtext("qualifiedname") or member.findtext("definition", "").split()[-1]


def members_of_namespaces(xml: pathlib.Path) -> dict[str, list[ElementTree.Element]]:
    """What namespaces declare, by header, in the order of its lines."""
    found = defaultdict(list)
    for path in sorted(xml.glob("namespace*.xml")):
        for member in ElementTree.parse(path).getroot().iter("memberdef"):
            found[member.find("location").get("file")].append(member)
    for members in found.values():
        members.sort(key=lambda member: int(member.find("location").get("line")))
    return found


def directives(file: ElementTree.Element, of_namespaces: list[ElementTree.Element]) -> list[str]:
    """Breathe's directives for what a header declares."""
    lines = []
    for inner in file.findall("innerclass"):
        kind = "struct" if inner.get("refid", "").startswith("struct") else "class"
        name = "".join(inner.itertext())
        if name.count("::") == depth(file):
            lines += [f".. doxygen{kind}:: {name}", "   :members:", "   :undoc-members:", ""]
    for member in of_namespaces:
        kind, name = member.get("kind", ""), qualified(member)
        if kind == "function":
            name += member.findtext("argsstring", "").removesuffix(" noexcept")
        if kind in ("function", "enum", "typedef", "variable"):
            lines += [f".. doxygen{kind}:: {name}", ""]
    return lines


def depth(file: ElementTree.Element) -> int:
    """How many namespaces its own names are in: deeper ones are members of classes."""
    return max((("".join(name.itertext())).count("::") + 1 for name in file.findall("innernamespace")), default=0)


def write_pages(headers: dict[str, str], xml: pathlib.Path, out: pathlib.Path) -> None:
    index = ElementTree.parse(xml / "index.xml").getroot()
    of_namespaces = members_of_namespaces(xml)
    folders = defaultdict(list)
    for header in headers:
        folders[header.split("/")[0]].append(header)
    out.mkdir(parents=True, exist_ok=True)
    for folder, own in folders.items():
        lines = [f"C++: {folder}/", "=" * (6 + len(folder)), ""]
        for header in own:
            what = headers[header].replace("`", "``")
            lines += [header, "-" * len(header), "", what[:1].upper() + what[1:] + "." if what else "", "",
                      *directives(file_of(index, xml, header), of_namespaces[header])]
        (out / f"{folder}.rst").write_text("\n".join(lines), encoding="utf-8")
    contents = ["# C++ headers", "", "The headers that are kept from version to version ([the library](../library.md)).", "", "```{toctree}",
                ":maxdepth: 1", "", *(f"cpp/{folder}" for folder in folders), "```", ""]
    (out.parent / "cpp-api.md").write_text("\n".join(contents), encoding="utf-8")


def main(xml: pathlib.Path, out: pathlib.Path) -> None:
    headers = public_headers()
    describe(list(headers), xml)
    write_pages(headers, xml, out)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
