#include "run/findings/missing_soil.hpp"
#include "run/findings/side_warnings.hpp"
#include "model/parts/setup.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "support/cases.hpp"
#include "support/problems.hpp"

namespace missing_soil_test {

std::vector<Problem> warnings_on(const Case& c, Mesh<2> mesh)
{
  Model model = build_model(c, std::make_shared<const Mesh<2>>(std::move(mesh)), 1);
  const State state = build_state(model);
  std::vector<Problem> warnings;
  find_odd_sides(model, state, warnings);
  find_missing_soil(model, state, warnings);
  return warnings;
}

TEST(SideWarnings, ASideThatDoesNotLieWhereItsNameSaysIsTold)
{
  const Case c = column("mpm_gp");
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {16.0, 3.0}, {32, 6});
  EXPECT_THAT(warnings_on(c, mesh), IsEmpty());
  std::swap(mesh.sides[0].name, mesh.sides[1].name);
  const auto warnings = warnings_on(c, mesh);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_THAT(warnings[0],
      told(_, "the side `right` does not face to the right", HasSubstr("It faces to the left, 3 m long.")));
}

Mesh<2> without_cell(Index cell)
{
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {16.0, 3.0}, {32, 6});
  mesh.cells.erase(mesh.cells.begin() + cell);
  for (NamedSide& side : mesh.sides)
    for (CellSide& edge : side.edges) edge.cell -= edge.cell > cell ? 1 : 0;
  connect(mesh);
  return mesh;
}

TEST(MissingSoil, ACellThatIsMissingInsideABodyIsTold)
{
  const auto warnings = warnings_on(column("mpm_gp"), without_cell(32 + 4));  // of 64 under the body
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_THAT(warnings[0], told(_, "a part of the soil lies outside of the mesh",
                               HasSubstr("drawn with 16 m^2, their points stand for 15.75 m^2: 1.6 % is missing. It "
                                         "reaches over the boundary of the mesh at (2")));
  EXPECT_THAT(warnings[1], told(_, "the mesh has a hole", HasSubstr("0.25 m^2 are missing, about 1 cell.")));
}

}  // namespace missing_soil_test
