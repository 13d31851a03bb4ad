#!/usr/bin/env python3
"""tools/check_unwind_table finds what is wrong in a table for exceptions: in small images made here, and, where
Debian's compiler for Windows is, in a program that it made.

usage: tests/tools/check_unwind_table.py FOLDER_OF_THE_SOURCES
"""
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOL = Path(sys.argv.pop(1)) / "tools/check_unwind_table"
COMPILER = shutil.which("x86_64-w64-mingw32-gcc")
HEADER, PDATA, XDATA = 0x80, 0x400, 0x600  # places in the file
XDATA_ADDRESS = 0x3000


def image(entries, versions=b"\x01\x01\x01\x01"):
    """The parts of a program of Windows that the tool reads. entries: (begin, end, number of unwind information)."""
    table = b"".join(struct.pack("<III", begin, end, XDATA_ADDRESS + 4 * k) for begin, end, k in entries)
    information = b"".join(bytes([version]) + bytes(3) for version in versions)
    sections = [(b".pdata", len(table), 0x2000, 0x200, PDATA),
                (b".xdata", 4 * len(versions), XDATA_ADDRESS, 0x200, XDATA)]
    head = bytearray(PDATA)
    struct.pack_into("<I", head, 0x3C, HEADER)
    struct.pack_into("<H12xH", head, HEADER + 6, len(sections), 0)
    for k, section in enumerate(sections):
        struct.pack_into("<8sIIII", head, HEADER + 24 + 40 * k, *section)
    return bytes(head) + table.ljust(XDATA - PDATA, b"\0") + information.ljust(0x200, b"\0")


def said_of(content):
    """(exit status, what the tool prints) of an image."""
    with tempfile.NamedTemporaryFile(suffix=".exe") as file:
        file.write(content)
        file.flush()
        done = subprocess.run([sys.executable, TOOL, file.name], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.replace(file.name, "PROGRAM") + done.stderr


class CheckUnwindTable(unittest.TestCase):
    def test_functions_one_after_the_other_are_right(self):
        self.assertEqual(said_of(image([(0x1000, 0x1010, 0), (0x1010, 0x1040, 1), (0x1050, 0x1060, 2)])), (0, ""))

    def test_entries_that_overlap(self):
        self.assertEqual(said_of(image([(0x1000, 0x1018, 0), (0x1010, 0x1040, 1)])),
                         (1, "PROGRAM: the entry of 0x1010 begins before that of 0x1000 ends, at 0x1018\n"))

    def test_entries_out_of_order(self):
        self.assertEqual(said_of(image([(0x1020, 0x1030, 0), (0x1000, 0x1010, 1)])),
                         (1, "PROGRAM: the entry of 0x1000 begins before that of 0x1020 ends, at 0x1030\n"))

    def test_an_entry_without_a_length(self):
        self.assertEqual(said_of(image([(0x1000, 0x1000, 0)])), (1, "PROGRAM: an entry of 0x1000 to 0x1000\n"))

    def test_an_entry_without_information(self):
        expected = (1, "PROGRAM: the entry of 0x1000 has no information that unwinds it\n")
        self.assertEqual(said_of(image([(0x1000, 0x1010, 1000)])), expected, "it lies in no section")
        self.assertEqual(said_of(image([(0x1000, 0x1010, 1)], b"\x01\x05")), expected, "it has another version")

    def test_an_empty_table_and_none(self):
        self.assertEqual(said_of(image([])), (1, "PROGRAM: its table for exceptions is empty\n"))
        self.assertEqual(said_of(image([(0x1000, 0x1010, 0)]).replace(b".pdata", b".other")),
                         (1, "PROGRAM: it has no table for exceptions\n"))

    def test_only_the_first_faults_are_printed(self):
        status, text = said_of(image([(0x1000, 0x1000, 0)] * 15))
        self.assertEqual((status, text.count("\n")), (1, 11))
        self.assertTrue(text.endswith("PROGRAM: 5 more\n"))

    @unittest.skipUnless(COMPILER, "no compiler for Windows")
    def test_a_program_of_the_compiler(self):
        with tempfile.TemporaryDirectory() as folder:
            source, program = Path(folder, "three.c"), Path(folder, "three.exe")
            source.write_text("#include <stdio.h>\nint twice(int n) { printf(\"%d\", n); return 2 * n; }\n"
                              "int main(int n, char** a) { (void)a; return twice(n) - twice(1); }\n")
            subprocess.run([COMPILER, "-O1", "-fno-inline", source, "-o", program], check=True)
            content = program.read_bytes()
        self.assertEqual(said_of(content), (0, ""))
        header = struct.unpack_from("<I", content, 0x3C)[0]
        n_sections, optional = struct.unpack_from("<H12xH", content, header + 6)
        rows = [header + 24 + optional + 40 * k for k in range(n_sections)]
        row = next(row for row in rows if content[row:row + 8].rstrip(b"\0") == b".pdata")
        (place,) = struct.unpack_from("<I", content, row + 20)
        begin, end = struct.unpack_from("<II", content, place)
        damaged = bytearray(content)
        struct.pack_into("<I", damaged, place + 4, end + 0x100)  # the first function now ends in the next ones
        status, text = said_of(bytes(damaged))
        self.assertEqual(status, 1)
        self.assertIn(f"begins before that of {begin:#x} ends, at {end + 0x100:#x}", text)


if __name__ == "__main__":
    unittest.main()
