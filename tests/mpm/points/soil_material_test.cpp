#include "mpm/points/soil_material.hpp"
#include "support/test.hpp"

namespace soil_material_test {

const std::vector<Real> clay_values{2e6, 0.4, 8e3, 2e3, 50.0};

SoilMaterial clay(const std::vector<int>& varying = {})
{
  const MaterialType* type = find_material("tresca_softening");
  return {"clay", type, type->make_varying(type->complete(clay_values), varying), 1990.0, {}};
}

/// One point with the given numbers beyond the fixed rows.
PointBlocks<2> one_point(const RowTable& table, const std::vector<Real>& more)
{
  PointBlocks<2> points(1, table);
  std::vector<Real> values(static_cast<std::size_t>(points.n_rows()), 0.0);
  std::ranges::copy(more, values.begin() + Rows::state);
  points.add({0, 0}, values);
  return points;
}

TEST(SoilMaterial, HasRowsForItsStateAndThenForItsParametersThatVary)
{
  RowTable table;
  SoilMaterial soil = clay({2, 4});
  add_rows(0, soil, table);
  EXPECT_THAT(soil.rows, ElementsAre(Rows::state, Rows::state + 1, Rows::state + 2));
  EXPECT_TRUE(soil.varies());
  EXPECT_EQ(table.added()[0].name, "eps_eq_p");
  EXPECT_EQ(table.added()[1].name, "parameter_su_peak");
  EXPECT_EQ(table.added()[1].unit, "Pa");
  EXPECT_EQ(table.added()[1].averaging, Averaging::keep);
  EXPECT_EQ(table.added()[2].name, "parameter_eta");
}

TEST(SoilMaterial, OfTwoLawsSharesARowOfTheSameName)
{
  RowTable table;
  SoilMaterial soil = clay(), sand = clay();
  sand.type = find_material("mohr_coulomb");
  sand.law = sand.type->make(std::vector<Real>{2e6, 0.3, 1e3, 30.0, 0.0, INFINITY, 1e3, 30.0, 0.0, 0.0});
  add_rows(0, soil, table);
  add_rows(1, sand, table);
  EXPECT_EQ(table.added().size(), 2u);
  EXPECT_EQ(row_of(soil, Role::plastic_strain), row_of(sand, Role::plastic_strain));
  EXPECT_TRUE(table.added()[0].is_of(1));
  EXPECT_FALSE(table.added()[1].is_of(0)) << "clay has no opening";
}

TEST(SoilMaterial, GivesTheStrengthOfAPointFromItsOwnNumbers)
{
  RowTable table;
  SoilMaterial uniform = clay(), varying = clay({2});
  add_rows(0, uniform, table);
  const PointBlocks<2> points = one_point(table, {0.06});
  EXPECT_TRUE(has_strength(uniform) && strain_gives_strength(uniform));
  EXPECT_DOUBLE_EQ(strength_of(uniform, points.block(0), 0), 2e3 + 6e3 * std::exp(-3.0));
  EXPECT_EQ(strength_at(uniform, points.block(0), 0, 0.0), 8e3);

  RowTable more;
  add_rows(0, varying, more);
  const PointBlocks<2> strong = one_point(more, {0.06, 12e3});
  EXPECT_DOUBLE_EQ(strength_of(varying, strong.block(0), 0), 2e3 + 10e3 * std::exp(-3.0));
  EXPECT_EQ(strength_at(varying, strong.block(0), 0, 0.0), 12e3);
}

TEST(SoilMaterial, OfALawWithoutARoleSaysSo)
{
  RowTable table;
  SoilMaterial fluid = clay();
  fluid.type = find_material("newtonian_fluid");
  fluid.law = fluid.type->make(std::vector<Real>{2e6, 1.0, 0.0});
  add_rows(0, fluid, table);
  EXPECT_EQ(row_of(fluid, Role::plastic_strain), -1);
  EXPECT_FALSE(has_strength(fluid));
  EXPECT_EQ(row_of(clay(), Role::plastic_strain), -1) << "no body is of it: it has no rows";
}

}  // namespace soil_material_test
