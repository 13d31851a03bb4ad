#include "model/bodies/seed.hpp"
#include "mpm/mesh/locate.hpp"
#include "support/meshes.hpp"

namespace seed_cut_test {

constexpr Real h = 0.1;            // cell size [m]
constexpr Real spacing = 0.2 * h;  // of points: 5 x 5 per cell

Polygon box(Vec<2> low, Vec<2> high) { return {low, {high[0], low[1]}, high, {low[0], high[1]}}; }

Polygon circle(Vec<2> centre, Real radius, int n)
{
  Polygon corners;
  for (int k = 0; k < n; ++k) {
    const Real angle = 2.0 * std::numbers::pi * k / n;
    corners.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
  return corners;
}

/// 4 m x 3 m; share: how far nodes are moved, over h.
Mesh<2> make_mesh(Real share) { return distorted_rectangle(40, 30, h, share, 77); }

const Polygon embankment{{0.0, 0.0}, {4.0, 0.0}, {4.0, 0.553}, {3.6, 0.553}, {0.6, 2.053}, {0.0, 2.053}};  // slope 1:2
const Polygon disc = circle({2.0, 1.5}, 1.13, 64);
const Polygon pipe = circle({1.93, 1.47}, 0.41, 24);

/// Bodies of every kind that one outline alone can be.
std::vector<std::pair<std::string, BodyOutline>> single_bodies()
{
  return {{"slope", {embankment, {5, 5}}}, {"disc", {disc, {5, 5}}}, {"disc with a hole", {disc, {4, 6}, {pipe}}}};
}

Real volume_of(const std::vector<Seed>& seeds, Index body)
{
  Real sum = 0.0;
  for (const Seed& seed : seeds)
    if (seed.body == body) sum += seed.volume;
  return sum;
}

std::vector<Seed> seed_one(const Mesh<2>& mesh, const BodyOutline& body)
{
  const std::vector<BodyOutline> bodies{body};
  return seed_points(mesh, bodies);
}

Vec<2> centroid_of(const std::vector<Seed>& seeds)
{
  Vec<2> sum{0.0, 0.0};
  Real volume = 0.0;
  for (const Seed& seed : seeds) {
    for (int d = 0; d < 2; ++d) sum[d] += seed.volume * seed.x[d];
    volume += seed.volume;
  }
  return {sum[0] / volume, sum[1] / volume};
}

/// First moments of a polygon, counter-clockwise [m^3].
Vec<2> moments_of(const Polygon& polygon)
{
  Vec<2> sum{0.0, 0.0};
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    for (int d = 0; d < 2; ++d) sum[d] += (a[d] + b[d]) * (a[0] * b[1] - a[1] * b[0]) / 6.0;
  }
  return sum;
}

Vec<2> centroid_of(const BodyOutline& body)
{
  Vec<2> sum = moments_of(body.polygon);
  for (const Polygon& hole : body.holes)
    for (int d = 0; d < 2; ++d) sum[d] -= moments_of(hole)[d];
  return {sum[0] / area(body), sum[1] / area(body)};
}

TEST(SeedCutBodies, HaveTheirMassWhateverTheMesh)
{
  for (const Real share : {0.0, 0.35}) {
    const auto mesh = make_mesh(share);
    for (const auto& [name, body] : single_bodies())
      EXPECT_NEAR(volume_of(seed_one(mesh, body), 0) / area(body), 1.0, 1e-12) << name << ", " << share;
  }
}

TEST(SeedCutBodies, HaveTheirMassWhereTheyLieOnTopOfEachOther)
{
  const Polygon ground = box({0.0, 0.0}, {4.0, 1.23}), wall = box({1.515, 0.333}, {1.737, 2.9});
  const std::vector<BodyOutline> bodies{{ground, {5, 5}}, {disc, {4, 4}, {pipe}}, {wall, {6, 3}}};
  const auto in = [](const Polygon& polygon, Vec<2> low, Vec<2> high) {
    return signed_area(clip_to_box(polygon, {low, high}));
  };
  const auto ring_in = [&](Vec<2> low, Vec<2> high) { return in(disc, low, high) - in(pipe, low, high); };
  const Real wall_area = 0.222 * 2.567;
  const Real disc_area = signed_area(disc) - signed_area(pipe) - ring_in(wall[0], wall[2]);
  const Real ground_area =
      4.0 * 1.23 - ring_in(ground[0], ground[2]) - 0.222 * (1.23 - 0.333) + ring_in(wall[0], {wall[2][0], 1.23});
  for (const Real share : {0.0, 0.35}) {
    const auto seeds = seed_points(make_mesh(share), bodies);
    EXPECT_NEAR(volume_of(seeds, 0) / ground_area, 1.0, 1e-12);
    EXPECT_NEAR(volume_of(seeds, 1) / disc_area, 1.0, 1e-12);
    EXPECT_NEAR(volume_of(seeds, 2) / wall_area, 1.0, 1e-12);
  }
}

TEST(SeedCutBodies, HaveTheirCentroid)
{
  for (const auto& [name, body] : single_bodies()) {
    const Vec<2> exact = centroid_of(body);
    const Vec<2> regular = centroid_of(seed_one(make_mesh(0.0), body)),
                 distorted = centroid_of(seed_one(make_mesh(0.35), body));
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(regular[d], exact[d], 1e-12) << name;
      EXPECT_NEAR(distorted[d], exact[d], 1e-4 * h)
          << name;  // a lattice point of a twisted cell is not the centroid of its part
    }
  }
}

TEST(SeedCutBodies, HaveTheirPointsInTheirCellsAndInThemselves)
{
  for (const Real share : {0.0, 0.35}) {
    const auto mesh = make_mesh(share);
    for (const auto& [name, body] : single_bodies())
      for (const Seed& seed : seed_one(mesh, body)) {
        ASSERT_TRUE(std::abs(seed.local[0]) < 1.0 && std::abs(seed.local[1]) < 1.0) << name;
        const Vec<2> x = place_in_cell(mesh, seed.cell, seed.local);
        ASSERT_NEAR(std::hypot(x[0] - seed.x[0], x[1] - seed.x[1]), 0.0, 1e-12 * h) << name;
        ASSERT_TRUE(covers(body, seed.x)) << name;
      }
  }
}

TEST(SeedCutBodies, KeepTheirPointsApartAndInProportion)
{
  for (const Real share : {0.0, 0.35}) {
    const auto mesh = make_mesh(share);
    for (const auto& [name, body] : single_bodies()) {
      const auto seeds = seed_one(mesh, body);
      Real nearest = h;
      for (std::size_t k = 0; k < seeds.size(); ++k)
        for (std::size_t other = k + 1; other < seeds.size() && seeds[other].cell <= seeds[k].cell + 41; ++other)
          nearest = std::min(nearest, std::hypot(seeds[k].x[0] - seeds[other].x[0], seeds[k].x[1] - seeds[other].x[1]));
      EXPECT_GT(nearest, (share == 0.0 ? 0.5 : 0.2) * spacing) << name;
      const Real part = h * h / (body.points_per_cell[0] * body.points_per_cell[1]);
      if (share > 0.0) continue;
      for (const Seed& seed : seeds)
        ASSERT_TRUE(seed.volume >= 0.2 * part * (1.0 - 1e-12) && seed.volume < 1.6 * part) << name;
    }
  }
}

/// Least and most distance [m] from the slope to the nearest point beneath it, over windows of two spacings along it.
std::pair<Real, Real> depth_of_surface(const std::vector<Seed>& seeds)
{
  const Vec<2> top = embankment[4], foot = embankment[3];
  const Real length = std::hypot(foot[0] - top[0], foot[1] - top[1]);
  const Vec<2> along{(foot[0] - top[0]) / length, (foot[1] - top[1]) / length};
  std::map<int, Real> depth;
  for (const Seed& seed : seeds) {
    const Real down = (seed.x[0] - top[0]) * along[0] + (seed.x[1] - top[1]) * along[1];
    const Real below = (seed.x[0] - top[0]) * along[1] - (seed.x[1] - top[1]) * along[0];
    const int window = static_cast<int>(std::floor(down / (2.0 * spacing))),
              n_windows = static_cast<int>(length / (2.0 * spacing));
    if (window < 2 || window >= n_windows - 2) continue;
    Real& least = depth.try_emplace(window, h).first->second;
    least = std::min(least, below);
  }
  const auto [least, most] =
      std::minmax_element(depth.begin(), depth.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return {least->second, most->second};
}

TEST(SeedCutBodies, HaveASlopeThatIsNoStaircase)
{
  const auto mesh = make_mesh(0.0);
  const auto [least, most] = depth_of_surface(seed_one(mesh, {embankment, {5, 5}}));
  EXPECT_GT(least, 0.1 * spacing);
  EXPECT_LT(most, 0.6 * spacing);
  // Lattice points alone lie up to 0.9 spacings below the slope: a tread of 2 and a riser of 1 spacing.
  std::vector<Seed> lattice = seed_one(mesh, {box({0.0, 0.0}, {4.0, 3.0}), {5, 5}});
  std::erase_if(lattice, [](const Seed& seed) { return !contains(embankment, seed.x); });
  const auto [lattice_least, lattice_most] = depth_of_surface(lattice);
  EXPECT_GT(lattice_most - lattice_least, 1.5 * (most - least));
}

TEST(SeedCutBodies, GiveASliverInACellOfItsOwnToTheCellNextDoor)
{
  const auto mesh = make_rectangle({0.0, 0.0}, {3.0, 1.0}, {3, 1});
  const auto seeds =
      seed_one(mesh, {box({0.0, 0.0}, {1.01, 1.0}), {5, 5}});  // 1 cm into the second cell, whose parts are 20 cm wide
  EXPECT_EQ(seeds.size(), 25u);
  EXPECT_NEAR(volume_of(seeds, 0), 1.01, 1e-15);
  EXPECT_NEAR(centroid_of(seeds)[0], 0.505, 1e-15);
  for (const Seed& seed : seeds) EXPECT_EQ(seed.cell, 0);
}

/// Alone in its cell the sliver would have next to no mass, and take shares of all that lies around it.
TEST(SeedCutBodies, GiveASliverBeyondACornerToTheCellAcrossIt)
{
  const Mesh<2> mesh = make_mesh(0.0);
  const std::vector<Seed> seeds = seed_one(mesh, {box({0.0, 0.0}, {2.0 + 0.01 * h, 1.0 + 0.01 * h}), {5, 5}});
  EXPECT_EQ(seeds.size(), 200u * 25u);
  EXPECT_NEAR(volume_of(seeds, 0), (2.0 + 0.01 * h) * (1.0 + 0.01 * h), 1e-12);
}

TEST(SeedCutBodies, GiveNoSliverToTheCellNextDoorAcrossADitch)
{
  const std::vector<BodyOutline> bodies{{box({0.0, 0.0}, {1.05, 1.0}), {1, 1}}, {box({0.9, 0.0}, {1.0, 1.0}), {1, 1}}};
  const auto seeds = seed_points(make_rectangle({0.0, 0.0}, {3.0, 1.0}, {3, 1}), bodies);
  ASSERT_EQ(seeds.size(), 3u);
  EXPECT_NEAR(seeds[0].x[0], 0.45, 1e-15);
  EXPECT_EQ(seeds[1].body, 1);
  EXPECT_NEAR(seeds[2].x[0], 1.025, 1e-15);
  EXPECT_NEAR(seeds[2].volume, 0.05, 1e-15);
}

TEST(SeedCutBodies, MakeOnePointOfTwoSliversInTheCellThatHoldsTheirCentroid)
{
  const auto mesh = make_rectangle({0.0, 0.0}, {3.0, 1.0}, {3, 1});
  for (const auto& [left, right, cell] : {std::tuple{0.85, 1.01, 0}, {0.99, 1.15, 1}}) {
    const auto seeds = seed_one(mesh, {box({left, 0.0}, {right, 1.0}), {1, 1}});
    ASSERT_EQ(seeds.size(), 1u);
    EXPECT_EQ(seeds[0].cell, cell);
    EXPECT_NEAR(seeds[0].volume, 0.16, 1e-15);
    EXPECT_NEAR(seeds[0].x[0], 0.5 * (left + right), 1e-15);
  }
}

TEST(SeedCutBodies, KeepATinyBodyAsAPointOfItsOwn)
{
  const auto mesh = make_rectangle({0.0, 0.0}, {3.0, 1.0}, {3, 1});
  const auto seeds = seed_one(mesh, {box({1.51, 0.51}, {1.52, 0.53}), {5, 5}});
  ASSERT_EQ(seeds.size(), 1u);
  EXPECT_NEAR(seeds[0].volume, 2e-4, 1e-17);
  EXPECT_NEAR(seeds[0].x[0], 1.515, 1e-15);
  EXPECT_NEAR(seeds[0].x[1], 0.52, 1e-15);
}

TEST(SeedCutBodies, AreSeededInOneOrderAndToTheBit)
{
  const auto mesh = make_mesh(0.35);
  const std::vector<BodyOutline> bodies{{embankment, {5, 5}}, {disc, {3, 4}, {pipe}}};
  const auto seeds = seed_points(mesh, bodies), again = seed_points(mesh, bodies);
  const auto before = [](const Seed& a, const Seed& b) {
    return std::pair(a.cell, a.body) < std::pair(b.cell, b.body);
  };
  EXPECT_TRUE(std::is_sorted(seeds.begin(), seeds.end(), before));
  ASSERT_EQ(seeds.size(), again.size());
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    ASSERT_EQ(seeds[k].x, again[k].x);
    ASSERT_EQ(seeds[k].local, again[k].local);
    ASSERT_EQ(seeds[k].volume, again[k].volume);
  }
}

TEST(SeedCutBodies, AreTheSameWhicheverWayTheirCornersRun)
{
  const auto mesh = make_mesh(0.35);
  const Polygon turned(embankment.rbegin(), embankment.rend());
  const auto one = seed_one(mesh, {embankment, {5, 5}}), other = seed_one(mesh, {turned, {5, 5}});
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    ASSERT_NEAR(one[k].volume, other[k].volume, 1e-14);
    ASSERT_NEAR(one[k].x[0], other[k].x[0], 1e-9 * h);
    ASSERT_NEAR(one[k].x[1], other[k].x[1], 1e-9 * h);
  }
}

}  // namespace seed_cut_test
