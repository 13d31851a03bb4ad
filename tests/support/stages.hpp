// Cases with stages, and what their states have in common.
#pragma once

#include "model/case/case.hpp"
#include "run/loop/state.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace terp::test {

using Change = std::function<void(Case&)>;

/// The case with stages, each with what it changes.
Case staged(const Case& base, const std::vector<std::pair<StageCase, Change>>& stages);

StageCase stage(const std::string& name, Real duration);
StageCase ramped(const std::string& name, Real duration, Real ramp);
StageCase resting(const std::string& name, Real at_most);

/// Elastic soil between smooth walls, 4 m x 1 m, that gravity compresses; cells of 0.25 m.
Case settling();

/// Mean of sigma_yy over the lowest points [Pa].
Real stress_at_base(const State& state);

}  // namespace terp::test
