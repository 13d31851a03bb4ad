#include "soil/laws/principal.hpp"
#include "support/random.hpp"

namespace principal_test {

using Tensor = SymTensor<Real, 2>;

TEST(PrincipalValues, AreThoseOfTheHandCalculation)
{
  // xx 7, yy 1, xy 4: mean 4, radius 5; direction of the larger at half the angle with cosine 0.6 and sine 0.8.
  const auto p = principal_values(Tensor{{7.0, 1.0, 2.0, 4.0}});
  EXPECT_DOUBLE_EQ(p.a, 9.0);
  EXPECT_DOUBLE_EQ(p.b, -1.0);
  EXPECT_EQ(p.zz, 2.0);
  EXPECT_DOUBLE_EQ(p.cos_2, 0.6);
  EXPECT_DOUBLE_EQ(p.sin_2, 0.8);
}

TEST(PrincipalValues, OfEqualValuesPointAlongX)
{
  const auto p = principal_values(Tensor{{-3.0, -3.0, 8.0, 0.0}});
  EXPECT_EQ(p.a, -3.0);
  EXPECT_EQ(p.b, -3.0);
  EXPECT_EQ(p.cos_2, 1.0);
  EXPECT_EQ(p.sin_2, 0.0);
}

TEST(PrincipalValues, LeadBackToTheTensor)
{
  Random random(61);
  for (int k = 0; k < 1000; ++k) {
    const Tensor t{
        {random.between(-9.0, 9.0), random.between(-9.0, 9.0), random.between(-9.0, 9.0), random.between(-9.0, 9.0)}};
    const Tensor back = from_principal_values(principal_values(t));
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(back[c], t[c], 1e-14);
  }
}

TEST(PrincipalValues, AreTheSameInAPackAndAlone)
{
  const auto alone = principal_values(Tensor{{1.3, -2.7, 0.4, 0.9}});
  const auto packed = principal_values(SymTensor<Pack, 2>{{Pack(1.3), Pack(-2.7), Pack(0.4), Pack(0.9)}});
  EXPECT_EQ(packed.a[2], alone.a);
  EXPECT_EQ(packed.b[2], alone.b);
  EXPECT_EQ(packed.cos_2[2], alone.cos_2);
  EXPECT_EQ(packed.sin_2[2], alone.sin_2);
}

PlanePrincipal<Real> values(Real a, Real b, Real zz) { return {a, b, zz, 1.0, 0.0}; }

TEST(SortPrincipalValues, KnowsAllPlacesOfZz)
{
  for (const Real zz : {9.0, 5.0, 3.0, 1.0, -2.0}) {  // major, equal to the major, middle, equal to the minor, minor
    const auto s = sort_principal_values(values(5.0, 1.0, zz));
    std::array<Real, 3> expected{5.0, 1.0, zz};
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(s.minor, expected[0]);
    EXPECT_EQ(s.middle, expected[1]);
    EXPECT_EQ(s.major, expected[2]);
  }
}

TEST(AssignByRank, GivesEachPlaceTheValueOfItsRank)
{
  const Sorted<Real> news{30.0, 20.0, 10.0};
  const auto assigned = [&](Real zz) {
    auto p = values(5.0, 1.0, zz);
    assign_by_rank(news, p);
    return std::array{p.a, p.b, p.zz};
  };
  EXPECT_EQ(assigned(3.0), (std::array{30.0, 10.0, 20.0}));
  EXPECT_EQ(assigned(9.0), (std::array{20.0, 10.0, 30.0}));
  EXPECT_EQ(assigned(-2.0), (std::array{30.0, 20.0, 10.0}));
}

TEST(AssignByRank, UndoesTheSorting)
{
  for (const Real zz : {9.0, 5.0, 3.0, 1.0, -2.0}) {
    auto p = values(5.0, 1.0, zz);
    assign_by_rank(sort_principal_values(p), p);
    EXPECT_EQ(p.a, 5.0);
    EXPECT_EQ(p.b, 1.0);
    EXPECT_EQ(p.zz, zz);
  }
}

}  // namespace principal_test
