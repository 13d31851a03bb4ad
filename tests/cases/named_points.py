"""What the history of the named points says, for tests of whole cases. (For people: `terp compare`.)"""

import numpy as np

from terp.pairs import POINTS_A_TO_F, POINTS_G_TO_J

SOFTENED_STRAIN = 0.06  # eps_eq_p at which 95 % of the strength drop is reached, paper Sec. 3 [-]
REGAINED = 1.0          # a rise of S_u above this counts as regained strength [Pa]


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
