// A lever is a line of the table; the first sequence of a plan is the case as given. Sizes of cells are a lever, too:
// the case as given is solved on all of them, the others on the coarsest, which costs least.

#include "cli/what_decides.hpp"

#include "io/case/document.hpp"
#include "io/case/units.hpp"
#include "io/files/run_folder.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

struct Lever {
  const char* name;
  std::vector<const char*> keys;  ///< that change together, below a material where `of_soil`
  bool of_soil;
  Real less, more;   ///< factors
  Real least = 0.0;  ///< value that the key may have
};

/// Factors: how well a soil investigation usually knows the input (docs/convergence.md).
const Lever levers[] = {
    {"k0", {"initial.k0"}, false, 0.8, 1.25},
    {"k0 of soils", {"k0"}, true, 0.8, 1.25},
    {"S", {"su_peak.shansep.S"}, true, 0.85, 1.15},
    {"POP", {"su_peak.shansep.pop"}, true, 0.7, 1.3},
    {"S_u", {"su_peak", "su_residual", "su_remoulded", "su_active", "su_direct", "su_passive"}, true, 0.85, 1.15},
    {"sensitivity", {"sensitivity"}, true, 0.8, 1.25, 1.0},
    {"phi", {"friction_angle", "friction_angle_residual", "dilatancy_angle", "dilatancy_angle_residual"}, true, 0.9,
        1.1},
};

/// KEY=VALUE with the number at a path times a factor; empty: there is no number, or it would not change.
std::string scaled(const Node& root, const std::string& path, Real factor, Real least)
{
  const Node* node = find_node(root, path);
  if (node == nullptr) return "";
  const auto number = [&](Real value) { return std::max(least, value * factor); };
  if (node->kind == NodeKind::number || node->kind == NodeKind::integer) {
    const Real value = node->kind == NodeKind::integer ? static_cast<Real>(node->integer) : node->number;
    return number(value) == value ? "" : fmt::format("{}={:.6g}", path, number(value));
  }
  if (node->kind != NodeKind::text) return "";
  const auto quantity = parse_quantity(node->text);
  if (!quantity) return "";
  return fmt::format("{}=\"{:.6g} {}\"", path, factor * std::stod(quantity->number), quantity->name);
}

std::vector<std::string> changes_of(const Node& root, const Lever& lever, Real factor)
{
  std::vector<std::string> changes;
  const auto add = [&](const std::string& path) {
    std::string change = scaled(root, path, factor, lever.least);
    if (!change.empty()) changes.push_back(std::move(change));
  };
  const Node* soils = find_item(root, "material");
  for (const char* key : lever.keys)
    if (!lever.of_soil)
      add(key);
    else if (soils != nullptr && soils->kind == NodeKind::table)
      for (const Node& soil : soils->items) add(join_path("material", soil.name) + '.' + key);
  return changes;
}

}  // namespace

std::vector<StudySequence> sequences_that_may_decide(const ConvergeOptions& options)
{
  const CaseFile file = read_case(options.run.path, options.run.changes);
  const Node root = parse_toml(file.text);
  std::vector<StudySequence> sequences;
  for (const Lever& lever : levers) {
    if (lever.name[0] == 'k' && file.values.initial.stress == InitialStress::none) continue;  // it decides nothing
    for (const Real factor : {lever.less, lever.more})
      if (auto changes = changes_of(root, lever, factor); !changes.empty())
        sequences.push_back({fmt::format("{} x {:g}", lever.name, factor), std::move(changes), {}});
  }
  if (sequences.empty())
    throw CaseError(
        fmt::format("error: {}: --what-decides: the case has no number that could decide\n"
                    "  It looks for initial.k0, and for S, pop, su_peak, sensitivity and friction_angle of "
                    "the soils.\n",
            options.run.path));
  return sequences;
}

Decision decide(const Plan& plan)
{
  std::vector<SolvedInput> solved;
  for (const StudySequence& sequence : plan.sequences)
    for (const StudyRun& run : sequence.runs) {
      const bool given = &sequence == plan.sequences.data();
      const std::string name = given ? fmt::format("cells of {:g} m", run.cell) : sequence.name;
      solved.push_back({given ? "cells" : sequence.name.substr(0, sequence.name.rfind(" x ")), name,
          run.fault.empty() ? outcome_of_run(path_in(plan.folder, run.folder)) : "stops: " + run.fault, run.folder});
    }
  return decide(plan.case_name, solved);
}

}  // namespace terp
