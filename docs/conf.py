# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of Sphinx for docs/build. The source folder is the project's top folder, so that links lead from a page to
READMEs and pictures as they do on GitHub."""
import os
import pathlib
import re
import subprocess

project = "Sherd"
author = copyright = "The Sherd developers"
extensions = ["myst_parser"]
html_theme = "furo"
root_doc = "docs/index"
include_patterns = ["*.md", *(f"{folder}/**.md" for folder in ("app", "core", "docs", "fracture", "meshops", "scenes",
                                                               "tests"))]
exclude_patterns = ["build"]
myst_heading_anchors = 6  # by the names that GitHub gives them


def add_contents(app, name, source):
    """Adds tables of contents to the index, which GitHub would not show: the pages to which it leads, in their order, and
    the READMEs of folders."""
    if name != root_doc:
        return
    listed = re.findall(r"\]\(([^)]*)\.md\)", source[0])
    pages = [path.removeprefix("../") if path.startswith("../") else f"docs/{path}" for path in listed]
    folders = sorted(app.env.found_docs - {root_doc, *pages})
    for caption, group in (("Pages", pages), ("Folders of the source", folders)):
        lines = "".join(f"/{page}\n" for page in group)
        source[0] += f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{lines}```\n"


def add_keys(app, name, source):
    """Replaces each command `sherd scenes --keys TABLE` in a block `scene-keys` by the tables of the program that docs/build
    names in SHERD."""
    def tables(block):
        command = [os.environ["SHERD"], "scenes", "--keys", block[1], "--markdown"]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    source[0] = re.sub(r"^```scene-keys\nsherd scenes --keys (\S+)\n```$", tables, source[0], flags=re.MULTILINE)


def link_to_folder(app, environment, reference, text):
    """Returns the text of a link to a folder, which has no page; None for other links, whose target is missing."""
    folder = pathlib.Path(app.srcdir, reference["refdoc"]).parent / reference["reftarget"]
    return text if folder.is_dir() else None


def setup(app):
    app.connect("source-read", add_contents)
    app.connect("source-read", add_keys)
    app.connect("missing-reference", link_to_folder)
