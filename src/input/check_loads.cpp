#include "input/check_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

void check_times(const LoadCase& load, const std::string& path, Real end_of_run, Findings& findings)
{
  const bool ends = std::isfinite(load.end);
  if (load.ramp > 0.0 && std::isinf(load.start) && !ends)
    findings.problems.push_back({path + ".ramp", "a load that was always there does not grow",
        "Give `start`, the time from which on it grows, or leave `ramp` out.", "load.ramp", true});
  if (std::isfinite(load.start) && ends && load.end < load.start + load.ramp)
    findings.problems.push_back({path + ".end", fmt::format("the load `{}` ends before it is there in full", load.name),
        fmt::format("Got end = {:g} s; allowed: at least start + ramp = {:g} s.", load.end, load.start + load.ramp),
        "load.end", false, {path + ".start", path + ".ramp"}});
  if (std::isfinite(load.start) && end_of_run > 0.0 && load.start >= end_of_run)
    findings.warnings.push_back({path + ".start", fmt::format("the load `{}` is never put on", load.name),
        fmt::format("It begins at {:g} s, the run ends at {:g} s.", load.start, end_of_run), "load.start", false,
        {"time.end"}});
}

}  // namespace

void check_loads(const Node& root, const Case& values, Findings& findings)
{
  const std::vector<LoadCase>& loads = values.loads;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const std::string path = fmt::format("load[{}]", k);
    const auto has = [&](const char* key) { return find_node(root, path + '.' + key) != nullptr; };
    if (has("from") && has("to") && !(loads[k].to > loads[k].from))
      findings.problems.push_back({path + ".to", fmt::format("the load `{}` has no width", loads[k].name),
          fmt::format("Got from = {:g} m, to = {:g} m; `to` is the right end.", loads[k].from, loads[k].to), "load.to",
          false, {path + ".from"}});
    const auto same_name = [&](const LoadCase& other) { return other.name == loads[k].name; };
    if (std::any_of(loads.begin(), loads.begin() + static_cast<std::ptrdiff_t>(k), same_name))
      findings.problems.push_back({path + ".name", fmt::format("two loads have the name `{}`", loads[k].name),
          "Give each its own, as in name = \"traffic\".", "load.name", false, {path}});
    check_times(loads[k], path, values.time.end, findings);
  }
}

}  // namespace terp
