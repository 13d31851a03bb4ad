#include "os/folder_claim.hpp"
#include "support/paths.hpp"

namespace folder_claim_test {

TEST(ClaimFolder, IsOfOneAtATime)
{
  const ScratchFolder scratch;
  int one = -1, other = -1;
  EXPECT_EQ(look_at_claim(scratch.path()), ClaimResult::taken);
  EXPECT_EQ(claim_folder(scratch.path(), one), ClaimResult::taken);
  EXPECT_EQ(claim_folder(scratch.path(), other), ClaimResult::held_by_another);
  EXPECT_EQ(look_at_claim(scratch.path()), ClaimResult::held_by_another);
  release_claim(one);
  EXPECT_EQ(claim_folder(scratch.path(), other), ClaimResult::taken);
  release_claim(other);
}

TEST(ClaimFolder, NeedsAFolder)
{
  const ScratchFolder scratch;
  int claim = 0;
  EXPECT_EQ(claim_folder(scratch.path() + "/none", claim), ClaimResult::no_folder);
  EXPECT_EQ(claim, -1);
}

}  // namespace folder_claim_test
