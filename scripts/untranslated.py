"""untranslated.py FOLDER FILES.ts: lists texts without a finished translation, and texts in the sources that no translator is asked
for; fails where there are any."""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

# Calls that show their literal to the user.
SHOWN = r"\b(?:setText|setToolTip|setWindowTitle|setTitle|setPlaceholderText|setAccessibleName|addMenu|addAction|addTab|addItem|QLabel|" \
        r"QCheckBox|QPushButton|QGroupBox|say|warn)\(\s*(?:QStringLiteral\(|QString\()?\s*\"([^\"]*)\""


def untranslated(file):
    """Context and text of each message that is not finished."""
    for context in ElementTree.parse(file).getroot().findall("context"):
        for message in context.findall("message"):
            translation = message.find("translation")
            forms = [form.text for form in translation.findall("numerusform")] or [translation.text]
            if translation.get("type") == "unfinished" or not all(forms):
                yield context.findtext("name"), message.findtext("source")


def bare_literals(folder):
    """File, line and text of literals that are shown as they are, and of said("…"), which lupdate does not see."""
    for source in sorted(Path(folder).rglob("*.cpp")):
        text = source.read_text(encoding="utf-8")
        for pattern in (SHOWN, r'\bsaid\("([^"]*)"'):
            for found in re.finditer(pattern, text):
                if re.search(r"[A-Za-z]{3}", found[1]):
                    yield source, text.count("\n", 0, found.start()) + 1, found[1]


def main(folder, *files):
    missing = [f"{Path(file).name} lacks, in {context}: {text!r}" for file in files for context, text in untranslated(file)]
    missing += [f"{source}:{line}: not translated, write tr() or Said::tr(): {text!r}"
                for source, line, text in bare_literals(folder)]
    print("\n".join(missing) or "all texts are translated")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
