#!/usr/bin/python3
"""The site that tools/make_site makes: each link leads to a file of it and to an anchor that is there, no address
outside is loaded, and each document is on it. Skipped (77) where cmark-gfm is missing.

    check_site.py TOOL
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse
from html.parser import HTMLParser

tool = pathlib.Path(sys.argv.pop(1))
root = tool.resolve().parent.parent


class Page(HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.anchors, self.links, self.loaded = set(), [], []
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors.add(given.get("id"))
        if tag == "a":
            self.links.append(given.get("href", ""))
        elif "src" in given or tag == "link":
            self.loaded.append(given.get("src") or given["href"])


def made(folder, *solver):
    return subprocess.run([tool, folder, *solver], capture_output=True, text=True, check=True).stdout


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.site = pathlib.Path(cls.temporary.name) / "site"
        solver = cls.site.with_name("solver.html")
        solver.write_text("<title>solver</title>")
        cls.said = made(cls.site, solver)
        cls.pages = {file: Page(file) for file in cls.site.rglob("*.html")}

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_links_lead_to_files_and_anchors_of_the_site(self):
        faults = []
        for file, page in self.pages.items():
            for address in page.links + page.loaded:
                parts = urllib.parse.urlsplit(address)
                target = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
                if parts.scheme == "data" or (address in page.links and parts.scheme in ("http", "https", "mailto")):
                    continue
                if parts.scheme or self.site.resolve() not in target.parents or not target.is_file() or (
                        parts.fragment and parts.fragment not in self.pages[target].anchors):
                    faults.append(f"{file.relative_to(self.site)}: {address}")
        self.assertEqual(faults, [])

    def test_every_document_is_there_and_is_found(self):
        index = (self.site / "sections.js").read_text()
        for document in (root / "docs").rglob("*.md"):
            page = document.relative_to(root).with_suffix(".html").as_posix().replace("README.html", "index.html")
            self.assertIn(self.site / page, self.pages)
            self.assertIn(f'"{page}"', index)

    def test_the_front_page_leads_to_the_solver_where_it_was_built(self):
        self.assertIn("terp.html", self.pages[self.site / "index.html"].links)
        self.assertIn("with the browser page", self.said)
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("without the browser page (make browser)", made(pathlib.Path(folder) / "site", "none.html"))
            front = pathlib.Path(folder) / "site/index.html"
            self.assertNotIn("terp.html", Page(front).links)
            self.assertIn("make browser", front.read_text())

    def test_pages_may_load_nothing_from_outside(self):
        for file, page in self.pages.items():
            if file.name not in ("terp.html", "reference_study.html"):  # with a policy of their own
                self.assertIn("default-src 'none'", file.read_text())


if __name__ == "__main__":
    if not shutil.which("cmark-gfm"):
        print("cmark-gfm is missing: tools/install-dependencies --site")
        sys.exit(77)
    unittest.main()
