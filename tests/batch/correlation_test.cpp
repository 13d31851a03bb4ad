#include "batch/correlation.hpp"

#include "support/test.hpp"

namespace correlation_test {

SquareMatrix three(Real ab, Real ac, Real bc)
{
  SquareMatrix c = SquareMatrix::unit(3);
  c.at(0, 1) = c.at(1, 0) = ab;
  c.at(0, 2) = c.at(2, 0) = ac;
  c.at(1, 2) = c.at(2, 1) = bc;
  return c;
}

TEST(Correlation, TheFactorGivesTheMatrixBack)
{
  const SquareMatrix c = three(0.5, -0.3, 0.2);
  const CholeskyResult result = cholesky(c);
  ASSERT_FALSE(result.fault);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      Real sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k) sum += result.factor.at(i, k) * result.factor.at(j, k);
      EXPECT_NEAR(sum, c.at(i, j), 1e-15);
    }
  EXPECT_THAT(
      times(result.factor, {1.0, 2.0, 0.0}), ElementsAre(1.0, DoubleNear(0.5 + 2.0 * std::sqrt(0.75), 1e-15),
                                                 DoubleNear(-0.3 + 2.0 * (0.2 + 0.15) / std::sqrt(0.75), 1e-15)));
}

TEST(Correlation, ThePairThatContradictsTheOthersIsNamed)
{
  const auto fault = cholesky(three(0.9, 0.3, -0.8)).fault;  // b follows a, but c follows a and opposes b
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->a, 1u);
  EXPECT_EQ(fault->b, 2u);
  EXPECT_TRUE(cholesky(three(1.0, 0.0, 0.0)).fault) << "one number twice";
}

}  // namespace correlation_test
