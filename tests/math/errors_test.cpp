#include "math/errors.hpp"
#include "support/test.hpp"

namespace errors_test {

TEST(InputError, NamesItsFirstProblemAndKeepsThemAll)
{
  const InputError error({{"mesh.cell", "not positive", "", "", false}, {"time.end", "missing", "", "", false}});
  EXPECT_STREQ(error.what(), "mesh.cell: not positive");
  EXPECT_EQ(error.problems().size(), 2u);
  EXPECT_EQ(error.problems()[1].key, "time.end");
}

TEST(InputError, WithoutProblemsStillSaysSomething)
{
  EXPECT_STREQ(InputError(std::vector<Problem>{}).what(), "bad input");
}

TEST(FailAssert, EndsTheProgramAndAsksForAReport)
{
  EXPECT_DEATH(fail_assert("n > 0", "points.cpp", 42),
      "terp: internal error at points.cpp:42: n > 0 does not hold. Please report it.");
}

}  // namespace errors_test
