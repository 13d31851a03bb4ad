#include "simulation/failure.hpp"

#include "events/moved.hpp"

#include <algorithm>

namespace terp {
namespace {

/// Number of slides so far. A new one shows only when the crest has retreated.
std::size_t count_slides(const State& state)
{
  const auto& x = state.crest.x;
  const bool same = x.size() > 1 && x.back() >= x[x.size() - 2];
  return same ? state.slip.size() : find_slides(state.crest).size();
}

void follow_slip(State& state)
{
  const auto& time = state.crest.time;
  if (time.size() < 2) return;
  state.slip.resize(std::max({std::size_t{1}, state.slip.size(), count_slides(state)}));
  SlipSurface& slip = state.slip.back();
  const Real rate = total_growth(state.points, state.audit.growth) / (time.back() - time[time.size() - 2]);
  if (!(rate > slip.rate)) return;
  slip = {.time = time.back(), .rate = rate, .line = find_slip_line(state.points, state.audit.growth, state.crest.columns)};
}

/// Largest x at t = 0 [m].
Real first_front(const State& state)
{
  Real x = state.x_initial.empty() ? 0.0 : state.x_initial[0];
  for (std::size_t k = 0; k < state.x_initial.size(); k += 2) x = std::max(x, state.x_initial[k]);
  return x;
}

Real total_volume(const PointBlocks<2>& points)
{
  Real volume = 0.0;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) { volume += block.row(PointRows<2>::volume)[lane]; });
  return volume;
}

}  // namespace

void follow_failure(State& state, LedgerRow& row)
{
  row.front_x = front(state.points);
  row.crest_x = find_crest(state.crest, state.points);
  row.crest_y = crest_height(state.crest, state.points, row.crest_x);
  row.moved_volume = moved_volume(state.points, state.x_initial, moved_distance(state.crest));
  state.crest.time.push_back(row.time);
  state.crest.x.push_back(row.crest_x);
  state.crest.kinetic.push_back(row.kinetic_nodal);
  follow_slip(state);
}

void summarise_failure(const State& state, Summary& s)
{
  s.front_x = front(state.points);
  s.run_out = s.front_x - first_front(state);
  const Real crest = find_crest(state.crest, state.points);
  if (crest > state.crest.columns.left) {
    s.crest_x = crest;
    s.crest_y = crest_height(state.crest, state.points, crest);
  }
  s.moved_distance = moved_distance(state.crest);
  s.moved_volume = moved_volume(state.points, state.x_initial, s.moved_distance);
  const Real volume = total_volume(state.points);
  s.moved_fraction = volume > 0.0 ? s.moved_volume / volume : 0.0;
  const auto slides = find_slides(state.crest);
  for (std::size_t k = 0; k < slides.size(); ++k) s.slides.push_back({slides[k], k < state.slip.size() ? state.slip[k] : SlipSurface{}});
  s.second_failure_time = slides.size() > 1 ? std::optional(slides[1].begins) : std::nullopt;
}

}  // namespace terp
