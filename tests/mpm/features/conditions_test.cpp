#include "mpm/features/conditions.hpp"
#include "math/errors.hpp"
#include "support/meshes.hpp"
#include "support/problems.hpp"

namespace conditions_test {

constexpr Real mass = 30.0, dt = 0.002;

// Nodes 0 1 2 3 at the bottom, 4 5 6 7, 8 9 10 11 at the top; cells 1 m x 0.5 m.
Mesh<2> mesh_3x2() { return make_rectangle({0.0, 0.0}, {3.0, 1.0}, {3, 2}); }

Vec<2> constrained(const Boundary& boundary, Index node, Vec<2> v)
{
  boundary.constrain(node, mass, {dt}, v);
  return v;
}

Vec<2> clamped(const Boundary& boundary, Index node, Vec<2> v, Vec<2> reaction = {0.0, 0.0}, Vec<2> v_1 = {0.0, 0.0})
{
  boundary.clamp(node, mass, {dt}, v_1, reaction, v);
  return v;
}

SideCondition on(const std::string& side, SideKind kind, Real adhesion = 0.0, Real friction = 0.0)
{
  SideCondition condition;
  condition.side = side, condition.kind = kind, condition.adhesion = adhesion, condition.friction = friction;
  return condition;
}

SideCondition moving(const std::string& side, Vec<2> velocity, bool slip = false)
{
  SideCondition condition = on(side, SideKind::velocity);
  condition.velocity = velocity, condition.slip = slip;
  return condition;
}

/// Two cells on a base that rises: (0,0) - (1,0) - (3,1) with the ground below.
Mesh<2> inclined_mesh()
{
  Mesh<2> mesh;
  mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}, {3.0, 1.0}, {0.0, 1.5}, {1.1, 1.4}, {2.8, 2.5}};
  mesh.cells = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  mesh.sides = {{"base", {{0, 0}, {1, 0}}}, {"front", {{1, 1}}}};
  connect(mesh);
  return mesh;
}

/// What sides make of the velocity of a node before the remap, and after it where that is given.
struct Effect {
  const char* what;
  std::vector<SideCondition> sides;
  Index node;
  Vec<2> v, constrained;
  std::optional<Vec<2>> clamped = {};
};

TEST(Boundary, MakesOfAVelocityWhatItsSidesSay)
{
  using enum SideKind;
  constexpr Real a = 6e3;
  const std::vector<SideCondition> wall{on("left", roller)},
      smooth_piston{moving("right", {-0.2, 0.1}, true), on("bottom", roller)},
      adhesive{on("bottom", contact_bilateral, a)}, rough{on("bottom", contact_bilateral, 0.0, 0.4)},
      leaves{on("bottom", contact_separating, a, 0.4)},
      wall_and_contact{on("left", roller), on("bottom", contact_bilateral)},
      wall_and_plane{on("left", roller), on("bottom", contact_separating)};
  const Effect effects[] = {
      {"a roller stops motion across it", wall, 4, {-3.0, 4.0}, {0.0, 4.0}},
      {"both ways", wall, 4, {3.0, -4.0}, {0.0, -4.0}, Vec<2>{0.0, -4.0}},
      {"a fixed side stops all", {on("bottom", fixed)}, 2, {-3.0, 4.0}, {0.0, 0.0}, Vec<2>{0.0, 0.0}},
      {"a smooth piston moves across itself", smooth_piston, 7, {0.3, 0.7}, {-0.2, 0.7}, Vec<2>{-0.2, 0.7}},
      {"and where it meets a roller", smooth_piston, 3, {0.3, 0.7}, {-0.2, 0.0}},
      {"adhesion times length", adhesive, 1, {2.0, -1.0}, {2.0 - a * 1.0 * dt / mass, 0.0}},
      {"against the motion", adhesive, 1, {-2.0, -1.0}, {-2.0 + a * 1.0 * dt / mass, 0.0}},
      {"half the length at an end", adhesive, 0, {2.0, -1.0}, {2.0 - a * 0.5 * dt / mass, 0.0}},
      {"adhesion that is enough", adhesive, 1, {0.39, -1.0}, {0.0, 0.0}},
      {"adhesion that just is not", adhesive, 1, {0.41, -1.0}, {0.41 - a * dt / mass, 0.0}},
      {"friction times the push", rough, 1, {2.0, -1.5}, {2.0 - 0.4 * 1.5, 0.0}},
      {"friction that is enough", rough, 1, {0.5, -1.5}, {0.0, 0.0}},
      {"no friction under tension, but held", rough, 1, {2.0, 1.5}, {2.0, 0.0}},
      {"adhesion and friction", {on("top", contact_bilateral, 3e3, 0.4)}, 9, {-2.0, 1.5},
          {-2.0 + 0.4 * 1.5 + 3e3 * dt / mass, 0.0}},
      {"a contact without strength is a roller", {on("bottom", contact_bilateral)}, 1, {2.0, -1.5}, {2.0, 0.0}},
      {"and holds under tension", {on("bottom", contact_bilateral)}, 1, {2.0, 0.7}, {2.0, 0.0}},
      {"a separating one lets go", {on("bottom", contact_separating)}, 1, {2.0, 0.7}, {2.0, 0.7}},
      {"whatever its strength", leaves, 1, {2.0, 0.7}, {2.0, 0.7}, Vec<2>{2.0, 0.7}},
      {"and acts where it is pressed", leaves, 1, {2.0, -1.5}, {2.0 - 0.4 - 0.6, 0.0}, Vec<2>{2.0, 0.0}},
      {"a corner of two rollers pins", {on("left", roller), on("bottom", roller)}, 0, {2.0, -1.5}, {0.0, 0.0},
          Vec<2>{0.0, 0.0}},
      {"so does one with a contact", wall_and_contact, 0, {-2.0, 1.5}, {0.0, 0.0}, Vec<2>{0.0, 0.0}},
      {"also where it is pressed", wall_and_contact, 0, {2.0, -1.5}, {0.0, 0.0}, Vec<2>{0.0, 0.0}},
      {"one with a separating plane is free to lift", wall_and_plane, 0, {2.0, 1.5}, {0.0, 1.5}},
      {"and holds what is pressed", wall_and_plane, 0, {2.0, -1.5}, {0.0, 0.0}},
  };
  for (const auto& [what, sides, node, v, expected, after] : effects) {
    const Boundary boundary(mesh_3x2(), sides);
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(constrained(boundary, node, v)[d], expected[d], expected[d] == 0.0 ? 0.0 : 1e-15) << what;
      if (after) {
        EXPECT_DOUBLE_EQ(clamped(boundary, node, v)[d], (*after)[d]) << what;
      }
    }
  }
}

TEST(Boundary, LeavesOtherNodesAlone)
{
  const Boundary boundary(mesh_3x2(), {on("left", SideKind::roller), on("bottom", SideKind::fixed)});
  for (const Index node : {5, 6, 7, 9, 10, 11}) {
    EXPECT_EQ(boundary.at(node), nullptr);
    EXPECT_THAT(constrained(boundary, node, {-3.0, 4.0}), ElementsAre(-3.0, 4.0));
    EXPECT_THAT(clamped(boundary, node, {-3.0, 4.0}), ElementsAre(-3.0, 4.0));
  }
}

TEST(DrivenSide, TakesThePrescribedVelocityEverywhereAlsoInItsCorners)
{
  const Boundary boundary(mesh_3x2(), {moving("right", {-0.2, 0.1}), on("bottom", SideKind::roller)});
  for (const Index node : {3, 7, 11}) {
    EXPECT_THAT(constrained(boundary, node, {5.0, 5.0}), ElementsAre(-0.2, 0.1));
    EXPECT_THAT(clamped(boundary, node, {5.0, 5.0}), ElementsAre(-0.2, 0.1));
  }
}

TEST(DrivenSide, TakesAVelocityThatDependsOnThePlace)
{
  const Mesh<2> mesh = mesh_3x2();
  SideCondition right = moving("right", {});
  right.velocity_at = [](Vec<2> x) { return Vec<2>{3.0 * x[1], x[0] - x[1]}; };
  const Boundary boundary(mesh, {right});
  for (const Index node : {3, 7, 11}) {
    const Vec<2> x = mesh.nodes[node];
    EXPECT_THAT(constrained(boundary, node, {5.0, 5.0}), ElementsAre(3.0 * x[1], x[0] - x[1]));
  }
}

TEST(ContactPlane, ASeparatingOneThatPushedStaysClosedForTheStep)
{
  const Boundary boundary(mesh_3x2(), {on("bottom", SideKind::contact_separating)});
  EXPECT_THAT(clamped(boundary, 2, {3.0, 4.0}, {0.0, 20.0}), ElementsAre(3.0, 0.0));
  EXPECT_THAT(clamped(boundary, 2, {3.0, 4.0}, {5.0, 0.0}), ElementsAre(3.0, 4.0));
  EXPECT_THAT(clamped(boundary, 2, {3.0, -4.0}), ElementsAre(3.0, 0.0));
}

TEST(ContactPlane, ActsOnTheRemappedVelocityWithTheStrengthLeftUnused)
{
  const Boundary boundary(mesh_3x2(), {on("bottom", SideKind::contact_bilateral, 30.0, 0.5)});  // node 1: 1 m of base
  const auto near = [](Real v) { return ElementsAre(DoubleNear(v, 1e-12), 0.0); };
  EXPECT_THAT(clamped(boundary, 1, {3.0, 4.0}, {-42.0, 24.0}), near(3.0));  // all of 30 N + 0.5 * 24 N: it slipped
  EXPECT_THAT(clamped(boundary, 1, {3.0, 4.0}, {-37.0, 24.0}), near(3.0 - 5.0 * dt / mass));
  EXPECT_THAT(clamped(boundary, 1, {-3.0, 4.0}, {-37.0, 24.0}), near(-3.0 + 5.0 * dt / mass));
  EXPECT_THAT(
      clamped(boundary, 1, {3.0, 4.0}, {-29.0, -24.0}), near(3.0 - 1.0 * dt / mass));  // pulled at: adhesion alone
  EXPECT_THAT(clamped(boundary, 1, {1e-4, 4.0}, {-12.0, 24.0}), near(0.0));            // it stuck, and stays
  Vec<2> v{1e-4, 4.0};
  boundary.clamp(1, mass, {dt}, {0.0, 0.0}, {-12.0, 24.0}, v, true);
  EXPECT_THAT(v, ElementsAre(1e-4, 0.0));  // across alone
}

TEST(ContactPlane, ASeparatingOneThatDidNotPushHoldsNothing)
{
  const Boundary boundary(mesh_3x2(), {on("bottom", SideKind::contact_separating, 30.0)});
  EXPECT_THAT(clamped(boundary, 1, {3.0, 4.0}, {0.0, 0.0}), ElementsAre(3.0, 4.0));
}

TEST(FreePart, LeavesOutWhatTheSidesCarry)
{
  const Boundary boundary(inclined_mesh(), {on("base", SideKind::contact_bilateral)});
  const Vec<2> weight{0.0, -10.0}, left = boundary.free_force(2, weight, 1.0);  // node 2: only the edge of slope 1 : 2
  EXPECT_THAT(left, ElementsAre(DoubleNear(-4.0, 1e-14), DoubleNear(-2.0, 1e-14)));
  EXPECT_THAT(boundary.free_force(4, weight, 1.0), ElementsAre(0.0, -10.0));
}

TEST(FreePart, IsNothingWhereANodeIsHeldInAllDirections)
{
  const Boundary fixed(mesh_3x2(), {on("bottom", SideKind::fixed)}),
      corner(mesh_3x2(), {on("bottom", SideKind::roller), on("left", SideKind::roller)});
  EXPECT_THAT(fixed.free_force(2, {3.0, 4.0}, 1.0), ElementsAre(0.0, 0.0));
  EXPECT_THAT(corner.free_velocity(0, {3.0, 4.0}, {3.0, 4.0}), ElementsAre(0.0, 0.0));
}

TEST(FreePart, IsAllWhereTheSoilPullsOffASeparatingContact)
{
  const Boundary boundary(mesh_3x2(), {on("bottom", SideKind::contact_separating)});
  EXPECT_THAT(boundary.free_velocity(2, {3.0, 4.0}, {0.0, 1.0}), ElementsAre(3.0, 4.0));
  EXPECT_THAT(boundary.free_velocity(2, {3.0, 4.0}, {0.0, -1.0}), ElementsAre(3.0, 0.0));
}

TEST(FreePart, OfAForceIsWhatExceedsAdhesionAndFriction)
{
  const Boundary boundary(mesh_3x2(), {on("bottom", SideKind::contact_bilateral, 30.0, 0.5)});
  EXPECT_THAT(
      boundary.free_force(1, {50.0, -24.0}, 1.0), ElementsAre(DoubleEq(50.0 - 30.0 - 12.0), 0.0));  // 1 m of base
  EXPECT_THAT(boundary.free_force(1, {-50.0, 24.0}, 1.0), ElementsAre(DoubleEq(-20.0), 0.0))
      << "a pull is not met with friction";
  EXPECT_THAT(boundary.free_force(1, {41.0, -24.0}, 1.0), ElementsAre(0.0, 0.0)) << "all is carried";
  EXPECT_THAT(boundary.free_velocity(1, {0.3, -0.2}, {41.0, -24.0}), ElementsAre(0.3, 0.0)) << "a velocity is not";
}

TEST(Contact, AtAStrengthHasItsAdhesionAndFrictionDividedByIt)
{
  const auto sides = [](Real over) {
    return Boundary(mesh_3x2(), {on("bottom", SideKind::contact_bilateral, 30.0 / over, 0.5 / over)});
  };
  const Boundary whole = sides(1.0), half = sides(2.0);
  EXPECT_EQ(whole.free_force(1, {50.0, -24.0}, 2.0), half.free_force(1, {50.0, -24.0}, 1.0));
  Vec<2> a{0.3, -0.2}, b = a;
  whole.constrain(1, mass, {dt, 2.0}, a), half.constrain(1, mass, {dt}, b);
  EXPECT_EQ(a, b);
  EXPECT_GT(a[0], 0.0);
  a = b = {0.3, -0.2};
  whole.clamp(1, mass, {dt, 2.0}, {}, {-3.0, 24.0}, a), half.clamp(1, mass, {dt}, {}, {-3.0, 24.0}, b);
  EXPECT_EQ(a, b);
  EXPECT_GT(a[0], 0.0);
}

TEST(FreePart, OfAForceIsAllWhereTheSoilLeavesASeparatingContact)
{
  const Boundary boundary(mesh_3x2(), {on("bottom", SideKind::contact_separating, 30.0)});
  EXPECT_THAT(boundary.free_force(2, {40.0, 24.0}, 1.0), ElementsAre(40.0, 24.0));
  EXPECT_THAT(boundary.free_force(2, {40.0, -24.0}, 1.0), ElementsAre(DoubleEq(10.0), 0.0));
}

TEST(Corner, DoesNotDependOnTheOrderOfTheSides)
{
  const SideCondition left = on("left", SideKind::roller),
                      bottom = on("bottom", SideKind::contact_separating, 2e3, 0.3);
  const auto mesh = mesh_3x2();
  for (const Vec<2> v : {Vec<2>{2.0, -1.5}, Vec<2>{-2.0, 1.5}, Vec<2>{0.1, -0.1}})
    EXPECT_EQ(constrained(Boundary(mesh, {left, bottom}), 0, v), constrained(Boundary(mesh, {bottom, left}), 0, v));
}

TEST(Corner, LeavesTheLastWordToARollerThatMeetsASeparatingPlane)
{
  const auto mesh = inclined_mesh();
  const SideCondition base = on("base", SideKind::contact_separating), front = on("front", SideKind::roller);
  for (const Boundary& boundary : {Boundary(mesh, {base, front}), Boundary(mesh, {front, base})}) {
    const Vec<2> v = constrained(boundary, 2, {5.0, -1.0});
    const Vec<2> normal{1.5 / std::hypot(1.5, 0.2), 0.2 / std::hypot(1.5, 0.2)};
    EXPECT_NEAR(v[0] * normal[0] + v[1] * normal[1], 0.0, 1e-14);
  }
}

TEST(InclinedSide, HasOutwardNormalsWeightedByLength)
{
  const auto mesh = inclined_mesh();
  const Boundary boundary(mesh, {on("base", SideKind::roller)});
  const Real s = std::sqrt(5.0);
  EXPECT_THAT(boundary.at(0)->sides[0].normal, ElementsAre(0.0, -1.0));
  EXPECT_THAT(boundary.at(2)->sides[0].normal, ElementsAre(DoubleEq(1.0 / s), DoubleEq(-2.0 / s)));
  // node 1: edge vectors (1, 0) and (2, 1) give the sum (1, -3) of normals times length
  EXPECT_THAT(
      boundary.at(1)->sides[0].normal, ElementsAre(DoubleEq(1.0 / std::sqrt(10.0)), DoubleEq(-3.0 / std::sqrt(10.0))));
}

TEST(InclinedSide, HasHalfTheLengthOfEachEdge)
{
  const Real a = 7e3;
  const Boundary boundary(inclined_mesh(), {on("base", SideKind::contact_bilateral, a)});
  EXPECT_DOUBLE_EQ(boundary.at(0)->sides[0].adhesion_force, a * 0.5);
  EXPECT_DOUBLE_EQ(boundary.at(1)->sides[0].adhesion_force, a * 0.5 * (1.0 + std::sqrt(5.0)));
  EXPECT_DOUBLE_EQ(boundary.at(2)->sides[0].adhesion_force, a * 0.5 * std::sqrt(5.0));
}

TEST(InclinedSide, LetsSoilSlideAlongItOnly)
{
  const Boundary boundary(inclined_mesh(), {on("base", SideKind::roller)});
  // along (2, 1)/sqrt(5) at node 2
  EXPECT_THAT(constrained(boundary, 2, {4.0, 2.0}), ElementsAre(DoubleNear(4.0, 1e-15), DoubleNear(2.0, 1e-15)));
  EXPECT_THAT(constrained(boundary, 2, {1.0, -2.0}), ElementsAre(DoubleNear(0.0, 1e-15), DoubleNear(0.0, 1e-15)));
  EXPECT_THAT(constrained(boundary, 2, {5.0, 0.0}), ElementsAre(DoubleNear(4.0, 1e-15), DoubleNear(2.0, 1e-15)));
}

TEST(InclinedSide, TakesFrictionAlongTheSlope)
{
  const Boundary boundary(inclined_mesh(), {on("base", SideKind::contact_bilateral, 0.0, 0.5)});
  // (5, 0) = (4, 2) along + (1, -2) across: speed sqrt(20); friction takes half of sqrt(5), a quarter of that
  EXPECT_THAT(constrained(boundary, 2, {5.0, 0.0}), ElementsAre(DoubleNear(3.0, 1e-14), DoubleNear(1.5, 1e-14)));
}

TEST(InclinedSide, PinsTheCornerWithASideThatIsNotAtRightAngles)
{
  const Boundary boundary(inclined_mesh(), {on("base", SideKind::roller), on("front", SideKind::roller)});
  EXPECT_TRUE(boundary.at(2)->corner);
  EXPECT_THAT(constrained(boundary, 2, {5.0, 1.0}), ElementsAre(0.0, 0.0));
}

/// A valley between two banks of slope 1 : 2; its bottom is node 1 at (0, 0).
Mesh<2> flat_valley()
{
  Mesh<2> mesh;
  mesh.nodes = {{-1.0, 0.5}, {0.0, 0.0}, {1.0, 0.5}, {1.0, 2.0}, {0.0, 2.0}, {-1.0, 2.0}};
  mesh.cells = {{0, 1, 4, 5}, {1, 2, 3, 4}};
  mesh.sides = {{"left", {{0, 0}}}, {"right", {{1, 0}}}};
  return mesh;
}

TEST(Corner, OfTwoSeparatingBanksHoldsWhatPushesOnBothAndLetsGoWhatLeavesOne)
{
  for (const auto& [first, second] : {std::pair{"left", "right"}, std::pair{"right", "left"}}) {
    const Boundary boundary(
        flat_valley(), {on(first, SideKind::contact_separating), on(second, SideKind::contact_separating)});
    EXPECT_THAT(constrained(boundary, 1, {0.0, -2.0}), ElementsAre(0.0, 0.0));
    EXPECT_THAT(constrained(boundary, 1, {0.5, -2.0}), ElementsAre(0.0, 0.0));
    EXPECT_THAT(constrained(boundary, 1, {1.0, 3.0}), ElementsAre(1.0, 3.0));  // off both
    const Vec<2> along = constrained(boundary, 1, {3.0, 1.0});                 // into the right one alone: up along it
    EXPECT_THAT(along, ElementsAre(DoubleNear(2.8, 1e-14), DoubleNear(1.4, 1e-14)));
    const Vec<2> pushed_off =
        constrained(boundary, 1, {1.0, -1.6});  // pushes on both, and the right one turns it off the left one
    EXPECT_THAT(pushed_off, ElementsAre(DoubleNear(0.16, 1e-14), DoubleNear(0.08, 1e-14)));
    EXPECT_THAT(boundary.free_force(1, {1.0, -20.0}, 1.0), ElementsAre(0.0, 0.0));
    EXPECT_THAT(boundary.free_force(1, {3.0, 1.0}, 1.0), ElementsAre(DoubleNear(2.8, 1e-14), DoubleNear(1.4, 1e-14)));
  }
}

TEST(Corner, OfARollerAndASeparatingBankIsClosedWhereTheRollerTurnsTheMotionIntoTheBank)
{
  const Boundary boundary(
      flat_valley(), {on("left", SideKind::roller), on("right", SideKind::contact_separating, 0.0, 0.3)});
  EXPECT_THAT(constrained(boundary, 1, {0.0, -2.0}), ElementsAre(0.0, 0.0));
  EXPECT_THAT(constrained(boundary, 1, {0.8, 0.75}), ElementsAre(0.0, 0.0));  // off both, but the roller turns it back
  EXPECT_THAT(constrained(boundary, 1, {-4.0, 2.0}),
      ElementsAre(DoubleNear(-4.0, 1e-14), DoubleNear(2.0, 1e-14)));  // up along the roller
}

TEST(Corner, ThatWasClosedStaysClosedInTheRemap)
{
  const Boundary boundary(
      flat_valley(), {on("left", SideKind::contact_separating), on("right", SideKind::contact_separating)});
  EXPECT_THAT(clamped(boundary, 1, {0.1, 3.0}, {0.0, 20.0}), ElementsAre(0.0, 0.0));
  EXPECT_THAT(clamped(boundary, 1, {0.1, 3.0}), ElementsAre(0.1, 3.0));  // it did not act
  const Vec<2> on_the_right =
      clamped(boundary, 1, {0.0, 3.0}, {-5.0, 10.0}, {2.0, 1.0});  // which held it in step 2: it runs along that
  EXPECT_THAT(on_the_right, ElementsAre(DoubleNear(1.2, 1e-14), DoubleNear(0.6, 1e-14)));
}

/// The bottom in two parts of 1 m and 2 m.
Mesh<2> mesh_on_two_bases()
{
  auto mesh = mesh_3x2();
  mesh.sides.push_back({"base left", {{0, 0}}});
  mesh.sides.push_back({"base right", {{1, 0}, {2, 0}}});
  return mesh;
}

TEST(TwoParts, OfAStraightRollerSlideAsOne)
{
  const Boundary boundary(mesh_on_two_bases(), {on("base left", SideKind::roller), on("base right", SideKind::roller)});
  EXPECT_FALSE(boundary.at(1)->corner);
  EXPECT_THAT(constrained(boundary, 1, {2.0, -1.5}), ElementsAre(2.0, 0.0));
}

TEST(TwoParts, OfAStraightBaseThatAreAlikeAreThatBase)
{
  for (const SideKind hold : {SideKind::contact_bilateral, SideKind::contact_separating}) {
    const SideCondition whole = on("bottom", hold, 6e3, 0.3);
    SideCondition left = whole, right = whole;
    left.side = "base left", right.side = "base right";
    const Boundary one(mesh_3x2(), {whole}), two(mesh_on_two_bases(), {left, right});
    for (const Vec<2> v : {Vec<2>{2.0, -1.5}, Vec<2>{-0.9, -2.5}, Vec<2>{0.3, 0.7}}) {
      EXPECT_EQ(constrained(two, 1, v), constrained(one, 1, v));
      for (const Vec<2> reaction : {Vec<2>{0.0, 0.0}, Vec<2>{900.0, 2e4}, Vec<2>{-1e4, 2e4}})
        EXPECT_EQ(clamped(two, 1, v, reaction), clamped(one, 1, v, reaction));
      EXPECT_EQ(two.free_force(1, {1e4 * v[0], 1e4 * v[1]}, 1.0), one.free_force(1, {1e4 * v[0], 1e4 * v[1]}, 1.0));
    }
  }
}

/// The push of the node is that of both half edges, each with its own friction; the order of the lines does not count.
TEST(TwoParts, OfAStraightBaseShareAdhesionAndFrictionByLength)
{
  const SideCondition rough = on("base left", SideKind::contact_bilateral, 6e3, 0.4);
  const SideCondition smooth = on("base right", SideKind::contact_bilateral, 3e3);
  for (const auto& sides : {std::vector{rough, smooth}, std::vector{smooth, rough}}) {
    const Boundary boundary(mesh_on_two_bases(), sides);
    const Real expected = 2.0 - 0.5 * 0.4 * 1.5 - (3e3 + 1.5e3) * dt / mass;
    EXPECT_THAT(constrained(boundary, 1, {2.0, -1.5}), ElementsAre(DoubleEq(expected), 0.0));
    EXPECT_THAT(clamped(boundary, 1, {2.0, -1.5}, {-3000.0, 10000.0}),
        ElementsAre(DoubleEq(2.0 - (4500.0 + 0.2 * 10000.0 - 3000.0) * dt / mass), 0.0));
  }
}

/// Pressed on, both act; pulled off, the bilateral one alone. The order of the lines does not count.
TEST(TwoParts, OfWhichOneLetsGoShareThePushAsWell)
{
  const SideCondition leaves = on("base left", SideKind::contact_separating, 1e3, 0.4);
  const SideCondition holds = on("base right", SideKind::contact_bilateral, 6e3, 0.2);
  for (const auto& sides : {std::vector{leaves, holds}, std::vector{holds, leaves}}) {
    const Boundary boundary(mesh_on_two_bases(), sides);
    EXPECT_EQ(boundary.at(1)->n, 2);
    const Real pressed = 2.0 - 0.5 * (0.4 + 0.2) * 1.5 - (500.0 + 3e3) * dt / mass, pulled = 2.0 - 3e3 * dt / mass;
    EXPECT_THAT(constrained(boundary, 1, {2.0, -1.5}), ElementsAre(DoubleNear(pressed, 1e-14), 0.0));
    EXPECT_THAT(constrained(boundary, 1, {2.0, 1.5}), ElementsAre(DoubleNear(pulled, 1e-14), 0.0));
    EXPECT_THAT(clamped(boundary, 1, {2.0, -1.5}, {-3000.0, 10000.0}),
        ElementsAre(DoubleNear(2.0 - (3500.0 + 0.3 * 10000.0 - 3000.0) * dt / mass, 1e-14), 0.0));
    EXPECT_THAT(
        boundary.free_force(1, {9000.0, -10000.0}, 1.0), ElementsAre(DoubleNear(9000.0 - 3500.0 - 3000.0, 1e-9), 0.0));
  }
}

TEST(TwoParts, OfAContactAndARollerHaveTheStrengthOfTheContact)
{
  const SideCondition smooth = on("base left", SideKind::roller),
                      rough = on("base right", SideKind::contact_bilateral, 6e3);
  for (const auto& sides : {std::vector{smooth, rough}, std::vector{rough, smooth}})
    EXPECT_THAT(constrained(Boundary(mesh_on_two_bases(), sides), 1, {2.0, -1.5}),
        ElementsAre(DoubleEq(2.0 - 3e3 * dt / mass), 0.0));
}

TEST(Boundary, NamesASideThatTheMeshDoesNotHave)
{
  const auto problems = problems_of([] { Boundary(mesh_3x2(), {on("botom", SideKind::roller)}); });
  ASSERT_THAT(
      problems, ElementsAre(told(_, "the mesh has no side `botom`", "Sides of this mesh: left, right, bottom, top")));
  EXPECT_EQ(problems[0].topic, "boundary");
  EXPECT_TRUE(problems[0].at_key);
  Mesh<2> nameless = mesh_3x2();
  nameless.sides.clear();
  EXPECT_THAT(problems_of([&] { find_side(nameless, "base"); }),
      ElementsAre(told(_, _,
          "No side of this mesh has a name. A mesh file names them by physical groups: in gmsh\n"
          "`Physical Curve(\"base\") = {1, 2};`. In [mesh] of a polygon: edges = { base = [0] }.\n"
          "Files .bdf, .nas and .vtk carry no names of groups: save the mesh as .msh or .unv.")));
  nameless.sides = {{.name = "fault", .is_inside = true}, {"base", {{0, 0}}}};
  EXPECT_THAT(problems_of([&] { find_side(nameless, "fault"); }),
      ElementsAre(told("boundary.fault", "the side `fault` lies inside the mesh, between two cells",
          "Its curve bounds nothing there: only parts of the boundary take a condition. Sides of this mesh: base")));
}

TEST(Boundary, RefusesAThirdSideAtANode)
{
  auto mesh = mesh_3x2();
  mesh.sides.push_back({"base left", {{0, 0}}});
  const std::vector sides{
      on("left", SideKind::roller), on("bottom", SideKind::roller), on("base left", SideKind::roller)};
  EXPECT_EQ(refusal<InputError>([&] { Boundary(mesh, sides); }),
      "boundary.base left: a node lies on more than two sides with conditions");
}

}  // namespace conditions_test
