"""The compiled part: use terp.Case and terp.Simulation, which say what each of these does."""

import numpy

version: str

class CaseFile:
    text: str
    path: str
    title: str
    name: str
    warnings: str

class SavedState:
    time: float
    step: int

class Simulation:
    summary: str
    warnings: str
    has_ended: bool
    time: float
    end_time: float
    n_steps: int
    dt: float
    stage: str
    n_points: int
    nodes: numpy.ndarray
    cells: numpy.ndarray

    def __init__(self, file: CaseFile, threads: int, mesh_of: Simulation | None, output: str, force: bool) -> None: ...
    def start(self) -> None: ...
    def step(self, n: int) -> None: ...
    def advance_to(self, time: float) -> None: ...
    def run_until(self, time: float) -> None: ...
    def field(self, name: str) -> numpy.ndarray: ...
    def set_field(self, name: str, values: numpy.ndarray) -> None: ...
    def blocks(self, name: str) -> list[numpy.ndarray]: ...
    def save(self) -> SavedState: ...
    def restore(self, state: SavedState) -> None: ...
    def finish(self) -> None: ...

def read_case(path: str, changes: list[str]) -> CaseFile: ...
def read_case_text(text: str, path: str, changes: list[str]) -> CaseFile: ...
