// How it thinks: every random number is counted, not drawn in turn (math/philox.hpp). The counter is (sample,
// number of the variable, stream, 0), the key the seed; fields count in the case (model/soils/gaussian_field).

#include "batch/study.hpp"

#include "math/philox.hpp"
#include "io/case/overrides.hpp"
#include "io/case/random_kind.hpp"
#include "model/soils/gaussian_field.hpp"
#include "batch/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace terp {
namespace {

Real uniform_of(const Study& study, std::size_t number, Index sample)
{
  if (!study.points.empty()) return study.points[number][static_cast<std::size_t>(sample)];
  return philox_uniform({static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(number), stream_of_values, 0},
      {static_cast<std::uint32_t>(study.settings.seed), 0});
}

std::vector<Real> draw_scores(const Study& study, Index sample)
{
  std::vector<Real> scores(study.settings.numbers.size());
  for (std::size_t k = 0; k < scores.size(); ++k) scores[k] = normal_quantile(uniform_of(study, k, sample));
  return scores;
}

/// Gaussian copula: the scores are correlated, each number keeps its own distribution.
std::vector<Real> numbers_of(const Study& study, const std::vector<Real>& independent)
{
  const StudySettings& s = study.settings;
  const std::size_t n = s.numbers.size();
  std::vector<Real> values(n);
  const std::vector<Real> scores = times(study.of_numbers, independent);
  constexpr Real least = 1e-16;
  for (std::size_t k = 0; k < n; ++k)
    values[k] = s.numbers[k].distribution.quantile(std::clamp(normal_probability(scores[k]), least, 1.0 - least));
  return values;
}

/// Twelve digits: what libraries of other machines give differs beyond them.
void add_numbers(const Study& study, const std::vector<Real>& values, Draw& draw)
{
  std::vector<Real> rounded;
  for (const Real value : values) rounded.push_back(std::stod(fmt::format("{:.12g}", value)));
  std::ranges::move(study.settings.changes_at(rounded), std::back_inserter(draw.changes));
  draw.held = study.settings.held_changes_at(rounded);
  draw.inputs.insert(draw.inputs.end(), rounded.begin(), rounded.end());
}

/// Which combination of a sweep a realisation is: the last key turns fastest.
std::vector<std::size_t> sweep_choice(const StudySettings& s, Index realisation)
{
  std::vector<std::size_t> choice(s.sweep.size(), static_cast<std::size_t>(realisation));
  if (s.form == SweepForm::table) return choice;
  auto rest = static_cast<std::size_t>(realisation);
  for (std::size_t k = s.sweep.size(); k-- > 0;) {
    choice[k] = rest % s.sweep[k].values.size();
    rest /= s.sweep[k].values.size();
  }
  return choice;
}

std::string pair_text(Vec<2> x) { return fmt::format("[{}, {}]", x[0], x[1]); }

/// "field = 2", or the fields that a correlated one is the sum of.
std::string parts_text(const Study& study, std::size_t number)
{
  std::string parts;
  int n = 0;
  for (std::size_t k = 0; k <= number; ++k)
    if (const Real weight = study.of_fields.at(number, k); weight != 0.0) {
      parts += fmt::format("{}[{}, {}]", parts.empty() ? "" : ", ", k, weight);
      ++n;
    }
  return n == 1 ? fmt::format("field = {}", number) : fmt::format("mix = [{}]", parts);
}

/// mean: TOML.
std::string field_text(const Study& study, std::size_t number, Index sample, const std::string& mean)
{
  const RandomFieldKey& f = study.settings.fields[number];
  const auto& box = study.boxes[number];
  return fmt::format(
      "{{ random = {{ mean = {}, cov = {}, theta = {}, box = [{}, {}], distribution = \"{}\", seed = {}, realisation "
      "= {}, {}{}{} }} }}",
      mean, f.cov, pair_text(f.scale), pair_text(box[0]), pair_text(box[1]), f.distribution, study.settings.seed,
      sample, parts_text(study, number),
      f.correlation == random_correlations().front() ? "" : fmt::format(", correlation = \"{}\"", f.correlation),
      f.known.empty() ? "" : ", known = " + f.known);
}

/// The field as the case reads it, with what soundings know of it.
RandomField read_field_of(const Study& study, std::size_t number, Index sample)
{
  const RandomFieldKey& f = study.settings.fields[number];
  const Node* own = find_node(study.base.source.root, f.key);
  const std::string mean = f.known.empty()   ? "1.0"  // of no say in the field over its trend
                           : !f.mean.empty() ? f.mean
                           : own != nullptr  ? toml_value(*own)
                                             : std::string("1.0");
  const Node root = parse_toml("field = " + field_text(study, number, sample, mean));
  KeyInfo key;
  key.path = f.key, key.unit = unit_at(f.key);
  key.field = [](Case& c, std::size_t) -> Field { return &c.at_strength; };  // a number
  Findings findings;
  FieldNeeds needs;
  const Node& field = root.items.front();
  const auto random =
      read_random_field(field.items.front(), {{field, f.key, key}, study.base.values.folder, findings, needs});
  if (!random) throw InputError(findings.problems);
  return *random;
}

/// Mean over the box of the field over its trend, in n x n places.
Real mean_of_field(const Study& study, std::size_t number, Index sample)
{
  const FieldOverTrend field(study, number, sample);
  const auto& [low, high] = study.boxes[number];
  constexpr int n = 40;
  Real sum = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      sum += field.at({low[0] + (i + 0.5) / n * (high[0] - low[0]), low[1] + (j + 0.5) / n * (high[1] - low[1])});
  return sum / (n * n);
}

}  // namespace

FieldOverTrend::FieldOverTrend(const Study& study, std::size_t field, Index sample)
    : FieldOverTrend(read_field_of(study, field, sample))
{
}

FieldOverTrend::FieldOverTrend(const RandomField& random)
    : marginal_(random.marginal), cov_(random.cov), field_(random.field)
{
}

Draw draw_at(const Study& study, const std::vector<Real>& scores)
{
  Draw draw{.changes = study.settings.set};
  add_numbers(study, numbers_of(study, scores), draw);
  return draw;
}

Draw draw_again(const Study& study, Index realisation, const std::vector<Real>& inputs)
{
  if (!info_of(study.settings.estimator).adaptive) return draw_realisation(study, realisation);
  Draw draw{.changes = study.settings.set};
  add_numbers(study, inputs, draw);
  return draw;
}

Draw draw_changes(const Study& study, Index realisation)
{
  const StudySettings& s = study.settings;
  Draw draw{.changes = s.set};
  if (study.is_coarse(realisation))
    draw.changes.insert(draw.changes.end(), s.multilevel.coarse.begin(), s.multilevel.coarse.end());
  const auto choice = sweep_choice(s, realisation);
  for (std::size_t k = 0; k < s.sweep.size(); ++k) {
    const Node& value = s.sweep[k].values[choice[k]];
    draw.changes.push_back(s.sweep[k].key + "=" + toml_value(value));
    draw.inputs.push_back(!s.sweep[k].is_of_numbers()       ? static_cast<Real>(choice[k])
                          : value.kind == NodeKind::integer ? static_cast<Real>(value.integer)
                                                            : value.number);
  }
  const Index sample = study.sample_of(realisation);
  if (s.fragility) {
    const Real level = s.fragility->levels[study.level_of(realisation)];
    for (std::string& change : s.fragility->changes_at(level)) draw.changes.push_back(std::move(change));
    draw.inputs.push_back(level);
  }
  add_numbers(study, numbers_of(study, draw_scores(study, sample)), draw);
  if (s.fields.empty()) return draw;
  Node root = study.base.source.root;
  for (const std::string& change : draw.changes) apply_override(root, change);
  for (std::size_t k = 0; k < s.fields.size(); ++k) {
    const RandomFieldKey& f = s.fields[k];
    const Node* own = find_node(root, f.key);
    const std::string mean = !f.mean.empty() ? f.mean : own != nullptr ? toml_value(*own) : std::string("0.0");
    draw.changes.push_back(f.key + "=" + field_text(study, k, sample, mean));
  }
  return draw;
}

Draw draw_realisation(const Study& study, Index realisation)
{
  Draw draw = draw_changes(study, realisation);
  for (std::size_t k = 0; k < study.settings.fields.size(); ++k)
    draw.inputs.push_back(mean_of_field(study, k, study.sample_of(realisation)));
  return draw;
}

CaseFile case_of(const Study& study, const Draw& draw)
{
  return read_case_text(study.case_text, study.case_path, draw.changes);
}

std::vector<std::string> held_changes(const Draw& draw)
{
  std::vector<std::string> changes = draw.changes;
  changes.insert(changes.end(), draw.held.begin(), draw.held.end());
  return changes;
}

std::string input_text(const Study& study, std::size_t number, Real value)
{
  const auto& sweep = study.settings.sweep;
  if (number < sweep.size() && !sweep[number].is_of_numbers()) {
    const Node& item = sweep[number].values[static_cast<std::size_t>(value)];
    return item.kind == NodeKind::text ? item.text : toml_value(item);
  }
  return number < sweep.size() ? fmt::format("{}", value) : fmt::format("{:.6g}", value);
}

}  // namespace terp
