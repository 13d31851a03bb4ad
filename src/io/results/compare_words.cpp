// Rows are found by the labels that measures.cpp gives them, and must be there. Words go no farther than the thresholds
// below: a difference that is small gets its numbers alone.

#include "io/results/compare.hpp"

#include "mpm/points/moved.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

using Value = std::optional<Real>;

constexpr Real survives = 5.0;         // of the soil that moved: blocks are left [%]
constexpr Real erased = 5.0;           // times as much elsewhere: here they are gone [-]
constexpr Real fewer = 1.5;            // times as much elsewhere: here there are fewer [-]
constexpr std::size_t most_named = 6;  // keys in one sentence

/// What distinguishes two runs: the scheme if it does and there are no others, else the names.
struct Pair {
  std::string a, b;
};

Pair titles(const Comparison& c, std::size_t other)
{
  if (c.names.size() == 2 && c.schemes[0] != c.schemes[other])
    return {scheme_title(c.schemes[0]), scheme_title(c.schemes[other])};
  return {c.names[0], c.names[other]};
}

const ComparisonRow& row_of(const Comparison& c, std::string_view label)
{
  return *std::ranges::find_if(c.rows, [&](const ComparisonRow& row) { return row.label == label; });
}

/// True if all runs end at one time, as far as that is known.
bool end_together(const Comparison& c)
{
  const auto& ends = row_of(c, "time at the end").values;
  return std::ranges::all_of(
      ends, [&](Value end) { return !end || !ends[0] || std::abs(*end - *ends[0]) <= same_time; });
}

/// What must be known before the numbers of two runs are set against each other; empty if all is well.
std::string end_sentence(const Comparison& c, std::size_t other)
{
  const auto& ends = row_of(c, "time at the end").values;
  if (!ends[0] || !ends[other] || std::abs(*ends[0] - *ends[other]) <= same_time) return "";
  return fmt::format(
      "The runs end at different times, {} at {:.2f} s and {} at {:.2f} s: what they say of the end is not of one "
      "time.",
      c.names[0], *ends[0], c.names[other], *ends[other]);
}

std::string front_sentence(const std::vector<RunResults>& runs, const Comparison& c, std::size_t other, const Pair& who)
{
  const auto& front = row_of(c, "front at the end").values;
  const auto facing = [&](std::size_t k) { return runs[k].summary.values.facing.value_or(Facing::right); };
  if (!front[0] && !front[other]) return "";
  if (!front[0] || !front[other]) return fmt::format("With {} the soil has no front.", front[0] ? who.b : who.a);
  if (facing(0) != facing(other)) return "The soil runs out to different sides.";
  const Real more = outwards(facing(0)) * (*front[0] - *front[other]);
  if (std::abs(more) < 0.005) return fmt::format("The fronts end at the same place, {:.2f} m.", *front[0]);
  return fmt::format("With {} the front ends {:.2f} m {} than with {} ({:.2f} m against {:.2f} m).", who.a,
      std::abs(more), more > 0.0 ? "farther" : "nearer", who.b, *front[0], *front[other]);
}

/// "at 0.18 s with A, at 0.25 s with B" or "... with A; with B there is none".
std::string times_of_slide(const std::vector<Value>& begins, std::size_t other, const Pair& who)
{
  const auto at = [](Value time, const std::string& name) { return fmt::format("at {:.2f} s with {}", *time, name); };
  if (begins[0] && begins[other]) return at(begins[0], who.a) + ", " + at(begins[other], who.b);
  return begins[0] ? fmt::format("{}; with {} there is none", at(begins[0], who.a), who.b)
                   : fmt::format("{}; with {} there is none", at(begins[other], who.b), who.a);
}

std::string slides_sentence(const Comparison& c, std::size_t other, const Pair& who)
{
  const auto& first = row_of(c, "first slide begins").values;
  const auto& second = row_of(c, "second slide begins").values;
  if (!first[0] && !first[other]) return "Neither run has a slide.";
  std::string text = "The first slide begins " + times_of_slide(first, other, who) + ".";
  if (second[0] || second[other]) text += " A second begins " + times_of_slide(second, other, who) + ".";
  return text;
}

std::string flood_sentence(const std::vector<RunResults>& runs, std::size_t other, const Pair& who)
{
  const auto &a = runs[0].summary.values.flood, &b = runs[other].summary.values.flood;
  if (!a || !b) return "";
  if (!a->verdict || !b->verdict || a->verdict != b->verdict || a->trigger || b->trigger)
    return fmt::format("{}with {} {}; with {} {}.",
        !a->verdict || !b->verdict ? "The verdicts cannot be compared: "
        : a->verdict != b->verdict ? "They differ in the verdict: "
                                   : "The verdict is the same: ",
        who.a, flood_clause(*a), who.b, flood_clause(*b));
  return fmt::format(
      "The verdict is the same, {}: the highest ground that remains stands at {:.2f} m with {}, at {:.2f} m "
      "with {}.",
      info_of(*a->verdict).words, a->residual_height, who.a, b->residual_height, who.b);
}

std::string softening_sentence(const Comparison& c, std::size_t other, const Pair& who)
{
  const ComparisonRow* last = nullptr;
  for (const ComparisonRow& row : c.rows)
    if (row.label.starts_with("softened volume")) last = &row;
  if (last == nullptr || !last->values[0] || !last->values[other]) return "";
  const std::string when = end_together(c) ? "At the end" : "At" + last->label.substr(last->label.rfind(" at ") + 3);
  return fmt::format(
      "{} {:.1f} % of the soil has lost more than half of what softening takes with {}, {:.1f} % with {}.", when,
      *last->values[0], who.a, *last->values[other], who.b);
}

/// "30.1 %", or "less than 0.1 %".
std::string percent(Real value)
{
  return value > 0.0 && value < 0.05 ? "less than 0.1 %" : fmt::format("{:.1f} %", value);
}

/// Whether soil that slid in one piece is still there; the words go no farther than the numbers.
std::string intact_sentence(const Comparison& c, std::size_t other, const Pair& who)
{
  const auto& intact = row_of(c, "intact share of the soil that moved").values;
  if (!intact[0] || !intact[other]) return "";
  const bool first = *intact[0] > *intact[other];
  const Real more = first ? *intact[0] : *intact[other], less = first ? *intact[other] : *intact[0];
  std::string text =
      fmt::format("Of the soil that moved, {} is intact at the end with {} (eps_eq_p below {:g}), {} with {}",
          percent(*intact[0]), who.a, intact_strain, percent(*intact[other]), who.b);
  const std::string &keeps = first ? who.a : who.b, &loses = first ? who.b : who.a;
  if (more >= survives && less <= more / erased)
    return text + fmt::format(": blocks that slide in one piece survive with {} and are erased with {}.", keeps, loses);
  if (more >= survives && less <= more / fewer)
    return text + fmt::format(": more of the blocks that slide in one piece survive with {}.", keeps);
  return text + ".";
}

std::string list_of(const std::vector<std::string>& names)
{
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 < names.size() ? ", " : " and ") + names[k];
  return text;
}

std::string named_points_sentence(const std::vector<RunResults>& runs, std::size_t other, const Pair& who)
{
  const auto a = points_that_regained_strength(runs[0]), b = points_that_regained_strength(runs[other]);
  if ((a.empty() && b.empty()) || runs[0].history.empty() || runs[other].history.empty()) return "";
  const auto names = [](const std::vector<std::string>& list) { return list.empty() ? "none" : list_of(list); };
  return fmt::format(
      "Of the named points, {} regained strength with {}, {} with {}.", names(a), who.a, names(b), who.b);
}

/// In what the cases differ beside the scheme; empty if in nothing.
std::string case_sentence(const std::vector<RunResults>& runs, const Comparison& c, std::size_t other)
{
  const auto all = case_differences(runs[0].case_toml, runs[other].case_toml);
  if (all.empty()) return "";
  const std::vector<std::string> some(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), most_named)));
  const std::string more = all.size() > most_named ? fmt::format(" and {} more keys", all.size() - most_named) : "";
  return fmt::format("Caution: the cases differ, {} against {} in {}{}. What follows is not of the scheme alone.",
      c.names[0], c.names[other], fmt::join(some, ", "), more);
}

std::string audit_sentence(const Comparison& c, std::size_t other, const Pair& who)
{
  const auto& fell = row_of(c, "points whose eps_eq_p ever fell").values;
  const auto& n = row_of(c, "material points").values;
  const auto clause = [&](std::size_t k, const std::string& name) {
    if (!fell[k] || *fell[k] == 0.0) return fmt::format("with {} no point loses any of its plastic strain", name);
    return fmt::format(
        "with {} the plastic strain fell at {:.0f} of {:.0f} points, so that soil regained strength, which its law "
        "forbids",
        name, *fell[k], n[k].value_or(0.0));
  };
  std::string text = clause(0, who.a) + "; " + clause(other, who.b) + ".";
  text[0] = 'W';
  return text;
}

}  // namespace

std::vector<std::string> describe_differences(const std::vector<RunResults>& runs, const Comparison& c)
{
  std::vector<std::string> text;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (summary_is_behind(runs[k]))
      text.push_back(fmt::format(
          "{} has not ended; what its summary holds is older than its ledger and is not compared.", c.names[k]));
  for (std::size_t other = 1; other < c.names.size(); ++other) {
    const Pair who = titles(c, other);
    const auto add = [&](const std::string& sentence) {
      if (!sentence.empty()) text.push_back(sentence);
    };
    add(case_sentence(runs, c, other));
    if (summary_is_behind(runs[0]) || summary_is_behind(runs[other])) continue;
    for (const auto& sentence : {end_sentence(c, other), flood_sentence(runs, other, who),
             slides_sentence(c, other, who), front_sentence(runs, c, other, who), intact_sentence(c, other, who),
             softening_sentence(c, other, who), audit_sentence(c, other, who), named_points_sentence(runs, other, who)})
      add(sentence);
  }
  return text;
}

}  // namespace terp
