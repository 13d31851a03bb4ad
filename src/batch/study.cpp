// Checks come in the order in which they rely on each other; after each step refuse_if_any ends it. The case is asked
// for each number alone, at its median and in its tails: several together that it refuses are a failed realisation. A
// key that changes_mesh does not know leaves all realisations on one mesh.

#include "batch/study.hpp"

#include "math/checksum.hpp"
#include "io/case/random_kind.hpp"
#include "mpm/mesh/box_grid.hpp"
#include "io/files/files.hpp"
#include "model/bodies/polygon.hpp"
#include "model/parts/setup.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "run/findings/field_warnings.hpp"
#include "run/stability/factor_of_safety.hpp"
#include "batch/case_refusal.hpp"
#include "batch/idle_sweep.hpp"
#include "batch/multilevel.hpp"
#include "batch/odd_distributions.hpp"
#include "batch/points.hpp"
#include "batch/reliability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace terp {
namespace {

constexpr Index most_realisations = 10'000'000;

/// The case must take what each number may be, alone: its median, and its tails. Others that keys follow with it are at
/// their medians.
void check_numbers(const Study& study, std::vector<Problem>& problems)
{
  const StudySettings& s = study.settings;
  const std::vector<Real> medians = s.quantiles(0.5);
  for (std::size_t k = 0; k < s.numbers.size(); ++k) {
    const RandomNumber& number = s.numbers[k];
    const auto refusal = [&](Real p) {
      const Real value = number.distribution.quantile(p);
      if (!number.is_name)
        return refusal_of(study, changes_with(study, {fmt::format("{}={:.12g}", number.key, value)}));
      std::vector<Real> values = s.named_values(medians);
      const std::vector<std::string> names = s.names();
      values[static_cast<std::size_t>(std::ranges::find(names, number.key) - names.begin())] = value;
      return refusal_of(study, changes_with(study, changes_with_numbers(s.follow, names, values)));
    };
    if (const std::string why = refusal(0.5); !why.empty()) {
      problems.push_back({join_path(number.path, number.is_name ? "name" : "key"),
          fmt::format("the case does not take `{}`", number.key), why, ""});
      continue;
    }
    const Real tail = std::clamp(0.1 / static_cast<Real>(study.n_realisations), 1e-9, 1e-3);
    for (const Real p : {tail, 1.0 - tail})
      if (const std::string why = refusal(p); !why.empty()) {
        problems.push_back({number.path, fmt::format("`{}` is drawn where the case refuses it", number.key),
            fmt::format("With probability {:.2g} it is {} {:.4g}. {}. What the case says:\n{}", tail,
                p < 0.5 ? "at most" : "at least", number.distribution.quantile(p),
                number.distribution.kind == DistributionKind::lognormal
                    ? "Give a smaller `cov`, or correct what it contradicts"
                    : "Give a distribution without such values: lognormal, or truncated_normal",
                why),
            ""});
        break;
      }
  }
}

/// As all numbers are at their medians.
void check_held(const Study& study, std::vector<Problem>& problems)
{
  const StudySettings& s = study.settings;
  if (s.held.empty()) return;
  std::vector<std::string> changes = s.changes_at(s.quantiles(0.5));
  for (std::string& change : s.held_changes_at(s.quantiles(0.5))) changes.push_back(std::move(change));
  if (const std::string why = refusal_of(study, changes_with(study, changes)); !why.empty())
    problems.push_back({"held", "the case does not take what [held] changes", why, ""});
}

/// Corners of the box about the bodies of a material: "material.NAME. ...". None if they are not drawn.
std::optional<std::array<Vec<2>, 2>> box_of_material(const Case& c, const std::string& key)
{
  const auto parts = split_path(key);
  if (parts.size() < 3 || parts[0] != "material") return std::nullopt;
  constexpr Real far = std::numeric_limits<Real>::infinity();
  std::array<Vec<2>, 2> box{Vec<2>{far, far}, Vec<2>{-far, -far}};
  for (const BodyCase& body : c.bodies) {
    if (body.material != parts[1]) continue;
    if (body.polygon.empty()) return std::nullopt;
    for (const Vec<2>& corner : body.polygon)
      for (std::size_t d = 0; d < 2; ++d)
        box[0][d] = std::min(box[0][d], corner[d]), box[1][d] = std::max(box[1][d], corner[d]);
  }
  return box[0][0] < box[1][0] ? std::optional(box) : std::nullopt;
}

void add_random(const std::string& path, const Node& node, std::vector<std::string>& found)
{
  if (node.kind == NodeKind::table && find_item(node, "random") != nullptr) found.push_back(path);
  for (std::size_t k = 0; k < node.items.size(); ++k)
    add_random(node.kind == NodeKind::list ? fmt::format("{}[{}]", path, k) : join_path(path, node.items[k].name),
        node.items[k], found);
}

/// The mean of a field must not be a field that is not drawn.
void check_mean(const Study& study, const RandomFieldKey& field, std::vector<Problem>& problems)
{
  const Node* own = find_node(study.base.source.root, field.key);
  std::vector<std::string> found;
  if (!field.mean.empty())
    add_random(join_path(field.path, "mean"), parse_toml("mean = " + field.mean), found);
  else if (own != nullptr)
    add_random(field.key, *own, found);
  if (!found.empty())
    problems.push_back({field.path, fmt::format("the mean of the field of `{}` is a random field itself", field.key),
        field.mean.empty() ? "The case has one there. Give `mean`, or take it out of the case."
                           : "Give a mean without `random`.",
        ""});
}

void find_boxes(Study& study, std::vector<Problem>& problems)
{
  for (const RandomFieldKey& field : study.settings.fields) {
    const auto box = field.box ? field.box : box_of_material(study.base.values, field.key);
    if (!box)
      problems.push_back({field.path, fmt::format("the field of `{}` needs `box`", field.key),
          "Its material has no body that is drawn. Give [[x, y], [x, y]] in m, around all of its soil.", ""});
    check_mean(study, field, problems);
    study.boxes.push_back(box.value_or(std::array<Vec<2>, 2>{}));
    if (field.mean.empty() && find_node(study.base.source.root, field.key) == nullptr)
      problems.push_back({field.path, fmt::format("the field of `{}` needs `mean`", field.key),
          "The case does not give the key. If its name is misspelt, see the case file.", ""});
  }
}

void set_factors(Study& study, std::vector<Problem>& problems)
{
  const StudySettings& s = study.settings;
  const auto factor = [&](const auto& list) {
    SquareMatrix matrix = SquareMatrix::unit(list.size());
    const auto number_of = [&](const std::string& key) {
      return static_cast<std::size_t>(
          std::ranges::find_if(list, [&](const auto& item) { return item.key == key; }) - list.begin());
    };
    for (const StudyCorrelation& c : s.correlations) {
      const std::size_t a = number_of(c.a), b = number_of(c.b);
      if (a < list.size() && b < list.size()) matrix.at(a, b) = matrix.at(b, a) = c.value;
    }
    CholeskyResult result = cholesky(matrix);
    if (!result.fault) return result.factor;
    const std::string &first = list[result.fault->a].key, &second = list[result.fault->b].key;
    const auto at = std::ranges::find_if(s.correlations,
        [&](const StudyCorrelation& c) { return (c.a == first && c.b == second) || (c.a == second && c.b == first); });
    problems.push_back({at != s.correlations.end() ? join_path(at->path, "value") : "correlation",
        "the correlations contradict each other",
        fmt::format("Between `{}` and `{}` it is {:g}, which does not go with those before: the matrix is not positive "
                    "definite.",
            first, second, matrix.at(result.fault->a, result.fault->b)),
        ""});
    return SquareMatrix::unit(list.size());
  };
  study.of_numbers = factor(s.numbers);
  study.of_fields = factor(s.fields);
}

/// The fields one by one, so that the message is of the field.
void check_fields_of_study(Study& study, std::vector<Problem>& problems)
{
  const Draw draw = draw_changes(study, 0);
  for (const RandomFieldKey& field : study.settings.fields) {
    const auto change = std::ranges::find_if(
        draw.changes, [&](const std::string& text) { return text.starts_with(field.key + "={ random"); });
    std::string why = refusal_of(study, changes_with(study, {*change}));
    if (why.empty()) try {
        const CaseFile file = read_case_text(study.case_text, study.case_path, changes_with(study, {*change}));
        build_model(file.values, study.mesh, 1);
      } catch (const InputError& error) {
        why = error.what();
      }
    if (!why.empty())
      problems.push_back(
          {join_path(field.path, "key"), fmt::format("the case does not take the field of `{}`", field.key), why, ""});
  }
}

void check_table(const Study& study, std::vector<Problem>& problems)
{
  for (Index row = 0; row < study.n_realisations; ++row) {
    const std::string why = refusal_of(study, draw_changes(study, row).changes);
    if (why.empty()) continue;
    problems.push_back({fmt::format("{}[{}]", join_path(study.settings.sweep.front().path, "values"), row),
        fmt::format("the case does not take row {} of the table", row), why, ""});
    return;
  }
}

void check_sweep(const Study& study, std::vector<Problem>& problems)
{
  if (study.settings.form == SweepForm::table) return check_table(study, problems);
  for (const SweepKey& sweep : study.settings.sweep)
    for (std::size_t k = 0; k < sweep.values.size(); ++k)
      if (const std::string why =
              refusal_of(study, changes_with(study, {sweep.key + "=" + toml_value(sweep.values[k])}));
          !why.empty()) {
        problems.push_back({fmt::format("{}[{}]", join_path(sweep.path, "values"), k),
            fmt::format("the case does not take `{}`", sweep.key), why, ""});
        break;
      }
}

/// `coarse`, and what follows the load.
std::vector<std::string> coarse_at(const Study& study, Real level)
{
  std::vector<std::string> changes = study.settings.multilevel.coarse;
  for (std::string& change : study.settings.fragility->changes_at(level)) changes.push_back(std::move(change));
  return changes;
}

/// At each level, and without the draws.
void check_levels(const Study& study, std::vector<Problem>& problems)
{
  if (!study.settings.fragility) return;
  const FragilityLoad& load = *study.settings.fragility;
  for (std::size_t k = 0; k < load.levels.size(); ++k) {
    std::string why = refusal_of(study, changes_with(study, load.changes_at(load.levels[k])));
    if (why.empty() && study.coarse) why = refusal_of(study, changes_with(study, coarse_at(study, load.levels[k])));
    if (why.empty()) continue;
    problems.push_back({fmt::format("fragility.levels[{}]", k),
        fmt::format("the case does not take h = {:g}", load.levels[k]), why, ""});
    return;
  }
}

FloodLevel flood_level_of(const Study& study, const Case& c)
{
  return build_model(c, study.shares_mesh ? study.mesh : std::make_shared<const Mesh<2>>(build_mesh(c)), 1).flood_level;
}

/// F at one level is that at the others only if each is judged, and against the water of the same end.
void check_water_of_levels(const Study& study, std::vector<Problem>& problems)
{
  if (!study.settings.fragility) return;
  const FragilityLoad& load = *study.settings.fragility;
  std::optional<FloodLevel> first;
  for (std::size_t k = 0; k < load.levels.size(); ++k) {
    const auto changes = changes_with(study, load.changes_at(load.levels[k]));
    const Case c = read_case_text(study.case_text, study.case_path, changes).values;
    if (!c.flood.asks() || std::isfinite(c.flood.water_level)) return;
    const FloodLevel now = flood_level_of(study, c);
    if (!first) first = now;
    const bool other_end = first->river && now.river && *first->river != *now.river;
    if (first->is_known() == now.is_known() && !other_end) continue;
    problems.push_back({fmt::format("fragility.levels[{}]", k),
        other_end ? fmt::format("the free water stands higher at the other end of the section than at h = {:g}",
                        load.levels.front())
                  : fmt::format("free water stands above the ground at h = {:g} and not at h = {:g}",
                        load.levels[first->is_known() ? 0 : k], load.levels[first->is_known() ? k : 0]),
        "F would be judged against another water, or not at all. Say which level counts, as in\n[fragility.set]\n"
        "\"flood.water_level\" = \"h\"",
        ""});
    return;
  }
}

/// All soil of a two-stage study is judged by its factor of safety.
void check_judged(const Study& study)
{
  if (study.settings.estimator == Estimator::two_stage) check_may_be_judged(study.base.values);
}

bool changes_mesh(const std::string& key)
{
  return key.starts_with("mesh") || key.starts_with("body") || key.starts_with("footing");
}

/// Of the bodies as they are drawn [m^2]; infinite if one comes as points or cells.
Real drawn_area(const Case& c)
{
  Real sum = 0.0;
  for (const BodyCase& body : c.bodies) {
    if (body.polygon.empty()) return std::numeric_limits<Real>::infinity();
    sum += std::abs(signed_area(body.polygon));
    for (const auto& hole : body.holes) sum -= std::abs(signed_area(hole));
  }
  return sum;
}

/// A slide of more soil than there is, or by more than the mesh is long, never happens: P(I) would be 0, whatever the
/// dike.
void check_event(const Study& study, std::vector<Problem>& problems)
{
  if (!study.shares_mesh || study.settings.estimator == Estimator::sweep) return;  // a sweep may be of a small sample
  const EventRule& event = study.settings.event;
  constexpr const char* sure = "P(I) would be 0, whatever is drawn.";
  if (const Real area = drawn_area(study.base.values); event.volume >= area)
    problems.push_back({"events.volume", "no slide can be so large",
        fmt::format("Got {:g} m^2; the case has {:g} m^2 of soil. {}", event.volume, area, sure), ""});
  const BoundingBox box = box_around(study.mesh->nodes);
  if (const Real longest = std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1]);
      event.displacement >= longest)
    problems.push_back({"events.displacement", "no soil can move so far",
        fmt::format("Got {:g} m; the mesh is {:.4g} m from corner to corner. {}", event.displacement, longest, sure),
        ""});
}

void set_shares_mesh(Study& study)
{
  const StudySettings& s = study.settings;
  const auto take = [&](const std::string& key) { study.shares_mesh = study.shares_mesh && !changes_mesh(key); };
  for (const RandomNumber& number : s.numbers) take(number.key);
  for (const KeyValues* keys : {&s.follow, &s.held})
    for (const auto& [key, value] : *keys) take(key);
  for (const SweepKey& sweep : s.sweep) take(sweep.key);
  if (s.fragility)
    for (const auto& [key, value] : s.fragility->set) take(key);
}

Index count_realisations(const StudySettings& s)
{
  const std::int64_t number = s.stop.number;
  if (info_of(s.estimator).adaptive)
    return static_cast<Index>(std::min<std::int64_t>(most_realisations, 10 * number + 1000));
  const auto refused_above_most = [](std::int64_t n) {
    return static_cast<Index>(std::min<std::int64_t>(n, most_realisations + 1));
  };
  if (s.fragility)
    return refused_above_most((number + s.multilevel.pairs) * static_cast<std::int64_t>(s.fragility->levels.size()));
  if (s.estimator != Estimator::sweep) return refused_above_most(number + s.multilevel.pairs);
  std::size_t n = s.form == SweepForm::table ? s.sweep.front().values.size() : 1;
  if (s.form == SweepForm::grid)
    for (const SweepKey& sweep : s.sweep) n = std::min<std::size_t>(n * sweep.values.size(), most_realisations + 1);
  return static_cast<Index>(n);
}

std::string case_in(const StudySettings& s) { return path_of(s.folder, s.case_path); }

}  // namespace

Index Study::n_levels() const { return settings.fragility ? static_cast<Index>(settings.fragility->levels.size()) : 1; }

std::vector<std::string> Study::input_names() const
{
  std::vector<std::string> names;
  if (settings.fragility) names.push_back(settings.fragility->label());
  for (const SweepKey& sweep : settings.sweep) names.push_back(sweep.key);
  for (const RandomNumber& number : settings.numbers) names.push_back(number.key);
  for (const RandomFieldKey& field : settings.fields)
    names.push_back(field.key + " (mean of the field over its trend)");
  return names;
}

Study prepare_study(StudySettings settings)
{
  Study study{.settings = std::move(settings)};
  const StudySettings& s = study.settings;
  if (info_of(s.estimator).adaptive && !has_openturns()) find_probability({.kind = s.estimator}, {});
  study.case_path = case_in(s);
  study.base = read_case(study.case_path, s.set);
  study.case_text = study.base.source.text;
  study.n_realisations = count_realisations(s);
  std::vector<Problem> problems;
  if (study.n_realisations > most_realisations)
    problems.push_back({s.estimator == Estimator::sweep ? "sweep" : "stop.number",
        s.estimator == Estimator::sweep ? "the sweep has too many combinations"
        : s.fragility                   ? "the study has too many realisations over all levels"
                                        : "the study has too many realisations",
        fmt::format("At most {}.", most_realisations), ""});
  refuse_if_any(problems, s);
  set_factors(study, problems);
  find_boxes(study, problems);
  refuse_overlaps(study, problems);
  refuse_if_any(problems, s);
  prepare_coarse(study, problems);
  check_numbers(study, problems);
  if (problems.empty()) check_held(study, problems);
  check_sweep(study, problems);
  check_levels(study, problems);
  refuse_if_any(problems, s);
  study.points = make_points(study.settings);
  set_shares_mesh(study);
  try {
    check_judged(study);
    study.mesh = std::make_shared<const Mesh<2>>(build_mesh(study.base.values));
    check_event(study, problems);
    refuse_idle_sweeps(study, problems);
    if (s.adaptive.of_flood && !flood_level_of(study, study.base.values).is_known())
      problems.push_back({"estimator.event", "`event = \"flood\"` needs a case with a water level",
          "See docs/flood.md, or choose `event = \"slide\"`.", ""});
    check_water_of_levels(study, problems);
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), study.base));
  }
  if (!s.fields.empty()) check_fields_of_study(study, problems);
  refuse_if_any(problems, s);
  check_levels_differ(study, problems);
  refuse_if_any(problems, s);
  study.case_digits = digits_of(record_of_case(study));
  study.study_digits = digits_of(identity_text(s));
  return study;
}

namespace {

/// A key of one place of a line of the water: the rest of the line stays, and free water with it.
void doubt_places_of_lines(const Study& study, std::vector<Problem>& doubts)
{
  const auto take = [&](const std::string& key, const std::string& path) {
    const bool of_line =
        key.find("phreatic_line[") != std::string::npos || key.find("head_lines.") != std::string::npos;
    if (!of_line || !key.ends_with(']')) return;
    doubts.push_back({join_path(path, "key"), fmt::format("`{}` moves one place of the line, the others stay", key),
        "A river stands at one height along all of its line, and heads follow it. For its level take [fragility], "
        "whose\n"
        "formulas move all places with it; its `distribution` gives one P over all levels. A key of one place fits\n"
        "a line that is uncertain within the dike alone.",
        ""});
  };
  for (const RandomNumber& number : study.settings.numbers)
    if (!number.is_name) take(number.key, number.path);
  for (const SweepKey& sweep : study.settings.sweep) take(sweep.key, sweep.path);
}

/// Soil that settles or swings goes as far; a slide of less than a few points shows nothing. Few slides go farther than
/// the section is high.
void doubt_small_events(const Study& study, Real cell, std::vector<Problem>& doubts)
{
  constexpr Real least_displacement = 1e-3, least_volume = 0.04;  // of a cell; one point of 5 x 5
  const EventRule& event = study.settings.event;
  if (event.displacement < least_displacement * cell)
    doubts.push_back({"events.displacement", "soil that only settles counts as a slide",
        fmt::format("Got {:g} m; cells are {:.3g} m wide. Soil at rest still moves by as much. Usual: 0.1 to 1 m.",
            event.displacement, cell),
        ""});
  const BoundingBox box = box_around(study.mesh->nodes);
  if (study.settings.estimator != Estimator::sweep && event.displacement > box.high[1] - box.low[1])
    doubts.push_back({"events.displacement", "a slide moves farther than the section is high",
        fmt::format(
            "Got {:g} m; the mesh is {:.3g} m high. Usual: 0.1 to 1 m.", event.displacement, box.high[1] - box.low[1]),
        ""});
  if (event.volume < least_volume * cell * cell)
    doubts.push_back({"events.volume", "a slide may be smaller than a material point",
        fmt::format("Got {:g} m^2; a cell holds {:.3g} m^2. Usual: 1 m^2 or more.", event.volume, cell * cell), ""});
}

}  // namespace

std::vector<Problem> find_doubts(const Study& study)
{
  std::vector<Problem> doubts = study.settings.warnings;
  if (!study.settings.note.empty()) doubts.push_back({"note", "a note of the study", study.settings.note, ""});
  doubt_places_of_lines(study, doubts);
  doubt_idle_sweeps(study, doubts);
  doubt_distributions(study, doubts);
  if (const Index n = study.settings.stop.number; study.settings.estimator == Estimator::sobol && (n & (n - 1)) != 0)
    doubts.push_back({"stop.number", "Sobol points are even in powers of two",
        fmt::format("Got {}. Take {} or {}.", n, std::bit_floor(static_cast<std::uint32_t>(n)),
            std::bit_ceil(static_cast<std::uint32_t>(n))),
        ""});
  std::vector<std::string> fixed;
  add_random("", study.base.source.root, fixed);
  for (const std::string& path : fixed) {
    const auto is_drawn = [&](const RandomFieldKey& field) {
      return path == field.key || path.starts_with(field.key + '.');
    };
    if (std::ranges::none_of(study.settings.fields, is_drawn))
      doubts.push_back({"case", fmt::format("the case has a random field at `{}` that this study does not draw", path),
          "It is the same in all realisations. Give it as [[field]] to draw it.", ""});
  }
  const Real cell = typical_cell_size(*study.mesh);
  doubt_small_events(study, cell, doubts);
  for (const RandomFieldKey& field : study.settings.fields)
    if (auto coarse = find_coarse_cells(
            join_path(field.path, "theta"), {field.scale, &correlation_named(field.correlation)}, cell))
      doubts.push_back(std::move(*coarse));
  return doubts;
}

}  // namespace terp
