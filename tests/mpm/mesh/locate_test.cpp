#include "mpm/mesh/locate.hpp"
#include "support/meshes.hpp"

namespace locate_test {

/// Left of all four straight sides by more than `margin` [m]: an independent form of locate().
bool holds(const Mesh<2>& mesh, Index cell, Vec<2> x, Real margin)
{
  const auto corners = mesh.corners(cell);
  for (int s = 0; s < 4; ++s) {
    const Vec<2>&a = corners[s], &b = corners[(s + 1) % 4];
    const Real area = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
    if (area <= margin * std::hypot(b[0] - a[0], b[1] - a[1])) return false;
  }
  return true;
}

/// Owners that locate() names from every cell of the mesh as first guess; `outside` where it finds none.
std::set<Index> owners_from_every_guess(const Mesh<2>& mesh, Vec<2> x)
{
  std::set<Index> owners;
  for (Index guess = 0; guess < mesh.n_cells(); ++guess) {
    const Location at = locate(mesh, x, guess);
    owners.insert(at.inside ? at.cell : outside);
  }
  return owners;
}

TEST(Locate, FindsTheOneCellThatHoldsAPlaceFromAnyFirstGuess)
{
  for (const Real share : {0.0, 0.1, 0.2, 0.3, 0.35}) {
    const auto mesh = distorted_rectangle(9, 6, 0.1, share, 11);
    Random random(12);
    for (int k = 0; k < 300; ++k) {
      const Vec<2> x{random.between(0.0, 0.9), random.between(0.0, 0.6)};
      std::set<Index> expected;
      for (Index e = 0; e < mesh.n_cells(); ++e)
        if (holds(mesh, e, x, 1e-12)) expected.insert(e);
      if (expected.empty()) continue;  // on a side
      ASSERT_EQ(owners_from_every_guess(mesh, x), expected)
          << "place " << x[0] << ", " << x[1] << ", nodes moved by " << share;
    }
  }
}

TEST(Locate, GivesLocalCoordinatesThatMapBackToThePlace)
{
  const auto mesh = distorted_rectangle(9, 6, 0.1, 0.3, 13);
  Random random(14);
  for (int k = 0; k < 3000; ++k) {
    const Vec<2> x{random.between(0.0, 0.9), random.between(0.0, 0.6)};
    const Location at = locate(mesh, x, random.below(mesh.n_cells()));
    ASSERT_TRUE(at.inside);
    const Vec<2> back = place_in_cell(mesh, at.cell, at.local);
    EXPECT_NEAR(back[0], x[0], 1e-15);
    EXPECT_NEAR(back[1], x[1], 1e-15);
  }
}

TEST(Locate,
    IsNotFooledByAnInverseMapWithoutAnswerInAFarCell)  // plain Newton sent 1.6 % of these places to a wrong cell
{
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto mesh = distorted_rectangle(12, 8, 0.1, 0.3, seed);
    Random random(seed);
    for (int k = 0; k < 2000; ++k) {
      const Vec<2> x{random.between(0.0, 1.2), random.between(0.0, 0.8)};
      const Location at = locate(mesh, x, random.below(mesh.n_cells()));
      ASSERT_TRUE(at.inside);
      ASSERT_TRUE(holds(mesh, at.cell, x, -1e-12)) << "cell " << at.cell << " does not hold " << x[0] << ", " << x[1];
    }
  }
}

// Side length 1/4: coordinates and their halves are exact, so a position on a side is on it to the last bit.
Mesh<2> exact_mesh() { return make_rectangle({0.0, 0.0}, {1.0, 0.75}, {4, 3}); }

TEST(Locate, GivesAPlaceOnASideToTheCellRightOfItOrAboveIt)
{
  const auto mesh = exact_mesh();
  EXPECT_THAT(owners_from_every_guess(mesh, {0.25, 0.1}), ElementsAre(1));
  EXPECT_THAT(owners_from_every_guess(mesh, {0.4, 0.25}), ElementsAre(5));
  EXPECT_EQ(locate(mesh, {0.25, 0.1}, 0).local[0], -1.0);
}

TEST(Locate, GivesAPlaceOnACornerToOneOfFourCells)
{
  const auto mesh = exact_mesh();
  EXPECT_THAT(owners_from_every_guess(mesh, {0.5, 0.25}), ElementsAre(6));
  EXPECT_THAT(locate(mesh, {0.5, 0.25}, 1).local, ElementsAre(-1.0, -1.0));
}

TEST(Locate, ClosesTheOuterBoundary)
{
  const auto mesh = exact_mesh();
  EXPECT_THAT(owners_from_every_guess(mesh, {1.0, 0.1}), ElementsAre(3));
  EXPECT_THAT(owners_from_every_guess(mesh, {0.6, 0.75}), ElementsAre(10));
  EXPECT_THAT(owners_from_every_guess(mesh, {1.0, 0.75}), ElementsAre(11));
  EXPECT_THAT(owners_from_every_guess(mesh, {0.0, 0.0}), ElementsAre(0));
  EXPECT_THAT(owners_from_every_guess(mesh, {1.0, 0.25}), ElementsAre(7));
}

TEST(
    Locate, AcceptsAPlaceOnAnySideOfADistortedMesh)  // round-off may leave it to either of the two cells, never to none
{
  for (const Real share : {0.1, 0.3, 0.35}) {
    const auto mesh = distorted_rectangle(6, 5, 0.1, share, 15);
    Random random(16);
    for (Index e = 0; e < mesh.n_cells(); ++e)
      for (int s = 0; s < 4; ++s) {
        const Vec<2>&a = mesh.nodes[mesh.cells[e][s]], &b = mesh.nodes[mesh.cells[e][(s + 1) % 4]];
        const Real t = random.between(0.0, 1.0);
        for (const Real part : {0.0, t}) {
          const Vec<2> x{a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])};
          const Location at = locate(mesh, x, e);
          ASSERT_TRUE(at.inside);
          EXPECT_TRUE(holds(mesh, at.cell, x, -1e-12));
        }
      }
  }
}

TEST(Locate, ReportsPlacesOutsideTheMesh)
{
  const auto regular = exact_mesh();
  const auto distorted = distorted_rectangle(4, 3, 0.25, 0.3, 17);
  for (const Vec<2> x :
      {Vec<2>{-1e-6, 0.3}, Vec<2>{1.000001, 0.3}, Vec<2>{0.3, -0.5}, Vec<2>{0.3, 7.0}, Vec<2>{-3.0, -2.0}})
    for (const Mesh<2>* mesh : {&regular, &distorted})
      EXPECT_THAT(owners_from_every_guess(*mesh, x), ElementsAre(outside)) << x[0] << ", " << x[1];
}

TEST(Locate, EndsAtTheWallThatThePlaceLiesBeyond)
{
  const auto mesh = distorted_rectangle(4, 3, 0.25, 0.3, 18);
  for (const Index guess : {0, 5, 11}) {
    const Location at = locate(mesh, {1.01, 0.3}, guess);
    EXPECT_FALSE(at.inside);
    EXPECT_EQ(at.cell % 4, 3);
    EXPECT_GT(at.local[0], 1.0);
  }
}

TEST(Locate, SaysNoToWhatIsNotANumber)
{
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  const auto distorted = distorted_rectangle(4, 3, 0.25, 0.3, 19);
  for (const Vec<2> x : {Vec<2>{nan, 0.1}, Vec<2>{0.1, nan}, Vec<2>{infinity, 0.1}, Vec<2>{0.1, -infinity}}) {
    EXPECT_FALSE(locate(exact_mesh(), x, 2).inside);
    EXPECT_FALSE(locate(distorted, x, 2).inside);
  }
}

TEST(Locate, FindsAPlaceAcrossANotchThatTheWalkCannotCross)  // cells 0 and 1 touch neither each other nor anything else
{
  Mesh<2> mesh;
  mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {2.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {2.0, 1.0}};
  mesh.cells = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  connect(mesh);
  EXPECT_THAT(owners_from_every_guess(mesh, {2.5, 0.5}), ElementsAre(1));
  EXPECT_THAT(owners_from_every_guess(mesh, {1.5, 0.5}), ElementsAre(outside));
}

TEST(Locate, WithoutAFirstGuessFindsTheSameCell)
{
  for (const Real share : {0.0, 0.3, 0.35}) {
    const auto mesh = distorted_rectangle(9, 6, 0.1, share, 20);
    Random random(21);
    for (int k = 0; k < 2000; ++k) {
      const Vec<2> x{random.between(0.0, 0.9), random.between(0.0, 0.6)};
      const Location at = locate(mesh, x);
      ASSERT_TRUE(at.inside);
      ASSERT_TRUE(holds(mesh, at.cell, x, -1e-12));
    }
    for (const Vec<2> x : {Vec<2>{-1e-6, 0.3}, Vec<2>{0.900001, 0.3}, Vec<2>{5.0, -7.0}})
      EXPECT_FALSE(locate(mesh, x).inside);
  }
}

TEST(Locate, WithoutAFirstGuessObeysTheHalfOpenRule)
{
  const auto mesh = exact_mesh();
  EXPECT_EQ(locate(mesh, {0.25, 0.1}).cell, 1);
  EXPECT_EQ(locate(mesh, {0.4, 0.25}).cell, 5);
  EXPECT_EQ(locate(mesh, {0.5, 0.25}).cell, 6);
  EXPECT_EQ(locate(mesh, {1.0, 0.75}).cell, 11);
}

TEST(ClampToCell, MovesOnlyWhatLiesOutside)
{
  EXPECT_THAT(clamp_to_cell({1.5, -0.3}), ElementsAre(1.0, -0.3));
  EXPECT_THAT(clamp_to_cell({-0.2, -7.0}), ElementsAre(-0.2, -1.0));
}

}  // namespace locate_test
