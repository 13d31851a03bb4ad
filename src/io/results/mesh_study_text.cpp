// Answers are judged in mesh_study and only put into words here. What is said of a flood comes first. A difference is
// shown with enough digits to tell it from zero, even where its measure has fewer. The change of a place is a length,
// with its share of the distance beside it. That of other measures is a share, where there is one.

#include "io/results/mesh_study.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

using Value = std::optional<Real>;

constexpr Real far_from_asked = 0.05;  // of a size, relative: a mesh from gmsh
constexpr Real least_ratio = 1.3;      // of two sizes: below it the order is mostly noise (Celik et al. 2008, step 2)

std::string unit_behind(const RunMeasure& measure)
{
  return measure.unit == "-" || measure.unit.empty() ? "" : ' ' + measure.unit;
}

/// Those of the measure, and for an amount three that count.
int digits_for(const RunMeasure& measure, Real value)
{
  constexpr int most = 6;
  if (measure.kind != MeasureKind::amount || value == 0.0) return measure.digits;
  return std::clamp(
      2 - static_cast<int>(std::floor(std::log10(std::abs(value)))), measure.digits, std::max(most, measure.digits));
}

std::string with_unit(const RunMeasure& measure, Real value) { return text_of(measure, value) + unit_behind(measure); }

/// With as many digits as tell it from zero.
std::string difference_text(const RunMeasure& measure, Real difference)
{
  const Real size = std::abs(difference);
  const bool is_seen = size >= 0.5 * std::pow(10.0, -measure.digits);
  return (is_seen ? fmt::format("{:.{}f}", size, measure.digits) : fmt::format("{:.1g}", size)) + unit_behind(measure);
}

std::string all_values(const StudyQuantity& q)
{
  std::vector<std::string> texts;
  for (const Value& value : q.values) texts.push_back(value ? text_of(q.measure, value) : "none");
  return fmt::format("{}{}", fmt::join(texts, ", "), unit_behind(q.measure));
}

Value last_value(const StudyQuantity& q)
{
  const auto found = std::find_if(q.values.rbegin(), q.values.rend(), [](const Value& v) { return v.has_value(); });
  return found == q.values.rend() ? std::nullopt : *found;
}

std::string change_text(const StudyQuantity& q)
{
  const Value share = q.relative_change();
  if (q.measure.kind == MeasureKind::place)
    return difference_text(q.measure, *q.change) +
           (share ? fmt::format(" ({} of the distance since t = 0)", percent_text(*share)) : "");
  return share ? percent_text(*share) : difference_text(q.measure, *q.change);
}

/// Why there is no order, or what it gives; begins with "; ". Empty with fewer than three sizes.
std::string order_text(const StudyQuantity& q)
{
  const RefinementEstimate& e = q.estimate;
  switch (e.trend) {
    case Trend::unknown: return "";
    case Trend::unchanged: return "";
    case Trend::oscillating: return "; no order: it goes up and down";
    case Trend::diverging: return "; no order: the differences do not fall";
    case Trend::monotone: break;
  }
  if (!e.order_is_usable()) return fmt::format("; the observed order, {:.2g}, is not usable", e.order);
  if (!q.has_order) return "; no order: it moves in steps of its resolution";
  const Value error = q.relative_error();
  return fmt::format("; order {:.1f}, tends to {}, error {}", e.order, with_unit(q.measure, e.limit),
      error && q.measure.kind != MeasureKind::place ? percent_text(*error) : difference_text(q.measure, e.uncertainty));
}

std::string size_list(const StudySequence& sequence)
{
  std::vector<std::string> texts;
  for (const StudyRun& run : sequence.runs) texts.push_back(fmt::format("{:g}", run.cell));
  return fmt::format("{} m", fmt::join(texts, ", "));
}

std::string list_of_labels(const StudiedSequence& sequence, auto&& is_meant)
{
  std::vector<std::string> labels;
  for (const StudyQuantity& q : sequence.quantities)
    if (is_meant(q.answer)) labels.push_back(q.measure.label);
  return fmt::format("{}", fmt::join(labels, ", "));
}

using TextRows = std::vector<std::vector<std::string>>;

std::string columns(const TextRows& rows)
{
  std::vector<std::size_t> widths(rows[0].size(), 0);
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  std::string text;
  for (const auto& row : rows) {
    text += fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t c = 1; c < row.size(); ++c) text += fmt::format("   {:>{}}", row[c], widths[c]);
    text += '\n';
  }
  return text;
}

constexpr AnswerInfo answers[] = {
    {"none", "-"},
    {"same", "the same"},
    {"settled", "settled"},
    {"unresolved", "within its resolution"},
    {"tends", "tends to a limit"},
    {"depends", "depends on the mesh"},
    {"some_sizes", "depends on the mesh: only some sizes have it"},
};

}  // namespace

const AnswerInfo& info_of(MeshAnswer answer) { return answers[static_cast<int>(answer)]; }

std::string percent_text(Real share)
{
  const Real value = 100.0 * share;
  return value < 0.095 ? fmt::format("{:.1g} %", value) : fmt::format("{:.{}f} %", value, value < 9.95 ? 1 : 0);
}

int digits_for(const RunMeasure& measure, const std::vector<Value>& values)
{
  int digits = measure.digits;
  for (const Value& value : values)
    if (value) digits = std::max(digits, digits_for(measure, *value));
  return digits;
}

std::string text_of(const RunMeasure& measure, Value value)
{
  if (!value) return "-";
  if (measure.kind != MeasureKind::word) return fmt::format("{:.{}f}", *value, digits_for(measure, *value));
  const auto k = static_cast<std::size_t>(std::max(*value, 0.0));
  return k < measure.words.size() ? measure.words[k] : "-";
}

std::string sentence_on(const StudyQuantity& q)
{
  const std::string& label = q.measure.label;
  switch (q.answer) {
    case MeshAnswer::same: return fmt::format("{}: {} at all sizes", label, with_unit(q.measure, *last_value(q)));
    case MeshAnswer::settled:
    case MeshAnswer::unresolved:
      return fmt::format("{}: {}, changes by {} between the last two sizes{}{}", label,
          with_unit(q.measure, *last_value(q)), change_text(q),
          q.answer == MeshAnswer::settled
              ? ""
              : fmt::format(", within its resolution of {}", difference_text(q.measure, q.resolution)),
          order_text(q));
    case MeshAnswer::tends:
      return fmt::format("{}: still changes, by {} between the last two sizes: {}{}", label, change_text(q),
          all_values(q), order_text(q));
    case MeshAnswer::depends: return fmt::format("{}: depends on the mesh: {}{}", label, all_values(q), order_text(q));
    case MeshAnswer::some_sizes:
      return fmt::format("{}: depends on the mesh, only some sizes have it: {}", label, all_values(q));
    case MeshAnswer::none: break;
  }
  return fmt::format("{}: {}", label, all_values(q));
}

/// " after strengths were divided by 1.12"; empty: the verdict is that of the section as it is.
std::string trigger_of(const StudySequence& sequence)
{
  for (const StudyRun& run : sequence.runs)
    if (const auto& flood = run.results.summary.values.flood; flood && flood->trigger)
      return ' ' + trigger_words(*flood->trigger);
  return "";
}

/// Whether all sizes say the same of the water; empty where nothing is said of it.
std::string answer_on_flood(const StudiedSequence& sequence)
{
  const auto found =
      std::ranges::find_if(sequence.quantities, [](const StudyQuantity& q) { return q.measure.name == flood_measure; });
  if (found == sequence.quantities.end() || !found->has_values()) return "";
  if (found->answer == MeshAnswer::same)
    return fmt::format(
        "All sizes agree: {}{}. ", text_of(found->measure, last_value(*found)), trigger_of(sequence.sequence));
  return fmt::format("WHETHER IT FLOODS{} CHANGES WITH THE MESH: {} on cells of {}. ", trigger_of(sequence.sequence),
      all_values(*found), size_list(sequence.sequence));
}

std::string answer_of(const StudiedSequence& sequence, Real tolerance)
{
  const auto n_solved = std::ranges::count(sequence.sequence.runs, std::string(), &StudyRun::fault);
  if (n_solved < 2) return "Fewer than two sizes were solved: nothing can be said of the mesh.";
  const auto depends = [](MeshAnswer a) { return a == MeshAnswer::depends || a == MeshAnswer::some_sizes; };
  const std::string worst = list_of_labels(sequence, depends),
                    others = list_of_labels(sequence, [](MeshAnswer a) { return a == MeshAnswer::tends; });
  const std::string flood = answer_on_flood(sequence);
  std::string text;
  if (!worst.empty()) text += fmt::format("Depends on the mesh: {}.", worst);
  if (!others.empty()) text += fmt::format("{}Still changes, towards a limit: {}.", text.empty() ? "" : " ", others);
  if (!text.empty())
    return flood + text + fmt::format(" All else changes by less than {} or its resolution.", percent_text(tolerance));
  return flood +
         fmt::format("Nothing that is measured changes by more than {} or its resolution between the last two sizes.",
             percent_text(tolerance));
}

std::vector<std::string> remarks_on(const StudySequence& sequence)
{
  std::vector<std::string> remarks;
  std::vector<const StudyRun*> solved;
  for (const StudyRun& run : sequence.runs) {
    if (run.fault.empty())
      solved.push_back(&run);
    else
      remarks.push_back(fmt::format("No result on cells of {:g} m: {}", run.cell, run.fault));
  }
  for (const StudyRun* run : solved)
    if (std::abs(run->size / run->cell - 1.0) > far_from_asked)
      remarks.push_back(fmt::format(
          "The cells of {:g} m came out as {:.3g} m (root of their mean area), which is what the formulas take.",
          run->cell, run->size));
  for (const StudyRun* run : solved)
    for (const ReachedSide& reached : run->results.summary.values.reached_sides)
      remarks.push_back(
          fmt::format("On cells of {:g} m soil {} the side `{}` of the mesh by t = {:.3g} s: what it does there is of "
                      "the side, which may hide that sizes differ.",
              run->cell, reached.rose ? "rose at" : "came to", reached.side, reached.time));
  if (solved.size() == 2) remarks.push_back("Two sizes give no order and no estimate of the error: that takes three.");
  for (std::size_t k = 1; k < solved.size(); ++k)
    if (const Real ratio = solved[k - 1]->size / solved[k]->size; ratio < least_ratio)
      remarks.push_back(fmt::format(
          "The cells of {:g} m and {:g} m are too near in size, ratio {:.3g}: below {} an order is mostly noise.",
          solved[k - 1]->cell, solved[k]->cell, ratio, least_ratio));
  for (std::size_t k = 0; k + 3 < solved.size() && k < 1; ++k)
    remarks.push_back("Order, limit and error are of the three smallest sizes.");
  return remarks;
}

std::string answer_on_variants(const MeshStudy& study)
{
  if (study.spreads.empty()) return "";
  std::vector<std::string> parts;
  for (const StudySpread& s : study.spreads)
    if (s.matters) parts.push_back(s.measure.label + (s.share ? fmt::format(" ({})", percent_text(*s.share)) : ""));
  const std::string start = fmt::format("On cells of {:g} m, as given and with {} variant{}: ", study.spread_cell,
      study.sequences.size() - 1, study.sequences.size() == 2 ? "" : "s");
  if (parts.empty())
    return start + fmt::format("nothing differs by more than {} or its resolution.", percent_text(study.tolerance));
  return start + fmt::format("{} differ{} by more than {} and its resolution.", fmt::join(parts, ", "),
                     parts.size() == 1 ? "s" : "", percent_text(study.tolerance));
}

namespace {

std::string spread_text(const MeshStudy& study)
{
  if (study.spreads.empty()) return "";
  std::string text = fmt::format("\nall variants, cells of {:g} m\n", study.spread_cell);
  TextRows rows{{""}};
  for (std::size_t k = 0; k < study.sequences.size(); ++k) {
    text += fmt::format("  [{}] {}\n", k, study.sequences[k].sequence.name);
    rows[0].push_back(fmt::format("[{}]", k));
  }
  for (const char* head : {"range", "share"}) rows[0].push_back(head);
  for (const StudySpread& s : study.spreads) {
    const RunMeasure& m = s.measure;
    rows.push_back({m.label + (m.unit == "-" ? "" : fmt::format(" [{}]", m.unit))});
    for (const Value& value : s.values) rows.back().push_back(text_of(m, value));
    rows.back().push_back(text_of(m, s.range));
    rows.back().push_back(s.share ? percent_text(*s.share) : "-");
  }
  return text + columns(rows) + answer_on_variants(study) + '\n';
}

}  // namespace

std::string study_text(const MeshStudy& study)
{
  std::string text;
  for (const StudiedSequence& s : study.sequences) {
    TextRows rows{{""}};
    for (const StudyRun& run : s.sequence.runs) rows[0].push_back(fmt::format("{:g} m", run.cell));
    for (const char* head : {"change", "order", "limit", "error"}) rows[0].push_back(head);
    for (const StudyQuantity& q : s.quantities) {
      if (!q.has_values()) continue;
      const RunMeasure& m = q.measure;
      rows.push_back({m.label + (m.unit == "-" ? "" : fmt::format(" [{}]", m.unit))});
      for (const Value& value : q.values) rows.back().push_back(text_of(m, value));
      const Value change = q.relative_change(), error = q.relative_error();
      rows.back().push_back(change ? percent_text(*change) : "-");
      rows.back().push_back(q.has_order ? fmt::format("{:.2f}", q.estimate.order) : "-");
      rows.back().push_back(q.has_order ? text_of(m, q.estimate.limit) : "-");
      rows.back().push_back(error ? percent_text(*error) : "-");
    }
    text += fmt::format("\n{}, cells of {}\n", s.sequence.name, size_list(s.sequence)) + columns(rows) + '\n';
    for (const StudyQuantity& q : s.quantities)
      if (q.has_values()) text += "  " + sentence_on(q) + '\n';
    for (const std::string& remark : remarks_on(s.sequence)) text += "  " + remark + '\n';
    text += answer_of(s, study.tolerance) + '\n';
  }
  return text + spread_text(study);
}

}  // namespace terp
