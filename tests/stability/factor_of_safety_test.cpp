// The whole way: a column whose factor of safety is known within its cell size.
#include "stability/factor_of_safety.hpp"

#include "base/errors.hpp"
#include "support/cases.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

const std::atomic<bool> go{false};

/// A vertical cut of 2 m, gamma H / S_u = 4.88: it stands up to 3.78 / 4.88 = 0.77, and on cells of H/4 up to a fifth more.
Case cut()
{
  Case c = test::column_without_softening("mpm_mixed");
  for (SideCase& side : c.sides)
    if (side.side == "bottom") side.kind = SideKind::fixed;
  return c;
}

TEST(FactorOfSafety, OfAVerticalCutIsNearTheLimitLoad)
{
  int told = 0;
  const StabilityResult result = find_factor_of_safety(cut(), {.search = {0.7, 1.1, 0.05}, .rules = {}, .threads = 1}, go,
                                                       [&](const Trial&, const StabilityResult&, int left) { told += left >= 0; });
  ASSERT_TRUE(result.search.found());
  EXPECT_GE(result.factor(), 0.77);
  EXPECT_LE(result.factor(), 0.77 * (1.0 + 0.85 * 0.5 / 2.0) + 0.05);
  EXPECT_EQ(result.strengths.size(), 2u);
  EXPECT_GT(told, 10);
}

TEST(FactorOfSafety, NeedsAStrength)
{
  Case c = cut();
  c.materials = {test::elastic(1e6, 0.3, 2000.0)};
  c.bodies[0].material = c.materials[0].name;
  try {
    find_factor_of_safety(c, {}, go);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().at(0).what, "no material of this case has a strength to reduce");
  }
}

TEST(FactorOfSafety, DoesNotTryStrengthsThatALawCannotTake)
{
  Case c = test::column("mpm_gp");
  EXPECT_THROW(find_factor_of_safety(c, {.search = {0.05, 0.1, 0.01}, .rules = {}, .threads = 1}, go), RunError);
}

}  // namespace
}  // namespace terp
