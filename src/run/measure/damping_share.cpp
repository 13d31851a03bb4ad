// How much energy local damping took, beside what its factor promises: alpha times the kinetic energy that the soil
// gained and lost. Where the out-of-balance force is noise, damping takes far more (decision 0043). A smooth collapse
// has a ratio of 1.4 to 5.6: forces and velocities count by component, and soil that slides on is damped as well.

#include "run/measure/followers.hpp"

#include "math/nan.hpp"
#include "run/report/ledger.hpp"
#include "run/report/ledger_context.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"

#include <cmath>

namespace terp {
namespace {

class DampingShare : public Follower {
  Real kinetic_ = 0.0;  ///< at the last row of the ledger [J per m]
  Real swing_ = 0.0;    ///< gained and lost so far [J per m]

  void start(const Model&, const State&) override { kinetic_ = swing_ = 0.0; }
  void row(const LedgerContext& context, std::span<Real>) override
  {
    swing_ += std::abs(context.totals.kinetic - kinetic_);
    kinetic_ = context.totals.kinetic;
  }
  void summarise(const Model& model, const State& state, Summary& summary) const override
  {
    const Real promised = model.damping.viscous > 0.0 ? 0.0 : model.damping.local * swing_;
    summary.numbers["damping_over_promised"] = promised > 0.0 ? -state.work.damping / promised : nan;
    const Real exchanged = energy_exchanged(state);
    summary.numbers["damping_fraction"] =
        model.damping.local > 0.0 && exchanged > 0.0 ? -state.work.damping / exchanged : nan;
  }
  void save(ArrayWriter& arrays) const override
  {
    arrays.copy("kinetic", std::vector<Real>{kinetic_});
    arrays.copy("swing", std::vector<Real>{swing_});
  }
  void load(const Model&, const State&, const ArrayReader& arrays) override
  {
    kinetic_ = arrays.reals("kinetic", 1)[0];
    swing_ = arrays.reals("swing", 1)[0];
  }
};

}  // namespace

const FollowerType damping_share_follower{.name = "damping_share",
    .summary = {{"damping_over_promised", "-", "damping over what it promises",
                    "work of local damping over alpha times the kinetic energy that was gained and lost from row to "
                    "row of the ledger: 1.4 to 5.6 in a smooth collapse, 8 to 18 where noise brakes the soil; `null`: "
                    "no local damping, or viscous damping beside it"},
        {"damping_fraction", "-", "part that damping took",
            "work of local and viscous damping over the largest energy exchanged; `null`: no local damping"}},
    .make = make_follower<DampingShare>};

}  // namespace terp
