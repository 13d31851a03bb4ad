// What rises and what falls is summed apart: together they would cancel. Neighbouring stages with the same change share
// one sentence; less than a hundredth of a square strip is none.

#include "import/dstability/earlier_ground.hpp"

#include "import/dstability/preload.hpp"
#include "import/dstability/section.hpp"
#include "import/dstability/reported_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace terp {
namespace {

constexpr Real least_height = 1e-3;  // [m]: files have places to the millimetre

struct Strip {
  Real area = 0.0, left = 1e30, right = -1e30;  ///< [m^2], x [m]

  void add(Real x, Real column, Real height)
  {
    if (!(height > least_height)) return;
    area += column * height;
    left = std::min(left, x - 0.5 * column);
    right = std::max(right, x + 0.5 * column);
  }
  bool counts(Real column) const { return area > 0.01 * column * column; }
};

struct Change {
  std::string labels;  ///< of the stages that have it
  Strip added, removed;
};

/// The ground [m]; where there is none as low as can be drawn in the section.
Real ground_of(const StixProject& project, const StixStage& stage, Real x, Real lowest)
{
  const Real ground = StixStageColumn(project, stage, x).ground();
  return std::isnan(ground) ? lowest : ground;
}

Change change_since(
    const StixProject& project, std::pair<const StixStage*, const StixStage*> stages, Vec<2> between, Real column)
{
  const auto& [then, now] = stages;
  const Real lowest = std::min(box_around(then->layers).low[1], box_around(now->layers).low[1]);
  Change change{.labels = fmt::format("`{}`", then->label), .added = {}, .removed = {}};
  for (Real x = between[0] + 0.5 * column; x < between[1]; x += column) {
    const Real rise = ground_of(project, *now, x, lowest) - ground_of(project, *then, x, lowest);
    change.added.add(x, column, rise);
    change.removed.add(x, column, -rise);
  }
  return change;
}

Sentence in_words(const Change& change, Real column)
{
  Sentence text;
  const auto add = [&](const Strip& strip, const Sentence& one) {
    if (!strip.counts(column)) return;
    const char* const between = text.empty() ? "" : ", ";
    text = {text.en + between + one.en, text.nl + between + one.nl};
  };
  add(change.added, filled<reported_texts::was_added>(change.added.area, change.added.left, change.added.right));
  add(change.removed,
      filled<reported_texts::was_removed>(change.removed.area, change.removed.left, change.removed.right));
  return filled<reported_texts::since>(change.labels, text);
}

}  // namespace

std::optional<EarlierGround> earlier_ground(
    const StixProject& project, std::size_t scenario, std::size_t stage, Vec<2> between, Real column)
{
  if (same_ground_until(project.scenarios[scenario], stage)) return std::nullopt;
  const std::vector<StixStage>& stages = project.scenarios[scenario].stages;
  std::vector<Change> changes;
  for (std::size_t k = 0; k < stage; ++k) {
    Change change = change_since(project, {&stages[k], &stages[stage]}, between, column);
    if (!change.added.counts(column) && !change.removed.counts(column)) continue;
    const auto is_same = [&](const Strip& a, const Strip& b) { return std::abs(a.area - b.area) < 1e-6; };
    if (!changes.empty() && is_same(changes.back().added, change.added) &&
        is_same(changes.back().removed, change.removed))
      changes.back().labels += ", " + change.labels;
    else
      changes.push_back(std::move(change));
  }
  if (changes.empty()) return EarlierGround{filled<reported_texts::changed_layers>(), false};
  Sentence all;
  for (const Change& change : changes) {
    const Sentence one = in_words(change, column);
    all = {all.en + one.en, all.nl + one.nl};
  }
  return EarlierGround{filled<reported_texts::changed_ground>(all), true};
}

}  // namespace terp
