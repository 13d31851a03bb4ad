// Equal buckets over all boxes, stored as one list of box numbers per bucket (as in a compressed sparse row). Boxes
// much larger than the others would fill many buckets; then the buckets are made larger until memory is bounded.
#include "mpm/mesh/box_grid.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr std::int64_t most_entries_per_box = 16;  // beyond: a few boxes as large as the mesh, so take larger buckets

struct BucketRange {
  std::array<Index, 2> first, last;  // both included
  std::int64_t count() const { return std::int64_t{last[0] - first[0] + 1} * (last[1] - first[1] + 1); }
};

/// Monotonic in x, also in floating point: a position in a box falls into a bucket of the box.
Index bucket_along(const BoxGrid& grid, int d, Real x)
{
  const Real at = (x - grid.low[d]) * grid.buckets_per_metre[d];
  return static_cast<Index>(std::clamp(at, 0.0, grid.n[d] - 1.0));
}

BucketRange buckets_of(const BoxGrid& grid, const BoundingBox& box)
{
  BucketRange range;
  for (int d = 0; d < 2; ++d) {
    range.first[d] = bucket_along(grid, d, box.low[d]);
    range.last[d] = bucket_along(grid, d, box.high[d]);
  }
  return range;
}

void divide(BoxGrid& grid, std::array<Index, 2> n)
{
  grid.n = n;
  for (int d = 0; d < 2; ++d) {
    const Real size = grid.high[d] - grid.low[d];
    grid.buckets_per_metre[d] = size > 0.0 ? n[d] / size : 0.0;
  }
}

std::int64_t count_entries(const BoxGrid& grid, std::span<const BoundingBox> boxes)
{
  std::int64_t n = 0;
  for (const auto& box : boxes) n += buckets_of(grid, box).count();
  return n;
}

/// A quarter as many buckets as boxes, square if they can be; fewer where boxes overlap many of them.
void choose_buckets(BoxGrid& grid, std::span<const BoundingBox> boxes)
{
  const Real n_buckets = std::max(1.0, 0.25 * static_cast<Real>(boxes.size()));
  const Real width = grid.high[0] - grid.low[0], height = grid.high[1] - grid.low[1];
  const Real along_x = std::sqrt(n_buckets * width / height);
  const Real nx =
      std::isfinite(along_x) ? std::clamp(std::round(along_x), 1.0, std::floor(n_buckets)) : std::floor(n_buckets);
  divide(grid, {static_cast<Index>(nx), static_cast<Index>(std::max(1.0, std::floor(n_buckets / nx)))});
  while (count_entries(grid, boxes) > most_entries_per_box * static_cast<std::int64_t>(boxes.size()))
    divide(grid, {std::max(grid.n[0] / 2, 1), std::max(grid.n[1] / 2, 1)});
}

template <class F>
void for_each_bucket(const BoxGrid& grid, const BoundingBox& box, F&& f)
{
  const BucketRange range = buckets_of(grid, box);
  for (Index j = range.first[1]; j <= range.last[1]; ++j)
    for (Index i = range.first[0]; i <= range.last[0]; ++i) f(static_cast<std::size_t>(j) * grid.n[0] + i);
}

void fill(BoxGrid& grid, std::span<const BoundingBox> boxes)
{
  const std::size_t n_buckets = static_cast<std::size_t>(grid.n[0]) * grid.n[1];
  grid.first_of_bucket.assign(n_buckets + 1, 0);
  for (const auto& box : boxes) for_each_bucket(grid, box, [&](std::size_t b) { ++grid.first_of_bucket[b + 1]; });
  for (std::size_t b = 0; b < n_buckets; ++b) grid.first_of_bucket[b + 1] += grid.first_of_bucket[b];
  std::vector<Index> next(grid.first_of_bucket.begin(), grid.first_of_bucket.end() - 1);
  grid.boxes.resize(grid.first_of_bucket.back());
  for (std::size_t k = 0; k < boxes.size(); ++k)
    for_each_bucket(grid, boxes[k], [&](std::size_t b) { grid.boxes[next[b]++] = static_cast<Index>(k); });
}

}  // namespace

Real distance_to_line(Vec<2> a, Vec<2> b, Vec<2> x)
{
  const Vec<2> along{b[0] - a[0], b[1] - a[1]};
  const Real squared = along[0] * along[0] + along[1] * along[1];
  const Real t =
      squared > 0.0 ? std::clamp(((x[0] - a[0]) * along[0] + (x[1] - a[1]) * along[1]) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(x[0] - a[0] - t * along[0], x[1] - a[1] - t * along[1]);
}

BoundingBox box_around(std::span<const Vec<2>> places)
{
  BoundingBox box{places[0], places[0]};
  for (const auto& x : places)
    for (int d = 0; d < 2; ++d) {
      box.low[d] = std::min(box.low[d], x[d]);
      box.high[d] = std::max(box.high[d], x[d]);
    }
  return box;
}

BoundingBox widened(const BoundingBox& box, Real share)
{
  const Real margin = share * std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  return {{box.low[0] - margin, box.low[1] - margin}, {box.high[0] + margin, box.high[1] + margin}};
}

BoxGrid make_box_grid(std::span<const BoundingBox> boxes)
{
  BoxGrid grid;
  if (boxes.empty()) return grid;
  grid.low = boxes[0].low;
  grid.high = boxes[0].high;
  for (const auto& box : boxes)
    for (int d = 0; d < 2; ++d) {
      grid.low[d] = std::min(grid.low[d], box.low[d]);
      grid.high[d] = std::max(grid.high[d], box.high[d]);
    }
  choose_buckets(grid, boxes);
  fill(grid, boxes);
  return grid;
}

std::span<const Index> boxes_near(const BoxGrid& grid, Vec<2> place)
{
  for (int d = 0; d < 2; ++d)
    if (grid.n[d] == 0 || !(place[d] >= grid.low[d] && place[d] <= grid.high[d])) return {};
  const std::size_t bucket =
      static_cast<std::size_t>(bucket_along(grid, 1, place[1])) * grid.n[0] + bucket_along(grid, 0, place[0]);
  return std::span(grid.boxes)
      .subspan(grid.first_of_bucket[bucket], grid.first_of_bucket[bucket + 1] - grid.first_of_bucket[bucket]);
}

}  // namespace terp
