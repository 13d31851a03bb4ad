#include "soil/laws/material.hpp"
#include "support/test.hpp"

namespace material_test {

TEST(Materials, AreFoundByNameAndOnlyByName)
{
  ASSERT_NE(find_material("tresca_softening"), nullptr);
  EXPECT_EQ(find_material("tresca_softening")->name, "tresca_softening");
  EXPECT_EQ(find_material("linear_elastic")->name, "linear_elastic");
  EXPECT_EQ(find_material("tresca"), nullptr);
  EXPECT_EQ(find_material(""), nullptr);
}

TEST(Materials, SayWhichOfTheirQuantitiesIsThePlasticStrainAndWhichTheStrength)
{
  const MaterialType &tresca = *find_material("tresca_softening"), &fluid = *find_material("newtonian_fluid");
  EXPECT_EQ(find_role(tresca.state, Role::plastic_strain), 0);
  EXPECT_EQ(find_role(tresca.state, Role::strength), -1);
  EXPECT_EQ(find_role(tresca.derived, Role::strength), 0);
  EXPECT_EQ(find_role(fluid.state, Role::plastic_strain), -1);  // its opening is none
}

TEST(Range, KnowsOpenFromClosedEnds)
{
  EXPECT_FALSE(positive.contains(0.0));
  EXPECT_TRUE(not_negative.contains(0.0));
  EXPECT_TRUE(between(0.0, 0.5).contains(0.5));
  EXPECT_FALSE(between_open(0.0, 0.5).contains(0.5));
  EXPECT_FALSE(between_open(0.0, 0.5).contains(0.0));
  EXPECT_TRUE(any_number.contains(-1e300));
}

TEST(Range, HoldsNothingThatIsNotANumber)
{
  EXPECT_FALSE(any_number.contains(std::numeric_limits<Real>::quiet_NaN()));
  EXPECT_FALSE(positive.contains(std::numeric_limits<Real>::quiet_NaN()));
}

}  // namespace material_test
