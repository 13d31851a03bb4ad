#include "run/measure/followers.hpp"

namespace terp {

const FollowerTypes& all_followers()
{
  static const FollowerTypes all{
#define TERP_FOLLOWER(name) &name##_follower,
#include "run/measure/followers.def"
#undef TERP_FOLLOWER
  };
  return all;
}

const std::vector<std::shared_ptr<const RunTable>>& all_tables()
{
  static const auto tables = tables_with(all_followers());
  return tables;
}

}  // namespace terp
