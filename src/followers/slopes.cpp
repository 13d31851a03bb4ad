// How the slopes of a section fail: front, crest, slides, slip surfaces. Definitions: docs/formats.md. Each ledger row
// enters the crest of each slope, and keeps the slip surface if the strain has never grown faster in this slide.
// Not for: when a slide began and stopped (events/crest, from the rows).

#include "base/errors.hpp"
#include "events/crest.hpp"
#include "events/moved.hpp"
#include "events/slip_surface.hpp"
#include "followers/first_section.hpp"
#include "followers/followers.hpp"
#include "simulation/ledger.hpp"
#include "simulation/state_arrays.hpp"
#include "simulation/summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace terp {
namespace {

// Of a column: fronts that came equally far, as round-off makes even a mirrored slide differ.
constexpr Real same_distance = 0.1;

struct SlopeFailure {
  CrestHistory crest;
  std::vector<SlipSurface> slip;  ///< of each slide so far, when its strain grew fastest; one before there is any slide
};

struct Followed {
  Section section;                   ///< at t = 0
  std::vector<SlopeFailure> slopes;  ///< of the section, in its order
};

/// Number of slides of a slope so far. A new one shows only when the crest has retreated.
std::size_t count_slides(const SlopeFailure& slope)
{
  const auto& x = slope.crest.x;
  const Real out = outwards(slope.crest.slope.facing);
  const bool same = x.size() > 1 && out * x.back() >= out * x[x.size() - 2];
  return same ? slope.slip.size() : find_slides(slope.crest).size();
}

/// Columns in which a slope may shear: all but those beyond the toe of the other slope.
Columns columns_of(const Followed& all, const Slope& slope)
{
  Columns columns = all.section.columns;
  for (const SlopeFailure& other : all.slopes) {
    if (other.crest.slope.facing == slope.facing) continue;
    const auto k = static_cast<Index>(std::llround((other.crest.slope.toe - columns.left) / columns.width));
    if (slope.facing == Facing::left) return {columns.left, columns.width, k};
    return {columns.left + k * columns.width, columns.width, columns.n - k};
  }
  return columns;
}

/// Growth of eps_eq_p since the last ledger row, in the order of for_each_point; seven digits are enough. Below 0 where
/// MPM-Mixed averages it away.
std::vector<float> growth_of_strain(const Model& model, const State& state, const StrainMemory& memory)
{
  std::vector<float> growth;
  growth.reserve(static_cast<std::size_t>(state.points.n_points()));
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const int strain = row_of(model.materials[block.material], Role::plastic_strain);
    for (Index lane = 0; lane < block.n; ++lane) {
      const auto id = static_cast<std::size_t>(block.row(PointRows<2>::id)[lane]);
      growth.push_back(strain < 0 ? 0.0f : static_cast<float>(block.row(strain)[lane] - memory.last_eps_eq_p[id]));
    }
  });
  return growth;
}

void follow_slip(const LedgerContext& context, std::size_t k, Followed& all)
{
  SlopeFailure& slope = all.slopes[k];
  const auto& time = slope.crest.time;
  if (time.size() < 2 || context.request.memory == nullptr) return;
  slope.slip.resize(std::max({std::size_t{1}, slope.slip.size(), count_slides(slope)}));
  SlipSurface& slip = slope.slip.back();
  const Real rate = context.totals.growth[k] / (time.back() - time[time.size() - 2]);
  if (!(rate > slip.rate)) return;
  const PointBlocks<2>& points = context.state.points;
  const auto smooth = mean_over_nodes(
      *context.model.mesh, points, growth_of_strain(context.model, context.state, *context.request.memory));
  slip = {
      .time = time.back(), .rate = rate, .line = find_slip_line(points, smooth, columns_of(all, slope.crest.slope))};
}

/// Where the fronts of the slopes to the left and to the right are [m]; NaN where nothing came that way yet and the toe
/// is not free.
using Fronts = std::array<Real, 2>;

Fronts find_fronts(const Model& model, const State& state, const Followed& all, const MovedSoil& moved)
{
  Fronts x{std::nan(""), std::nan("")};
  for (const SlopeFailure& slope : all.slopes) {
    const std::size_t side = slope.crest.slope.facing == Facing::left ? 0 : 1;
    x[side] = slope.crest.slope.free_toe ? extent_in_x(*model.mesh, state.points)[side]
              : side == 0                ? moved.reach_left
                                         : moved.reach_right;
  }
  return x;
}

Real front_of(const Fronts& x, Facing facing) { return x[facing == Facing::left ? 0 : 1]; }

/// Where the soil in front of a slope ended at t = 0, or the toe of the slope if it is not free [m].
Real first_front(const State& state, const Slope& slope)
{
  if (!slope.free_toe || state.x_initial.empty()) return slope.toe;
  const Real out = outwards(slope.facing);
  Real x = state.x_initial[0];
  for (std::size_t k = 0; k < state.x_initial.size(); k += 2)
    if (out * state.x_initial[k] > out * x) x = state.x_initial[k];
  return x;
}

/// How far the front of a slope has come [m]; NaN without a front.
Real run_out_of(const State& state, const Fronts& fronts, const Slope& slope)
{
  const Real distance = outwards(slope.facing) * (front_of(fronts, slope.facing) - first_front(state, slope));
  return slope.free_toe || std::isnan(distance) ? distance : std::max(distance, 0.0);
}

/// The slides of a slope. Of two slopes one may merely lose the soil that slides the other way: its front did not come
/// out.
std::vector<SlideSummary> slides_of(
    const State& state, const Followed& all, const Fronts& fronts, const SlopeFailure& slope)
{
  std::vector<SlideSummary> list;
  const Real run_out = run_out_of(state, fronts, slope.crest.slope);
  if (all.slopes.size() > 1 && !(slope.crest.slope.free_toe ? run_out > 0.0 : run_out >= 0.0)) return list;
  for (const Slide& slide : find_slides(slope.crest))
    list.push_back({slide, list.size() < slope.slip.size() ? slope.slip[list.size()] : SlipSurface{}});
  return list;
}

/// The slope whose front came farthest; the first of those that came equally far; none without slopes.
const SlopeFailure* main_slope(const State& state, const Followed& all, const Fronts& fronts)
{
  const SlopeFailure* best = nullptr;
  const auto come = [&](const SlopeFailure& slope) {
    const Real distance = run_out_of(state, fronts, slope.crest.slope);
    return std::isnan(distance) ? -1.0 : distance;
  };
  for (const SlopeFailure& slope : all.slopes)
    if (best == nullptr || come(slope) > come(*best) + same_distance * all.section.columns.width) best = &slope;
  return best;
}

std::optional<Real> finite(Real value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

SlipSurface next_slip(const Real* head, const std::vector<Real>& places, std::size_t& next)
{
  SlipSurface slip{.time = head[0], .rate = head[1], .line = {}};
  for (Real n = head[2]; n > 0.5 && next + 1 < places.size(); n -= 1.0, next += 2)
    slip.line.push_back({places[next], places[next + 1]});
  return slip;
}

class Slopes : public Follower {
  Followed all_;

  void start(const Model& model, const State& state) override
  {
    all_ = {.section = first_section(*model.mesh, state.points), .slopes = {}};
    find_slopes_of_section();
  }

  void find_slopes_of_section()
  {
    for (const Slope& slope : find_slopes(all_.section))
      all_.slopes.push_back(
          {{.slope = slope, .width = all_.section.columns.width, .time = {}, .x = {}, .kinetic = {}}, {}});
  }

  void request(TotalsRequest& request) override
  {
    request.moved_distance = moved_distance(all_.section);
    for (const SlopeFailure& slope : all_.slopes) request.shear.push_back(columns_of(all_, slope.crest.slope));
  }

  void row(const LedgerContext& context, std::span<Real> values) override
  {
    const State& state = context.state;
    const Fronts fronts = find_fronts(context.model, state, all_, context.totals.moved);
    const auto heights = surface_heights(*context.model.mesh, state.points, all_.section.columns);
    for (std::size_t k = 0; k < all_.slopes.size(); ++k) {
      CrestHistory& crest = all_.slopes[k].crest;
      const Standing standing = find_standing(all_.section, crest.slope, all_.slopes.size() == 1, heights);
      const Real x = find_crest(all_.section, crest.slope, standing);
      crest.time.push_back(state.time);
      crest.x.push_back(std::isnan(x) ? back_of(all_.section, crest.slope) : x);
      crest.kinetic.push_back(context.kinetic_nodal);
      Real* const of_slope = &values[crest.slope.facing == Facing::left ? 3 : 0];
      of_slope[0] = front_of(fronts, crest.slope.facing);
      of_slope[1] = crest.x.back();
      of_slope[2] = crest_height(all_.section, crest.slope, standing, heights);
      follow_slip(context, k, all_);
    }
  }

  void summarise(const Model& model, const State& state, Summary& s) const override
  {
    const MovedSoil moved = find_moved(state.points, state.x_initial, moved_distance(all_.section));
    const Fronts fronts = find_fronts(model, state, all_, moved);
    if (const SlopeFailure* main = main_slope(state, all_, fronts)) summarise_slope(model, state, fronts, *main, s);
    for (const SlopeFailure& slope : all_.slopes)
      for (SlideSummary& slide : slides_of(state, all_, fronts, slope)) s.slides.push_back(std::move(slide));
    std::ranges::stable_sort(s.slides, {}, [](const SlideSummary& slide) { return slide.slide.begins; });
  }

  void summarise_slope(
      const Model& model, const State& state, const Fronts& fronts, const SlopeFailure& main, Summary& s) const
  {
    const Slope& slope = main.crest.slope;
    s.facing = slope.facing;
    s.free_toe = slope.free_toe;
    s.front_x = front_of(fronts, slope.facing);
    s.run_out = run_out_of(state, fronts, slope);
    const auto heights = surface_heights(*model.mesh, state.points, all_.section.columns);
    const Standing standing = find_standing(all_.section, slope, all_.slopes.size() == 1, heights);
    s.crest_x = finite(find_crest(all_.section, slope, standing));
    s.crest_y = finite(crest_height(all_.section, slope, standing, heights));
    const auto slides = slides_of(state, all_, fronts, main);
    s.second_failure_time = slides.size() > 1 ? std::optional(slides[1].slide.begins) : std::nullopt;
  }

  /// The first surface, and of each slope its crest over time; time, rate and number of places of each slip surface,
  /// and the places of all.
  void save(ArrayWriter& arrays) const override
  {
    const Columns& columns = all_.section.columns;
    arrays.refer("heights", all_.section.heights);
    arrays.copy("columns", std::vector<Real>{columns.left, columns.width, all_.section.base});
    for (std::size_t k = 0; k < all_.slopes.size(); ++k) {
      const SlopeFailure& slope = all_.slopes[k];
      ArrayWriter of_slope = arrays.below(fmt::format("slope_{}", k));
      of_slope.refer("time", slope.crest.time);
      of_slope.refer("crest", slope.crest.x);
      of_slope.refer("kinetic", slope.crest.kinetic);
      std::vector<Real> surfaces, places;
      for (const SlipSurface& slip : slope.slip) {
        surfaces.insert(surfaces.end(), {slip.time, slip.rate, static_cast<Real>(slip.line.size())});
        for (const Vec<2>& x : slip.line) places.insert(places.end(), {x[0], x[1]});
      }
      of_slope.copy("slip_surfaces", std::move(surfaces));
      of_slope.copy("slip_places", std::move(places));
    }
  }

  /// The slopes follow from the first surface.
  void load(const Model&, const State&, const ArrayReader& arrays) override
  {
    const auto &heights = arrays.reals("heights"), &columns = arrays.reals("columns", 3);
    const bool fits = !heights.empty() && std::isfinite(columns[0]) && std::isfinite(columns[1]) && columns[1] > 0.0;
    if (!fits) throw FileError("the checkpoint does not fit this case: its first surface has no columns");
    all_ = {{{columns[0], columns[1], static_cast<Index>(heights.size())}, heights, columns[2]}, {}};
    find_slopes_of_section();
    for (std::size_t k = 0; k < all_.slopes.size(); ++k) {
      const ArrayReader of_slope = arrays.below(fmt::format("slope_{}", k));
      CrestHistory& crest = all_.slopes[k].crest;
      crest.time = of_slope.reals("time");
      crest.x = of_slope.reals("crest", crest.time.size());
      crest.kinetic = of_slope.reals("kinetic", crest.time.size());
      const auto &surfaces = of_slope.reals("slip_surfaces"), &places = of_slope.reals("slip_places");
      std::size_t next = 0;
      for (std::size_t j = 0; j + 2 < surfaces.size(); j += 3)
        all_.slopes[k].slip.push_back(next_slip(&surfaces[j], places, next));
    }
  }
};

}  // namespace

const FollowerType slopes_follower{.name = "slopes",
    .columns = {{"front_x", "m", "front", "front of the slope to the right (Front, crest and slides)"},
        {"crest_x", "m", "crest", "x of the crest of the slope to the right"},
        {"crest_y", "m", "height of the crest", "height of the surface there"},
        {"front_left_x", "m", "front to the left", "front of the slope to the left"},
        {"crest_left_x", "m", "crest to the left", "x of the crest of the slope to the left"},
        {"crest_left_y", "m", "height of the crest to the left", "height of the surface there"}},
    .make = make_follower<Slopes>};

}  // namespace terp
