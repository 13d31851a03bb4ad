"""packaging/release refuses what must not be published, in a small repository with its files.

    release.py ROOT
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

root = pathlib.Path(sys.argv.pop(1))


class Release(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "packaging").mkdir()
        for name in ("packaging/release", "CMakeLists.txt", "CHANGELOG.md", "CITATION.cff"):
            shutil.copy(root / name, self.folder / name)
        self.git("init", "-q")
        self.commit()

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x@example.org", *words], cwd=self.folder,
                       check=True)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-qm", "x")

    def change(self, name, old, new):
        file = self.folder / name
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new, 1))

    def dry_run(self):
        done = subprocess.run([self.folder / "packaging/release", "--dry-run"], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def version(self):
        return (self.folder / "CMakeLists.txt").read_text().split("project(terp VERSION ")[1].split()[0]

    def test_says_what_it_would_do_and_does_nothing(self):
        code, said = self.dry_run()
        self.assertEqual(code, 0, said)
        for word in ("make package", "make wheel", "make windows", "make browser", "as v" + self.version()):
            self.assertIn(word, said)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         [".git", "CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "packaging"])

    def test_refuses_a_tree_with_changes(self):
        (self.folder / "new").touch()
        self.assertEqual((1, True), (self.dry_run()[0], "not committed" in self.dry_run()[1]))

    def test_refuses_a_version_without_changes_or_date(self):
        self.change("CMakeLists.txt", f"VERSION {self.version()} ", "VERSION 9.9.9 ")
        self.commit()
        self.assertIn("no line `## [9.9.9] - YYYY-MM-DD`", self.dry_run()[1])
        self.change("CHANGELOG.md", "\n## [", "\n## [9.9.9] - unreleased\n\n## [")
        self.commit()
        self.assertIn("no line `## [9.9.9] - YYYY-MM-DD`", self.dry_run()[1])
        self.change("CHANGELOG.md", "[9.9.9] - unreleased", "[9.9.9] - 2030-01-01")
        self.commit()
        self.assertIn("CITATION.cff is not of 9.9.9, 2030-01-01", self.dry_run()[1])

    def test_refuses_a_tag_that_exists(self):
        self.git("tag", "v" + self.version())
        self.assertIn("exists: raise the version", self.dry_run()[1])


if __name__ == "__main__":
    unittest.main()
