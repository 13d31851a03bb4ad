#include "mpm/kernels/node_diffusion.hpp"

#include "support/test.hpp"

namespace node_diffusion_test {

constexpr Real all_soil = 1.0;

/// A mesh whose nodes are those of squares of 1 m taken by `map`, n cells each way.
Mesh<2> mapped_squares(Index n, const std::function<Vec<2>(Vec<2>)>& map)
{
  std::vector<Vec<2>> nodes;
  for (Index j = 0; j <= n; ++j)
    for (Index i = 0; i <= n; ++i) nodes.push_back(map({static_cast<Real>(i), static_cast<Real>(j)}));
  return make_grid(std::move(nodes), {n, n});
}

struct Spread {
  Mesh<2> mesh;
  NodeDiffusion diffusion;
  NodeSpread nodes;

  Spread(
      Mesh<2> m, Real length, const std::function<Real(Vec<2>)>& filling = [](Vec<2>) { return all_soil; })
      : mesh(std::move(m)), diffusion(make_node_diffusion(mesh, length)), nodes(diffusion)
  {
    for (Index i = 0; i < mesh.n_nodes(); ++i) {
      const Real volume = filling(mesh.nodes[i]) * diffusion.full_volume[i];
      nodes.filling[i] = filling(mesh.nodes[i]);
      nodes.inverse_volume[i] = volume > 0.0 ? 1.0 / volume : 0.0;
      nodes.variance[i] = variance_to_spread(length * length, diffusion.mapping_variance[i]);
    }
  }

  Real volume(Index i) const { return nodes.filling[i] * diffusion.full_volume[i]; }
  Real total() const
  {
    Real sum = 0.0;
    for (Index i = 0; i < mesh.n_nodes(); ++i) sum += volume(i) * nodes.value[i];
    return sum;
  }
  /// A unit at one node, spread.
  void from(Index node)
  {
    nodes.value[node] = 1.0 / volume(node);
    for (Index g = 0; g < diffusion.n_groups(); ++g) set_rates(diffusion, g, nodes);
    for (int n = 0; n < diffusion.n_substeps; ++n) {
      for (Index g = 0; g < diffusion.n_groups(); ++g) spread_nodes(diffusion, g, nodes);
      std::swap(nodes.value, nodes.next);
    }
  }
  /// Second moments xx, yy, xy about a node [m^2].
  std::array<Real, 3> moments(Index about) const
  {
    std::array<Real, 3> m{};
    for (Index i = 0; i < mesh.n_nodes(); ++i) {
      const Real w = volume(i) * nodes.value[i], x = mesh.nodes[i][0] - mesh.nodes[about][0],
                 y = mesh.nodes[i][1] - mesh.nodes[about][1];
      m[0] += w * x * x, m[1] += w * y * y, m[2] += w * x * y;
    }
    return m;
  }
};

constexpr Index n_cells = 40, middle = 20 * 41 + 20;

TEST(NodeDiffusion, KeepsTheSumAndHasTheVarianceOfTheLength)
{
  const Real c = std::cos(0.4), s = std::sin(0.4);
  const std::vector<std::function<Vec<2>(Vec<2>)>> shapes{[](Vec<2> x) { return x; },
      [&](Vec<2> x) -> Vec<2> {
        return {c * x[0] - s * x[1], s * x[0] + c * x[1]};
      },  // turned
      [](Vec<2> x) -> Vec<2> {
        return {2.0 * x[0], x[1]};
      },  // twice as long as wide
      [](Vec<2> x) -> Vec<2> {
        return {x[0] + 0.5 * x[1], x[1]};
      }};  // sheared
  for (const auto& shape : shapes)
    for (const Real cells : {1.5, 2.0, 4.0}) {
      const Mesh<2> mesh = mapped_squares(n_cells, shape);
      const Real h2 = mesh.geometry(0).volume, length = cells * std::sqrt(h2);
      Spread spread(mesh, length);
      spread.from(middle);
      EXPECT_NEAR(spread.total(), 1.0, 1e-12);
      const Real expected = 0.5 * length * length - h2 / 2.0;  // of exp(-r^2/l^2), less what the mapping does
      const auto m = spread.moments(middle);
      EXPECT_NEAR(m[0], expected, 1e-9 * expected);
      EXPECT_NEAR(m[1], expected, 1e-9 * expected);
      EXPECT_NEAR(m[2], 0.0, 1e-9 * expected);
    }
}

TEST(NodeDiffusion, IsThatOfTheLengthWithinTwoPercentOnDistortedCells)
{
  const auto wavy = [](Vec<2> x) -> Vec<2> {
    return {x[0] + 0.2 * std::sin(1.7 * x[0] + 2.9 * x[1]), x[1] + 0.2 * std::sin(2.3 * x[0] - 1.1 * x[1])};
  };
  Spread spread(mapped_squares(n_cells, wavy), 4.0);
  spread.from(middle);
  EXPECT_NEAR(spread.total(), 1.0, 1e-12);
  const auto m = spread.moments(middle);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(m[k], 8.0 - 0.5, 0.02 * 8.0);
}

TEST(NodeDiffusion, HasTheShapeOfAGaussian)
{
  Spread spread(mapped_squares(n_cells, [](Vec<2> x) { return x; }), 4.0);
  spread.from(middle);
  const Real variance = 8.0 - 0.5, peak = 1.0 / (2.0 * std::numbers::pi * variance);
  for (Index i = 0; i < spread.mesh.n_nodes(); ++i) {
    const Vec<2> x = spread.mesh.nodes[i];
    const Real r2 = (x[0] - 20.0) * (x[0] - 20.0) + (x[1] - 20.0) * (x[1] - 20.0);
    EXPECT_NEAR(spread.nodes.value[i], peak * std::exp(-0.5 * r2 / variance), 0.045 * peak);  // of ten sub-steps: 4.2 %
  }
}

TEST(NodeDiffusion, TakesAsFewSubStepsAsLeaveEachNodeAPartOfItsOwn)
{
  const Mesh<2> squares = mapped_squares(8, [](Vec<2> x) { return x; });
  // tau = (l^2/2 - h^2/2)/2 in steps of 3/8 h^2
  EXPECT_EQ(make_node_diffusion(squares, 1.0).n_substeps, 1);
  EXPECT_EQ(make_node_diffusion(squares, 2.0).n_substeps, 2);
  EXPECT_EQ(make_node_diffusion(squares, 4.0).n_substeps, 10);
  Spread spread(squares, 2.0);
  spread.from(4 * 9 + 4);
  for (Index i = 0; i < spread.mesh.n_nodes(); ++i) EXPECT_GE(spread.nodes.value[i], 0.0);
}

TEST(NodeDiffusion, DoesNotBridgeAGapAndKeepsTheSumAtAFreeSurface)
{
  // No soil at the nodes of x = 22 m; half-filled nodes on both sides of the gap.
  const auto filling = [](Vec<2> x) { return x[0] == 22.0 ? 0.0 : std::abs(x[0] - 22.0) == 1.0 ? 0.5 : 1.0; };
  Spread spread(mapped_squares(n_cells, [](Vec<2> x) { return x; }), 4.0, filling);
  spread.from(middle);
  EXPECT_NEAR(spread.total(), 1.0, 1e-12);
  for (Index i = 0; i < spread.mesh.n_nodes(); ++i) {
    const bool beyond = spread.mesh.nodes[i][0] >= 22.0;
    EXPECT_TRUE(beyond ? spread.nodes.value[i] == 0.0 : spread.nodes.value[i] >= 0.0) << i;
  }
}

}  // namespace node_diffusion_test
