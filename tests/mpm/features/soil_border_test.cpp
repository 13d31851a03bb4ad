#include "mpm/features/soil_border.hpp"

#include "support/simulations.hpp"
#include "support/two_soils.hpp"

namespace soil_border_test {

TEST(BorderOfTwoSoils, HasTheDirectionOfAStraightCut)
{
  struct Row {
    Index points;
    Real mean, most;
  };
  for (const auto& [points, mean, most] : {Row{3, 2.5, 9.0}, Row{4, 2.0, 7.0}, Row{6, 1.5, 5.0}}) {
    Real sum = 0.0, largest = 0.0;
    int n = 0;
    for (Real degrees = -60.0; degrees < 120.0; degrees += 6.5) {
      const Simulation s(two_soils("mpm_gp", Shares::overlap, {2.5 + 0.003 * degrees, 2.45}, degrees, points));
      for (const Index cell : s.state.points.occupied()) {
        const Vec<2>& at = s.model.mesh->centres[cell];
        const Index b = s.state.points.first_block(cell);
        if (s.state.points.block(b).next < 0 || std::hypot(at[0] - 2.5, at[1] - 2.45) > 0.5) continue;
        const Vec<2> normal = find_border(*s.model.mesh, s.state.points, cell, {0, 1}).across;
        const Real angle = degrees * std::numbers::pi / 180.0;
        const Real along = std::abs(normal[0] * std::cos(angle) + normal[1] * std::sin(angle));
        EXPECT_NEAR(std::hypot(normal[0], normal[1]), 1.0, 1e-12);
        const Real error = std::asin(std::min(along, 1.0)) * 180.0 / std::numbers::pi;
        largest = std::max(largest, error);
        sum += error;
        ++n;
      }
    }
    EXPECT_GT(n, 60);
    EXPECT_LT(sum / n, mean) << points;
    EXPECT_LT(largest, most) << points;
  }
}

TEST(BorderOfTwoSoils, IsNoneWhereTheyAreMixed)
{
  Simulation s(two_soils("mpm_gp", Shares::overlap, {2.625, 2.375}, 0.0));
  draw_points(s, [](Vec<2> x) {  // the upper soil falls between the points of the lower
    return x[1] > 2.375 ? Vec<2>{x[0] + 0.03, 4.75 - x[1] + 0.01} : x;
  });
  int shared = 0;
  for (const Index cell : s.state.points.occupied()) {
    const Index b = s.state.points.first_block(cell);
    const Vec<2>& at = s.model.mesh->centres[cell];
    if (s.state.points.block(b).next < 0 || std::abs(at[0] - 2.625) > 0.6 || at[1] > 2.0 || at[1] < 1.6) continue;
    ++shared;
    const Vec<2> normal = find_border(*s.model.mesh, s.state.points, cell, {0, 1}).across;
    EXPECT_EQ(normal[0], 0.0);
    EXPECT_EQ(normal[1], 0.0);
  }
  EXPECT_GT(shared, 2);
}

/// The upper soil as a strip of this thickness around a line [m].
Case strip(Vec<2> place, Real degrees, Real thickness, Real length)
{
  Case c = two_soils("mpm_gp", Shares::overlap, place, degrees);
  const Real angle = degrees * std::numbers::pi / 180.0, cosine = std::cos(angle), sine = std::sin(angle);
  std::vector<Vec<2>> corners;
  for (const auto& [x, y] : {Vec<2>{-1.0, -1.0}, Vec<2>{1.0, -1.0}, Vec<2>{1.0, 1.0}, Vec<2>{-1.0, 1.0}}) {
    const Real along = 0.5 * length * x, up = 0.5 * thickness * y;
    corners.push_back({place[0] + cosine * along - sine * up, place[1] + sine * along + cosine * up});
  }
  c.bodies[1].polygon = corners;
  return c;
}

TEST(BorderOfTwoSoils, GoesAlongABandThatLiesWithinOneOfThem)
{
  for (const Real thickness : {0.08, 0.125, 0.25}) {
    Real sum = 0.0;
    int n = 0, n_bands = 0;
    for (Real degrees = -60.0; degrees < 120.0; degrees += 13.0) {
      const Vec<2> place{2.5 + 0.003 * degrees, 2.43};
      const Simulation s(strip(place, degrees, thickness, 3.0));
      const Real angle = degrees * std::numbers::pi / 180.0;
      for (const Index cell : s.state.points.occupied()) {
        const Vec<2>& at = s.model.mesh->centres[cell];
        const Index b = s.state.points.first_block(cell);
        if (s.state.points.block(b).next < 0 || std::hypot(at[0] - place[0], at[1] - place[1]) > 0.8) continue;
        const Border border = find_border(*s.model.mesh, s.state.points, cell, {0, 1});
        ASSERT_NEAR(std::hypot(border.across[0], border.across[1]), 1.0, 1e-12) << degrees << " " << thickness;
        const Real along = std::abs(border.across[0] * std::cos(angle) + border.across[1] * std::sin(angle));
        sum += std::asin(std::min(along, 1.0)) * 180.0 / std::numbers::pi;
        ++n;
        if (border.band < 0) continue;
        ++n_bands;
        EXPECT_EQ(border.band, 1);
        const Real height = border.across[0] * (place[0] - at[0]) + border.across[1] * (place[1] - at[1]);
        EXPECT_NEAR(border.height, height, 0.06) << degrees;
      }
    }
    EXPECT_GT(n, 60);
    EXPECT_GT(n_bands, n / 3) << thickness;
    EXPECT_LT(sum / n, 4.0) << thickness;
  }
}

TEST(BorderOfTwoSoils, IsNoneInAnInclusionThatIsAsLongAsWide)
{
  for (const Real degrees : {0.0, 30.0}) {
    const Simulation s(strip({2.625, 2.375}, degrees, 0.25, 0.25));
    int n = 0;
    for (const Index cell : s.state.points.occupied()) {
      const Vec<2>& at = s.model.mesh->centres[cell];
      if (std::hypot(at[0] - 2.625, at[1] - 2.375) > 0.01) continue;
      ++n;
      EXPECT_EQ(find_border(*s.model.mesh, s.state.points, cell, {0, 1}).across[0], 0.0);
      EXPECT_EQ(find_border(*s.model.mesh, s.state.points, cell, {0, 1}).across[1], 0.0);
    }
    EXPECT_EQ(n, 1) << degrees;
  }
}

TEST(BandInACell, MovesTheCornersByItsOwnPartOfTheHeight)
{
  const Simulation s(two_soils("mpm_gp", Shares::point, {2.625, 2.375}, 30.0));
  const Mesh<2>& mesh = *s.model.mesh;
  const Index cell = s.state.points.occupied()[0];
  const Vec<2>& centre = mesh.centres[cell];
  for (Real degrees = -180.0; degrees < 180.0; degrees += 33.0) {
    const Real angle = degrees * std::numbers::pi / 180.0;
    const Vec<2> n{std::cos(angle), std::sin(angle)};
    const Real half = 0.02, middle = 0.03;  // of the height of the band [m]
    const auto height = [&](Vec<2> x) { return n[0] * (x[0] - centre[0]) + n[1] * (x[1] - centre[1]); };
    constexpr int n_lines = 400;
    int n_within = 0;
    for (int i = 0; i < n_lines * n_lines; ++i) {
      const Real x = (i % n_lines + 0.5) / n_lines - 0.5, y = (i / n_lines + 0.5) / n_lines - 0.5;
      n_within += std::abs(height({centre[0] + 0.25 * x, centre[1] + 0.25 * y}) - middle) < half ? 1 : 0;
    }
    const Real share = n_within / Real{n_lines * n_lines};
    const auto band = within_soil(mesh, cell, {n, 0, middle}, share),
               rest = within_soil(mesh, cell, {n, 1, middle}, 1.0 - share);
    Real lowest = 1.0;
    for (const Index node : mesh.cells[cell]) lowest = std::min(lowest, height(mesh.nodes[node]));
    for (std::size_t i = 0; i < 4; ++i) {
      const Real at = height(mesh.nodes[mesh.cells[cell][i]]);
      const Real wanted = std::clamp(at - (middle - half), 0.0, 2.0 * half);
      EXPECT_NEAR(band[i], wanted, 0.0025) << degrees;
      EXPECT_NEAR(band[i] + rest[i], at - lowest, 1e-14);
    }
  }
}

TEST(BorderInACell, LiesWhereItLeavesEachSoilItsShareOfTheArea)
{
  Simulation s(two_soils("mpm_gp", Shares::point, {2.625, 2.375}, 30.0));
  const Mesh<2>& mesh = *s.model.mesh;
  const Index cell = s.state.points.occupied()[0];
  const Vec<2>& centre = mesh.centres[cell];
  constexpr int n_lines = 200;
  for (Real degrees = -180.0; degrees < 180.0; degrees += 33.0)
    for (const Real share : {0.02, 0.3, 0.5, 0.77, 0.99}) {
      const Real angle = degrees * std::numbers::pi / 180.0;
      const Vec<2> n{std::cos(angle), std::sin(angle)};
      const std::array<Real, 4> above = above_border(mesh, cell, n, share);
      const auto height = [&](Vec<2> x) { return n[0] * (x[0] - centre[0]) + n[1] * (x[1] - centre[1]); };
      Real border = 1.0;
      for (std::size_t i = 0; i < 4; ++i)
        if (above[i] > 0.0) border = height(mesh.nodes[mesh.cells[cell][i]]) - above[i];
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(above[i], std::max(height(mesh.nodes[mesh.cells[cell][i]]) - border, 0.0), 1e-14);
      int n_above = 0;
      for (int i = 0; i < n_lines * n_lines; ++i) {
        const Real x = (i % n_lines + 0.5) / n_lines - 0.5, y = (i / n_lines + 0.5) / n_lines - 0.5;
        n_above += height({centre[0] + 0.25 * x, centre[1] + 0.25 * y}) > border ? 1 : 0;
      }
      EXPECT_NEAR(n_above / Real{n_lines * n_lines}, share, 0.006) << degrees;
    }
}

}  // namespace soil_border_test
