// Material points put into cells by hand, for tests of the rooms that work on one block.
#pragma once

#include "support/test.hpp"
#include "mpm/mesh/locate.hpp"
#include "mpm/points/point_blocks.hpp"

namespace terp::test {

/// One material point; what a test does not set has values that no other field shares.
struct PointValues {
  Vec<2> local{0.0, 0.0};
  Real volume = 0.25;
  Real mass = 500.0;
  Vec<2> v{0.0, 0.0};
  std::array<Real, 4> sigma{};
  std::vector<Real> state{};
  Real id = 0.0;
};

inline void add_point(const Mesh<2>& mesh, Index cell, const PointValues& point, PointBlocks<2>& points,
    Index material = 0, Index body = 0)
{
  std::vector<Real> values(points.n_rows(), 0.0);
  const Vec<2> x = place_in_cell(mesh, cell, point.local);
  for (int d = 0; d < 2; ++d) {
    values[Rows::x + d] = x[d];
    values[Rows::xi + d] = point.local[d];
    values[Rows::v + d] = point.v[d];
  }
  values[Rows::mass] = point.mass;
  values[Rows::volume] = point.volume;
  for (int k = 0; k < 4; ++k) values[Rows::sigma + k] = point.sigma[k];
  for (std::size_t k = 0; k < point.state.size(); ++k) values[Rows::state + k] = point.state[k];
  values[Rows::id] = point.id;
  points.add({cell, material, body}, values);
}

/// The block of the only material in a cell.
inline PointBlock<2>& only_block(PointBlocks<2>& points, Index cell) { return points.block(points.first_block(cell)); }

}  // namespace terp::test
