#include "support/simulations.hpp"

namespace softening_length_test {

TEST(SofteningLength, IsReportedBesideCellAndHeightWithTheShareOfTheHalo)
{
  Case c = clamped_cell("mpm_gp");  // four points in a cell of 1 m
  c.materials[0].softening.length = 1.5;
  Simulation s = followed(c);
  const Summary before = summarise(s.model, s.state);
  EXPECT_EQ(before.numbers.at("softening_length_over_cell"), 1.5);
  EXPECT_EQ(before.numbers.at("softening_length_over_cell_reached"), 1.5);
  EXPECT_EQ(before.numbers.at("softening_length_over_height"), 3.0);  // points are 0.5 m apart
  EXPECT_TRUE(std::isnan(before.numbers.at("halo_fraction")));
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    const int id = static_cast<int>(block.row(Rows::id)[lane]), driver = s.model.materials[0].increment_row - 1;
    // ln(2)/50 = 0.01386 of the strain leaves half of the drop.
    block.row(driver)[lane] = id == 0 ? 0.0138 : 0.014;
    block.row(Rows::state)[lane] = id == 1 ? 0.0069 : id == 2 ? 0.0071 : 0.02;
  });
  EXPECT_NEAR(summarise(s.model, s.state).numbers.at("halo_fraction"), 1.0 / 3.0, 1e-15);
}

TEST(SofteningLength, IsNoNumberWithoutOne)
{
  const Simulation s = followed(clamped_cell("mpm_gp"));
  for (const char* name : {"softening_length_over_cell", "softening_length_over_cell_reached",
           "softening_length_over_height", "halo_fraction"})
    EXPECT_TRUE(std::isnan(summarise(s.model, s.state).numbers.at(name))) << name;
}

}  // namespace softening_length_test
