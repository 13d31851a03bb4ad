#include "math/tensor.hpp"
#include "math/pack.hpp"
#include "support/test.hpp"

namespace tensor_test {

TEST(SymTensor, TraceAddsTheThreeDirectComponents)
{
  EXPECT_EQ(trace(SymTensor<Real, 2>{{1.0, 20.0, 300.0, 4000.0}}), 321.0);
  EXPECT_EQ(trace(SymTensor<Real, 3>{{1.0, 20.0, 300.0, 4000.0, 5000.0, 6000.0}}), 321.0);
}

TEST(SymTensor, AddIsotropicLeavesTheShearAlone)
{
  SymTensor<Real, 2> a{{1.0, 2.0, 3.0, 4.0}};
  add_isotropic(a, 0.5);
  EXPECT_THAT(a.c, ElementsAre(1.5, 2.5, 3.5, 4.0));
}

TEST(SymTensor, DoubleDotCountsEachShearComponentTwice)
{
  const SymTensor<Real, 2> a{{1.0, 2.0, 3.0, 4.0}}, b{{5.0, 7.0, 11.0, 13.0}};
  EXPECT_EQ(double_dot(a, b), 5.0 + 14.0 + 33.0 + 2.0 * 52.0);
  const SymTensor<Real, 3> c{{1.0, 2.0, 3.0, 4.0, 6.0, 8.0}}, d{{5.0, 7.0, 11.0, 13.0, 17.0, 19.0}};
  EXPECT_EQ(double_dot(c, d), 52.0 + 2.0 * (52.0 + 102.0 + 152.0));
}

TEST(SymTensor, ElasticStressSplitsIntoVolumeAndShape)
{
  const Real K = 70.0, G = 30.0;
  SymTensor<Real, 2> sigma{{1.0, 2.0, 3.0, 4.0}};
  add_elastic_stress(sigma, SymTensor<Real, 2>{{0.01, 0.02, -0.06, 0.05}}, K, G);
  // trace -0.03, deviator (0.02, 0.03, -0.05, 0.05)
  EXPECT_THAT(sigma.c, Pointwise(DoubleNear(1e-14), {1.0 - 2.1 + 1.2, 2.0 - 2.1 + 1.8, 3.0 - 2.1 - 3.0, 4.0 + 3.0}));
}

TEST(SymTensor, ElasticStressIsTheSameInAPackAndAlone)
{
  SymTensor<Real, 2> one{{0.1, 0.2, 0.3, 0.4}};
  SymTensor<Pack, 2> eight{{Pack(0.1), Pack(0.2), Pack(0.3), Pack(0.4)}};
  add_elastic_stress(one, SymTensor<Real, 2>{{1e-3, -3e-3, 7e-4, 2e-3}}, 4.9e7, 2e6);
  add_elastic_stress(eight, SymTensor<Pack, 2>{{Pack(1e-3), Pack(-3e-3), Pack(7e-4), Pack(2e-3)}}, 4.9e7, 2e6);
  for (int k = 0; k < 4; ++k)
    for (int lane = 0; lane < pack_width; ++lane) EXPECT_EQ(eight[k][lane], one[k]);
}

}  // namespace tensor_test
