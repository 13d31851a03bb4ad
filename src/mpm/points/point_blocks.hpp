// Material points, stored in blocks: a block holds the points of one material and body in one cell, structure of arrays
// inside, padded to whole packs. Several materials or bodies in a cell are several blocks (decisions 0022, 0041).
// Not for: deciding where a point belongs (move.hpp) or what it is worth (kernels, schemes).
#pragma once

#include "math/types.hpp"
#include "os/memory.hpp"
#include "math/number.hpp"
#include "soil/row_table.hpp"

#include <compare>
#include <span>
#include <vector>

namespace terp {

/// What the points of one block have in common. Blocks of a cell are in this order.
struct BlockKey {
  Index cell = -1;
  Index material = -1;  ///< index into Model::materials
  Index body = 0;       ///< the body that the points belong to; all are of body 0 until bodies touch (decision 0041)

  auto operator<=>(const BlockKey&) const = default;
};

/// Points of one material and body in one cell. Lanes n ... capacity are padding: mass, volume and velocity zero, never
/// moved.
template <int Dim>
struct PointBlock : BlockKey {
  Real* data = nullptr;  ///< 64-byte aligned, shape [n_rows, capacity]
  Index capacity = 0;    ///< multiple of pack_width
  Index n = 0;           ///< points in use, lanes 0 ... n-1
  Index next = -1;       ///< next block of the same cell, with a larger key; -1: last

  Real* row(int r) const { return data + static_cast<std::ptrdiff_t>(r) * capacity; }
  Index n_padded() const { return round_up_to_pack(n); }
};

/// Where a point is stored.
struct PointPlace {
  Index block, lane;
};

/// All blocks. Memory comes in slabs that never move; a freed block is used again for the next one of its size.
template <int Dim>
class PointBlocks {
 public:
  using Rows = PointRows<Dim>;

  PointBlocks() = default;
  PointBlocks(Index n_cells, RowTable table);
  /// With n_more rows beyond the fixed ones, which have no names.
  PointBlocks(Index n_cells, int n_more);

  const RowTable& table() const { return table_; }
  int n_rows() const { return n_rows_; }
  std::int64_t n_points() const { return n_points_; }

  /// Makes room for n points in the block of a key before they are added: no growth, no waste.
  void expect(const BlockKey& key, Index n);
  /// Adds a point with its n_rows() values to the block of a key, making one if needed.
  void add(const BlockKey& key, std::span<const Real> values);
  /// Copies the values of a point out and removes it; the block's last point takes its lane.
  void take(Index block, Index lane, std::span<Real> values);
  /// Sets aside blocks for about n more points so that the run does not ask for memory.
  void reserve(std::int64_t n);
  /// Renews `occupied` and `slot_of_cell` after cells were filled or emptied, and frees empty blocks.
  /// Returns true if any cell was filled or emptied.
  bool update_occupied();

  PointBlock<Dim>& block(Index b) { return blocks_[b]; }
  const PointBlock<Dim>& block(Index b) const { return blocks_[b]; }
  /// First block of a cell, or -1.
  Index first_block(Index cell) const { return first_block_[cell]; }

  /// Cells that hold points, ascending, shape [n_occupied].
  const std::vector<Index>& occupied() const { return occupied_; }
  /// Place of a cell in `occupied`, or -1, shape [n_cells].
  const std::vector<Index>& slot_of_cell() const { return slot_of_cell_; }
  /// Upper bound of body numbers.
  Index n_bodies() const { return n_bodies_; }
  /// Upper bound of block numbers.
  Index n_blocks() const { return static_cast<Index>(blocks_.size()); }
  /// Memory of the blocks that hold points [bytes].
  std::int64_t bytes() const;
  /// Memory asked for so far [bytes]; what no block has used takes none.
  std::int64_t reserved_bytes() const;

 private:
  Index find_block(const BlockKey& key) const;
  Index make_block(const BlockKey& key, Index capacity);
  void grow(PointBlock<Dim>& block);
  void merge_new_cells();
  void release(Index block);
  Real* allocate(Index capacity);

  RowTable table_;
  int n_rows_ = 0;
  std::int64_t n_points_ = 0;
  Index n_bodies_ = 1;
  std::vector<PointBlock<Dim>> blocks_;
  std::vector<Index> unused_;             // numbers of blocks that may be used again
  std::vector<std::vector<Real*>> free_;  // by capacity / pack_width
  std::vector<ZeroedArray<Real>> slabs_;
  std::size_t slab_used_ = 0;  // of the last slab [Reals]
  std::vector<Index> first_block_, slot_of_cell_, occupied_, new_cells_;
  bool occupation_changed_ = false;
};

/// Calls f(block) for every block of a cell, in order of their keys.
template <int Dim, class F>
void for_each_block(const PointBlocks<Dim>& points, Index cell, F&& f)
{
  for (Index b = points.first_block(cell); b >= 0; b = points.block(b).next) f(points.block(b), b);
}

/// Calls f(block) for every block, cells ascending.
template <int Dim, class F>
void for_each_block(const PointBlocks<Dim>& points, F&& f)
{
  for (const Index cell : points.occupied())
    for_each_block(points, cell, [&](const PointBlock<Dim>& block, Index) { f(block); });
}

/// Calls f(block, lane) for every point, cells ascending: the fixed order of checkpoints and reports.
template <int Dim, class F>
void for_each_point(const PointBlocks<Dim>& points, F&& f)
{
  for_each_block(points, [&](const PointBlock<Dim>& block) {
    for (Index lane = 0; lane < block.n; ++lane) f(block, lane);
  });
}

}  // namespace terp
