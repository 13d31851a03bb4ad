// How the slopes of a section fail: front, crest, slides, slip surfaces. Definitions: docs/formats.md. Each ledger row
// enters the crest of each slope, and keeps the slip surface if the strain has never grown faster in this slide.
// Not for: when a slide began and stopped (run/measure/crest, from the rows).

#include "math/errors.hpp"
#include "run/measure/crest.hpp"
#include "mpm/points/moved.hpp"
#include "run/measure/moved_depth.hpp"
#include "run/measure/slip_surface.hpp"
#include "run/measure/followers.hpp"
#include "model/ground/ground_section.hpp"
#include "run/report/ledger.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace terp {
namespace {

// Of a column: fronts that came equally far, as round-off makes even a mirrored slide differ.
constexpr Real same_distance = 0.1;

struct SlopeFailure {
  CrestHistory crest;             ///< without what the other slope took of it
  std::vector<SlipSurface> slip;  ///< of each slide so far, when its strain grew fastest; one before there is any slide
  std::vector<SlipSurface> onset;  ///< of each slide so far, when it was first seen
  Real deep_from = std::nan("");   ///< time from which on ground of below least_depth has moved its way [s]
};

struct Followed {
  Section section;                   ///< at t = 0
  std::vector<SlopeFailure> slopes;  ///< of the section, in its order
  std::array<Real, 2> extent;        ///< smallest and largest x of the ground at t = 0 [m]
  std::vector<std::uint8_t> ground;  ///< which materials are ground; empty: all
  Real least_depth = 0.0;            ///< above which soil ravels, and does not slide [m]
  bool alone() const { return slopes.size() == 1; }
};

/// Number of slides of a slope so far. A new one shows only when the crest has retreated.
std::size_t count_slides(const SlopeFailure& slope)
{
  const auto& x = slope.crest.x;
  const Real out = outwards(slope.crest.slope.facing);
  const bool same = x.size() > 1 && out * x.back() >= out * x[x.size() - 2];
  return same ? slope.onset.size() : find_slides(slope.crest).size();
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
      const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
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
  const std::size_t n_slides = count_slides(slope);
  slope.slip.resize(std::max({std::size_t{1}, slope.slip.size(), n_slides}));
  const bool is_new = n_slides > slope.onset.size();
  const Real rate = context.totals.growth[k] / (time.back() - time[time.size() - 2]);
  if (!is_new && !(rate > slope.slip.back().rate)) return;
  const PointBlocks<2>& points = context.state.points;
  const auto smooth = mean_over_nodes(
      *context.model.mesh, points, growth_of_strain(context.model, context.state, *context.request.memory));
  const Columns columns = columns_of(all, slope.crest.slope);
  SlipSurface now{.time = time.back(), .rate = rate, .line = find_slip_line(points, smooth, columns)};
  if (!all.alone()) now.line = part_below_motion(now.line, points, all.ground, columns, slope.crest.slope.facing);
  if (is_new) slope.onset.resize(n_slides, now);
  if (rate > slope.slip.back().rate) slope.slip.back() = std::move(now);
}

/// Where the fronts of the slopes to the left and to the right are [m]; NaN where nothing came that way yet and the toe
/// is not free.
using Fronts = std::array<Real, 2>;

Fronts find_fronts(const Model& model, const State& state, const Followed& all, const MovedSoil& moved)
{
  Fronts x{std::nan(""), std::nan("")};
  for (const SlopeFailure& slope : all.slopes) {
    const std::size_t side = slope.crest.slope.facing == Facing::left ? 0 : 1;
    x[side] = slope.crest.slope.free_toe ? extent_in_x(*model.mesh, state.points, all.ground)[side]
              : side == 0                ? moved.reach_left
                                         : moved.reach_right;
  }
  return x;
}

Real front_of(const Fronts& x, Facing facing) { return x[facing == Facing::left ? 0 : 1]; }

/// How far the front of a slope has come from where the ground in front of it ended at t = 0, or from the toe of the
/// slope if that is not free [m]; NaN without a front.
Real run_out_of(const Followed& all, const Fronts& fronts, const Slope& slope)
{
  const Real first = slope.free_toe ? front_of(all.extent, slope.facing) : slope.toe;
  const Real distance = outwards(slope.facing) * (front_of(fronts, slope.facing) - first);
  return slope.free_toe || std::isnan(distance) ? distance : std::max(distance, 0.0);
}

SlipSurface of_slide(const std::vector<SlipSurface>& surfaces, std::size_t k)
{
  return k < surfaces.size() ? surfaces[k] : SlipSurface{};
}

/// The slides of a slope. Of two slopes one may merely lose the soil that slides the other way: its front did not come
/// out.
std::vector<SlideSummary> slides_of(const Followed& all, const Fronts& fronts, const SlopeFailure& slope)
{
  std::vector<SlideSummary> list;
  const Real run_out = run_out_of(all, fronts, slope.crest.slope);
  if (all.slopes.size() > 1 && !(slope.crest.slope.free_toe ? run_out > 0.0 : run_out >= 0.0)) return list;
  if (all.least_depth > 0.0 && std::isnan(slope.deep_from)) return list;  // it ravels
  for (Slide slide : find_slides(slope.crest)) {
    slide.begins = std::fmax(slide.begins, slope.deep_from);
    list.push_back({slide, of_slide(slope.slip, list.size()), of_slide(slope.onset, list.size())});
  }
  return list;
}

/// The slope whose front came farthest; the first of those that came equally far; none without slopes.
const SlopeFailure* main_slope(const Followed& all, const Fronts& fronts)
{
  const SlopeFailure* best = nullptr;
  const auto come = [&](const SlopeFailure& slope) {
    const Real distance = run_out_of(all, fronts, slope.crest.slope);
    return std::isnan(distance) ? -1.0 : distance;
  };
  for (const SlopeFailure& slope : all.slopes)
    if (best == nullptr || come(slope) > come(*best) + same_distance * all.section.columns.width) best = &slope;
  return best;
}

/// Which way the ground of each column of the first section went, by its volume: above 0 to the right [m^3].
std::vector<Real> ways_of_columns(const Followed& all, const State& state)
{
  const Columns& columns = all.section.columns;
  std::vector<Real> ways(static_cast<std::size_t>(columns.n), 0.0);
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (!is_ground(all.ground, block)) return;
    const Real first = state.x_initial[2 * static_cast<std::size_t>(block.row(Rows::id)[lane])];
    const Real column = (first - columns.left) / columns.width;
    if (!(column >= 0.0 && column < columns.n)) return;
    ways[static_cast<std::size_t>(column)] += block.row(Rows::volume)[lane] * (block.row(Rows::x)[lane] - first);
  });
  return ways;
}

/// By column: 1 for those of the crest of a slope whose ground went down the other slope. They are no loss of this one.
std::vector<std::uint8_t> taken_by_the_other(
    const Followed& all, const Slope& slope, const std::vector<Real>& heights, const State& state)
{
  std::vector<std::uint8_t> taken(heights.size(), 0);
  const Real tolerance = standing_tolerance(slope.relief);
  const auto fell = [&](Index k) { return !(std::abs(heights[k] - all.section.heights[k]) <= tolerance); };
  bool some = false;
  for (Index k = slope.first; k < slope.last; ++k) some |= fell(k);
  if (!some) return taken;
  const std::vector<Real> ways = ways_of_columns(all, state);
  for (Index k = slope.first; k < slope.last; ++k) taken[k] = fell(k) && outwards(slope.facing) * ways[k] < 0.0;
  return taken;
}

/// The crest [m]; the side behind it if nothing stands. taken: as of find_standing.
Real crest_of(
    const Followed& all, const Slope& slope, const std::vector<Real>& heights, std::span<const std::uint8_t> taken = {})
{
  const Real x = find_crest(all.section, slope, find_standing(all.section, slope, all.alone(), heights, taken));
  return std::isnan(x) ? back_of(all.section, slope) : x;
}

/// The crest, or farther out where what is gone slid down the other slope [m].
Real own_crest(const Followed& all, const Slope& slope, const std::vector<Real>& heights, const State& state)
{
  const Real x = crest_of(all, slope, heights);
  if (all.alone()) return x;
  const Real kept = crest_of(all, slope, heights, taken_by_the_other(all, slope, heights, state));
  return outwards(slope.facing) * kept > outwards(slope.facing) * x ? kept : x;
}

std::optional<Real> finite(Real value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

SlipSurface next_slip(const Real* head, const std::vector<Real>& places, std::size_t& next)
{
  SlipSurface slip{.time = head[0], .rate = head[1], .line = {}};
  for (Real n = head[2]; n > 0.5 && next + 1 < places.size(); n -= 1.0, next += 2)
    slip.line.push_back({places[next], places[next + 1]});
  return slip;
}

/// Time, rate and number of places of each slip surface, and the places of all.
void save_surfaces(const std::vector<SlipSurface>& all, const std::string& name, const ArrayWriter& arrays)
{
  std::vector<Real> surfaces, places;
  for (const SlipSurface& slip : all) {
    surfaces.insert(surfaces.end(), {slip.time, slip.rate, static_cast<Real>(slip.line.size())});
    for (const Vec<2>& x : slip.line) places.insert(places.end(), {x[0], x[1]});
  }
  ArrayWriter below = arrays;
  below.copy(name + "_surfaces", std::move(surfaces));
  below.copy(name + "_places", std::move(places));
}

std::vector<SlipSurface> load_surfaces(const std::string& name, const ArrayReader& arrays)
{
  std::vector<SlipSurface> all;
  const auto &surfaces = arrays.reals(name + "_surfaces"), &places = arrays.reals(name + "_places");
  std::size_t next = 0;
  for (std::size_t j = 0; j + 2 < surfaces.size(); j += 3) all.push_back(next_slip(&surfaces[j], places, next));
  return all;
}

void save_slides(const std::vector<SlideSummary>& slides, ArrayWriter arrays)
{
  std::vector<Real> values;
  std::vector<SlipSurface> slips, onsets;
  for (const auto& [slide, slip, onset, stage] : slides) {
    values.insert(values.end(), {slide.begins, slide.stops.value_or(std::nan("")), slide.crest_from, slide.crest_to,
                                    slide.kinetic_peak, outwards(slide.facing)});
    slips.push_back(slip);
    onsets.push_back(onset);
  }
  arrays.copy("slides", std::move(values));
  save_surfaces(slips, "slip", arrays);
  save_surfaces(onsets, "onset", arrays);
}

std::vector<SlideSummary> load_slides(const ArrayReader& arrays)
{
  const std::vector<Real>& values = arrays.reals("slides");
  const std::vector<SlipSurface> slips = load_surfaces("slip", arrays), onsets = load_surfaces("onset", arrays);
  std::vector<SlideSummary> slides;
  for (std::size_t k = 0; 6 * k + 5 < values.size() && k < std::min(slips.size(), onsets.size()); ++k) {
    const Real* v = &values[6 * k];
    const Facing facing = v[5] < 0.0 ? Facing::left : Facing::right;
    slides.push_back({{v[0], finite(v[1]), v[2], v[3], v[4], facing}, slips[k], onsets[k]});
  }
  return slides;
}

class Slopes : public Follower {
  Followed all_;
  std::vector<SlideSummary> before_;  ///< that began before displacement was last counted anew

  void start(const Model& model, const State& state) override
  {
    const auto ground = ground_of(model);
    all_ = {.section = first_section(model, state.points, ground),
        .slopes = {},
        .extent = extent_in_x(*model.mesh, state.points, ground),
        .ground = ground,
        .least_depth = model.description.flood.least_depth};
    before_.clear();
    find_slopes_of_section();
  }

  void count_displacement_anew(const Model& model, const State& state) override
  {
    std::vector<SlideSummary> slides = all_slides(find_fronts(model, state, all_, moved_of(state)));
    start(model, state);
    before_ = std::move(slides);
  }

  /// Of all stages, in order of time.
  std::vector<SlideSummary> all_slides(const Fronts& fronts) const
  {
    std::vector<SlideSummary> slides = before_;
    for (const SlopeFailure& slope : all_.slopes)
      for (SlideSummary& slide : slides_of(all_, fronts, slope)) slides.push_back(std::move(slide));
    std::ranges::stable_sort(slides, {}, [](const SlideSummary& slide) { return slide.slide.begins; });
    return slides;
  }

  MovedSoil moved_of(const State& state) const
  {
    return find_moved(state.points, state.x_initial, moved_distance(all_.section), all_.ground);
  }

  void find_slopes_of_section()
  {
    const Columns& columns = all_.section.columns;
    const auto slopes = find_slopes(all_.section);
    for (const Slope& slope : slopes) {
      CrestHistory crest{.slope = slope, .width = columns.width, .time = {}, .x = {}, .kinetic = {}};
      if (slopes.size() > 1)
        crest.ends = columns.left + columns.width * (slope.facing == Facing::right ? slope.first : slope.last);
      all_.slopes.push_back({std::move(crest), {}, {}});
    }
  }

  void request(TotalsRequest& request) override
  {
    request.moved_distance = moved_distance(all_.section);
    request.ground = all_.ground;
    for (const SlopeFailure& slope : all_.slopes) request.shear.push_back(columns_of(all_, slope.crest.slope));
  }

  void row(const LedgerContext& context, std::span<Real> values) override
  {
    const State& state = context.state;
    const Fronts fronts = find_fronts(context.model, state, all_, context.totals.moved);
    const auto heights = surface_heights(*context.model.mesh, state.points, all_.section.columns, all_.ground);
    if (all_.least_depth > 0.0) look_deep(state);
    for (std::size_t k = 0; k < all_.slopes.size(); ++k) {
      CrestHistory& crest = all_.slopes[k].crest;
      const Standing standing = find_standing(all_.section, crest.slope, all_.alone(), heights);
      crest.time.push_back(state.time);
      crest.x.push_back(own_crest(all_, crest.slope, heights, state));
      crest.kinetic.push_back(context.kinetic_nodal);
      Real* const of_slope = &values[crest.slope.facing == Facing::left ? 3 : 0];
      of_slope[0] = front_of(fronts, crest.slope.facing);
      of_slope[1] = crest_of(all_, crest.slope, heights);
      of_slope[2] = crest_height(all_.section, crest.slope, standing, heights);
      follow_slip(context, k, all_);
    }
  }

  void look_deep(const State& state)
  {
    const MovedByDepth moved = moved_by_depth(
        state.points, state.x_initial, moved_distance(all_.section), all_.section, all_.ground, all_.least_depth);
    for (SlopeFailure& slope : all_.slopes)
      if (std::isnan(slope.deep_from) && moved.deep(slope.crest.slope.facing) > least_deep_volume(all_.section))
        slope.deep_from = state.time;
  }

  void summarise(const Model& model, const State& state, Summary& s) const override
  {
    const Fronts fronts = find_fronts(model, state, all_, moved_of(state));
    if (const SlopeFailure* main = main_slope(all_, fronts)) summarise_slope(model, state, fronts, *main, s);
    s.slides = all_slides(fronts);
    for (SlideSummary& slide : s.slides) slide.stage = stage_at(s.stages, slide.slide.begins);
    if (!s.slides.empty()) s.first_slide_time = s.slides.front().slide.begins;
  }

  void summarise_slope(
      const Model& model, const State& state, const Fronts& fronts, const SlopeFailure& main, Summary& s) const
  {
    const Slope& slope = main.crest.slope;
    s.facing = slope.facing;
    s.free_toe = slope.free_toe;
    s.front_x = front_of(fronts, slope.facing);
    s.run_out = run_out_of(all_, fronts, slope);
    const auto heights = surface_heights(*model.mesh, state.points, all_.section.columns, all_.ground);
    const Standing standing = find_standing(all_.section, slope, all_.alone(), heights);
    s.crest_x = finite(find_crest(all_.section, slope, standing));
    s.crest_y = finite(crest_height(all_.section, slope, standing, heights));
    const auto slides = slides_of(all_, fronts, main);
    s.second_failure_time = slides.size() > 1 ? std::optional(slides[1].slide.begins) : std::nullopt;
  }

  /// The first surface and extent, slides before, and of each slope its crest over time and its slip surfaces.
  void save(ArrayWriter& arrays) const override
  {
    const Columns& columns = all_.section.columns;
    arrays.refer("heights", all_.section.heights);
    arrays.copy("columns", std::vector<Real>{columns.left, columns.width, all_.section.base});
    arrays.copy("extent", std::vector<Real>{all_.extent[0], all_.extent[1]});
    save_slides(before_, arrays.below("before"));
    for (std::size_t k = 0; k < all_.slopes.size(); ++k) {
      const SlopeFailure& slope = all_.slopes[k];
      ArrayWriter of_slope = arrays.below(fmt::format("slope_{}", k));
      of_slope.refer("time", slope.crest.time);
      of_slope.refer("crest", slope.crest.x);
      of_slope.refer("kinetic", slope.crest.kinetic);
      if (all_.least_depth > 0.0) of_slope.copy("deep_from", std::vector<Real>{slope.deep_from});
      save_surfaces(slope.slip, "slip", of_slope);
      save_surfaces(slope.onset, "onset", of_slope);
    }
  }

  void load(const Model& model, const State&, const ArrayReader& arrays) override
  {
    const auto &heights = arrays.reals("heights"), &columns = arrays.reals("columns", 3),
               &extent = arrays.reals("extent", 2);
    const bool fits = !heights.empty() && std::isfinite(columns[0]) && std::isfinite(columns[1]) && columns[1] > 0.0;
    if (!fits) throw FileError("the checkpoint does not fit this case: its first surface has no columns");
    all_ = {{{columns[0], columns[1], static_cast<Index>(heights.size())}, heights, columns[2]}, {},
        {extent[0], extent[1]}, ground_of(model), model.description.flood.least_depth};
    before_ = load_slides(arrays.below("before"));
    find_slopes_of_section();
    for (std::size_t k = 0; k < all_.slopes.size(); ++k) {
      const ArrayReader of_slope = arrays.below(fmt::format("slope_{}", k));
      CrestHistory& crest = all_.slopes[k].crest;
      crest.time = of_slope.reals("time");
      crest.x = of_slope.reals("crest", crest.time.size());
      crest.kinetic = of_slope.reals("kinetic", crest.time.size());
      if (all_.least_depth > 0.0) all_.slopes[k].deep_from = of_slope.reals("deep_from", 1)[0];
      all_.slopes[k].slip = load_surfaces("slip", of_slope);
      all_.slopes[k].onset = load_surfaces("onset", of_slope);
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
