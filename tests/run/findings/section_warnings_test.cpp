#include "run/findings/setup_warnings.hpp"
#include "model/parts/setup.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "support/cases.hpp"
#include "support/problems.hpp"

namespace section_warnings_test {

std::vector<Problem> warnings_on(const Case& c, Mesh<2> mesh)
{
  Model model = build_model(c, std::make_shared<const Mesh<2>>(std::move(mesh)), 1);
  build_state(model);
  std::vector<Problem> warnings;
  find_odd_places(model, warnings);
  return warnings;
}

std::vector<Problem> warnings_of(const Case& c) { return warnings_on(c, build_mesh(c)); }

Case two_layers(Real upper_bottom)
{
  Case c = column("mpm_gp");
  c.bodies = {body("clay", {0.0, 0.0}, {8.0, 1.0}), body("clay", {0.0, upper_bottom}, {8.0, 2.0})};
  return c;
}

TEST(SectionWarnings, AreSilentOverBodiesThatTouchOrOverlap)
{
  EXPECT_THAT(warnings_of(column("mpm_gp")), IsEmpty());
  EXPECT_THAT(warnings_of(two_layers(1.0)), IsEmpty());
  EXPECT_THAT(warnings_of(two_layers(0.8)), IsEmpty());
}

/// Each later body lies on top of those before it in the same place, down to the base of the mesh.
TEST(SectionWarnings, AreSilentOverLayersThatAreDrawnOverEachOther)
{
  Case c = column("mpm_gp");
  c.bodies = {
      body("clay", {0.0, 0.0}, {8.0, 2.0}), body("clay", {0.0, 0.0}, {8.0, 1.0}), body("clay", {0.0, 0.0}, {8.0, 0.5})};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.bodies[1].polygon = {{0.0, 0.0}, {8.0, 0.0}, {8.0, 0.7}, {0.0, 1.4}};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.bodies[2] = body("clay", {3.0, 0.0}, {5.0, 0.5});
  EXPECT_THAT(warnings_of(c), IsEmpty());
}

TEST(SectionWarnings, AGapOfACentimetreBetweenLayersIsTold)
{
  const auto warnings = warnings_of(two_layers(1.01));
  EXPECT_THAT(warnings, ElementsAre(told("body[0]", "a gap between body 0 (`clay`) and body 1 (`clay`)",
                            HasSubstr("It is 0.01 m wide at ("))));
  EXPECT_THAT(warnings[0].detail, HasSubstr("less than a cell of 0.5 m."));
}

TEST(SectionWarnings, AGapAboveTheBottomIsTold)
{
  Case c = column("mpm_gp");
  c.bodies = {body("clay", {0.0, 0.02}, {8.0, 2.0})};
  EXPECT_THAT(warnings_of(c), ElementsAre(told(_, "a gap between body 0 (`clay`) and the side `bottom`")));
}

TEST(SectionWarnings, OutlinesThatMeetUnderAnAngleHaveNoGap)
{
  Case c = column("mpm_gp");
  c.bodies[0].polygon = {{0.0, 0.0}, {8.0, 0.0}, {4.0, 2.0}, {0.0, 2.0}};
  BodyCase wedge = c.bodies[0];
  wedge.polygon = {{8.0, 0.0}, {10.0, 0.0}, {10.0, 1.5}};
  c.bodies.push_back(wedge);
  EXPECT_THAT(warnings_of(c), IsEmpty());
}

TEST(SectionWarnings, ABodyThatHangsInTheAirIsTold)
{
  Case c = column("mpm_gp");
  c.bodies.push_back(body("clay", {2.0, 2.4}, {3.0, 2.9}));
  const auto warnings = warnings_of(c);
  EXPECT_THAT(warnings, ElementsAre(told("body[1]", "body 1 (`clay`) hangs in the air",
                            "It touches no other body and no side that holds against gravity. It falls by 0.4 m. Draw "
                            "it down to what carries it.\nSoil that lands comes to rest up to a cell above the ground "
                            "(docs/limits.md#8-sides-contact-and-footings).")));
  c.bodies[1].velocity = {0.0, -1.0};  // thrown on purpose
  EXPECT_THAT(warnings_of(c), IsEmpty());
}

TEST(SectionWarnings, ARollerBesideABodyDoesNotHoldItUp)
{
  Case c = column("mpm_gp");
  c.bodies = {body("clay", {0.0, 0.5}, {8.0, 2.0})};
  EXPECT_THAT(
      warnings_of(c), ElementsAre(told("body[0]", "body 0 (`clay`) hangs in the air",
                          StartsWith("It touches no other body and no side that holds against gravity (the "
                                     "side `left` does not: soil slides along it). It falls by 0.5 m. Draw "))));
  for (SideCondition& side : c.sides)
    if (side.side == "left") side.kind = SideKind::fixed;  // a console
  EXPECT_THAT(warnings_of(c), IsEmpty());
}

TEST(SectionWarnings, AGapOfAWholeCellUnderALayerIsTold)
{
  EXPECT_THAT(warnings_of(two_layers(1.5)),
      ElementsAre(told("body[1]", "body 1 (`clay`) hangs in the air", HasSubstr("It falls by 0.5 m."))));
}

TEST(SectionWarnings, BodiesThatHangTogetherAreToldOnce)
{
  Case c = column("mpm_gp");
  c.bodies.push_back(body("clay", {2.0, 2.3}, {3.0, 2.6}));
  c.bodies.push_back(body("clay", {2.0, 2.6}, {3.0, 2.9}));
  EXPECT_THAT(warnings_of(c), ElementsAre(told("body[1]", "body 1 (`clay`) and body 2 (`clay`) hang in the air",
                                  HasSubstr("They touch no side that holds against gravity. They fall by 0.3 m."))));
}

TEST(SectionWarnings, AGapLikeAWedgeUnderABodyIsTold)
{
  for (const Real rise : {0.05, 0.4}) {
    Case c = two_layers(1.0);
    c.bodies[1] = c.bodies[0];
    c.bodies[1].polygon = {{0.0, 1.0}, {8.0, 1.0 + rise}, {8.0, 2.0}, {0.0, 2.0}};
    EXPECT_THAT(
        warnings_of(c), ElementsAre(told("body[1]", "a gap like a wedge between body 1 (`clay`) and body 0 (`clay`)",
                            HasSubstr("body 1 (`clay`) lies on body 0 (`clay`) with one end only"))))
        << rise;
    c.bodies[1].polygon = {{0.0, 1.0}, {2.0, 1.0}, {8.0, 1.0 + rise}, {8.0, 2.0}, {0.0, 2.0}};  // it has a foot
    EXPECT_THAT(warnings_of(c), IsEmpty()) << rise;
  }
}

TEST(SectionWarnings, AnOverhangAndACavernAreMeant)
{
  Case c = column("mpm_gp");
  c.bodies = {body("clay", {0.0, 0.0}, {3.0, 1.0}), body("clay", {0.0, 1.0}, {8.0, 2.0})};
  EXPECT_THAT(warnings_of(c), IsEmpty());
  c.bodies.push_back(body("clay", {6.0, 0.0}, {8.0, 1.0}));
  EXPECT_THAT(warnings_of(c), IsEmpty());
}

TEST(SectionWarnings, ASideThatDoesNotLieWhereItsNameSaysIsTold)
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

TEST(SectionWarnings, ACellThatIsMissingInsideABodyIsTold)
{
  const auto warnings = warnings_on(column("mpm_gp"), without_cell(32 + 4));  // of 64 under the body
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_THAT(warnings[0], told(_, "a part of the soil lies outside of the mesh",
                               HasSubstr("drawn with 16 m^2, their points stand for 15.75 m^2: 1.6 % is missing. It "
                                         "reaches over the boundary of the mesh at (2")));
  EXPECT_THAT(warnings[1], told(_, "the mesh has a hole", HasSubstr("0.25 m^2 are missing, about 1 cell.")));
}

TEST(SectionWarnings, AMeshInMillimetresIsTold)
{
  EXPECT_THAT(warnings_on(column("mpm_gp"), make_rectangle({0.0, 0.0}, {16000.0, 3000.0}, {32, 6})),
      Contains(testing::Field(&Problem::what, "all bodies together are smaller than a cell")));
}

}  // namespace section_warnings_test
