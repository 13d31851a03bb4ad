#include "simulation/failure.hpp"

#include "simulation/ledger.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real same_way =
    0.1;  // of a column: fronts that came equally far, as round-off makes even a mirrored slide differ

/// Number of slides of a slope so far. A new one shows only when the crest has retreated.
std::size_t count_slides(const SlopeFailure& slope)
{
  const auto& x = slope.crest.x;
  const Real out = outwards(slope.crest.slope.facing);
  const bool same = x.size() > 1 && out * x.back() >= out * x[x.size() - 2];
  return same ? slope.slip.size() : find_slides(slope.crest).size();
}

/// Columns in which a slope may shear: all but those beyond the toe of the other slope.
Columns columns_of(const State& state, const Slope& slope)
{
  Columns columns = state.section.columns;
  for (const SlopeFailure& other : state.slopes) {
    if (other.crest.slope.facing == slope.facing) continue;
    const auto k = static_cast<Index>(std::llround((other.crest.slope.toe - columns.left) / columns.width));
    if (slope.facing == Facing::left) return {columns.left, columns.width, k};
    return {columns.left + k * columns.width, columns.width, columns.n - k};
  }
  return columns;
}

/// Growth of eps_eq_p since the last ledger row, in the order of for_each_point; seven digits are enough. Below 0 where
/// MPM-Mixed averages it away.
std::vector<float> growth_of_strain(const Model& model, const State& state)
{
  std::vector<float> growth;
  growth.reserve(static_cast<std::size_t>(state.points.n_points()));
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const int strain = row_of(model.materials[block.material], Role::plastic_strain);
    for (Index lane = 0; lane < block.n; ++lane) {
      const auto id = static_cast<std::size_t>(block.row(PointRows<2>::id)[lane]);
      growth.push_back(strain < 0 ? 0.0f : static_cast<float>(block.row(strain)[lane] - state.audit.last_eps_eq_p[id]));
    }
  });
  return growth;
}

/// growth: of the strain, summed over the volume that belongs to the slope [m^2].
void follow_slip(const Model& model, const State& state, Real growth, SlopeFailure& slope)
{
  const auto& time = slope.crest.time;
  if (time.size() < 2) return;
  slope.slip.resize(std::max({std::size_t{1}, slope.slip.size(), count_slides(slope)}));
  SlipSurface& slip = slope.slip.back();
  const Real rate = growth / (time.back() - time[time.size() - 2]);
  if (!(rate > slip.rate)) return;
  const auto smooth = mean_over_nodes(*model.mesh, state.points, growth_of_strain(model, state));
  slip = {.time = time.back(),
      .rate = rate,
      .line = find_slip_line(state.points, smooth, columns_of(state, slope.crest.slope))};
}

/// Where the fronts of the slopes to the left and to the right are [m]; NaN where nothing came that way yet and the toe
/// is not free.
using Fronts = std::array<Real, 2>;

Fronts find_fronts(const Model& model, const State& state, const MovedSoil& moved)
{
  Fronts x{std::nan(""), std::nan("")};
  for (const SlopeFailure& slope : state.slopes) {
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
  const Real way = outwards(slope.facing) * (front_of(fronts, slope.facing) - first_front(state, slope));
  return slope.free_toe || std::isnan(way) ? way : std::max(way, 0.0);
}

/// The slides of a slope. Of two slopes one may merely lose the soil that slides the other way: its front did not come
/// out.
std::vector<SlideSummary> slides_of(const State& state, const Fronts& fronts, const SlopeFailure& slope)
{
  std::vector<SlideSummary> list;
  const Real run_out = run_out_of(state, fronts, slope.crest.slope);
  if (state.slopes.size() > 1 && !(slope.crest.slope.free_toe ? run_out > 0.0 : run_out >= 0.0)) return list;
  for (const Slide& slide : find_slides(slope.crest))
    list.push_back({slide, list.size() < slope.slip.size() ? slope.slip[list.size()] : SlipSurface{}});
  return list;
}

/// The slope whose front came farthest; the first of those that came equally far; none without slopes.
const SlopeFailure* main_slope(const State& state, const Fronts& fronts)
{
  const SlopeFailure* best = nullptr;
  const auto come = [&](const SlopeFailure& slope) {
    const Real way = run_out_of(state, fronts, slope.crest.slope);
    return std::isnan(way) ? -1.0 : way;
  };
  for (const SlopeFailure& slope : state.slopes)
    if (best == nullptr || come(slope) > come(*best) + same_way * state.section.columns.width) best = &slope;
  return best;
}

Real volume_that_left(const State& state)
{
  Real volume = 0.0;
  for (const LeftPoint& p : state.left) volume += p.volume;
  return volume;
}

Real total_volume(const PointBlocks<2>& points)
{
  Real volume = 0.0;
  for_each_point(
      points, [&](const PointBlock<2>& block, Index lane) { volume += block.row(PointRows<2>::volume)[lane]; });
  return volume;
}

std::optional<Real> finite(Real value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

void summarise_slope(const Model& model, const State& state, const Fronts& fronts, const SlopeFailure& main, Summary& s)
{
  const Slope& slope = main.crest.slope;
  s.facing = slope.facing;
  s.free_toe = slope.free_toe;
  s.front_x = front_of(fronts, slope.facing);
  s.run_out = run_out_of(state, fronts, slope);
  const auto heights = surface_heights(*model.mesh, state.points, state.section.columns);
  const Standing standing = find_standing(state.section, slope, state.slopes.size() == 1, heights);
  s.crest_x = finite(find_crest(state.section, slope, standing));
  s.crest_y = finite(crest_height(state.section, slope, standing, heights));
  const auto slides = slides_of(state, fronts, main);
  s.second_failure_time = slides.size() > 1 ? std::optional(slides[1].slide.begins) : std::nullopt;
}

}  // namespace

void start_following(const Model& model, Columns columns, State& state)
{
  state.section = look_at_section(*model.mesh, state.points, columns);
  state.slopes.clear();
  for (const Slope& slope : find_slopes(state.section))
    state.slopes.push_back({{.slope = slope, .width = columns.width, .time = {}, .x = {}, .kinetic = {}}, {}});
}

std::vector<Columns> shear_columns(const State& state)
{
  std::vector<Columns> columns;
  for (const SlopeFailure& slope : state.slopes) columns.push_back(columns_of(state, slope.crest.slope));
  return columns;
}

void follow_failure(const LedgerContext& context, State& state, std::span<Real> values)
{
  const Model& model = context.model;
  const Fronts fronts = find_fronts(model, state, context.totals.moved);
  const auto heights = surface_heights(*model.mesh, state.points, state.section.columns);
  values.back() = context.totals.moved.volume + volume_that_left(state);
  for (std::size_t k = 0; k < state.slopes.size(); ++k) {
    SlopeFailure& slope = state.slopes[k];
    CrestHistory& crest = slope.crest;
    const Standing standing = find_standing(state.section, crest.slope, state.slopes.size() == 1, heights);
    const Real x = find_crest(state.section, crest.slope, standing);
    crest.time.push_back(state.time);
    crest.x.push_back(std::isnan(x) ? back_of(state.section, crest.slope) : x);
    crest.kinetic.push_back(context.kinetic_nodal);
    Real* const of_slope = &values[crest.slope.facing == Facing::left ? 3 : 0];
    of_slope[0] = front_of(fronts, crest.slope.facing);
    of_slope[1] = crest.x.back();
    of_slope[2] = crest_height(state.section, crest.slope, standing, heights);
    follow_slip(model, state, context.totals.growth[k], slope);
  }
}

void summarise_failure(const Model& model, const State& state, Summary& s)
{
  s.moved_distance = moved_distance(state.section);
  const MovedSoil moved = find_moved(state.points, state.x_initial, s.moved_distance);
  const Fronts fronts = find_fronts(model, state, moved);
  if (const SlopeFailure* main = main_slope(state, fronts)) summarise_slope(model, state, fronts, *main, s);
  for (const SlopeFailure& slope : state.slopes)
    for (SlideSummary& slide : slides_of(state, fronts, slope)) s.slides.push_back(std::move(slide));
  std::stable_sort(
      s.slides.begin(), s.slides.end(), [](const auto& a, const auto& b) { return a.slide.begins < b.slide.begins; });
  const Real left = volume_that_left(state), volume = total_volume(state.points) + left;
  s.moved_volume = moved.volume + left;
  s.moved_fraction = volume > 0.0 ? s.moved_volume / volume : 0.0;
  std::vector<int> strain_rows;
  for (const SoilMaterial& material : model.materials) strain_rows.push_back(row_of(material, Role::plastic_strain));
  s.intact_fraction = finite(intact_share(state.points, state.x_initial, s.moved_distance, strain_rows));
}

}  // namespace terp
