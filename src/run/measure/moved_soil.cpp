// How much soil has moved away from its first place, and how much of that is intact. Definitions: docs/formats.md.

#include "mpm/points/moved.hpp"
#include "run/measure/followers.hpp"
#include "mpm/mesh/mesh.hpp"
#include "model/ground/ground_section.hpp"
#include "run/report/ledger.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"

#include <cmath>

namespace terp {
namespace {

Real total_volume(const PointBlocks<2>& points, Ground ground)
{
  Real volume = 0.0;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    if (is_ground(ground, block)) volume += block.row(Rows::volume)[lane];
  });
  return volume;
}

class MovedSoilFollower : public Follower {
  Real distance_ = 0.0;               ///< from where on soil counts as moved [m]
  std::vector<std::uint8_t> ground_;  ///< which materials are ground; empty: all

  void start(const Model& model, const State& state) override
  {
    ground_ = ground_of(model);
    distance_ = moved_distance(first_section(model, state.points, ground_));
  }
  void count_displacement_anew(const Model& model, const State& state) override { start(model, state); }
  void request(TotalsRequest& request) override { request.moved_distance = distance_, request.ground = ground_; }
  void row(const LedgerContext& context, std::span<Real> values) override
  {
    values[0] = context.totals.moved.volume + volume_that_left(context.state);
  }
  void summarise(const Model& model, const State& state, Summary& s) const override
  {
    const Real left = volume_that_left(state), volume = total_volume(state.points, ground_) + left;
    s.moved_distance = distance_;
    s.moved_volume = find_moved(state.points, state.x_initial, distance_, ground_).volume + left;
    s.moved_fraction = volume > 0.0 ? s.moved_volume / volume : 0.0;
    std::vector<int> strain_rows;
    for (const SoilMaterial& material : model.materials)
      strain_rows.push_back(material.is_ground ? row_of(material, Role::plastic_strain) : -1);
    const Real intact = intact_share(state.points, state.x_initial, distance_, strain_rows);
    if (!std::isnan(intact)) s.intact_fraction = intact;
  }
  void save(ArrayWriter& arrays) const override { arrays.copy("distance", std::vector<Real>{distance_}); }
  void load(const Model& model, const State&, const ArrayReader& arrays) override
  {
    ground_ = ground_of(model);
    distance_ = arrays.reals("distance", 1)[0];
  }
};

}  // namespace

const FollowerType moved_soil_follower{.name = "moved_soil",
    .columns = {{"moved_volume", "m^2", "volume that moved",
        "volume of the points that moved, with those that left (Front, crest and slides)"}},
    .make = make_follower<MovedSoilFollower>};

}  // namespace terp
