// Sides between boxes of two kinds make a planar graph, whose chains are simplified as those of a drawing: neighbours
// share their outline.

#include "import/drawing/point_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace terp {
namespace {

constexpr Real least_fill = 0.05;   // of a box, from which on it counts as ground
constexpr Real outline_fill = 0.5;  // of a box, from which on it lies in an outline

struct BoxRaster {
  Vec<2> low{};
  Real side = 0.0;
  std::array<Index, 2> n{};
  std::vector<std::map<int, Real>> volume;  ///< of each material, by box

  Real fill(Index i, Index j) const
  {
    Real sum = 0.0;
    for (const auto& [material, part] : volume[i + n[0] * j]) sum += part;
    return sum / (side * side);
  }
  /// The material with most volume in a box that holds some.
  int most(Index i, Index j) const
  {
    const auto& parts = volume[i + n[0] * j];
    return std::ranges::max_element(parts, {}, [](const auto& part) { return part.second; })->first;
  }
};

BoxRaster raster_of(std::span<const Vec<2>> places, std::span<const Real> volumes, std::span<const int> materials)
{
  std::vector<Real> sizes(volumes.begin(), volumes.end());
  std::ranges::nth_element(sizes, sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2));
  const Real point = std::sqrt(sizes[sizes.size() / 2]);
  BoxRaster raster;
  raster.side = 3.0 * point;
  const BoundingBox box = box_around(places);
  for (int d = 0; d < 2; ++d) {
    raster.low[d] = box.low[d] - 0.5 * point;
    raster.n[d] = static_cast<Index>(std::floor((box.high[d] - raster.low[d]) / raster.side)) + 1;
  }
  raster.volume.resize(static_cast<std::size_t>(raster.n[0]) * raster.n[1]);
  for (std::size_t p = 0; p < places.size(); ++p) {
    const auto i = static_cast<Index>((places[p][0] - raster.low[0]) / raster.side);
    const auto j = static_cast<Index>((places[p][1] - raster.low[1]) / raster.side);
    raster.volume[i + raster.n[0] * j][materials[p]] += volumes[p];
  }
  return raster;
}

/// The highest box of a column that counts as ground; -1: none, beyond the raster too.
Index top_of(const BoxRaster& raster, Index i)
{
  if (i < 0 || i >= raster.n[0]) return -1;
  Index j = raster.n[1] - 1;
  while (j >= 0 && raster.fill(i, j) < least_fill) --j;
  return j;
}

/// Materials of boxes, with an empty box around all.
struct BoxLabels {
  Real side = 0.0;  ///< [m]
  std::array<Index, 2> n{};
  std::vector<int> label;

  BoxLabels(Real side_of_box, std::array<Index, 2> n_boxes) : side(side_of_box), n(n_boxes)
  {
    label.assign(static_cast<std::size_t>(n[0] + 2) * (n[1] + 2), -1);
  }

  int& at(Index i, Index j) { return label[(i + 1) + (n[0] + 2) * (j + 1)]; }
  int at(Index i, Index j) const { return label[(i + 1) + (n[0] + 2) * (j + 1)]; }
};

/// A box of the last column counts if points fill half of the width that they have there.
BoxLabels labels_of(const BoxRaster& raster, Real last_width)
{
  BoxLabels labels(raster.side, {raster.n[0], raster.n[1] + 1});  // a row more, for what reaches above the ground
  for (Index j = 0; j < raster.n[1]; ++j)
    for (Index i = 0; i < raster.n[0]; ++i) {
      const bool is_last = i + 1 == raster.n[0];
      if (raster.fill(i, j) >= outline_fill * (is_last ? last_width / raster.side : 1.0))
        labels.at(i, j) = raster.most(i, j);
    }
  return labels;
}

/// Each column as high as its top and a box more: straightened outlines are then nowhere below the ground.
void reach_above_ground(const BoxRaster& raster, BoxLabels& labels)
{
  for (Index i = 0; i < raster.n[0]; ++i)
    if (const Index top = top_of(raster, i); top >= 0) labels.at(i, top) = labels.at(i, top + 1) = raster.most(i, top);
}

constexpr Index parts = 3;  // of a box, along a side: each has about one point

/// Boxes in parts, of which each has the material of the point with most volume in it, or that of a part beside it.
BoxLabels in_parts(const BoxRaster& raster, BoxLabels& boxes, std::span<const Vec<2>> places,
    std::span<const Real> volumes, std::span<const int> materials)
{
  constexpr int unknown = -2;
  BoxLabels fine(raster.side / parts, {parts * boxes.n[0], parts * boxes.n[1]});
  for (Index j = 0; j < fine.n[1]; ++j)
    for (Index i = 0; i < fine.n[0]; ++i) fine.at(i, j) = boxes.at(i / parts, j / parts) < 0 ? -1 : unknown;
  std::map<std::pair<Index, Index>, Real> most;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const auto i = static_cast<Index>((places[p][0] - raster.low[0]) / fine.side);
    const auto j = static_cast<Index>((places[p][1] - raster.low[1]) / fine.side);
    Real& volume = most[{i, j}];
    if (fine.at(i, j) != -1 && volumes[p] > volume) volume = volumes[p], fine.at(i, j) = materials[p];
  }
  for (bool grows = true; grows;) {
    grows = false;
    const BoxLabels before = fine;
    for (Index j = 0; j < fine.n[1]; ++j)
      for (Index i = 0; i < fine.n[0]; ++i)
        for (const auto& [di, dj] : {std::pair{0, -1}, {-1, 0}, {1, 0}, {0, 1}})
          if (fine.at(i, j) == unknown)
            if (const int beside = before.at(i + di, j + dj); beside >= 0) fine.at(i, j) = beside, grows = true;
  }
  for (int& label : fine.label) label = std::max(label, -1);
  return fine;
}

/// Sides of boxes between different labels; owners are the labels left and right.
PlanarGraph edges_of(Vec<2> low, const BoxLabels& labels)
{
  PlanarGraph graph;
  std::map<std::pair<Index, Index>, Index> known;
  const auto place = [&](Index i, Index j) {
    const auto [at, is_new] = known.try_emplace({i, j}, static_cast<Index>(graph.places.size()));
    if (is_new) graph.places.push_back({low[0] + i * labels.side, low[1] + j * labels.side});
    return at->second;
  };
  for (Index j = 0; j <= labels.n[1]; ++j)
    for (Index i = 0; i <= labels.n[0]; ++i) {
      const int here = labels.at(i, j), left = labels.at(i - 1, j), below = labels.at(i, j - 1);
      if (here != left) graph.edges.push_back({place(i, j), place(i, j + 1), {left, here}});
      if (here != below) graph.edges.push_back({place(i, j), place(i + 1, j), {here, below}});
    }
  return graph;
}

}  // namespace

PointRegions regions_of_points(std::span<const Vec<2>> places, std::span<const Real> volumes,
    std::span<const int> materials, const OutlineOptions& options)
{
  if (places.empty()) return {};
  const BoxRaster raster = raster_of(places, volumes, materials);
  PointRegions result{raster.side, {}};
  const Real last = box_around(places).high[0] + raster.side / 6.0 - (raster.low[0] + (raster.n[0] - 1) * raster.side);
  BoxLabels labels = labels_of(raster, options.reaches_above ? std::min(last, raster.side) : raster.side);
  if (options.reaches_above) {
    reach_above_ground(raster, labels);
    labels = in_parts(raster, labels, places, volumes, materials);
  }
  const PlanarGraph graph = edges_of(raster.low, labels);
  const PlanarFaces faces = find_faces(graph);
  const ChainMap boxes = find_chains(graph, faces, regions_by_edges(graph, faces).value(), 1e-9 * labels.side);
  ChainMap simpler = boxes;
  ChainChanges changes;
  const Real tolerance = options.tolerance > 0.0 ? options.tolerance : 0.75 * labels.side;
  simplify(simpler, {0.0, tolerance, 1e-3 * labels.side}, changes);
  const auto regions = regions_between(simpler);
  result.regions = regions ? *regions : regions_between(boxes).value();
  return result;
}

}  // namespace terp
