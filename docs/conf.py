"""Settings of the documentation. CONTRIBUTING.md has the command that builds it.

Nothing on a page is loaded from elsewhere: mathematics becomes MathML while the pages are built, and the search is
Sphinx's own.
"""

import os
import sys
from importlib.metadata import version as version_of
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))  # docs.extensions, and the packages of this tree
os.environ["MPLBACKEND"] = "agg"

project = "fembearing"
author = "the fembearing developers"
copyright = f"{author}, MIT licence"
version = release = version_of("fembearing")
html_title = f"fembearing {version}"

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "numpydoc",
    "sphinx_gallery.gen_gallery",
    "docs.extensions.mathml",
    "docs.extensions.citations",
    "docs.extensions.docstrings",
    "docs.extensions.pictures",
    "docs.extensions.links",
    "docs.extensions.from_tree",
]
exclude_patterns = ["_templates", "extensions", "**/*.py.md5"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
nitpicky = False  # annotations name types of NumPy and the standard library, whose inventories would have to be fetched

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath", "substitution"]
myst_substitutions = {"version": version}
myst_heading_anchors = 4
suppress_warnings = ["config.cache"]  # the gallery's settings hold functions

autosummary_generate = True
default_role = "code"
autodoc_typehints = "none"  # the signature has them
autodoc_member_order = "bysource"
toc_object_entries_show_parents = "hide"
numpydoc_show_class_members = False
numpydoc_class_members_toctree = False

sphinx_gallery_conf = {
    "examples_dirs": "../examples",
    "gallery_dirs": "gallery",
    "filename_pattern": "/plot_",
    "ignore_pattern": r"__init__\.py",
    "within_subsection_order": "docs.extensions.gallery.place",
    "download_all_examples": False,
    "show_memory": False,
    "write_computation_times": False,
    "show_signature": False,
    "remove_config_comments": True,
    "min_reported_time": 0,
    "image_srcset": ["2x"],
    "thumbnail_size": (640, 480),
    "default_thumb_file": str(ROOT / "docs/pictures/6205-inner-pressure.png"),
}

templates_path = ["_templates"]
html_theme = "pydata_sphinx_theme"
html_static_path = ["_static"]
html_css_files = ["fembearing.css"]
html_math_renderer = "mathml"
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "logo": {"text": "fembearing"},
    "navbar_align": "left",
    "header_links_before_dropdown": 6,
    "show_prev_next": True,
    "secondary_sidebar_items": ["page-toc", "edit-this-page"],  # edits: see CONTRIBUTING.md
    "footer_start": ["copyright"],
    "footer_end": [],
    "navbar_end": ["theme-switcher"],
    "show_toc_level": 2,
}
