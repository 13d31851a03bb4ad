// Whether the strain history of each point obeys its law: eps_eq_p must not fall, S_u must not rise, between two rows
// of the ledger. The walk over the points (totals) finds where it does not; here it is remembered.

#include "run/measure/followers.hpp"
#include "run/report/ledger.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"
#include "soil/libraries/user_law.hpp"

#include <algorithm>

namespace terp {
namespace {

/// False where all soil is of libraries that have no such variable, as far as the case says.
bool knows_plastic_strain(const Model& model)
{
  return std::ranges::any_of(model.materials, [](const SoilMaterial& soil) {
    return terms_of(*soil.type) == nullptr || row_of(soil, Role::plastic_strain) >= 0;
  });
}

class HistoryAudit : public Follower {
  StrainMemory memory_;
  std::vector<bool> fell_, rose_;  ///< by id: eps_eq_p ever fell, S_u ever rose

  void start(const Model& model, const State& state) override
  {
    const auto n = static_cast<std::size_t>(state.n_ids());
    memory_ = remember_strain(model, state);
    for (auto* flags : {&fell_, &rose_}) flags->assign(n, false);
  }

  void points_were_set(const Model& model, const State& state) override { memory_ = remember_strain(model, state); }

  void request(TotalsRequest& request) override { request.memory = &memory_; }

  void row(const LedgerContext& context, std::span<Real>) override
  {
    for (const std::size_t id : context.totals.fell) fell_[id] = true;
    for (const std::size_t id : context.totals.rose) rose_[id] = true;
    const PointBlocks<2>& points = context.state.points;
    for (Index b = 0; b < points.n_blocks(); ++b) {
      if (!context.totals.strained[b]) continue;
      const PointBlock<2>& block = points.block(b);
      const Real* eps = block.row(row_of(context.model.materials[block.material], Role::plastic_strain));
      for (Index lane = 0; lane < block.n; ++lane)
        memory_.last_eps_eq_p[static_cast<std::size_t>(block.row(Rows::id)[lane])] = eps[lane];
    }
  }

  void summarise(const Model& model, const State&, Summary& summary) const override
  {
    const auto& eps = memory_.last_eps_eq_p;
    if (knows_plastic_strain(model)) summary.max_eps_eq_p = eps.empty() ? 0.0 : *std::ranges::max_element(eps);
    summary.points_eps_eq_p_fell = std::ranges::count(fell_, true);
    summary.points_su_rose = std::ranges::count(rose_, true);
  }

  void save(ArrayWriter& arrays) const override
  {
    arrays.refer("last_eps_eq_p", memory_.last_eps_eq_p);
    arrays.refer("last_su", memory_.last_su);
    arrays.refer("fell", fell_);
    arrays.refer("rose", rose_);
  }

  void load(const Model& model, const State& state, const ArrayReader& arrays) override
  {
    const auto n = static_cast<std::size_t>(state.n_ids());
    memory_ = {arrays.reals("last_eps_eq_p", n), arrays.reals("last_su", must_remember_strength(model) ? n : 0)};
    fell_ = arrays.flags("fell", n);
    rose_ = arrays.flags("rose", n);
  }
};

}  // namespace

const FollowerType history_audit_follower{.name = "history_audit", .make = make_follower<HistoryAudit>};

}  // namespace terp
