// Each change is looked at alone, at the quantiles that `terp study check` prints, so that a message names what it
// comes from. What the case says of it in text is asked of all; a model is made for the least and the greatest values
// of a list. A message counts as said if another one has its words, whatever its numbers: those differ between the
// quantiles.

#include "batch/study_warnings.hpp"

#include "batch/case_refusal.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "model/parts/setup.hpp"
#include "run/findings/setup_warnings.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <set>

namespace terp {
namespace {

/// Of the size of cells or the number of points, which a study takes coarse on purpose.
bool is_of_cells(const Problem& problem)
{
  return std::ranges::find(problem.others, "mesh.cell") != problem.others.end() ||
         problem.topic == "body.points_per_cell";
}

/// A change of the case that the study may make.
struct TriedCase {
  std::string path;   ///< in the study file
  std::string words;  ///< "`material.clay.density` = 19.9 (50 %)"
  std::vector<std::string> changes;
  bool is_set_up = true;  ///< else its text is read alone
};

class CaseWarnings {
 public:
  explicit CaseWarnings(const Study& study) : study_(study) {}

  bool is_news(const Problem& problem)
  {
    std::string words;
    for (const char c : problem.what + ' ' + problem.key)
      if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '`') words += c;
    return said_.insert(words).second;
  }
  void remember(const std::vector<Problem>& said)
  {
    for (const Problem& problem : said) is_news(problem), phrases_.insert(problem.what);
  }

  std::vector<Problem> of_model(const Case& c, const SharedMesh& mesh)
  {
    Model model = build_model(c, mesh, 1);
    level_ = model.flood_level.value;
    std::vector<Problem> warnings = find_warnings(model, build_state(model));
    std::erase_if(warnings, is_of_cells);
    return warnings;
  }

  void look_at(const TriedCase& tried, std::vector<Problem>& found)
  {
    try {
      const CaseFile file = read_case_text(study_.case_text, study_.case_path, changes_with(study_, tried.changes));
      std::vector<Problem> warnings = file.warnings;
      if (tried.is_set_up)
        std::ranges::move(
            of_model(file.values,
                study_.shares_mesh ? study_.mesh : std::make_shared<const Mesh<2>>(build_mesh(file.values))),
            std::back_inserter(warnings));
      if (tried.is_set_up) tried_levels_.emplace_back(tried.path, level_);
      for (const Problem& problem : warnings)
        if (!phrases_.contains(problem.what) && is_news(problem))
          found.push_back({tried.path, fmt::format("with {}: {}", tried.words, problem.what), problem.detail, ""});
    } catch (const CaseError&) {  // what a draw is refused for is reported elsewhere
    } catch (const InputError&) {
    } catch (const RunError&) {
    }
  }

  /// A load whose formulas move a phreatic line, and the heads of the layers stay where they are.
  void find_still_heads(std::vector<Problem>& found) const
  {
    const auto& load = study_.settings.fragility;
    const auto& situations = study_.base.values.water.situations;
    for (std::size_t k = 0; load && k < situations.size(); ++k) {
      const std::string path = fmt::format("water.situation[{}].", k);
      const auto sets = [&](const char* key) {
        return std::ranges::any_of(load->set, [&](const auto& entry) { return entry.first.starts_with(path + key); });
      };
      if (situations[k].head_lines.empty() || !sets("phreatic_line") || sets("head_lines")) continue;
      found.push_back({"fragility.set", "the river follows the load, and the heads of the layers do not",
          fmt::format(
              "`{}phreatic_line` is a formula of h, and `{}head_lines` stays as in the case. Give it, too, or leave it "
              "if\nthe layers do not feel the river.",
              path, path),
          ""});
    }
  }

  /// A load whose formulas move the water, and the river stays where it is.
  void find_still_river(std::vector<Problem>& found) const
  {
    const auto& load = study_.settings.fragility;
    const auto of_water = [](const auto& key_value) { return key_value.first.starts_with("water."); };
    if (!load || !study_.base.values.flood.asks() || std::ranges::none_of(load->set, of_water)) return;
    std::vector<Real> levels;
    for (const auto& [path, level] : tried_levels_)
      if (path.starts_with("fragility.")) levels.push_back(level);
    if (levels.size() < 2 || levels.front() != levels.back()) return;
    found.push_back({"fragility.set", "the river stands at one level, whatever the load",
        fmt::format(
            "It is {:.4g} m at the first level and at the last one. Let the river's end of the phreatic line be "
            "a formula of h.",
            levels.front()),
        ""});
  }

 private:
  const Study& study_;
  std::set<std::string> said_, phrases_;
  Real level_ = 0.0;  ///< of the water of [flood] in the last model [m]
  std::vector<std::pair<std::string, Real>> tried_levels_;
};

std::vector<TriedCase> cases_to_try(const Study& study)
{
  const StudySettings& s = study.settings;
  std::vector<TriedCase> tried;
  for (const RandomNumber& number : s.numbers)
    for (const Real p : {0.5, 0.05, 0.95}) {
      const std::string value = fmt::format("{:.6g}", number.distribution.quantile(p));
      if (!number.is_name)
        tried.push_back({join_path(number.path, "key"), fmt::format("`{}` = {} ({:g} %)", number.key, value, 100.0 * p),
            {number.key + '=' + value}});
    }
  for (const SweepKey& sweep : s.sweep)
    for (std::size_t k = 0; k < sweep.values.size(); ++k)
      tried.push_back({fmt::format("{}[{}]", join_path(sweep.path, "values"), k),
          fmt::format("`{}` = {}", sweep.key, toml_value(sweep.values[k])),
          {sweep.key + '=' + toml_value(sweep.values[k])}, k == 0 || k + 1 == sweep.values.size()});
  for (std::size_t k = 0; s.fragility && k < s.fragility->levels.size(); ++k)
    tried.push_back({fmt::format("fragility.levels[{}]", k), fmt::format("h = {:g}", s.fragility->levels[k]),
        s.fragility->changes_at(s.fragility->levels[k]), k == 0 || k + 1 == s.fragility->levels.size()});
  if (!s.fields.empty())
    for (std::string& change : draw_changes(study, 0).changes)
      for (const RandomFieldKey& field : s.fields)
        if (change.starts_with(field.key + "={ random"))
          tried.push_back({join_path(field.path, "key"), fmt::format("the field of `{}`", field.key), {change}});
  return tried;
}

}  // namespace

WarningsOfCases find_warnings_of_cases(const Study& study, const std::vector<Problem>& doubts)
{
  CaseWarnings warnings(study);
  WarningsOfCases found;
  warnings.remember(doubts);
  warnings.remember(study.base.warnings);
  try {
    found.base = warnings.of_model(study.base.values, study.mesh);
  } catch (const RunError&) {  // a case that stops itself says so in its check
  }
  warnings.remember(found.base);
  if (study.coarse) {
    std::vector<Problem> coarse = study.coarse->base.warnings;
    std::ranges::move(warnings.of_model(study.coarse->base.values, study.coarse->mesh), std::back_inserter(coarse));
    for (const Problem& problem : coarse)
      if (!problem.key.starts_with("--set") && warnings.is_news(problem))  // `coarse` follows `set`
        found.drawn.push_back({"estimator.coarse", "the coarse case: " + problem.what, problem.detail, ""});
  }
  for (const TriedCase& tried : cases_to_try(study)) warnings.look_at(tried, found.drawn);
  warnings.find_still_river(found.drawn);
  warnings.find_still_heads(found.drawn);
  return found;
}

}  // namespace terp
