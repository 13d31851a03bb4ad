// What the columns of a ledger row are read from.
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"
#include "mpm/step/totals.hpp"

namespace terp {

/// Of the points that left through open sides [m^2].
inline Real volume_that_left(const State& state)
{
  Real volume = 0.0;
  for (const LeftPoint& p : state.left) volume += p.volume;
  return volume;
}

struct LedgerContext {
  const Model& model;
  const State& state;
  const TotalsRequest& request;
  const Totals& totals;
  Real kinetic_nodal;  ///< of the nodes at the start of the last step [J per m]
  Real left_energy;    ///< of the points that left, when they did [J per m]
  Real fastest_node;   ///< of those that hold soil, in the last step [m/s]; NaN: not looked at, or no step yet
};

}  // namespace terp
