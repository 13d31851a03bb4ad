"""Formulas of expected.toml, in the language of the program (docs/verification_cases.md), of numbers or numpy arrays.

They are evaluated as the program does: functions are those of the C library, number by number, since those of numpy
differ in the last bit; a small whole power of a name is a product. Not for: where a formula stands (expected).
"""

import difflib
import functools
import math
import re

import numpy as np


class FormulaError(ValueError):
    """The text is no formula, or names what is not there. The message says why, in a sentence."""


def did_you_mean(word, known):
    """A sentence with the nearest of the known words, after a space; empty: none is near."""
    close = difflib.get_close_matches(word, list(known), n=1)
    return f" Did you mean `{close[0]}`?" if close else ""


def _of_numbers(of_c, of_numpy):
    """A function of the C library for arrays. Where it has no value or no finite one, that of numpy: nan or inf."""
    def of_one(*x):
        try:
            return of_c(*x)
        except (ValueError, OverflowError):
            return of_numpy(*x)
    of_many = np.vectorize(of_one, otypes=[float])
    return lambda *x: of_many(*x)[()]


FUNCTIONS = {name: _of_numbers(getattr(math, name), getattr(np, name))
             for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log10")}
FUNCTIONS |= {name: _of_numbers(getattr(math, name), getattr(np, "arc" + name[1:]))
              for name in ("asin", "acos", "atan", "atan2")}
FUNCTIONS |= {
    "ln": _of_numbers(math.log, np.log), "erf": _of_numbers(math.erf, None), "erfc": _of_numbers(math.erfc, None),
    "sqrt": np.sqrt, "abs": np.abs, "sign": np.sign, "rint": lambda x: np.floor(x + 0.5),
    "mod": lambda a, b: a - b * np.floor(a / b),
    "step": lambda x: np.where(np.isnan(x), x, np.where(x < 0.0, 0.0, 1.0))[()],
    "min": lambda *x: functools.reduce(np.minimum, x), "max": lambda *x: functools.reduce(np.maximum, x),
    "sum": lambda *x: functools.reduce(np.add, x), "avg": lambda *x: functools.reduce(np.add, x) / len(x),
}
N_ARGUMENTS = {"atan2": 2, "mod": 2, "min": None, "max": None, "sum": None, "avg": None}  # None: one or more; else 1

_power = _of_numbers(math.pow, np.power)
OPERATORS = [  # by rank, each from left to right but for the power
    {"||": lambda a, b: ((a != 0) | (b != 0)) * 1.0},
    {"&&": lambda a, b: ((a != 0) & (b != 0)) * 1.0},
    {"<": lambda a, b: (a < b) * 1.0, "<=": lambda a, b: (a <= b) * 1.0, ">": lambda a, b: (a > b) * 1.0,
     ">=": lambda a, b: (a >= b) * 1.0, "==": lambda a, b: (a == b) * 1.0, "!=": lambda a, b: (a != b) * 1.0},
    {"+": np.add, "-": np.subtract},
    {"*": np.multiply, "/": np.divide},
]
TOKEN = re.compile(r"\s*((?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|[A-Za-z_]\w*|[<>=!]=|&&|\|\||\S)")


class _Parser:
    """Descends by rank. A node is a function of the dictionary of all values."""

    def __init__(self, text):
        self.tokens = [(match[1], match.start(1)) for match in TOKEN.finditer(text)]
        self.tokens.append(("", len(text)))
        self.k = 0
        self.names = {}  # as a set in the order of the text

    def whole(self):
        node = self.choice()
        if self.tokens[self.k][0]:
            self.refuse()
        return node

    def take(self, *words):
        """The next token if it is one of the words, else None."""
        if self.tokens[self.k][0] in words:
            self.k += 1
            return self.tokens[self.k - 1][0]
        return None

    def refuse(self):
        word, at = self.tokens[self.k]
        if word == "=":
            raise FormulaError(f"`=` at letter {at + 1} compares nothing. Compare with `==`, `<=`, `>=` or `!=`.")
        if word == ",":
            raise FormulaError(f"The comma at letter {at + 1} separates no arguments of a function. The decimal point "
                               "is `.`, as in 0.5.")
        raise FormulaError(f"`{word}` at letter {at + 1} stands where none may." if word else "The formula has no end.")

    def expect(self, word):
        if not self.take(word):
            self.refuse()

    def choice(self):
        condition = self.binary(0)
        if not self.take("?"):
            return condition
        yes = self.choice()
        self.expect(":")
        no = self.choice()
        return lambda v: np.where(condition(v) != 0, yes(v), no(v))[()]

    def binary(self, rank):
        if rank == len(OPERATORS):
            return self.signed()
        node = self.binary(rank + 1)
        while word := self.take(*OPERATORS[rank]):
            node = _joined(OPERATORS[rank][word], node, self.binary(rank + 1))
        return node

    def signed(self):
        if self.take("-"):
            node = self.signed()
            return lambda v: -node(v)
        return self.signed() if self.take("+") else self.power()

    def power(self):
        base, first = self.operand(), self.k - 1
        if not self.take("^"):
            return base
        is_name = self.tokens[first][0] in self.names
        exponent = self.signed()
        if is_name and self.k == first + 3 and self.tokens[self.k - 1][0] in ("2", "3", "4"):
            n = int(self.tokens[self.k - 1][0])
            return lambda v: functools.reduce(np.multiply, [base(v)] * n)
        return _joined(_power, base, exponent)

    def operand(self):
        if self.take("("):
            node = self.choice()
            self.expect(")")
            return node
        word = self.tokens[self.k][0]
        if word[:1].isdigit() or (word[:1] == "." and len(word) > 1):
            self.k += 1
            return lambda v, value=np.float64(word): value
        if not re.match(r"[A-Za-z_]", word):
            self.refuse()
        self.k += 1
        if word == "pi":
            return lambda v: np.float64(math.pi)
        if self.tokens[self.k][0] == "(":
            return self.call(word)
        self.names[word] = None
        return lambda v: v[word]

    def call(self, name):
        if name not in FUNCTIONS:
            raise FormulaError(f"There is no function `{name}`.{did_you_mean(name, FUNCTIONS)}")
        self.expect("(")
        arguments = [self.choice()]
        while self.take(","):
            arguments.append(self.choice())
        self.expect(")")
        n = N_ARGUMENTS.get(name, 1)
        if n is not None and len(arguments) != n:
            raise FormulaError(f"`{name}` takes {n} argument{'s' if n > 1 else ''}, got {len(arguments)}.")
        return lambda v: FUNCTIONS[name](*(argument(v) for argument in arguments))


def _joined(operator, left, right):
    return lambda v: operator(left(v), right(v))


@functools.lru_cache(maxsize=None)
def _parsed(text):
    parser = _Parser(text)
    node = parser.whole()
    return node, tuple(parser.names)


def evaluate(text, constants, variables=(), column=None):
    """Value of a formula: a number, or an array where a variable is one; nan where a name in it is nan.

    constants: {name: number}. variables: further names; column(name) gives the values of those in the text.
    """
    node, names = _parsed(text)
    for name in names:
        if name in constants and name in variables:
            raise FormulaError(f"`{name}` is a constant and the name of what stands here. Give the constant another "
                               "name.")
        if name not in constants and name not in variables:
            known = sorted({*constants, *variables})
            raise FormulaError(f"`{name}` is not known here.{did_you_mean(name, known)} Names: {', '.join(known)}")
    values = {name: np.float64(constants[name]) if name in constants else column(name) for name in names}
    with np.errstate(all="ignore"):
        result = node(values)
        unknown = functools.reduce(np.logical_or, [np.isnan(value) for value in values.values()], np.False_)
        return np.where(unknown, np.nan, result)[()]
