#include "schemes/scheme_info.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace terp {
namespace {

TEST(SchemeInfo, ListsEverySchemeOnceWithALineOfText)
{
  std::vector<std::string> names;
  for (const SchemeInfo& scheme : all_schemes()) {
    names.emplace_back(scheme.name);
    EXPECT_FALSE(scheme.summary.empty()) << scheme.name;
  }
  EXPECT_THAT(names, testing::ElementsAre("standard_mpm", "mpm_mixed", "mpm_gp"));
}

}  // namespace
}  // namespace terp
