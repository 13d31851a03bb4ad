// Meshes with general quadrilaterals for tests.
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "support/random.hpp"

namespace terp::test {

/// A vector of length at most `reach` in any direction.
inline Vec<2> random_shift(Real reach, Random& random)
{
  const Real angle = random.between(-std::numbers::pi, std::numbers::pi),
             length = reach * std::sqrt(random.between(0.0, 1.0));
  return {length * std::cos(angle), length * std::sin(angle)};
}

/// A rectangle from the origin, nx x ny cells of size h, whose inner nodes are moved by up to share * h.
inline Mesh<2> distorted_rectangle(Index nx, Index ny, Real h, Real share, std::uint64_t seed)
{
  const Mesh<2> regular = make_rectangle({0.0, 0.0}, {nx * h, ny * h}, {nx, ny});
  Mesh<2> mesh;
  mesh.nodes = regular.nodes;
  mesh.cells = regular.cells;
  mesh.sides = regular.sides;
  Random random(seed);
  for (Index j = 1; j < ny; ++j)
    for (Index i = 1; i < nx; ++i) {
      const Vec<2> shift = random_shift(share * h, random);
      for (int d = 0; d < 2; ++d) mesh.nodes[j * (nx + 1) + i][d] += shift[d];
    }
  connect(mesh);
  return mesh;
}

/// The unit square with each corner moved by up to `share` in any direction.
inline std::array<Vec<2>, 4> distorted_square(Real share, Random& random)
{
  std::array<Vec<2>, 4> corners{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
  for (auto& x : corners) {
    const Vec<2> shift = random_shift(share, random);
    x = {x[0] + shift[0], x[1] + shift[1]};
  }
  return corners;
}

inline Real total_area(const Mesh<2>& mesh)
{
  Real sum = 0.0;
  for (Index e = 0; e < mesh.n_cells(); ++e) sum += mesh.geometry(e).volume;
  return sum;
}

/// Length of each named side of a mesh [m].
inline std::map<std::string, Real> lengths_of_sides(const Mesh<2>& mesh)
{
  std::map<std::string, Real> lengths;
  for (const NamedSide& side : mesh.sides)
    for (const CellSide& edge : side.edges) {
      const Vec<2> a = mesh.nodes[mesh.cells[edge.cell][edge.side]],
                   b = mesh.nodes[mesh.cells[edge.cell][(edge.side + 1) % 4]];
      lengths[side.name] += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
  return lengths;
}

}  // namespace terp::test
