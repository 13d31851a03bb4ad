// Where the work of the water comes from: from free water that sinks where soil makes room, and from water that enters
// soil as it opens. Neither is found from the forces, so that the three can differ. docs/methods.md, "Water".

#include "math/nan.hpp"
#include "model/water/carried_water.hpp"
#include "model/water/nodal_water.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/measure/followers.hpp"
#include "run/report/ledger.hpp"
#include "run/report/ledger_context.hpp"
#include "run/report/summary.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr std::int64_t first_judged = 20;  // step from which on the work is more than a swing
constexpr int per_cell = 4;  // columns of ground in the width of a cell: no narrower than points lie apart

/// To which the mesh reaches down in the middle of each column, or at its end where that lies beyond it [m].
std::vector<Real> lowest_of_mesh(const Mesh<2>& mesh, const Columns& columns)
{
  std::vector<Real> lowest(static_cast<std::size_t>(columns.n), std::numeric_limits<Real>::infinity());
  for (const auto& cell : mesh.cells)
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const Vec<2>*a = &mesh.nodes[cell[i]], *b = &mesh.nodes[cell[(i + 1) % cell.size()]];
      if ((*a)[0] > (*b)[0]) std::swap(a, b);
      const auto column = [&](Real x) { return (x - columns.left) / columns.width - 0.5; };
      const auto first = static_cast<Index>(std::ceil(column((*a)[0]))),
                 last = static_cast<Index>(std::min(std::floor(column((*b)[0])), columns.n - 1.0));
      for (Index k = first; k <= last; ++k) {
        const Real x = columns.left + (k + 0.5) * columns.width, width = (*b)[0] - (*a)[0];
        const Real y = width > 0.0 ? std::lerp((*a)[1], (*b)[1], (x - (*a)[0]) / width) : std::min((*a)[1], (*b)[1]);
        lowest[static_cast<std::size_t>(k)] = std::min(lowest[static_cast<std::size_t>(k)], y);
      }
    }
  for (std::size_t k = 1; k < lowest.size(); ++k)
    if (std::isinf(lowest[k])) lowest[k] = lowest[k - 1];
  return lowest;
}

/// The ground by columns, of the volume of soil in each: it knows no gaps below [m].
std::vector<Real> ground_by_volume(const Model& model, const State& state, const Columns& columns)
{
  std::vector<Real> ground = lowest_of_mesh(*model.mesh, columns);
  const auto enter = [&](Real x, Real volume) {
    const Real size = std::sqrt(volume), low = (x - 0.5 * size - columns.left) / columns.width,
               high = low + size / columns.width;
    const auto inside = [&](Real k) { return static_cast<Index>(std::clamp(std::floor(k), 0.0, columns.n - 1.0)); };
    const Index first = inside(low), last = inside(high);
    for (Index k = first; k <= last; ++k) {  // what reaches beyond the mesh is in its first or last column
      const Real from = k == first ? low : static_cast<Real>(k), to = k == last ? high : k + 1.0;
      ground[static_cast<std::size_t>(k)] += size * (to - from);
    }
  };
  for_each_point(state.points,
      [&](const PointBlock<2>& block, Index lane) { enter(block.row(Rows::x)[lane], block.row(Rows::volume)[lane]); });
  for (const LeftPoint& p : state.left) enter(p.x[0], p.volume);
  return ground;
}

/// What the water was at a row of the ledger.
struct Look {
  std::vector<Real> ground, free;  ///< by columns [m]; free: to which water stands there, minus infinity: none
  std::vector<Real> pressure;      ///< of the water in the soil, by nodes [Pa]
  Real bodies = 0.0;               ///< mass that stages placed and dug away so far [kg per m]
};

/// Whether the model says where its water is, and that stands level.
bool is_known(const Model& model)
{
  return model.nodal_water && model.nodal_water->drawn() != nullptr && model.gravity[0] == 0.0;
}

/// Of a model whose water is known.
Look look_at_water(const Model& model, const State& state)
{
  const DrawnWater& drawn = *model.nodal_water->drawn();
  const Columns columns{drawn.columns.left, drawn.columns.width / per_cell, drawn.columns.n * per_cell};
  Look look;
  look.ground = ground_by_volume(model, state, columns);
  look.bodies = state.mass_placed + state.mass_removed;
  const WaterWay way = water_way(model, state.time);
  std::vector<Real> level, drawn_ground;
  for (Index k = 0; k < columns.n; ++k) {
    const auto of = static_cast<std::size_t>(k / per_cell);
    level.push_back(std::lerp(drawn.levels[way.from][of], drawn.levels[way.to][of], way.share));
    drawn_ground.push_back(drawn.ground[of]);
  }
  look.free = free_water(level, drawn_ground, look.ground, walls_between(columns, model.description.water.walls));
  const PorePressure pore = water_at(model, state);
  look.pressure = pore.pressure;
  for (std::size_t i = 0; i < pore.suction.size(); ++i) look.pressure[i] -= pore.suction[i];
  return look;
}

/// Energy of the water that entered soil as it opened, and moves with it, in a field of pressures [J per m].
Real energy_in_soil(const Model& model, const State& state, const std::vector<Real>& pressure)
{
  Real energy = 0.0;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& material = model.materials[block.material];
    if (!material.stores_effective) return;
    const auto N = Quad4::shape_functions(std::array{block.row(Rows::xi)[lane], block.row(Rows::xi + 1)[lane]});
    Real here = 0.0;
    for (int i = 0; i < Quad4::n_corners; ++i)
      here += N[i] * pressure[static_cast<std::size_t>(model.mesh->cells[block.cell][i])];
    energy += here * (block.row(Rows::volume)[lane] - block.row(Rows::mass)[lane] / material.density);
  });
  return energy;
}

/// Energy that free water gives as the ground comes down from its elevation of before [J per m].
Real given_by_free_water(const Model& model, const Look& before, const Look& now)
{
  const auto energy = [](Real level, Real ground) {
    const Real depth = std::max(level - ground, 0.0);
    return 0.5 * depth * depth;
  };
  Real sum = 0.0;
  for (std::size_t k = 0; k < now.ground.size(); ++k) {
    const Real level = std::isfinite(now.free[k]) ? now.free[k] : before.free[k];
    if (std::isfinite(level)) sum += energy(level, now.ground[k]) - energy(level, before.ground[k]);
  }
  return sum * model.nodal_water->drawn()->columns.width / per_cell * model.description.water.unit_weight;
}

class WaterEnergy : public Follower {
  Real supply_ = 0.0, volume_ = 0.0, most_ = 0.0;  ///< so far [J per m]
  Look last_;                                      ///< nothing: there was no row yet
  Real in_soil_ = 0.0;                             ///< at the last look, in its field [J per m]

  void start(const Model& model, const State& state) override
  {
    *this = {};
    if (is_known(model)) look(model, state);
  }
  void look(const Model& model, const State& state)
  {
    last_ = look_at_water(model, state);
    in_soil_ = energy_in_soil(model, state, last_.pressure);
  }
  void row(const LedgerContext& c, std::span<Real> values) override
  {
    if (c.model.with.water && !is_known(c.model)) return;
    if (is_known(c.model)) {
      const Look before = std::move(last_);
      const Real in_soil = in_soil_;
      look(c.model, c.state);
      if (!before.ground.empty() && before.bodies == last_.bodies) {
        supply_ += given_by_free_water(c.model, before, last_);
        volume_ += energy_in_soil(c.model, c.state, before.pressure) - in_soil;
      }
      if (c.state.step >= first_judged) most_ = std::max(most_, c.state.work.outer[outer_water] - supply_ - volume_);
    }
    values[0] = supply_, values[1] = volume_;
  }
  void summarise(const Model& model, const State& state, Summary& summary) const override
  {
    const Real scale = energy_from_outside(state);
    summary.numbers["water_from_nowhere"] = is_known(model) && scale > 0.0 ? most_ / scale : nan;
  }
  void save(ArrayWriter& arrays) const override
  {
    arrays.copy("sums", std::vector<Real>{supply_, volume_, most_, in_soil_, last_.bodies});
    arrays.refer("ground", last_.ground);
    arrays.refer("free", last_.free);
    arrays.refer("pressure", last_.pressure);
  }
  void load(const Model& model, const State& state, const ArrayReader& arrays) override
  {
    if (!arrays.has("sums") && !arrays.has("ground")) return start(model, state);  // a checkpoint of before has none
    const std::vector<Real>& sums = arrays.reals("sums", 5);
    supply_ = sums[0], volume_ = sums[1], most_ = sums[2], in_soil_ = sums[3], last_.bodies = sums[4];
    last_.ground = arrays.reals("ground");
    last_.free = arrays.reals("free", last_.ground.size());
    last_.pressure = arrays.reals("pressure");
  }
  void begin_from(const Model&, const Model& model, const State& first) override { start(model, first); }
};

}  // namespace

const FollowerType water_energy_follower{.name = "water_energy",
    .columns =
        {{"water_supply", "J/m", "energy of free water",
             "what free water gave so far as soil made room for it, less what it took as soil came: its depth on "
             "the ground, squared, times half its unit weight; a change of its level gives nothing"},
            {"water_volume", "J/m", "energy of the water in opened soil",
                "pressure of the water that entered soil of effective stress as it opened so far, on that volume"}},
    .summary = {{"water_from_nowhere", "-", "work of water that no water gives",
        "the most at any row of the ledger of water_work - water_supply - water_volume, of the energy from outside; "
        "`null`: no water, points of files leave it open, or gravity has a part along x"}},
    .make = make_follower<WaterEnergy>};

}  // namespace terp
