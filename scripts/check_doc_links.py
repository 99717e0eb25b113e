#!/usr/bin/env python3
"""Checks that every link, picture, script and style sheet of a folder of web pages leads somewhere, anchors included.

Usage: check_doc_links.py FOLDER [FILE.md...] | --self-test

Links to other sites are not followed. The names of pages in .js files, which are doxygen's trees of contents and its
search, are checked too. Markdown files may link to files and folders next to them.
"""

import html.parser
import pathlib
import re
import tempfile
import urllib.parse

from complaints import report, run_script

ELSEWHERE = ("http:", "https:", "mailto:", "javascript:", "data:")
LINK_IN_MARKDOWN = re.compile(r"""\]\(([^)\s]+)\)|(?:src|href)=["']([^"']+)["']""")
LINK_IN_SCRIPT = re.compile(r"""["']([\w./-]+\.html)(#[\w.-]+)?["']""")


class Page(html.parser.HTMLParser):
    """The anchors of a page, and the links with their lines."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.anchors = set()
        self.links = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (name == "name" and tag == "a"):
                self.anchors.add(value)
            elif (name in ("href", "src") or (name == "data" and tag == "object")) and value is not None:
                self.links.append((self.getpos()[0], value))


def links_of_script(text):
    return [(text.count("\n", 0, match.start()) + 1, match.group(1) + (match.group(2) or ""))
            for match in LINK_IN_SCRIPT.finditer(text)]


def links_of_markdown(text):
    return [(text.count("\n", 0, match.start()) + 1, match.group(1) or match.group(2))
            for match in LINK_IN_MARKDOWN.finditer(text)]


def complaint_about(folder, source, link, pages):
    """The complaint about a link from one file, or None."""
    parts = urllib.parse.urlsplit(link)
    target = source if parts.path == "" else (source.parent / urllib.parse.unquote(parts.path)).resolve()
    # A script of the search may be in a folder of its own; it names pages relative to that folder or to the top.
    if source.suffix == ".js" and not target.exists():
        target = (folder / urllib.parse.unquote(parts.path)).resolve()
    if not target.exists():
        return "does not exist"
    anchor = urllib.parse.unquote(parts.fragment)
    if anchor and target.suffix == ".html" and target in pages and anchor not in pages[target].anchors:
        return "has no such anchor"
    return None


def check(folder, markdown_files=()):
    """Returns the number of pages, the number of links and the complaints."""
    folder = pathlib.Path(folder).resolve()
    pages = {path.resolve(): Page(path.read_text(encoding="utf-8")) for path in sorted(folder.rglob("*.html"))}
    links = [(path, line, link) for path, page in pages.items() for line, link in page.links]
    for path in sorted(folder.rglob("*.js")):
        links += [(path, line, link) for line, link in links_of_script(path.read_text(encoding="utf-8"))]
    for path in (pathlib.Path(name).resolve() for name in markdown_files):
        links += [(path, line, link) for line, link in links_of_markdown(path.read_text(encoding="utf-8"))]
    links = [item for item in links if not item[2].startswith(ELSEWHERE) and item[2] != "#"]
    complaints = []
    for path, line, link in links:
        complaint = complaint_about(folder, path, link, pages)
        if complaint:
            complaints.append(f"{path}:{line}: {link} {complaint}")
    return len(pages), len(links), complaints


# --- self-test -------------------------------------------------------------------------------------------------------

SOUND_PAGES = {
    "index.html": '<a href="other.html#part">x</a> <a href="#top">x</a> <h1 id="top">x</h1> <img src="a%20b.png"/>'
                  '<a href="https://www.cgal.org/nothing">x</a> <a href="javascript:f()">x</a>',
    "other.html": '<a name="part"></a> <script src="tree.js"></script>',
    "tree.js": 'var tree = [["x", "index.html#top", "other.html"]];',
    "search/all.js": 'var data = ["../other.html#part"];',
    "a b.png": "",
    "read.md": "[x](index.html) <img src='a b.png'> [x](https://www.cgal.org/nothing) [x](search)",
}

FAULTS = {
    "page": ("index.html", '<a href="gone.html">', "gone.html does not exist"),
    "anchor": ("index.html", '<a href="other.html#gone">', "other.html#gone has no such anchor"),
    "own anchor": ("other.html", '<a href="#gone">', "#gone has no such anchor"),
    "picture": ("other.html", '<img src="gone.png">', "gone.png does not exist"),
    "drawing": ("other.html", '<object data="gone.svg"></object>', "gone.svg does not exist"),
    "page in a script": ("tree.js", '"gone.html"', "gone.html does not exist"),
    "markdown": ("read.md", "[x](gone.md)", "gone.md does not exist"),
    "picture in markdown": ("read.md", '<img src="gone.png">', "gone.png does not exist"),
    "anchor in a script": ("search/all.js", '"../index.html#gone"', "index.html#gone has no such anchor"),
}


def complaints_of(pages):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in pages.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return check(folder, [pathlib.Path(folder) / "read.md"])[2]


def self_test():
    failures = [f"sound pages: {complaint}" for complaint in complaints_of(SOUND_PAGES)]
    for fault, (name, text, words) in FAULTS.items():
        complaints = complaints_of({**SOUND_PAGES, name: SOUND_PAGES[name] + "\n" + text})
        if len(complaints) != 1 or words not in complaints[0]:
            failures.append(f"not found: {fault}: {complaints}")
    return report(failures, f"self-test: {len(FAULTS)} faults")


def main(folder, *files):
    number_of_pages, number_of_links, complaints = check(folder, files)
    if number_of_pages == 0:
        complaints.append(f"{folder}: no pages")
    return report(complaints, f"{number_of_pages} pages, {number_of_links} links")


if __name__ == "__main__":
    run_script(__doc__, self_test, main, range(1, 100))
