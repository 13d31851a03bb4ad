// A load is put on points once, when it begins, and goes with them: a row holds the part of its stretch that each
// carries, the pressure comes in each step. A load that is not permanent has zeros there until it begins.

#include "model/loads/loads.hpp"

#include "model/ground/top_points.hpp"
#include "mpm/features/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real reach = 2.5;  // of its size: as far as a top point is ground. In cut cells points are smaller than apart

/// The part of a stretch that no top point reaches [m]; from > to: none.
struct Gap {
  Real from, to;
};

Gap find_gap(const std::vector<TopPoint>& tops, Real from, Real to)
{
  Real reached = from;
  for (const TopPoint& top : tops) {
    if (top.x[0] - reach * top.size > reached) return {reached, std::min(to, top.x[0] - reach * top.size)};
    reached = std::max(reached, top.x[0] + reach * top.size);
    if (reached >= to) return {to, from};
  }
  return {reached, to};
}

std::string describe_gap(const Load& load, const Gap& gap, const StepState& state)
{
  Real low = std::numeric_limits<Real>::infinity(), high = -low;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    low = std::min(low, block.row(Rows::x)[lane]);
    high = std::max(high, block.row(Rows::x)[lane]);
  });
  return fmt::format(
      "It stands on x = {:g} to {:g} m; from {:.4g} to {:.4g} m there is no soil. The soil reaches from x = {:.4g} to "
      "{:.4g} m.\nMove `from` and `to` onto the soil, or make two loads of it.",
      load.from, load.to, gap.from, gap.to, low, high);
}

/// width[k] of top point k: integral of its hat function over the stretch; beyond the last points the hats are 1.
std::vector<Real> share_stretch(const std::vector<TopPoint>& tops, Real from, Real to)
{
  std::vector<Real> width(tops.size(), 0.0);
  const auto overlap = [&](Real a, Real b) { return std::pair(std::max(a, from), std::min(b, to)); };
  for (std::size_t k = 0; k + 1 < tops.size(); ++k) {
    const Real a = tops[k].x[0], b = tops[k + 1].x[0];
    const auto [l, r] = overlap(a, b);
    if (!(r > l && b > a)) continue;
    const Real right = (r - l) * ((0.5 * (l + r) - a) / (b - a));
    width[k + 1] += right;
    width[k] += (r - l) - right;
  }
  width.front() += std::max(0.0, std::min(to, tops.front().x[0]) - from);
  width.back() += std::max(0.0, to - std::max(from, tops.back().x[0]));
  return width;
}

/// The top points that can carry a part of the stretch: those on it and one on each side, of ground that stays.
std::vector<TopPoint> top_points_at(const Model& model, const Load& load, const StepState& state)
{
  Real largest = 0.0;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    for (Index lane = 0; lane < block.n; ++lane) largest = std::max(largest, block.row(Rows::volume)[lane]);
  });
  const Real margin = 4.0 * std::sqrt(largest);  // what hides the neighbours of the ends lies within it
  return find_top_points(state.points, load.from - margin, load.to + margin, held_row_of(model));
}

}  // namespace

std::vector<Load> make_loads(const Case& description, const Case& before)
{
  std::vector<Load> loads;
  for (std::size_t k = 0; k < description.loads.size(); ++k) {
    const LoadCase& c = description.loads[k];
    loads.push_back({c.name, c.from, c.to, c.pressure, c.start, c.end, c.ramp, before.loads[k].pressure, -1});
  }
  return loads;
}

std::string describe_pressures(const Case& whole, std::size_t load)
{
  Real pressure = whole.stages.empty() ? whole.loads[load].pressure : whole.stages[0].changed->loads[load].pressure;
  std::string text = fmt::format("{:.4g} kPa", pressure / 1e3);
  for (const StageCase& stage : whole.stages) {
    const Real now = stage.changed->loads[load].pressure;
    if (now != pressure) text += fmt::format(", {:.4g} kPa in `{}`", now / 1e3, stage.name);
    pressure = now;
  }
  return text;
}

void add_rows_of_loads(std::vector<Load>& loads, RowTable& rows)
{
  for (std::size_t k = 0; k < loads.size(); ++k)
    loads[k].row = rows.add({.name = fmt::format("load_{}", k),
        .unit = "m",
        .meaning = fmt::format("part of the stretch of the load `{}` that the point carries", loads[k].name),
        .owner = "load"});
}

std::string place_load(const Model& model, const Load& load, StepState& state)
{
  const std::vector<TopPoint> tops = top_points_at(model, load, state);
  if (const Gap gap = find_gap(tops, load.from, load.to); gap.from < gap.to) return describe_gap(load, gap, state);
  const std::vector<Real> width = share_stretch(tops, load.from, load.to);
  for_each_block(state.points, [&](const PointBlock<2>& block) { std::fill_n(block.row(load.row), block.n, 0.0); });
  for (std::size_t k = 0; k < tops.size(); ++k)
    state.points.block(tops[k].place.block).row(load.row)[tops[k].place.lane] = width[k];
  return {};
}

bool stands_on_what_goes(const Model& model, const Load& load, const StepState& state)
{
  if (!model.with.bodies) return false;
  bool any = false;
  const int held_row = held_row_of(model);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    any = any || (block.row(held_row)[lane] < 0.0 && block.row(load.row)[lane] != 0.0);
  });
  return any;
}

void place_first_loads(const Model& model, StepState& state)
{
  const std::span<const Load> loads = loads_of(model);
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const Load& load = loads[k];
    if (std::string why = place_load(model, load, state); !why.empty())
      throw InputError(
          Problem{fmt::format("load[{}].from", k), fmt::format("there is no ground under the load `{}`", load.name),
              why, "load", false, {fmt::format("load[{}].to", k), "body"}});
    if (!load.is_permanent())
      for_each_block(state.points, [&](const PointBlock<2>& block) { std::fill_n(block.row(load.row), block.n, 0.0); });
  }
}

std::string place_due_loads(const Model& model, StepState& state)
{
  for (const Load& load : loads_of(model)) {
    if (load.is_permanent() || model.first_step + load.first_step(model.dt, model.first_time) != state.step) continue;
    if (const std::string why = place_load(model, load, state); !why.empty())
      return fmt::format("step {}, t = {:.4f} s: there is no ground under the load `{}`, which begins now\n  {}",
          state.step, state.time, load.name, why);
  }
  return {};
}

}  // namespace terp
