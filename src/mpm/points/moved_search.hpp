// How much soil has moved, found eight points at a time. Not for: what counts as moved (moved.hpp).
#pragma once

#include "math/pack.hpp"
#include "mpm/points/moved.hpp"

namespace terp {

/// Finds it block by block. Sums go by lane, so that their order is that of the blocks alone.
class MovedSearch {
 public:
  /// x_initial: by id, shape [n_points, 2] [m]; distance: from where on soil counts as moved [m].
  MovedSearch(std::span<const Real> x_initial, Real distance) : first_(x_initial.data()), square_(distance * distance)
  {
  }

  /// The points p ... p + 7 of a block.
  void enter(const PointBlock<2>& block, Index p)
  {
    const Index n = block.n - p;
    const Real* id = block.row(Rows::id) + p;
    const Pack x = Pack::load(block.row(Rows::x) + p);
    const Pack dx = x - Pack::gather(first_, 2, id, n),
               dy = Pack::load(block.row(Rows::x + 1) + p) - Pack::gather(first_ + 1, 2, id, n);
    const Mask moved = (dx * dx + dy * dy > Pack(square_)) & (lane_numbers() < Pack(static_cast<Real>(n)));
    volume_ += select(moved, Pack::load(block.row(Rows::volume) + p), Pack(0.0));
    left_ = min(left_, select(moved & (dx < Pack(0.0)), x, left_));
    right_ = max(right_, select(moved & (dx > Pack(0.0)), x, right_));
  }

  MovedSoil found() const
  {
    MovedSoil soil{.volume = sum(volume_)};
    for (int k = 0; k < pack_width; ++k) {
      if (left_[k] < std::numeric_limits<Real>::infinity() && !(left_[k] >= soil.reach_left))
        soil.reach_left = left_[k];
      if (right_[k] > -std::numeric_limits<Real>::infinity() && !(right_[k] <= soil.reach_right))
        soil.reach_right = right_[k];
    }
    return soil;
  }

 private:
  const Real* first_;
  Real square_;
  Pack volume_{0.0};
  Pack left_{std::numeric_limits<Real>::infinity()}, right_{-std::numeric_limits<Real>::infinity()};
};

}  // namespace terp
