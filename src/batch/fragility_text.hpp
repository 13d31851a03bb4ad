// A fragility curve for a terminal, as a table, and as D-Stability takes it.
#pragma once

#include "batch/fragility.hpp"

#include <string>
#include <vector>

namespace terp {

std::string fragility_text(const Study& study, const FragilityCurve& curve);

/// What to know before the curve is used.
std::vector<std::string> remarks_on_fragility(const Study& study, const FragilityCurve& curve);

/// fragility.csv: a line per level; numbers to the bit, nan or inf where there is no finite one.
std::string fragility_csv(const Study& study, const FragilityCurve& curve);

/// The load is a water level in m, as D-Stability has it.
bool is_water_level(const FragilityLoad& load);

/// A curve in the form in which D-Stability exports its own: reliability indices by water level, without influence
/// factors (Monte Carlo has none). Levels where nothing happened, or all, have no finite index and are left out.
std::string dstability_curve(const Study& study, const FragilityCurve& curve, bool of_flood);

/// The same curve as Continu Inzicht takes it: probability of failure by water level, never falling and at least
/// 1e-200; numbers of section, mechanism and measure are to be filled in. Levels without an estimate are left out.
std::string continu_inzicht_csv(const FragilityCurve& curve, bool of_flood);

}  // namespace terp
