// What the machine can do at most: numbers that could be of a machine. How large they are is its own affair.
#include "mpm/step/kernels.hpp"
#include "support/test.hpp"

namespace machine_test {

constexpr double slowest = 1e-3, fastest = 1e5;  // a pocket calculator, a supercomputer's node

TEST(Machine, TriadIsAFiniteRateForArraysOfAnySize)
{
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{100'000}, std::size_t{4'000'000}}) {
    const double rate = kernels().measure_triad(bytes);
    EXPECT_GT(rate, slowest) << bytes << " bytes";
    EXPECT_LT(rate, fastest) << bytes << " bytes";
  }
}

TEST(Machine, MultiplyAddIsAFiniteRate)
{
  EXPECT_GT(kernels().measure_multiply_add(), slowest);
  EXPECT_LT(kernels().measure_multiply_add(), fastest);
}

}  // namespace machine_test
