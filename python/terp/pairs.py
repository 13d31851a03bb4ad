"""The runs that belong together: the same case solved with MPM-Mixed and with MPM-GP.

Also what their case says about the paper's column: which model it is, the norm of the total strain, the strengths.
"""

import dataclasses

from terp.errors import RunError
from terp.run import Run

POINTS_A_TO_F = "ABCDEF"
POINTS_G_TO_J = "GHIJ"

SCHEME_TITLES = {"mpm_mixed": "MPM-Mixed", "mpm_gp": "MPM-GP", "standard_mpm": "standard MPM"}


@dataclasses.dataclass(frozen=True)
class Pair:
    """One case, solved with both schemes."""

    mixed: Run
    gp: Run
    model: int  # 1: no softening, 2: softening

    @property
    def runs(self):
        return (self.mixed, self.gp)


def read_pairs(folders):
    """Folders in the order mixed, gp (, mixed, gp) as a list of pairs, model 1 first."""
    if len(folders) not in (2, 4):
        raise RunError(f"give two run folders (RUN_MIXED RUN_GP) or four, not {len(folders)}")
    pairs = [read_pair(*folders[k:k + 2]) for k in range(0, len(folders), 2)]
    if len({pair.model for pair in pairs}) < len(pairs):
        raise RunError(f"both pairs are model {pairs[0].model}; give one pair of model 1 and one of model 2")
    return sorted(pairs, key=lambda pair: pair.model)


def read_pair(mixed_folder, gp_folder):
    mixed, gp = Run(mixed_folder), Run(gp_folder)
    _require_schemes(mixed, gp)
    models = [model_of(run) for run in (mixed, gp)]
    if models[0] != models[1]:
        raise RunError(f"{mixed.folder} is model {models[0]}, but {gp.folder} is model {models[1]}; "
                       "a pair is one case solved with both schemes")
    return Pair(mixed, gp, models[0])


def _require_schemes(mixed, gp):
    schemes = [run.summary.get("scheme") for run in (mixed, gp)]
    if schemes == ["mpm_mixed", "mpm_gp"]:
        return
    if schemes == ["mpm_gp", "mpm_mixed"]:
        raise RunError(f"the two runs are swapped: {mixed.folder} was solved with mpm_gp and {gp.folder} with "
                       "mpm_mixed; give RUN_MIXED first")
    wrong, scheme, expected = ((mixed, schemes[0], "mpm_mixed") if schemes[0] != "mpm_mixed"
                               else (gp, schemes[1], "mpm_gp"))
    raise RunError(f"{wrong.folder} was solved with {scheme}, but {expected} is needed here: "
                   "give RUN_MIXED first, then RUN_GP")


def model_of(run):
    """1 if the residual strength equals the peak strength (no softening), else 2."""
    peak, residual = strengths(run)
    return 1 if residual == peak else 2


def strengths(run):
    """S_u,p and S_u,r of the first material that has them [Pa]."""
    for material in run.case.get("material", {}).values():
        if "su_peak" in material and "su_residual" in material:
            return float(material["su_peak"]), float(material["su_residual"])
    raise RunError(f"the case of {run.folder} has no material with su_peak and su_residual")
