// The first sequence of a plan is the case as given. Sizes of cells are an input, too: the case as given is solved on
// all of them, the others on the coarsest, which costs least. What is not possible is named and stops nothing.

#include "cli/what_decides.hpp"

#include "cli/strength_levers.hpp"
#include "io/case/case_file.hpp"
#include "io/case/document.hpp"
#include "io/case/printable.hpp"
#include "io/files/run_folder.hpp"
#include "model/parts/initial.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

/// Soil in all of which k0 is this already, given or by default.
bool begins_with(const Case& c, Real k0)
{
  const auto follows_from_the_law = [](const MaterialCase& m) {  // k0_at
    const MaterialType* law = find_material(m.model);
    return law != nullptr &&
           std::ranges::find(law->parameters, "yield_stress", &ParameterInfo::name) != law->parameters.end();
  };
  const auto has_it = [&](const MaterialCase& m) {
    if (!std::isnan(m.k0)) return m.k0 == k0;
    return std::isnan(c.initial.k0) ? k0 == 1.0 && !follows_from_the_law(m) : c.initial.k0 == k0;
  };
  return std::ranges::all_of(c.materials, has_it);
}

void add_k0_keys(const Node& table, const std::string& path, Real k0, std::vector<std::string>& changes)
{
  if (table.kind != NodeKind::table) return;
  for (const Node& item : table.items)
    if (item.name == "k0")
      changes.push_back(fmt::format("{}={:g}", join_path(path, item.name), k0));
    else
      add_k0_keys(item, join_path(path, item.name), k0, changes);
}

void add_k0(const Node& root, const Case& c, Levers& levers)
{
  if (!begins_with_k0(c)) return levers.not_varied.push_back("k0 (the soil does not begin with it)");
  for (const Real k0 : {0.5, 1.0}) {
    if (begins_with(c, k0)) continue;
    std::vector<std::string> changes{fmt::format("initial.k0={:g}", k0)};
    if (const Node* soils = find_item(root, "material")) add_k0_keys(*soils, "material", k0, changes);
    levers.sequences.push_back({fmt::format("k0 = {:g}", k0), std::move(changes), {}, "k0"});
  }
}

}  // namespace

std::string first_line_of(const std::string& error)
{
  std::string line = error.substr(0, error.find('\n'));
  if (const std::size_t at = line.find("error: "); at != std::string::npos) line = line.substr(at + 7);
  return line;
}

Levers levers_of(const ConvergeOptions& options)
{
  const CaseFile file = read_case(options.run.path, options.run.changes);
  const Node root = parse_toml(file.text);
  Levers levers;
  add_k0(root, file.values, levers);
  for (const StrengthLever& lever : strength_levers())
    for (const Real factor : {lever.less, lever.more}) {
      ScaledStrength scaled = scale_strength(root, lever, factor);
      for (std::string& key : scaled.left)
        if (std::ranges::find(levers.not_varied, key) == levers.not_varied.end())
          levers.not_varied.push_back(std::move(key));
      if (!scaled.changes.empty())
        levers.sequences.push_back(
            {fmt::format("{} x {:g}", lever.name, factor), std::move(scaled.changes), {}, lever.name});
    }
  for (std::string& key : strengths_without_lever(root)) levers.not_varied.push_back(std::move(key));
  return levers;
}

void refuse_if_nothing_decides(const ConvergeOptions& options, const Plan& plan)
{
  if (!options.what_decides || plan.sequences.size() > 1) return;
  throw CaseError(
      printable(fmt::format("error: {}: --what-decides: the case has no number that could decide\n"
                            "  It looks for k0 and for strengths of the soils. Not varied: {}.\n",
          options.run.path, fmt::join(plan.not_varied, "; "))));
}

Decision decide(const Plan& plan)
{
  std::vector<SolvedInput> solved;
  for (const StudySequence& sequence : plan.sequences)
    for (const StudyRun& run : sequence.runs) {
      const bool given = &sequence == plan.sequences.data();
      const std::string name = given ? fmt::format("cells of {:g} m", run.cell) : sequence.name;
      solved.push_back({given                    ? "cells"
                        : sequence.input.empty() ? sequence.name
                                                 : sequence.input,
          name, run.fault.empty() ? outcome_of_run(path_in(plan.folder, run.folder)) : "stops: " + run.fault,
          run.folder});
    }
  return decide(plan.case_name, solved, plan.not_varied);
}

}  // namespace terp
