// What the footings of a case meet: the reaction of the soil, and their work; footings.csv. The reaction of a row is
// the mean since the row before: what the nodes gave to the footing, step by step, over the time.

#include "math/plane.hpp"
#include "mpm/features/footings.hpp"
#include "run/measure/followers.hpp"
#include "run/report/ledger_context.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr std::string_view reaction_meaning =
    "force of the soil on the footing, summed over its nodes, mean since the row before: the momentum that the footing "
    "gave over the time";

const std::shared_ptr<const RunTable>& footings_table()
{
  static const auto table = std::make_shared<const RunTable>(RunTable{.name = "footings",
      .meaning = "displacement and measured reaction of each footing",
      .columns = {{"time", "s", "time", "of the step"}, {"footing", "", "footing", "name in the case file", true},
          {"displacement_x", "m", "displacement, x", "of the footing since t = 0"},
          {"displacement_y", "m", "displacement, y", "of the footing since t = 0"},
          {"reaction_x", "N/m", "reaction, x", reaction_meaning},
          {"reaction_y", "N/m", "reaction, y", reaction_meaning},
          {"work", "J/m", "work", "done by the footing on the soil so far; part of `boundary_work` of the ledger"}}});
  return table;
}

struct FootingMeter {
  Vec<2> impulse{0.0, 0.0};   ///< of the soil on it since `since` [N s per m]
  Real since = 0.0;           ///< time of the last row of footings.csv [s]
  Vec<2> reaction{0.0, 0.0};  ///< of that row: mean force of the soil on the footing since the row before [N per m]
  Real largest = 0.0;         ///< largest reaction of any row, against the motion [N per m]
  Real work = 0.0;            ///< done on the soil [J per m]
};

/// Component of a reaction against the motion of the footing; its size if the footing rests.
Real resistance(const Footing& footing, Vec<2> reaction)
{
  const Real speed = std::hypot(footing.velocity[0], footing.velocity[1]);
  return speed > 0.0 ? -dot(reaction, footing.velocity) / speed : std::hypot(reaction[0], reaction[1]);
}

class Footings : public Follower {
  std::vector<FootingMeter> meters_;  ///< in the order of the case

  void start(const Model& model, const State&) override { meters_.assign(footings_of(model).size(), {}); }

  void step(const Model&, const Workspace& work) override
  {
    if (!work.with.footings) return;
    const FootingsScratch& footings = *work.with.footings;
    for (std::size_t k = 0; k < footings.placed.size(); ++k) {
      const Vec<2> impulse = footings.impulses[k];
      for (int d = 0; d < 2; ++d) meters_[k].impulse[d] -= impulse[d];
      meters_[k].work += dot(impulse, footings.placed[k].velocity);
    }
  }

  std::vector<TableRow> rows(const Model& model, const State& state) override
  {
    std::vector<TableRow> rows;
    const std::span<const Footing> footings = footings_of(model);
    for (std::size_t k = 0; k < footings.size(); ++k) {
      const Footing& footing = footings[k];
      FootingMeter& meter = meters_[k];
      if (const Real interval = state.time - meter.since; interval > 0.0) {
        meter.reaction = {meter.impulse[0] / interval, meter.impulse[1] / interval};
        meter.impulse = {0.0, 0.0};
        meter.since = state.time;
        meter.largest = std::max(meter.largest, resistance(footing, meter.reaction));
      }
      const Vec<2> moved = footing.displacement(state.time);
      rows.emplace_back(footings_table(), footing.name).values = {
          state.time, moved[0], moved[1], meter.reaction[0], meter.reaction[1], meter.work};
    }
    return rows;
  }

  void summarise(const Model& model, const State& state, Summary& summary) const override
  {
    const std::span<const Footing> footings = footings_of(model);
    for (std::size_t k = 0; k < meters_.size(); ++k)
      summary.footings.push_back({footings[k].name, footings[k].displacement(state.time), meters_[k].reaction,
          meters_[k].largest, meters_[k].work});
  }

  void save(ArrayWriter& arrays) const override
  {
    std::vector<Real> values;
    for (const FootingMeter& m : meters_)
      values.insert(
          values.end(), {m.impulse[0], m.impulse[1], m.since, m.reaction[0], m.reaction[1], m.largest, m.work});
    arrays.copy("meters", std::move(values));
  }

  void load(const Model& model, const State&, const ArrayReader& arrays) override
  {
    meters_.assign(footings_of(model).size(), {});
    const Real* v = arrays.reals("meters", 7 * meters_.size()).data();
    for (FootingMeter& m : meters_) {
      m = {.impulse = {v[0], v[1]}, .since = v[2], .reaction = {v[3], v[4]}, .largest = v[5], .work = v[6]};
      v += 7;
    }
  }
};

}  // namespace

const FollowerType footings_follower{.name = "footings", .table = footings_table(), .make = make_follower<Footings>};

}  // namespace terp
