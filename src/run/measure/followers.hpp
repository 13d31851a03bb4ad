// The list of all followers, and the tables and columns that they report.
#pragma once

#include "run/loop/follower.hpp"

namespace terp {

#define TERP_FOLLOWER(name) extern const FollowerType name##_follower;
#include "run/measure/followers.def"
#undef TERP_FOLLOWER

/// In the order of followers.def.
const FollowerTypes& all_followers();

/// Every table that a run may write.
const std::vector<std::shared_ptr<const RunTable>>& all_tables();

}  // namespace terp
