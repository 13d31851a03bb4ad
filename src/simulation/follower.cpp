#include "simulation/follower.hpp"

#include "simulation/history.hpp"
#include "simulation/ledger.hpp"

namespace terp {

void Follower::row(const LedgerContext&, std::span<Real>) {}

void start_followers(const Model& model, State& state)
{
  state.followers.clear();
  for (const FollowerType* type : model.followers) {
    state.followers.push_back({type, type->make()});
    state.followers.back().follower->start(model, state);
  }
}

std::vector<std::shared_ptr<const RunTable>> tables_with(const FollowerTypes& followers)
{
  std::vector<std::shared_ptr<const RunTable>> tables{history_table(), ledger_table(followers)};
  for (const FollowerType* type : followers)
    if (type->table) tables.push_back(type->table);
  return tables;
}

}  // namespace terp
