// Edges are cut in rounds until none is near a place or crosses another. Places never move, so their distance stays at
// least the snap distance. An edge is bent to places that are nearer than 0.7 of it: then no end of the edge is near
// its own parts, and cutting comes to an end.

#include "import/drawing/planar_graph.hpp"

#include "math/errors.hpp"
#include "math/plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

namespace terp {
namespace {

constexpr int most_rounds = 60;
constexpr Index most_edges = 100'000, most_crossings = 100'000;

[[noreturn]] void refuse_lines(const char* what)
{
  throw InputError({"", what,
      fmt::format("Terp joins lines of at most {} sides that cross at most {} times. Leave out hatchings and meshes: "
                  "--layers names the layers of the section.",
          most_edges, most_crossings),
      ""});
}

/// Places in square buckets as wide as the snap distance.
class PlaceTable {
 public:
  PlaceTable(std::vector<Vec<2>>& places, Real snap) : places_(places), snap_(snap) {}

  /// The place nearest to x within the snap distance, or x itself as a new place.
  Index at(Vec<2> x)
  {
    const auto [i, j] = bucket(x);
    Index nearest = -1;
    for (std::int64_t di = -1; di <= 1; ++di)
      for (std::int64_t dj = -1; dj <= 1; ++dj)
        if (const auto found = buckets_.find(key(i + di, j + dj)); found != buckets_.end())
          for (const Index k : found->second)
            if (distance(places_[k], x) <= snap_ &&
                (nearest < 0 || distance(places_[k], x) < distance(places_[nearest], x)))
              nearest = k;
    if (nearest >= 0) return nearest;
    places_.push_back(x);
    buckets_[key(i, j)].push_back(static_cast<Index>(places_.size()) - 1);
    return static_cast<Index>(places_.size()) - 1;
  }

 private:
  std::array<std::int64_t, 2> bucket(Vec<2> x) const
  {
    return {static_cast<std::int64_t>(std::floor(x[0] / snap_)), static_cast<std::int64_t>(std::floor(x[1] / snap_))};
  }
  static std::uint64_t key(std::int64_t i, std::int64_t j)
  {
    return static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(j);
  }

  std::vector<Vec<2>>& places_;
  Real snap_;
  std::unordered_map<std::uint64_t, std::vector<Index>> buckets_;
};

using Ends = std::pair<Index, Index>;

/// Edges by their ends, the lower number first; an outline that passes twice cancels.
class EdgeTable {
 public:
  void add(Index a, Index b, const std::vector<int>& owners, bool cancels)
  {
    if (a == b) return;
    auto& known = edges_[std::minmax(a, b)];
    for (const int owner : owners) {
      const auto at = std::ranges::lower_bound(known, owner);
      const bool is_there = at != known.end() && *at == owner;
      if (is_there && cancels) known.erase(at);
      if (!is_there) known.insert(at, owner);
    }
  }
  std::map<Ends, std::vector<int>>& all() { return edges_; }

 private:
  std::map<Ends, std::vector<int>> edges_;
};

class Joiner {
 public:
  Joiner(const std::vector<DrawnLine>& lines, Real snap) : snap_(snap), table_(graph_.places, snap)
  {
    std::size_t n_sides = 0;
    for (const DrawnLine& line : lines) n_sides += line.places.size();
    if (n_sides > most_edges) refuse_lines("the lines of the drawing are too many");
    for (const DrawnLine& line : lines) {
      std::vector<Index> at;
      for (const Vec<2>& x : line.places) at.push_back(known_place(x));
      const std::size_t n = at.size() - (line.closed ? 0 : 1);
      EdgeTable& edges = line.closed ? outlines_ : open_;
      for (std::size_t k = 0; k < n && !at.empty(); ++k)
        edges.add(at[k], at[(k + 1) % at.size()], {line.owner}, line.closed);
    }
  }

  PlanarGraph join()
  {
    for (int round = 0; cut_round(); ++round)
      if (round == most_rounds)
        throw InputError({"", "the lines of the drawing lie too near to each other",
            fmt::format("They could not be joined within {:g} m. Give a smaller distance, or check the unit of the "
                        "drawing.",
                snap_),
            ""});
    for (const auto& [ends, owners] : open_.all()) outlines_.add(ends.first, ends.second, owners, false);
    for (auto& [ends, owners] : outlines_.all())
      if (!owners.empty()) graph_.edges.push_back({ends.first, ends.second, std::move(owners)});
    drop_loose_ends();
    return std::move(graph_);
  }

 private:
  Index known_place(Vec<2> x)
  {
    const std::size_t before = graph_.places.size();
    const Index at = table_.at(x);
    const Real moved = distance(graph_.places[at], x);
    if (graph_.places.size() == before && moved > 0.0) ++graph_.counts.merged;
    graph_.counts.largest = std::max(graph_.counts.largest, moved);
    return at;
  }

  /// True if an edge was cut.
  bool cut_round()
  {
    std::vector<Ends> all;
    for (EdgeTable* table : {&outlines_, &open_})
      for (const auto& [ends, owners] : table->all()) all.push_back(ends);
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    cuts_.clear();
    collect_places_near(all);
    if (cuts_.empty()) collect_crossings(all);
    for (auto& [ends, places] : cuts_) {
      const Vec<2> a = graph_.places[ends.first];
      std::ranges::sort(places, {}, [&](Index k) { return distance(a, graph_.places[k]); });
      places.erase(std::unique(places.begin(), places.end()), places.end());
    }
    if (!cuts_.empty()) {
      outlines_ = cut_edges(outlines_, true);
      open_ = cut_edges(open_, false);
    }
    return !cuts_.empty();
  }

  EdgeTable cut_edges(EdgeTable& table, bool cancels) const
  {
    EdgeTable parts;
    for (const auto& [ends, owners] : table.all()) {
      Index from = ends.first;
      if (const auto cut = cuts_.find(ends); cut != cuts_.end())
        for (const Index k : cut->second) {
          parts.add(from, k, owners, cancels);
          from = k;
        }
      parts.add(from, ends.second, owners, cancels);
    }
    return parts;
  }

  void collect_places_near(const std::vector<Ends>& all)
  {
    std::vector<Index> by_x(graph_.places.size());
    std::iota(by_x.begin(), by_x.end(), Index{0});
    const auto x_of = [&](Index k) { return graph_.places[k][0]; };
    std::ranges::sort(by_x, {}, x_of);
    for (const auto& [i, j] : all) {
      const Vec<2> a = graph_.places[i], b = graph_.places[j];
      const BoundingBox box = box_around(std::array{a, b});
      for (auto k = std::ranges::lower_bound(by_x, box.low[0] - snap_, {}, x_of);
           k != by_x.end() && x_of(*k) <= box.high[0] + snap_; ++k) {
        const Vec<2> x = graph_.places[*k];
        if (*k == i || *k == j || x[1] < box.low[1] - snap_ || x[1] > box.high[1] + snap_) continue;
        const Real along = (x[0] - a[0]) * (b[0] - a[0]) + (x[1] - a[1]) * (b[1] - a[1]);
        const Real length = distance(a, b), off = std::abs(cross(a, b, x)) / length;
        if (along <= 0.0 || along >= length * length || off > edge_reach * snap_) continue;
        cuts_[{i, j}].push_back(*k);
        ++graph_.counts.joined;
        graph_.counts.largest = std::max(graph_.counts.largest, off);
      }
    }
  }

  void collect_crossings(std::vector<Ends> all)
  {
    const auto left = [&](const Ends& e) { return std::min(graph_.places[e.first][0], graph_.places[e.second][0]); };
    std::ranges::sort(all, {}, left);
    std::vector<BoundingBox> boxes;
    for (const auto& [i, j] : all) boxes.push_back(box_around(std::array{graph_.places[i], graph_.places[j]}));
    for (std::size_t k = 0; k < all.size(); ++k)
      for (std::size_t other = k + 1; other < all.size() && boxes[other].low[0] <= boxes[k].high[0]; ++other) {
        Vec<2> x;
        if (!overlap(boxes[k], boxes[other])) continue;
        if (!lines_cross(graph_.places[all[k].first], graph_.places[all[k].second], graph_.places[all[other].first],
                graph_.places[all[other].second], x))
          continue;
        const Index at = crossing_place(all[k], all[other], x);
        if (++graph_.counts.crossings > most_crossings) refuse_lines("the lines of the drawing cross too often");
        for (const Ends& ends : {all[k], all[other]})
          if (at != ends.first && at != ends.second) cuts_[ends].push_back(at);
      }
  }

  /// An end of either edge if one is near the crossing, else the place there.
  Index crossing_place(const Ends& one, const Ends& two, Vec<2> x)
  {
    for (const Index end : {one.first, one.second, two.first, two.second})
      if (distance(graph_.places[end], x) <= snap_) return end;
    return table_.at(x);
  }

  /// Each edge that goes may leave a loose one behind it.
  void drop_loose_ends()
  {
    std::vector<std::vector<std::size_t>> edges_at(graph_.places.size());
    for (std::size_t k = 0; k < graph_.edges.size(); ++k)
      for (const Index at : {graph_.edges[k].a, graph_.edges[k].b}) edges_at[at].push_back(k);
    std::vector<bool> is_gone(graph_.edges.size(), false);
    for (std::size_t at = 0; at < edges_at.size(); ++at)
      for (std::size_t here = at; edges_at[here].size() == 1;) {
        const std::size_t edge = edges_at[here].front();
        const GraphEdge& e = graph_.edges[edge];
        graph_.loose.push_back(e.a == static_cast<Index>(here) ? e : GraphEdge{e.b, e.a, e.owners});
        is_gone[edge] = true;
        edges_at[here].clear();
        here = static_cast<std::size_t>(e.a) == here ? e.b : e.a;
        std::erase(edges_at[here], edge);
      }
    std::size_t k = 0;
    std::erase_if(graph_.edges, [&](const GraphEdge&) { return is_gone[k++]; });
  }

  Real snap_;
  PlanarGraph graph_;
  PlaceTable table_;
  EdgeTable outlines_, open_;
  std::map<Ends, std::vector<Index>> cuts_;
};

}  // namespace

Vec<2> place_in(const Polygon& outline)
{
  std::size_t longest = 0;
  Real most = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k)
    if (const Real length = distance(outline[k], outline[(k + 1) % outline.size()]); length > most)
      most = length, longest = k;
  const Vec<2> a = outline[longest], b = outline[(longest + 1) % outline.size()];
  const Real off = 1e-7;  // of the edge, to its left
  return {0.5 * (a[0] + b[0]) - off * (b[1] - a[1]), 0.5 * (a[1] + b[1]) + off * (b[0] - a[0])};
}

PlanarGraph join_lines(const std::vector<DrawnLine>& lines, Real snap) { return Joiner(lines, snap).join(); }

PlanarFaces find_faces(const PlanarGraph& graph)
{
  std::vector<std::array<Index, 2>> ends;
  for (const GraphEdge& edge : graph.edges) ends.push_back({edge.a, edge.b});
  return find_faces(graph.places, ends);
}

std::optional<std::vector<int>> regions_by_edges(const PlanarGraph& graph, const PlanarFaces& faces)
{
  constexpr int unknown = -2;
  std::vector<int> region(faces.rings.size(), unknown);
  for (std::size_t k = 0; k < graph.edges.size(); ++k)
    for (const bool left : {true, false}) {
      int& known = region[left ? faces.left[k] : faces.right[k]];
      const int here = graph.edges[k].owners[left ? 0 : 1];
      if (known != unknown && known != here) return std::nullopt;
      known = here;
    }
  return region;
}

Polygon corners_of(const PlanarGraph& graph, const FaceRing& ring)
{
  Polygon corners;
  for (const Index k : ring.places) corners.push_back(graph.places[k]);
  return corners;
}

Real area_of_face(const PlanarGraph& graph, const std::vector<FaceRing>& rings)
{
  Real sum = 0.0;
  for (const FaceRing& ring : rings) sum += signed_area(corners_of(graph, ring));
  return sum;
}

Real distance_to(const Polygon& line, std::size_t first, std::size_t last, Vec<2> x)
{
  Real nearest = distance(line[first], x);
  for (std::size_t k = first; k < last; ++k) {
    const Vec<2> a = line[k], b = line[k + 1];
    const Real length = distance(a, b);
    const Real along = (x[0] - a[0]) * (b[0] - a[0]) + (x[1] - a[1]) * (b[1] - a[1]);
    nearest = std::min(
        nearest, distance(between(a, b, length > 0.0 ? std::clamp(along / (length * length), 0.0, 1.0) : 0.0), x));
  }
  return nearest;
}

bool are_apart(const std::vector<Vec<2>>& places, const GraphEdge& e, const GraphEdge& f)
{
  const Vec<2> a = places[e.a], b = places[e.b], c = places[f.a], d = places[f.b];
  for (int axis = 0; axis < 2; ++axis)
    if (std::min(a[axis], b[axis]) > std::max(c[axis], d[axis]) ||
        std::min(c[axis], d[axis]) > std::max(a[axis], b[axis]))
      return true;
  Vec<2> x;
  if (lines_cross(a, b, c, d, x)) return false;
  const auto touches = [&](Index k, const GraphEdge& edge) {
    return k != edge.a && k != edge.b && distance_to({places[edge.a], places[edge.b]}, 0, 1, places[k]) <= 1e-9;
  };
  return !(touches(e.a, f) || touches(e.b, f) || touches(f.a, e) || touches(f.b, e));
}

bool lines_are_apart(const PlanarGraph& graph)
{
  std::vector<std::size_t> order(graph.edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto low = [&](std::size_t k) {
    return std::min(graph.places[graph.edges[k].a][0], graph.places[graph.edges[k].b][0]);
  };
  std::ranges::sort(order, {}, low);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const GraphEdge& e = graph.edges[order[i]];
    const Real high = std::max(graph.places[e.a][0], graph.places[e.b][0]);
    for (std::size_t j = i + 1; j < order.size() && low(order[j]) <= high; ++j)
      if (!are_apart(graph.places, e, graph.edges[order[j]])) return false;
  }
  return true;
}

}  // namespace terp
