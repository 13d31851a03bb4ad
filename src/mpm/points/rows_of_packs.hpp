// Rows of a block, eight points at a time. Not for: the blocks (point_blocks.hpp).
#pragma once

#include "math/pack.hpp"
#include "mpm/points/point_blocks.hpp"

namespace terp {

/// n rows from `first` on, of the points p ... p + 7.
template <int n, int Dim>
inline std::array<Pack, n> load_rows(const PointBlock<Dim>& block, int first, Index p)
{
  std::array<Pack, n> values;
  for (int k = 0; k < n; ++k) values[k] = Pack::load(block.row(first + k) + p);
  return values;
}

template <std::size_t n, int Dim>
inline void store_rows(const std::array<Pack, n>& values, const PointBlock<Dim>& block, int first, Index p)
{
  for (std::size_t k = 0; k < n; ++k) values[k].store(block.row(first + static_cast<int>(k)) + p);
}

}  // namespace terp
