"""The ledger of cases with a known answer: each is solved by the program, measured, and held against its reference.

`python3 -m terp.verify --help`. The path of a case: `cases` (which), `expected` (reads expected.toml), `solve` (one run
of the program, and its numbers, `measures`, by `formula`), `judge` (rows), `ledger` (text and pages). What the keys of
expected.toml mean: docs/verification_cases.md.
"""
