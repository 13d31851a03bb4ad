// A full block moves to memory that is larger by one pack; its old memory goes to the list of free pieces of that size.
// So memory is never given back, and with enough in reserve a step asks for none. Blocks of a cell form a list in the
// order of their keys. Sums run in that order, so it decides the bits of results. add() may move the data of a block,
// and the list of all blocks too: keep no pointer or reference across it. An empty block stays in its list, and
// `occupied` stays as it was, until update_occupied().

#include "mpm/points/point_blocks.hpp"

#include "math/errors.hpp"

#include <algorithm>

namespace terp {
namespace {

constexpr std::size_t smallest_slab = 1u << 17,
                      largest_slab = 1u << 22;  // 1 and 32 MiB of Reals: asked for rarely, more as there are more

RowTable unnamed_rows(int n)
{
  RowTable table;
  for (int k = 0; k < n; ++k)
    table.add({.name = "row_" + std::to_string(k), .unit = "-", .meaning = "", .owner = "unnamed"});
  return table;
}

}  // namespace

template <int Dim>
PointBlocks<Dim>::PointBlocks(Index n_cells, int n_more) : PointBlocks(n_cells, unnamed_rows(n_more))
{
}

template <int Dim>
PointBlocks<Dim>::PointBlocks(Index n_cells, RowTable table)
    : table_(std::move(table)), n_rows_(table_.n_rows()), first_block_(n_cells, -1), slot_of_cell_(n_cells, -1)
{
  occupied_.reserve(n_cells);
  new_cells_.reserve(n_cells);
  blocks_.reserve(n_cells);
  unused_.reserve(n_cells);
}

template <int Dim>
Real* PointBlocks<Dim>::allocate(Index capacity)
{
  const std::size_t size_class = capacity / pack_width;
  if (size_class < free_.size() && !free_[size_class].empty()) {
    Real* data = free_[size_class].back();
    free_[size_class].pop_back();
    return data;
  }
  const std::size_t n = static_cast<std::size_t>(capacity) * n_rows_;
  if (slabs_.empty() || slab_used_ + n > slabs_.back().size()) {
    slabs_.emplace_back(
        std::max(n, std::clamp<std::size_t>(reserved_bytes() / sizeof(Real), smallest_slab, largest_slab)));
    slab_used_ = 0;
  }
  Real* data = slabs_.back().data() + slab_used_;  // aligned: slabs begin with a page, blocks are whole packs
  slab_used_ += n;
  return data;
}

/// Number of the block of a key, or -1.
template <int Dim>
Index PointBlocks<Dim>::find_block(const BlockKey& key) const
{
  Index b = first_block_[key.cell];
  while (b >= 0 && blocks_[b] != key) b = blocks_[b].next;
  return b;
}

template <int Dim>
Index PointBlocks<Dim>::make_block(const BlockKey& key, Index capacity)
{
  Index b;
  if (unused_.empty()) {
    b = n_blocks();
    blocks_.emplace_back();
  } else {
    b = unused_.back();
    unused_.pop_back();
  }
  Real* data = allocate(capacity);
  std::fill_n(data, static_cast<std::size_t>(capacity) * n_rows_, 0.0);
  blocks_[b] = {key, data, capacity, 0, -1};
  n_bodies_ = std::max(n_bodies_, key.body + 1);
  if (first_block_[key.cell] < 0) {
    new_cells_.push_back(key.cell);
    occupation_changed_ = true;
  }
  Index* link = &first_block_[key.cell];
  while (*link >= 0 && blocks_[*link] < key) link = &blocks_[*link].next;
  blocks_[b].next = *link;
  *link = b;
  return b;
}

template <int Dim>
void PointBlocks<Dim>::grow(PointBlock<Dim>& block)
{
  const Index capacity = block.capacity + pack_width;
  Real* data = allocate(capacity);
  std::fill_n(data, static_cast<std::size_t>(capacity) * n_rows_, 0.0);
  for (int r = 0; r < n_rows_; ++r)
    std::copy_n(block.row(r), block.n, data + static_cast<std::ptrdiff_t>(r) * capacity);
  const std::size_t size_class = block.capacity / pack_width;
  if (free_.size() <= size_class) free_.resize(size_class + 1);
  free_[size_class].push_back(block.data);
  block.data = data;
  block.capacity = capacity;
}

template <int Dim>
void PointBlocks<Dim>::release(Index b)
{
  PointBlock<Dim>& block = blocks_[b];
  const std::size_t size_class = block.capacity / pack_width;
  if (free_.size() <= size_class) free_.resize(size_class + 1);
  free_[size_class].push_back(block.data);
  block = {};
  unused_.push_back(b);
}

template <int Dim>
void PointBlocks<Dim>::expect(const BlockKey& key, Index n)
{
  if (find_block(key) < 0) make_block(key, round_up_to_pack(n));
}

template <int Dim>
void PointBlocks<Dim>::add(const BlockKey& key, std::span<const Real> values)
{
  TERP_ASSERT(key.cell >= 0 && key.body >= 0 && static_cast<int>(values.size()) == n_rows_);
  Index b = find_block(key);
  if (b < 0) b = make_block(key, pack_width);
  PointBlock<Dim>& block = blocks_[b];
  if (block.n == block.capacity) grow(block);
  const Index lane = block.n++;
  for (int r = 0; r < n_rows_; ++r) block.row(r)[lane] = values[r];
  ++n_points_;
}

template <int Dim>
void PointBlocks<Dim>::take(Index b, Index lane, std::span<Real> values)
{
  PointBlock<Dim>& block = blocks_[b];
  TERP_ASSERT(lane < block.n);
  const Index last = --block.n;
  for (int r = 0; r < n_rows_; ++r) {
    Real* row = block.row(r);
    values[r] = row[lane];
    row[lane] = row[last];
    row[last] = 0.0;
  }
  --n_points_;
  if (block.n == 0) occupation_changed_ = true;
}

template <int Dim>
void PointBlocks<Dim>::reserve(std::int64_t n)
{
  for (Index size_class = 1; size_class <= 5; ++size_class) {
    if (free_.size() <= static_cast<std::size_t>(size_class)) free_.resize(size_class + 1);
    const std::int64_t n_blocks = n / (5 * pack_width * size_class) + 4;
    std::vector<Real*> fresh;
    for (std::int64_t k = 0; k < n_blocks; ++k) fresh.push_back(allocate(size_class * pack_width));
    free_[size_class].reserve(4 * (fresh.size() + first_block_.size()));
    free_[size_class].insert(free_[size_class].end(), fresh.begin(), fresh.end());
  }
}

template <int Dim>
bool PointBlocks<Dim>::update_occupied()
{
  if (!occupation_changed_) return false;
  occupation_changed_ = false;
  const auto drop_empty_blocks = [&](Index cell) {
    for (Index* link = &first_block_[cell]; *link >= 0;) {
      const Index b = *link;
      if (blocks_[b].n > 0) {
        link = &blocks_[b].next;
      } else {
        *link = blocks_[b].next;
        release(b);
      }
    }
    if (first_block_[cell] < 0) slot_of_cell_[cell] = -1;
    return first_block_[cell] < 0;
  };
  std::erase_if(occupied_, drop_empty_blocks);
  std::sort(new_cells_.begin(), new_cells_.end());
  new_cells_.erase(std::unique(new_cells_.begin(), new_cells_.end()), new_cells_.end());
  std::erase_if(new_cells_, [&](Index cell) { return slot_of_cell_[cell] >= 0 || drop_empty_blocks(cell); });
  merge_new_cells();
  for (std::size_t slot = 0; slot < occupied_.size(); ++slot) slot_of_cell_[occupied_[slot]] = static_cast<Index>(slot);
  return true;
}

/// Merges two ascending lists from their ends, in place: std::inplace_merge would ask for memory in every step.
template <int Dim>
void PointBlocks<Dim>::merge_new_cells()
{
  std::size_t old = occupied_.size(), fresh = new_cells_.size(), end = old + fresh;
  occupied_.resize(end);
  while (fresh > 0) {
    if (old > 0 && occupied_[old - 1] > new_cells_[fresh - 1])
      occupied_[--end] = occupied_[--old];
    else
      occupied_[--end] = new_cells_[--fresh];
  }
  new_cells_.clear();
}

template <int Dim>
std::int64_t PointBlocks<Dim>::bytes() const
{
  std::int64_t n = 0;
  for (const PointBlock<Dim>& block : blocks_) n += std::int64_t{block.capacity} * n_rows_;
  return n * static_cast<std::int64_t>(sizeof(Real));
}

template <int Dim>
std::int64_t PointBlocks<Dim>::reserved_bytes() const
{
  std::int64_t n = 0;
  for (const ZeroedArray<Real>& slab : slabs_) n += static_cast<std::int64_t>(slab.size());
  return n * static_cast<std::int64_t>(sizeof(Real));
}

template class PointBlocks<2>;

}  // namespace terp
