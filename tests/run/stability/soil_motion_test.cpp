#include "mpm/step/workspace.hpp"
#include "run/stability/soil_motion.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"

namespace soil_motion_test {

/// A box 1 m wide, of cells of 0.25 m, as high as asked, that falls.
struct Box {
  Case description;
  Model model;
  State state;
  Workspace work;
  explicit Box(Real top)
      : description(make(top)), model(build_model(description, 1)), state(build_state(model)), work(model, state)
  {
  }
  static Case make(Real top)
  {
    Case c = free_box("mpm_gp", {1.0, 0.5}, {2.0, top});
    c.forces.gravity = {0.0, -10.0};
    return c;
  }
};

TEST(SoilMotion, IsThatOfTheFastestHundredthAlsoInCellsThatAreNotFilled)
{
  Box ragged(1.35);  // a row of cells that is 40 % full on three that are filled
  const auto n = static_cast<Index>(ragged.state.n_ids() / 100);
  ASSERT_GT(n, 1);
  Index moved = 0;
  for_each_point(ragged.state.points, [&](const PointBlock<2>& block, Index lane) {
    if (block.row(Rows::x + 1)[lane] > 1.25 && moved++ < n) block.row(Rows::x)[lane] += 0.01;
  });
  EXPECT_NEAR(displacement_of_the_fastest(ragged.state, {}), 0.01, 1e-12);
}

TEST(SoilMotion, IsOutOfBalanceByItsWholeWeightInFreeFall)
{
  Box box(1.25);
  OutOfBalance balance(box.model);
  EXPECT_EQ(balance.take_share(), 0.0);  // no step yet
  for (int k = 0; k < 3; ++k) {
    make_step(box.model, box.state, box.work);
    balance.add_forces(box.model, box.work);
  }
  EXPECT_NEAR(balance.take_share(), 1.0, 1e-5);  // three sweeps for the slope of the pressure leave 2e-6
  EXPECT_EQ(balance.take_share(), 0.0);
}

}  // namespace soil_motion_test
