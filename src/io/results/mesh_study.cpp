// Sizes are those of the cells that were made, not those asked for. The answer is the first that fits, from equal to
// "depends". A change that the resolution of a measure hides is never called a trend. Sequences are compared at the
// smallest size that all of them have solved.

#include "io/results/mesh_study.hpp"

#include <limits>

namespace terp {
namespace {

using Value = std::optional<Real>;

constexpr Real round_off_of_values = 1e-9;  // of a value, relative [-]

bool is_solved(const StudyRun& run) { return run.fault.empty(); }

bool is_same(Real a, Real b) { return std::abs(a - b) <= round_off_of_values * std::max(std::abs(a), std::abs(b)); }

struct Sized {
  Real size, value;
  const StudyRun* run;
};

/// After the point, with which a tenth of this is seen.
int digits_that_show(Real resolution)
{
  return static_cast<int>(std::ceil(1.0 - std::log10(resolution) - round_off_of_values));
}

/// What a change counts as a share of; none: of nothing.
Value scale_of(const RunMeasure& measure, const Sized& finest)
{
  if (measure.kind == MeasureKind::place) {
    const Value distance = measure.distance ? measure.distance(finest.run->results) : std::nullopt;
    return std::max(std::abs(distance.value_or(0.0)), finest.size);
  }
  const bool has_size = measure.kind == MeasureKind::amount || measure.kind == MeasureKind::time;
  return !has_size || finest.value == 0.0 ? std::nullopt : Value(std::abs(finest.value));
}

MeshAnswer answer_on(const StudyQuantity& q, const std::vector<Sized>& sizes, Real tolerance)
{
  const auto same = [&](const Sized& s) { return is_same(s.value, sizes[0].value); };
  if (std::ranges::all_of(sizes, same)) return MeshAnswer::same;
  if (q.measure.kind == MeasureKind::count || q.measure.kind == MeasureKind::word) return MeshAnswer::depends;
  const auto small = [&](Real difference) { return q.scale && std::abs(difference) <= tolerance * *q.scale; };
  const bool is_known = q.estimate.trend != Trend::unknown;
  if (small(*q.change) && (!is_known || small(q.estimate.uncertainty))) return MeshAnswer::settled;
  if (std::abs(*q.change) <= q.resolution) return MeshAnswer::unresolved;
  return q.has_order ? MeshAnswer::tends : MeshAnswer::depends;
}

}  // namespace

StudyQuantity judge_sizes(const RunMeasure& measure, const std::vector<StudyRun>& runs, Real tolerance)
{
  constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
  StudyQuantity q{
      .measure = measure, .values = {}, .change = {}, .scale = {}, .estimate = {Trend::unknown, none, none, none}};
  std::vector<Sized> sizes;
  bool missing = false;
  for (const StudyRun& run : runs) {
    Value value = is_solved(run) ? measure.value(run.results) : std::nullopt;
    if (value && !std::isfinite(*value)) value = std::nullopt;
    q.values.push_back(value);
    if (value) sizes.push_back({run.size, *value, &run});
    missing |= is_solved(run) && !value;
  }
  if (sizes.empty()) return q;
  if (missing) return q.answer = MeshAnswer::some_sizes, q;
  if (sizes.size() < 2) return q;
  const Sized &finest = sizes.back(), &before = sizes[sizes.size() - 2];
  q.change = is_same(finest.value, before.value) ? 0.0 : finest.value - before.value;
  q.scale = scale_of(measure, finest);
  if (measure.resolution) {
    q.resolution = measure.resolution(before.run->results, before.size);
    const bool has_origin = measure.kind == MeasureKind::place || measure.kind == MeasureKind::time;
    if (has_origin && q.resolution > 0.0) q.measure.digits = std::max(measure.digits, digits_that_show(q.resolution));
  }
  if (measure.kind != MeasureKind::count && measure.kind != MeasureKind::word) {
    std::vector<Real> x, y;
    for (const Sized& s : sizes) x.push_back(s.size), y.push_back(s.value);
    q.estimate = estimate_limit(x, y);
    const bool in_steps = measure.in_steps && std::abs(*q.change) <= q.resolution;
    q.has_order = q.estimate.order_is_usable() && !in_steps && *q.change != 0.0;
  }
  q.answer = answer_on(q, sizes, tolerance);
  return q;
}

namespace {

std::optional<std::size_t> solved_at(const StudySequence& sequence, Real cell)
{
  for (std::size_t k = 0; k < sequence.runs.size(); ++k)
    if (sequence.runs[k].cell == cell && is_solved(sequence.runs[k])) return k;
  return std::nullopt;
}

/// Smallest size that all sequences have solved [m]; 0: there is none.
Real common_cell(const std::vector<StudiedSequence>& sequences)
{
  Real least = 0.0;
  for (const StudyRun& run : sequences[0].sequence.runs) {
    const auto has_it = [&](const StudiedSequence& s) { return solved_at(s.sequence, run.cell).has_value(); };
    if (std::ranges::all_of(sequences, has_it) && (least == 0.0 || run.cell < least)) least = run.cell;
  }
  return least;
}

/// Of the quantity of this number in all sequences.
StudySpread spread_of(const MeshStudy& study, std::size_t number)
{
  const StudyQuantity& first = study.sequences[0].quantities[number];
  StudySpread spread{.measure = first.measure, .values = {}, .range = {}, .share = {}};
  std::vector<Real> found;
  for (const StudiedSequence& s : study.sequences) {
    spread.values.push_back(s.quantities[number].values[*solved_at(s.sequence, study.spread_cell)]);
    if (spread.values.back()) found.push_back(*spread.values.back());
  }
  if (found.size() < spread.values.size()) return spread.matters = !found.empty(), spread;
  const auto [low, high] = std::ranges::minmax(found);
  const bool is_word = first.measure.kind == MeasureKind::word, differs = !is_same(low, high);
  if (is_word || first.measure.kind == MeasureKind::count) spread.matters = differs;
  if (is_word) return spread;
  spread.range = differs ? high - low : 0.0;
  if (first.scale) spread.share = *spread.range / *first.scale;
  if (!spread.share) return spread;
  const StudySequence& base = study.sequences[0].sequence;
  const StudyRun& run = base.runs[*solved_at(base, study.spread_cell)];  // the cells of the table, not coarser ones
  const Real resolution = first.measure.resolution ? first.measure.resolution(run.results, run.size) : 0.0;
  spread.matters |= *spread.share > study.tolerance && *spread.range > resolution;
  return spread;
}

void spread_over_variants(MeshStudy& study)
{
  if (study.sequences.size() < 2) return;
  study.spread_cell = common_cell(study.sequences);
  if (study.spread_cell == 0.0) return;
  for (std::size_t k = 0; k < study.sequences[0].quantities.size(); ++k) study.spreads.push_back(spread_of(study, k));
}

}  // namespace

MeshStudy study_mesh(const std::vector<StudySequence>& sequences, Real tolerance)
{
  std::vector<RunResults> all;
  for (const StudySequence& sequence : sequences)
    for (const StudyRun& run : sequence.runs)
      if (is_solved(run)) all.push_back(run.results);
  MeshStudy study{.case_name = {}, .title = {}, .tolerance = tolerance, .sequences = {}};
  for (const StudySequence& sequence : sequences) study.sequences.push_back({sequence, {}});
  if (all.empty()) return study;
  for (const RunMeasure& measure : measures_of(all)) {
    if (measure.name.empty()) continue;
    std::vector<StudyQuantity> rows;
    for (const StudySequence& sequence : sequences) rows.push_back(judge_sizes(measure, sequence.runs, tolerance));
    if (std::ranges::none_of(rows, &StudyQuantity::has_values)) continue;
    for (std::size_t k = 0; k < rows.size(); ++k) study.sequences[k].quantities.push_back(std::move(rows[k]));
  }
  spread_over_variants(study);
  return study;
}

}  // namespace terp
