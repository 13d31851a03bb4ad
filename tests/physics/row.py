"""What a row of the table is, which variants of it are solved, and how a number is judged."""
import itertools
import math
import random
from dataclasses import dataclass, field

import meshes

BASE = {"scheme": ("gp", "mixed"), "points": (2, 3, 4), "shares": ("overlap", "point"), "kind": meshes.KINDS}
ROWS = {}


@dataclass
class Row:
    """solve(variant) gives the measures. Without a `number` the whole product of BASE and `cross` is solved, each with
    one value of the factors in `cycle`, in turn. With it so many variants are, as a Latin square has them: each value
    of each factor comes equally often. `base` replaces factors of BASE that the row does not have in full.
    """
    name: str
    solve: callable
    number: int = 0
    cross: dict = field(default_factory=dict)
    cycle: dict = field(default_factory=dict)
    base: dict = field(default_factory=dict)

    def variants(self, seed):
        """Factors of each variant."""
        shuffle = random.Random(f"{seed}/{self.name}")
        factors = BASE | self.base | self.cross
        if self.number:
            chosen, turning = [{} for _ in range(self.number)], factors | self.cycle
        else:
            chosen = [dict(zip(factors, values)) for values in itertools.product(*factors.values())]
            turning = self.cycle
        for name, values in turning.items():
            turns = list(values) * math.ceil(len(chosen) / len(values))
            turns = turns[:len(chosen)]
            shuffle.shuffle(turns)
            for factors_of_one, value in zip(chosen, turns):
                factors_of_one[name] = value
        return chosen


def row(**options):
    """Enters a function into the table under its own name."""
    def enter(solve):
        ROWS[solve.__name__] = Row(solve.__name__, solve, **options)
        return solve
    return enter


@dataclass
class Measure:
    """A number and its bounds. Without bounds it is printed and not judged."""
    name: str
    value: float
    unit: str = ""
    at_most: float = math.inf
    at_least: float = -math.inf

    def passes(self):
        return not self.judged() or self.at_least <= self.value <= self.at_most

    def judged(self):
        return self.at_most < math.inf or self.at_least > -math.inf

    def excess(self, size, margin):
        """Whether the value lies farther beyond its bound than `size`, known from before, by more than `margin`."""
        if self.value > self.at_most:
            return self.value > size + margin * abs(size)
        return self.value < size - margin * abs(size) or math.isnan(self.value)

    def __str__(self):
        bounds = [f"{self.at_least:.4g} <="] if self.at_least > -math.inf and self.at_least != self.at_most else []
        bounds = " ".join(bounds + [f"{self.name} {self.value:.4g}"])
        if self.at_least == self.at_most:
            bounds += f" = {self.at_most:.4g}"
        elif self.at_most < math.inf:
            bounds += f" <= {self.at_most:.4g}"
        return f"{bounds} {self.unit}".strip()
