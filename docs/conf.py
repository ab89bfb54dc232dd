"""The site of jointid. scripts/docs builds it: docs/site/stage.py puts pages and generated references side by side first."""

import atexit
import os
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = pathlib.Path(os.environ.get("JOINTID_SOURCE", HERE.parent))

sys.path.insert(0, str(SOURCE / "python"))

project = "jointid"
author = "the authors of jointid"
release = re.search(r"project\(jointid VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
version = release

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "breathe", "sphinx_gallery.gen_gallery"]
exclude_patterns = ["site", "gallery-source", "**/README.txt"]
source_suffix = {".rst": "restructuredtext", ".md": "markdown"}
root_doc = "index"
nitpicky = True
# C++ names types of headers that are not listed; docstrings of Python describe types in words.
nitpick_ignore_regex = [(r"cpp:.*", r".*"), (r"py:(class|exc|obj)", r".*")]
suppress_warnings = ["misc.highlighting_failure"]  # blocks with "…" in place of what a reader fills in

myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence"]

autodoc_mock_imports = ["jointid._jointid"]
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented"

breathe_projects = {"jointid": os.environ.get("JOINTID_DOXYGEN", str(HERE / "xml"))}
breathe_default_project = "jointid"
breathe_show_include = False

sphinx_gallery_conf = {
    "examples_dirs": "gallery-source",
    "gallery_dirs": "gallery",
    "plot_gallery": False,
    "download_all_examples": False,
    "min_reported_time": 1e9,
    "show_memory": False,
    "remove_config_comments": True,
    "show_signature": False,
}

html_theme = "furo"
html_title = f"jointid {release}"
html_search_scorer = str(SOURCE / "docs/site/scorer.js")
html_copy_source = False
html_show_sourcelink = False
html_last_updated_fmt = None
html_show_copyright = False
pygments_style = "sphinx"


def with_examples(_app, _what, _name, _object, _options, lines):
    """Docstrings end with examples, without a heading: napoleon would take them for the last of the parameters or errors."""
    first = next((i for i, line in enumerate(lines) if line.startswith(">>>")), None)
    if first is not None and "Examples" not in lines:
        lines[first:first] = ["Examples", "--------"]


def forget_the_module(_app, _error):
    """What the package does when Python ends asks the extension module, which is not there."""
    if leave := getattr(sys.modules.get("jointid._progress"), "_leave", None):
        atexit.unregister(leave)


def setup(app):
    app.connect("build-finished", forget_the_module)
    app.connect("autodoc-process-docstring", with_examples, priority=400)  # before napoleon's 500
