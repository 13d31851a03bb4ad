#include "stability/judged_soil.hpp"
#include "simulation/setup.hpp"
#include "support/cases.hpp"

namespace judged_soil_test {

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
  /// Moves the points above a height by this much [m].
  void shift(Real above, Real way)
  {
    for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
      if (block.row(Rows::x + 1)[lane] > above) block.row(Rows::x)[lane] += way;
    });
  }
};

TEST(JudgedSoil, LeavesOutWhatHoldsOnToPartFilledCells)
{
  Box whole(1.25), ragged(1.35);  // three rows of cells; a fourth that is 40 % full
  const JudgedSoil all(whole.model, whole.state), inner(ragged.model, ragged.state);
  whole.shift(1.0, 0.01);
  ragged.shift(1.0, 0.01);
  EXPECT_NEAR(all.largest_displacement(whole.state), 0.01, 1e-12);
  EXPECT_EQ(inner.largest_displacement(ragged.state), 0.0);
  ragged.shift(0.9, 0.02);
  EXPECT_NEAR(inner.largest_displacement(ragged.state), 0.02, 1e-12);
}

TEST(JudgedSoil, IsAllSoilWhereNoCellIsFilled)
{
  Box thin(0.6);
  const JudgedSoil soil(thin.model, thin.state);
  thin.shift(0.0, 0.01);
  EXPECT_NEAR(soil.largest_displacement(thin.state), 0.01, 1e-12);
}

TEST(JudgedSoil, IsAllSoilWhereEachFilledCellHoldsOnToAPartFilledOne)
{
  Box thin(0.85);  // a row of filled cells below one that is 40 % full
  JudgedSoil soil(thin.model, thin.state);
  thin.shift(0.0, 0.01);
  EXPECT_NEAR(soil.largest_displacement(thin.state), 0.01, 1e-12);
  thin.model.step(thin.model, thin.state, thin.work);
  soil.add_forces(thin.model, thin.work);
  EXPECT_NEAR(soil.take_out_of_balance(), 1.0, 1e-12);
}

TEST(JudgedSoil, IsOutOfBalanceByItsWholeWeightInFreeFall)
{
  Box box(1.25);
  JudgedSoil soil(box.model, box.state);
  EXPECT_EQ(soil.take_out_of_balance(), 0.0);  // no step yet
  for (int k = 0; k < 3; ++k) {
    box.model.step(box.model, box.state, box.work);
    soil.add_forces(box.model, box.work);
  }
  EXPECT_NEAR(soil.take_out_of_balance(), 1.0, 1e-5);  // three sweeps for the slope of the pressure leave 2e-6
  EXPECT_EQ(soil.take_out_of_balance(), 0.0);
}

}  // namespace judged_soil_test
