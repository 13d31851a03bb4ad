// Which sub-cell's value a point takes.
#include "transfer/cell_sums.hpp"

#include "parallel/pack.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

const std::array<Real, 4> values{
    10.0, 11.0, 12.0, 13.0};  // of Gauss points g = (xi >= 0) + 2 (eta >= 0), not in the order of corners

TEST(AtSubCell, IsTheValueOfTheGaussPointOnThatSide)
{
  EXPECT_EQ(at_sub_cell<Real>(values, false, false), 10.0);
  EXPECT_EQ(at_sub_cell<Real>(values, true, false), 11.0);
  EXPECT_EQ(at_sub_cell<Real>(values, true, true), 13.0);
  EXPECT_EQ(at_sub_cell<Real>(values, false, true), 12.0);
}

TEST(AtSubCell, ChoosesForEachLaneOnItsOwn)
{
  alignas(64) std::array<Real, pack_width> xi, eta, chosen;
  for (int k = 0; k < pack_width; ++k) {
    xi[k] = k % 2 == 0 ? -0.5 : 0.5;
    eta[k] = k % 4 < 2 ? -0.5 : 0.5;
  }
  at_sub_cell<Pack>(values, Pack::load(xi.data()) >= Pack(0.0), Pack::load(eta.data()) >= Pack(0.0))
      .store(chosen.data());
  for (int k = 0; k < pack_width; ++k)
    EXPECT_EQ(chosen[k], at_sub_cell<Real>(values, xi[k] > 0.0, eta[k] > 0.0)) << "lane " << k;
}

}  // namespace
}  // namespace terp
