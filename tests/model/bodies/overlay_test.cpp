#include "model/bodies/overlay.hpp"
#include "support/meshes.hpp"

namespace overlay_test {

using Corners = std::array<Vec<2>, 4>;

const Corners square{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};

Polygon box(Vec<2> low, Vec<2> high) { return {low, {high[0], low[1]}, high, {low[0], high[1]}}; }

void expect_part(const Part& part, Index body, Real area, Vec<2> centroid)
{
  EXPECT_EQ(part.body, body);
  EXPECT_NEAR(part.area, area, 1e-15);
  for (int d = 0; d < 2; ++d) EXPECT_NEAR(part.centroid[d], centroid[d], 1e-15);
}

Real area_of(const std::vector<Part>& parts, Index body)
{
  Real sum = 0.0;
  for (const Part& part : parts)
    if (part.body == body) sum += part.area;
  return sum;
}

TEST(ShareOut, GivesTheGroundAllThatNoRingCovers)
{
  const auto parts = share_out({7, {}}, square);
  ASSERT_THAT(parts, SizeIs(1));
  expect_part(parts[0], 7, 4.0, {0.0, 0.0});
  EXPECT_THAT(share_out({-1, {}}, square), IsEmpty());
}

TEST(ShareOut, CutsOffATriangleExactly)
{
  const Overlay overlay{-1, {{{{0.0, -3.0}, {3.0, 0.0}, {3.0, -3.0}}, 2, false}}};  // x - y > 3: outside
  EXPECT_THAT(share_out(overlay, square), IsEmpty());
  const Overlay near{-1, {{{{-1.5, -3.0}, {3.0, 1.5}, {3.0, -3.0}}, 2, false}}};  // x - y > 1.5
  const auto parts = share_out(near, square);
  ASSERT_THAT(parts, SizeIs(1));
  expect_part(parts[0], 2, 0.125, {1.0 - 0.5 / 3.0, -1.0 + 0.5 / 3.0});
}

TEST(ShareOut, PutsLaterBodiesOnTopAndHolesThroughTheirOwnBodyAlone)
{
  const Overlay overlay{0, {{box({-1.0, -1.0}, {0.5, 0.5}), 1, false}, {box({-0.5, -0.5}, {0.0, 0.0}), 1, true},
                               {box({-0.25, -2.0}, {2.0, 2.0}), 3, false}}};
  const auto parts = share_out(overlay, square);
  EXPECT_NEAR(area_of(parts, 3), 2.5, 1e-15);
  EXPECT_NEAR(area_of(parts, 1), 0.75 * 1.5 - 0.25 * 0.5, 1e-15);
  EXPECT_NEAR(area_of(parts, 0), 0.75 * 0.5 + 0.25 * 0.5, 1e-15);
}

TEST(ShareOut, GivesWhatIsApartAsPartsOfTheirOwn)
{
  const Overlay overlay{-1, {{box({-2.0, -2.0}, {2.0, 2.0}), 0, false}, {box({-0.25, -1.5}, {0.5, 1.5}), 0, true}}};
  const auto parts = share_out(overlay, square);
  ASSERT_THAT(parts, SizeIs(2));
  expect_part(parts[0], 0, 1.5, {-0.625, 0.0});
  expect_part(parts[1], 0, 1.0, {0.75, 0.0});
}

TEST(ShareOut, KeepsWhatHangsTogetherInOnePart)
{
  const Polygon tee{
      {-1.0, 0.5}, {-0.25, 0.5}, {-0.25, -1.0}, {0.5, -1.0}, {0.5, 0.5}, {1.0, 0.5}, {1.0, 1.0}, {-1.0, 1.0}};
  const auto parts = share_out({-1, {{tee, 0, false}}}, square);
  ASSERT_THAT(parts, SizeIs(1));
  expect_part(parts[0], 0, 2.125, {1.125 * 0.125 / 2.125, (1.125 * -0.25 + 0.75) / 2.125});
}

TEST(ShareOut, SplitsABentSliverThatDoesNotHoldItsCentroid)
{
  const Overlay overlay{0, {{box({-0.9, -0.9}, {2.0, 2.0}), 1, false}}};  // leaves an L of 0.1 m to the ground
  const auto parts = share_out(overlay, square);
  ASSERT_THAT(parts, SizeIs(3));
  expect_part(parts[0], 0, 0.2, {0.0, -0.95});
  expect_part(parts[1], 0, 0.19, {-0.95, 0.05});
  expect_part(parts[2], 1, 3.61, {0.05, 0.05});
}

TEST(ShareOut, IsNotConfusedByLinesThatCoincideButForRoundOff)
{
  const Real shift = 3e-17;
  const Overlay overlay{-1,
      {{box({-2.0, -2.0}, {0.1, 2.0}), 0, false}, {box({0.1 + shift, -2.0}, {1.0 + shift, 1.0 - shift}), 1, false}}};
  const auto parts = share_out(overlay, square);
  EXPECT_NEAR(area_of(parts, 0), 2.2, 1e-14);
  EXPECT_NEAR(area_of(parts, 1), 1.8, 1e-14);
}

/// A ring of n random corners in the square from -1.5 to 1.5, or on a lattice of 0.25, where lines meet and coincide.
Polygon random_ring(int n, bool on_lattice, Random& random)
{
  Polygon ring;
  for (int k = 0; k < n; ++k) {
    Vec<2> x{random.between(-1.5, 1.5), random.between(-1.5, 1.5)};
    if (on_lattice) x = {0.25 * std::round(4.0 * x[0]), 0.25 * std::round(4.0 * x[1])};
    ring.push_back(x);
  }
  return ring;
}

TEST(ShareOut, FillsAnyQuadrilateralWhateverIsDrawnOverIt)
{
  Random random(5);
  for (int trial = 0; trial < 3000; ++trial) {
    const bool on_lattice = trial % 2 == 0;
    Overlay overlay{0, {}};
    for (Index body = 1; body <= 3; ++body) {
      overlay.rings.push_back({random_ring(3 + random.below(5), on_lattice, random), body, false});
      overlay.rings.push_back({random_ring(3, on_lattice, random), body, true});
    }
    const Corners corners = trial % 3 == 0 ? square : distorted_square(0.25, random);
    const auto parts = share_out(overlay, corners);
    Real sum = 0.0;
    for (const Part& part : parts) {
      sum += part.area;
      ASSERT_GT(part.area, 0.0);
    }
    ASSERT_NEAR(sum, signed_area(corners), 1e-13) << "trial " << trial;
  }
}

TEST(ShareOut, GivesTheSameShareInEveryQuadrilateralAsInTheirUnion)
{
  Random random(6);
  for (int trial = 0; trial < 1000; ++trial) {
    Overlay overlay{
        -1, {{random_ring(6, trial % 2 == 0, random), 0, false}, {random_ring(5, trial % 2 == 0, random), 1, false}}};
    const Vec<2> m{random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
    const Vec<2> s{m[0], -1.0}, e{1.0, m[1]}, n{m[0], 1.0}, w{-1.0, m[1]};
    const auto whole = share_out(overlay, square);
    for (const Index body : {0, 1}) {
      Real sum = 0.0;
      for (const Corners& quarter : {Corners{{square[0], s, m, w}}, Corners{{s, square[1], e, m}},
               Corners{{m, e, square[2], n}}, Corners{{w, m, n, square[3]}}})
        sum += area_of(share_out(overlay, quarter), body);
      ASSERT_NEAR(sum, area_of(whole, body), 1e-13) << "trial " << trial;
    }
  }
}

TEST(ShareOut, PutsCentroidsIntoTheirBody)
{
  Random random(7);
  for (int trial = 0; trial < 1000; ++trial) {
    const Ring star{random_ring(7, false, random), 1, false}, kite{random_ring(4, false, random), 2, false};
    const Overlay overlay{0, {star, kite, {random_ring(3, false, random), 2, true}}};
    for (const Part& part : share_out(overlay, square)) {
      if (part.area > 1e-12) {
        ASSERT_EQ(top_body(overlay, part.centroid), part.body) << "trial " << trial;
      }
    }
  }
}

}  // namespace overlay_test
