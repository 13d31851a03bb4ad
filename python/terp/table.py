"""The two schemes side by side, in plain text.

    python3 -m terp.table RUN_MIXED RUN_GP
    python3 -m terp.table MIXED_1 GP_1 MIXED_2 GP_2

Exit status: 0 printed, 2 a run is missing or does not fit.
"""

import sys

import numpy as np

from terp.command import exit_status, runs_parser
from terp.pairs import POINTS_A_TO_F, POINTS_G_TO_J, SCHEME_TITLES, read_pairs

SOFTENED_STRAIN = 0.06  # eps_eq_p at which 95 % of the strength drop is reached, paper Sec. 3 [-]
REGAINED = 1.0          # a rise of S_u above this counts as regained strength [Pa]
NONE = "-"


def table_of(pair):
    """The table as text, without a line break at its end."""
    blocks = [end_rows(pair), softened_rows(pair), softening_time_rows(pair), audit_rows(pair), cost_rows(pair)]
    head = (pair.gp.case.get("title", f"model {pair.model}"), SCHEME_TITLES["mpm_mixed"], SCHEME_TITLES["mpm_gp"])
    rows = [head] + [row for block in blocks for row in block]
    widths = [max(len(row[k]) for row in rows) for k in range(3)]
    rule = "-" * (sum(widths) + 6)
    lines = [_line(head, widths), rule]
    for block in blocks:
        lines += [_line(row, widths) for row in block] + ([rule] if block else [])
    return "\n".join(lines)


def end_rows(pair):
    """Where the soil ended and when it failed again."""
    return [
        _summary_row(pair, "time at the end [s]", _end_time, "{:.3f}"),
        _summary_row(pair, "front at the end [m]", "front_x", "{:.2f}"),
        _summary_row(pair, "crest at the end [m]", "crest_x", "{:.2f}"),
        _summary_row(pair, "second failure [s]", "second_failure_time", "{:.2f}"),
        _summary_row(pair, "largest eps_eq_p at the end [-]", "max_eps_eq_p", "{:.2f}"),
    ]


def softened_rows(pair):
    """Share of the volume with S_u below half its peak, at the output times of either run."""
    shares = [{round(row["time"], 3): row["fraction"] for row in run.summary.get("softened_fraction", [])}
              for run in pair.runs]
    return [(f"softened volume at {time:g} s [%]", *(_text(share.get(time), "{:.1f}", 100) for share in shares))
            for time in sorted(set(shares[0]) | set(shares[1])) if time > 0]


def softening_time_rows(pair):
    """When each named point has lost 95 % of its strength drop."""
    names = [name for name in POINTS_A_TO_F + POINTS_G_TO_J
             if any(name in run.history_points for run in pair.runs)]
    return [(f"{name}: eps_eq_p > {SOFTENED_STRAIN:g} from [s]",
             *(_text(softening_time(run, name), "{:.2f}") for run in pair.runs)) for name in names]


def audit_rows(pair):
    """What an exact history forbids, and how well the sums close."""
    return [
        _summary_row(pair, "points whose eps_eq_p ever fell", "points_eps_eq_p_fell", "{:d}"),
        _summary_row(pair, "points whose S_u ever rose", "points_su_rose", "{:d}"),
        ("of A-J, regained S_u", *(" ".join(regained(run)) or "none" for run in pair.runs)),
        _summary_row(pair, "points put back at a wall", "clamped_points", "{:d}"),
        _summary_row(pair, "energy balance error [-]", "energy_balance_error", "{:.1e}"),
        _summary_row(pair, "speed, 99.9 % quantile [m/s]", "v_999", "{:.2f}"),
    ]


def cost_rows(pair):
    """What the run took."""
    return [
        _summary_row(pair, "material points", "points", "{:d}"),
        _summary_row(pair, "steps", "steps", "{:d}"),
        _summary_row(pair, "threads", "threads", "{:d}"),
        _summary_row(pair, "million point-steps per second",
                     lambda run: _scaled(run, "point_steps_per_s", 1e-6), "{:.2f}"),
        _summary_row(pair, "wall time [s]", "wall_s", "{:.1f}"),
    ]


def softening_time(run, name):
    """First time at which eps_eq_p of a named point exceeds 0.06 [s]; None if never or if it is not recorded."""
    if name not in run.history_points:
        return None
    rows = run.history_of(name)
    beyond = np.flatnonzero(rows["eps_eq_p"] > SOFTENED_STRAIN)
    return float(rows["time"][beyond[0]]) if len(beyond) else None


def regained(run):
    """Names among A-J whose S_u rose by more than 1 Pa between two rows of history.csv."""
    names = [name for name in POINTS_A_TO_F + POINTS_G_TO_J if name in run.history_points]
    return [name for name in names if np.any(np.diff(run.history_of(name)["su"]) > REGAINED)]


def _end_time(run):
    return float(run.history["time"].max()) if len(run.history) else None


def _scaled(run, key, factor):
    value = run.summary.get(key)
    return None if value is None else factor * value


def _summary_row(pair, label, key, form):
    """One row: `key` names an entry of summary.json, or is a function of the run."""
    values = [key(run) if callable(key) else run.summary.get(key) for run in pair.runs]
    return (label, *(_text(value, form) for value in values))


def _text(value, form, factor=1):
    return NONE if value is None or value != value else form.format(factor * value)


def _line(row, widths):
    return f"{row[0]:<{widths[0]}}   {row[1]:>{widths[1]}}   {row[2]:>{widths[2]}}"


def main(arguments=None):
    options = runs_parser("python3 -m terp.table", "Set MPM-Mixed and MPM-GP side by side.").parse_args(arguments)
    return exit_status(lambda: print("\n\n".join(table_of(pair) for pair in read_pairs(options.runs))))


if __name__ == "__main__":
    sys.exit(main())
