#include "run/loop/follower.hpp"

#include "run/report/history.hpp"
#include "run/report/ledger.hpp"
#include "model/parts/model.hpp"
#include "mpm/step/workspace.hpp"

namespace terp {
namespace {

/// Shows the step of a run to its followers.
class Followers : public StepWatcher {
 public:
  Followers(const Model& model, const State& state) : model_(model), state_(state) {}

  void step(const StepModel&, const Workspace& work) override
  {
    for (const ActiveFollower& active : state_.followers) active.follower->step(model_, work);
  }

 private:
  const Model& model_;
  const State& state_;
};

}  // namespace

void Follower::row(const LedgerContext&, std::span<Real>) {}

void start_followers(const Model& model, State& state)
{
  state.followers.clear();
  for (const FollowerType* type : model.followers) {
    state.followers.push_back({type, type->make()});
    state.followers.back().follower->start(model, state);
  }
}

void make_step(const Model& model, State& state, Workspace& work)
{
  Followers followers(model, state);
  work.watcher = &followers;
  model.step(model, state, work);
  work.watcher = nullptr;
}

std::vector<std::shared_ptr<const RunTable>> tables_with(const FollowerTypes& followers)
{
  std::vector<std::shared_ptr<const RunTable>> tables{history_table(), ledger_table(followers)};
  for (const FollowerType* type : followers)
    if (type->table) tables.push_back(type->table);
  return tables;
}

}  // namespace terp
