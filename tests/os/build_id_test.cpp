#include "os/build_id.hpp"
#include "support/test.hpp"

namespace build_id_test {

TEST(BuildId, IsThatOfTheProgramAndStays)
{
  EXPECT_THAT(build_id(), MatchesRegex("[0-9a-f]+")) << "Debian's compiler asks the linker for one";
  EXPECT_EQ(build_id().size(), 16u);
  EXPECT_EQ(build_id(), build_id());
}

}  // namespace build_id_test
