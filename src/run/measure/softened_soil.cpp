// How much of the soil has lost more than half of what softening can take from its strength, at each frame; and the
// lowest strength that a law of a library returned, which Terp does not hold above zero.

#include "run/measure/followers.hpp"

#include "math/nan.hpp"
#include "run/report/ledger.hpp"
#include "run/report/ledger_context.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"
#include "soil/libraries/user_law.hpp"

#include <cmath>
#include <limits>

namespace terp {
namespace {

constexpr Real round_off_of_strength = 1e-9;  // of a strength, relative [-]

/// S_u in the middle between peak and least; 0 for soil that does not soften [Pa].
Real half_softened(const SoilMaterial& material, const PointBlock<2>& block, Index lane)
{
  constexpr Real all = std::numeric_limits<Real>::infinity();
  const Real peak = strength_at(material, block, lane, 0.0);
  const LawTerms* const of_library = terms_of(*material.type);
  const Real least = of_library != nullptr ? of_library->residual_strength : strength_at(material, block, lane, all);
  return peak - least > round_off_of_strength * peak ? 0.5 * (peak + least) : 0.0;
}

/// False while there is soil of a library of which nobody said what softening leaves.
bool is_known(const Model& model, const State& state)
{
  bool known = true;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const LawTerms* const of_library = terms_of(*model.materials[block.material].type);
    known = known && (of_library == nullptr || !std::isnan(of_library->residual_strength));
  });
  return known;
}

/// Share of the volume whose S_u has lost more than half of the way from its peak to the least.
Real softened_fraction(const Model& model, const State& state)
{
  Real soft = 0.0, all = 0.0;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const bool softens = has_strength(material);
    for (Index lane = 0; lane < block.n; ++lane) {
      const Real volume = block.row(Rows::volume)[lane];
      all += volume;
      if (softens && strength_of(material, block, lane) < half_softened(material, block, lane)) soft += volume;
    }
  });
  return all > 0.0 ? soft / all : 0.0;
}

/// Of soil of libraries whose strength the case names [Pa]; NaN: there is none.
Real lowest_of_libraries(const Model& model, const State& state)
{
  Real lowest = nan;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    if (!material.type->by_library || !has_strength(material)) return;
    for (Index lane = 0; lane < block.n; ++lane) lowest = std::fmin(lowest, strength_of(material, block, lane));
  });
  return lowest;
}

class SoftenedSoil : public Follower {
  std::vector<Real> time_, fraction_;  ///< [s], [-]; by frame
  Real lowest_ = nan;                  ///< lowest_of_libraries at the rows of the ledger so far

  void start(const Model& model, const State& state) override { lowest_ = lowest_of_libraries(model, state); }
  void row(const LedgerContext& context, std::span<Real>) override
  {
    lowest_ = std::fmin(lowest_, lowest_of_libraries(context.model, context.state));
  }
  void frame(const Model& model, const State& state) override
  {
    if (!is_known(model, state)) return;
    time_.push_back(state.time);
    fraction_.push_back(softened_fraction(model, state));
  }
  void summarise(const Model&, const State&, Summary& summary) const override
  {
    for (std::size_t k = 0; k < time_.size(); ++k) summary.softened_fraction.emplace_back(time_[k], fraction_[k]);
    summary.numbers["lowest_library_strength"] = lowest_;
  }
  void save(ArrayWriter& arrays) const override
  {
    arrays.refer("time", time_);
    arrays.refer("fraction", fraction_);
    if (!std::isnan(lowest_)) arrays.copy("lowest", std::vector<Real>{lowest_});
  }
  void load(const Model&, const State&, const ArrayReader& arrays) override
  {
    time_ = arrays.reals("time");
    fraction_ = arrays.reals("fraction", time_.size());
    lowest_ = arrays.has("lowest") ? arrays.reals("lowest", 1)[0] : nan;
  }
};

}  // namespace

const FollowerType softened_soil_follower{.name = "softened_soil",
    .summary = {{"lowest_library_strength", "Pa", "lowest strength of soil of a library",
        "smallest strength that a law of a library returned, at the rows of the ledger; `null`: there is no soil of a "
        "library with the key `strength`"}},
    .make = make_follower<SoftenedSoil>};

}  // namespace terp
