// Flows that are known exactly, on meshes along the axes, askew and turned. Bounds: shared measurements of the method
// with room (docs/verification.md has the finer cells).
#include "model/seepage/flow_surface.hpp"
#include "model/seepage/free_surface.hpp"
#include "mpm/mesh/locate.hpp"
#include "support/test.hpp"

namespace free_surface_test {

enum class Cells { along, askew, turned };

/// Cells of a size that cover a box. Askew: inner nodes moved by up to a quarter of a cell.
Mesh<2> cells_over(Vec<2> low, Vec<2> high, Real size, Cells how)
{
  if (how == Cells::turned) {
    const Vec<2> middle{0.5 * (low[0] + high[0]) + 0.31 * size, 0.5 * (low[1] + high[1]) + 0.17 * size};
    const Real r = 0.5 * std::hypot(high[0] - low[0], high[1] - low[1]) + 2.0 * size;
    const auto n = static_cast<Index>(std::ceil(2.0 * r / size));
    const Real c = std::cos(std::numbers::pi / 6.0), s = std::sin(std::numbers::pi / 6.0);
    std::vector<Vec<2>> nodes;
    for (Index j = 0; j <= n; ++j)
      for (Index i = 0; i <= n; ++i) {
        const Real x = -r + 2.0 * r * i / n, y = -r + 2.0 * r * j / n;
        nodes.push_back({middle[0] + c * x - s * y, middle[1] + s * x + c * y});
      }
    return make_grid(nodes, {n, n});
  }
  const std::array n{static_cast<Index>(std::lround((high[0] - low[0]) / size)),
      static_cast<Index>(std::lround((high[1] - low[1]) / size))};
  std::vector<Vec<2>> nodes;
  std::uint32_t random = 12345;
  const auto next = [&] {
    random = random * 1664525u + 1013904223u;
    return (random >> 8) / 16777216.0 - 0.5;
  };
  for (Index j = 0; j <= n[1]; ++j)
    for (Index i = 0; i <= n[0]; ++i) {
      Vec<2> x{low[0] + (high[0] - low[0]) * i / n[0], low[1] + (high[1] - low[1]) * j / n[1]};
      if (how == Cells::askew) {
        const Real dx = 0.5 * size * next(), dy = 0.5 * size * next();
        if (i > 0 && i < n[0]) x[0] += dx;
        if (j > 0 && j < n[1]) x[1] += dy;
      }
      nodes.push_back(x);
    }
  return make_grid(nodes, n);
}

struct Body {
  Polygon outline;
  Real k;
};

/// Of an edge; nothing: no flow.
using ConditionAt = std::function<std::optional<EdgeCondition>(const SoilEdge&)>;

struct Solved {
  Mesh<2> mesh;
  FlowSoil soil;
  FlowResult flow;
};

Solved solve(Mesh<2> mesh, const std::vector<Body>& bodies, const ConditionAt& at, FlowOptions options,
    std::span<const Real> start = {}, const std::vector<Real>& levels = {})
{
  std::vector<BodyOutline> outlines;
  std::vector<FlowMaterial> materials;
  for (const Body& body : bodies) {
    outlines.push_back({body.outline, {2, 2}});
    materials.push_back({{body.k, body.k}});
  }
  std::vector<SurfacePlace> places;
  for (const SoilEdge& edge : surface_of(mesh, outlines)) {
    std::vector<Real> shares{0.0, 1.0};
    for (const Real level : levels)
      if ((edge.a[1] - level) * (edge.b[1] - level) < 0.0)
        shares.insert(shares.end() - 1, (level - edge.a[1]) / (edge.b[1] - edge.a[1]));
    std::ranges::sort(shares);
    for (std::size_t k = 0; k + 1 < shares.size(); ++k)
      if (const SoilEdge part = part_of(edge, shares[k], shares[k + 1]); const auto condition = at(part))
        add_places(mesh, part, *condition, places);
  }
  FlowSoil soil = make_flow_soil(mesh, outlines, materials, std::move(places));
  FlowResult flow = find_flow(mesh, soil, 3, options, start);
  return {std::move(mesh), std::move(soil), std::move(flow)};
}

FlowOptions band(Real width)
{
  FlowOptions options;
  options.band.width = width;
  return options;
}

FlowOptions saturated()
{
  FlowOptions options;
  options.is_saturated = true;
  return options;
}

Real middle_y(const SoilEdge& edge) { return 0.5 * (edge.a[1] + edge.b[1]); }
Real middle_x(const SoilEdge& edge) { return 0.5 * (edge.a[0] + edge.b[0]); }

EdgeCondition fed(Real head, Index part) { return {FlowCondition::head, head, 0.0, part}; }
EdgeCondition face(Index part) { return {FlowCondition::seep, 0.0, 0.0, part}; }

class ThroughCells : public ::testing::TestWithParam<Cells> {};
INSTANTIATE_TEST_SUITE_P(Seepage, ThroughCells, ::testing::Values(Cells::along, Cells::askew, Cells::turned));

/// Dupuit's discharge of a rectangular dam is exact: (H1^2 - H2^2)/2L.
TEST_P(ThroughCells, ADamLetsThroughWhatDupuitSays)
{
  const Real H1 = 10.0, H2 = 2.0, L = 10.0, top = 12.0, size = 0.5;
  const auto at = [&](const SoilEdge& edge) -> std::optional<EdgeCondition> {
    if (edge.kind == EdgeKind::left) return middle_y(edge) < H1 ? fed(H1, 0) : face(1);
    if (edge.kind == EdgeKind::right) return middle_y(edge) < H2 ? fed(H2, 2) : face(2);
    return std::nullopt;
  };
  const Solved dam = solve(cells_over({0.0, 0.0}, {L, top}, size, GetParam()),
      {{{{0.0, 0.0}, {L, 0.0}, {L, top}, {0.0, top}}, 1.0}}, at, band(0.5 * size), {}, {H1, H2});
  EXPECT_TRUE(dam.flow.counts);
  EXPECT_NEAR(dam.flow.outflow[2], 4.8, 4.8 * 3e-3);
  EXPECT_NEAR(dam.flow.outflow[0], -dam.flow.outflow[2], 5e-4 * 4.8);
}

/// q = (pi/2) 20/ln 3 between two arcs that no cell follows.
TEST_P(ThroughCells, AQuarterOfARingLetsThroughItsLogarithm)
{
  Polygon ring;
  for (int k = 0; k <= 180; ++k)
    ring.push_back({30.0 * std::cos(k * std::numbers::pi / 360.0), 30.0 * std::sin(k * std::numbers::pi / 360.0)});
  for (int k = 180; k >= 0; --k)
    ring.push_back({10.0 * std::cos(k * std::numbers::pi / 360.0), 10.0 * std::sin(k * std::numbers::pi / 360.0)});
  const auto at = [](const SoilEdge& edge) -> std::optional<EdgeCondition> {
    const Real r = std::hypot(middle_x(edge), middle_y(edge)),
               along = std::abs(edge.normal[0] * middle_x(edge) + edge.normal[1] * middle_y(edge)) / r;
    if (along < 0.9) return std::nullopt;
    return r < 20.0 ? fed(30.0, 0) : fed(10.0, 1);
  };
  const Solved of = solve(cells_over({0.0, 0.0}, {31.0, 31.0}, 1.0, GetParam()), {{ring, 1.0}}, at, saturated());
  const Real exact = 0.5 * std::numbers::pi * 20.0 / std::log(3.0);
  EXPECT_NEAR(of.flow.outflow[1], exact, 2e-3 * exact);
}

/// Confocal parabolas: q = s0 k.
TEST_P(ThroughCells, ADrainBelowADamDrawsKozenysFlow)
{
  const Real s0 = 4.0, H = 12.0, size = 0.5;
  Polygon dam{{-4.0, 0.0}, {0.0, 0.0}};
  for (int k = 0; k < 60; ++k) {
    const Real t = s0 * k / 59.0;
    dam.push_back({(H * H - t * t) / (2.0 * s0), H * t / s0});
  }
  dam.insert(dam.end(), {{16.0, 14.0}, {-4.0, 14.0}});
  const auto at = [&](const SoilEdge& edge) -> std::optional<EdgeCondition> {
    if (edge.a[1] < 1e-9 && edge.b[1] < 1e-9)
      return std::max(edge.a[0], edge.b[0]) < 1e-9 ? std::optional(face(1)) : std::nullopt;
    const Real x = middle_x(edge), y = middle_y(edge);
    if (edge.normal[0] > 0.5 && y < H + 0.01 && x > 15.0) return fed(H, 0);
    return std::nullopt;
  };
  const Solved of =
      solve(cells_over({-4.0, 0.0}, {18.0, 14.0}, size, GetParam()), {{dam, 1.0}}, at, band(0.5 * size), {}, {});
  EXPECT_TRUE(of.flow.counts);
  EXPECT_NEAR(of.flow.outflow[1], 4.0, 4.0 * 0.015);
}

/// Down through 2 m of clay on 8 m of sand: q = dh/sum(d/k).
TEST_P(ThroughCells, AThinLayerOfClayHoldsTheFlowBack)
{
  const auto at = [](const SoilEdge& edge) -> std::optional<EdgeCondition> {
    if (middle_y(edge) > 10.0 - 1e-6) return fed(12.0, 0);
    if (middle_y(edge) < 1e-6) return fed(9.0, 1);
    return std::nullopt;
  };
  const Solved of = solve(cells_over({0.0, 0.0}, {4.0, 10.0}, 0.5, GetParam()),
      {{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 8.0}, {0.0, 8.0}}, 1e-4},
          {{{0.0, 8.0}, {4.0, 8.0}, {4.0, 10.0}, {0.0, 10.0}}, 1e-9}},
      at, saturated());
  const Real exact = 4.0 * 3.0 / (2.0 / 1e-9 + 8.0 / 1e-4);
  EXPECT_NEAR(of.flow.outflow[1], exact, exact * (GetParam() == Cells::along ? 1e-6 : 0.05));
}

const Polygon dike{
    {0.0, 0.0}, {60.0, 0.0}, {60.0, 2.0}, {47.0, 2.0}, {32.0, 7.0}, {28.0, 7.0}, {13.0, 2.0}, {0.0, 2.0}};

TEST_P(ThroughCells, StillWaterOnBothSidesOfADikeStaysStill)
{
  const auto at = [](const SoilEdge& edge) -> std::optional<EdgeCondition> {
    if (edge.kind != EdgeKind::ground) return std::nullopt;
    return middle_y(edge) < 6.0 ? fed(6.0, 0) : face(1);
  };
  Mesh<2> mesh = cells_over({0.0, -0.37}, {60.0, 7.63}, 1.0, GetParam());
  const std::vector<Real> start(mesh.nodes.size(), 7.0);
  const Solved of = solve(std::move(mesh), {{dike, 1.0}}, at, band(0.5), start, {6.0});
  EXPECT_TRUE(of.flow.counts);
  Real most = 0.0;
  for (const FlowPlace& place : of.soil.places)
    if (place.is_soil) most = std::max(most, std::abs(*head_at(of.mesh, of.flow.heads, place.x) - 6.0));
  EXPECT_LT(most, 1e-9);
  EXPECT_LT(std::abs(of.flow.outflow[0]), 1e-9);
}

TEST_P(ThroughCells, ADikeOfSandLeaksAsOnFineCells)
{
  const auto at = [](const SoilEdge& edge) -> std::optional<EdgeCondition> {
    if (edge.kind != EdgeKind::ground) return std::nullopt;
    if (middle_x(edge) < 30.0) return middle_y(edge) < 6.0 ? fed(6.0, 0) : face(2);
    return face(1);
  };
  const Real size = 0.5;
  const Solved of = solve(cells_over({0.0, -0.37 * size}, {60.0, 8.0 - 0.37 * size}, size, GetParam()), {{dike, 1.0}},
      at, band(0.5 * size), {}, {6.0});
  EXPECT_TRUE(of.flow.counts);
  EXPECT_NEAR(of.flow.outflow[1], 0.6486, 0.6486 * 2.5e-3);
}

/// Soil of 10 m whose head was 5 m too high everywhere gives its water off at the top.
TEST(SeepageInTime, ALayerGivesOffItsExcessAsTerzaghiSays)
{
  const Real k = 1e-7, S = 1e-3, H = 10.0, dT = 0.005;
  Mesh<2> mesh = cells_over({0.0, 0.0}, {0.5, H}, 0.5, Cells::along);
  const std::vector<BodyOutline> outline{{{{0.0, 0.0}, {0.5, 0.0}, {0.5, H}, {0.0, H}}, {2, 2}}};
  const std::vector<FlowMaterial> material{{{k, k}, {0.0, S}}};
  std::vector<SurfacePlace> places;
  for (const SoilEdge& edge : surface_of(mesh, outline))
    if (middle_y(edge) > H - 1e-6) add_places(mesh, edge, fed(H, 0), places);
  const FlowSoil soil = make_flow_soil(mesh, outline, material, std::move(places), true);
  FlowOptions options = saturated();
  options.tolerance = 1e-9;
  std::vector<Real> heads(mesh.nodes.size(), H + 5.0);
  Real stored = 0.0;
  for (int n = 1; n <= 100; ++n) {
    const std::vector<Real> before = heads;
    const FlowStep step{dT * H * H * S / k, before};
    const FlowResult flow = find_flow(mesh, soil, 1, options, before, step);
    ASSERT_TRUE(flow.counts);
    heads = flow.heads;
    stored += flow.outflow[0] * step.dt;
    if (n != 20 && n != 100) continue;
    const Real T = n * dT;
    Real exact = 0.0;
    for (int j = 1; j < 400; j += 2)
      exact += 5.0 * 4.0 / (std::numbers::pi * j) * std::sin(j * std::numbers::pi / 2.0) *
               std::exp(-std::pow(j * std::numbers::pi / 2.0, 2) * T);
    EXPECT_NEAR(*head_at(mesh, heads, {0.25, 1e-6}) - H, exact, 0.005 * 5.0);
  }
  // What came out is what is no longer stored.
  Real left = 0.0;
  for (const FlowPlace& place : soil.places) left += place.weight * S * (*head_at(mesh, heads, place.x) - H);
  EXPECT_NEAR(stored, 5.0 * S * H * 0.5 - left, 1e-6 * 5.0 * S * H);
}

/// A river that rises at once by 0.4 m beside a level table: 0.4 erfc(x/(2 sqrt(k D t/S_y))).
TEST(SeepageInTime, ARiverThatRisesIsFollowedAsBoussinesqSays)
{
  const Real k = 1e-4, yield = 0.2, end = 86400.0, size = 1.0;
  Mesh<2> mesh = cells_over({0.0, 0.0}, {100.0, 10.0}, size, Cells::along);
  const std::vector<BodyOutline> outline{{{{0.0, 0.0}, {100.0, 0.0}, {100.0, 10.0}, {0.0, 10.0}}, {2, 2}}};
  std::vector<SurfacePlace> places;
  for (const SoilEdge& edge : surface_of(mesh, outline)) {
    if (edge.kind != EdgeKind::left) continue;
    if (middle_y(edge) < 8.0) add_places(mesh, edge, fed(8.4, 0), places);
    if (middle_y(edge) < 8.0 || middle_y(edge) > 9.0) continue;
    add_places(mesh,
        part_of(edge,
            edge.a[1] < 8.4 && edge.b[1] < edge.a[1] ? 0.0
            : edge.a[1] < edge.b[1]                  ? 0.0
                                                     : 0.6,
            edge.a[1] < edge.b[1] ? 0.4 : 1.0),
        fed(8.4, 0), places);
  }
  const FlowSoil soil =
      make_flow_soil(mesh, outline, std::vector<FlowMaterial>{{{k, k}, {yield, 1e-5}}}, std::move(places), true);
  FlowOptions options = band(0.5 * size);
  options.tolerance = 1e-8;
  std::vector<Real> heads(mesh.nodes.size(), 8.0);
  for (int n = 0; n < 12; ++n) {
    const std::vector<Real> before = heads;
    const FlowResult flow = find_flow(mesh, soil, 1, options, before, FlowStep{end / 12.0, before});
    ASSERT_TRUE(flow.counts);
    heads = flow.heads;
  }
  for (const Real x : {5.0, 10.0, 20.0})
    EXPECT_NEAR(
        (*head_at(mesh, heads, {x, 7.9}) - 8.0) / 0.4, std::erfc(x / (2.0 * std::sqrt(k * 8.2 / yield * end))), 0.035)
        << x;
}

}  // namespace free_surface_test
