// Why not the fragments of gmsh's OpenCASCADE kernel (tried with gmsh 4.8.4): without a tolerance they leave slivers
// where an outline ends 5 cm from a corner of the domain, which set the time step. With a tolerance of 0.1 m they bend
// the domain: an outline 3 to 6 cm above the base drew the base up. Here followed places move onto the domain, which
// never moves. Why faces, and not one surface with the followed lines embedded in it: gmsh's pairing of triangles by
// Blossom fails for the closed outlines of a dike ("Perfect Match failed"), so two of three recipes would give no mesh.

#include "model/meshes/planar_map.hpp"

#include "math/plane.hpp"
#include "model/meshes/mesh_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace terp {
namespace {

using Polygon = std::vector<Vec<2>>;

constexpr Real same_line = 1e-12;  // of the longer edge, that two edges on one line may be apart

Real projection(Vec<2> a, Vec<2> b, Vec<2> x)
{
  const Real length = distance(a, b);
  return ((x[0] - a[0]) * (b[0] - a[0]) + (x[1] - a[1]) * (b[1] - a[1])) / (length * length);
}

Real area(const Polygon& x)
{
  Real sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += 0.5 * cross(x[0], x[k], x[(k + 1) % x.size()]);
  return sum;
}

/// Even-odd rule.
bool holds(const Polygon& polygon, Vec<2> x)
{
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a[1] > x[1]) != (b[1] > x[1]) && x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

/// Places and lines while they are cut. The polygon's own lines come first.
class Cutter {
 public:
  Cutter(const Polygon& polygon, Real tolerance) : polygon_(polygon), tolerance_(tolerance), places_(polygon)
  {
    const Index n = static_cast<Index>(polygon.size());
    for (Index k = 0; k < n; ++k) {
      lines_.push_back({k, (k + 1) % n, k});
      tolerance_ = std::min(tolerance_, 0.1 * distance(polygon[k], polygon[(k + 1) % n]));
    }
  }

  void add_outline(const Polygon& outline)
  {
    std::vector<Index> at;
    for (const Vec<2>& x : outline) at.push_back(place(onto_edge(x)));
    for (std::size_t k = 0; k < at.size(); ++k)
      if (at[k] != at[(k + 1) % at.size()]) lines_.push_back({at[k], at[(k + 1) % at.size()], -1});
  }

  void add_crossings()
  {
    for (std::size_t k = 0; k < lines_.size(); ++k)
      for (std::size_t other = k + 1; other < lines_.size(); ++other) add_crossing(lines_[k], lines_[other]);
  }

  /// Lines from place to place, each once, inside the polygon, without loose ends.
  std::vector<CutLine> split() const
  {
    std::vector<CutLine> parts;
    std::map<std::pair<Index, Index>, bool> known;
    for (const CutLine& line : lines_) {
      const std::vector<Index> cuts = places_on(line);
      for (std::size_t k = 1; k < cuts.size(); ++k) {
        const CutLine part{cuts[k - 1], cuts[k], line.edge};
        const bool inside = line.edge >= 0 || holds(polygon_, between(places_[part.a], places_[part.b], 0.5));
        if (inside && known.try_emplace(std::minmax(part.a, part.b), true).second) parts.push_back(part);
      }
    }
    while (drop_loose_ends(parts)) {
    }
    return parts;
  }

  const std::vector<Vec<2>>& places() const { return places_; }

 private:
  Vec<2> onto_edge(Vec<2> x) const
  {
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      const Vec<2>&a = polygon_[k], &b = polygon_[(k + 1) % polygon_.size()];
      const Real t = projection(a, b, x);
      if (t > 0.0 && t < 1.0 && distance(between(a, b, t), x) <= tolerance_) return between(a, b, t);
    }
    return x;
  }

  Index place(Vec<2> x)
  {
    Index nearest = 0;
    for (Index i = 1; i < static_cast<Index>(places_.size()); ++i)
      if (distance(places_[i], x) < distance(places_[nearest], x)) nearest = i;
    if (distance(places_[nearest], x) <= tolerance_) return nearest;
    places_.push_back(x);
    return static_cast<Index>(places_.size()) - 1;
  }

  void add_crossing(const CutLine& first, const CutLine& second)
  {
    const Vec<2> a = places_[first.a], b = places_[first.b], c = places_[second.a], d = places_[second.b];
    Vec<2> x;
    if (!lines_cross(a, b, c, d, x)) return;
    if (first.edge >= 0 && second.edge >= 0)
      throw MeshError(fmt::format("the polygon crosses itself: edges {} and {} meet at x = {} m, y = {} m", first.edge,
          second.edge, coordinate_text(x[0]), coordinate_text(x[1])));
    place(x);
  }

  std::vector<Index> places_on(const CutLine& line) const
  {
    const Vec<2> a = places_[line.a], b = places_[line.b];
    std::vector<std::pair<Real, Index>> found{{0.0, line.a}, {1.0, line.b}};
    // On an edge of the polygon only what lies on it to round-off: it must not bend.
    const Real reach =
        line.edge >= 0 ? 1e-12 * (std::abs(a[0]) + std::abs(a[1]) + std::abs(b[0]) + std::abs(b[1])) : tolerance_;
    for (Index i = 0; i < static_cast<Index>(places_.size()); ++i) {
      const Real t = projection(a, b, places_[i]);
      if (i != line.a && i != line.b && t > 0.0 && t < 1.0 && distance(between(a, b, t), places_[i]) <= reach)
        found.emplace_back(t, i);
    }
    std::ranges::sort(found);
    std::vector<Index> order;
    for (const auto& [t, i] : found) order.push_back(i);
    return order;
  }

  bool drop_loose_ends(std::vector<CutLine>& parts) const
  {
    std::vector<int> uses(places_.size(), 0);
    for (const CutLine& part : parts) ++uses[part.a], ++uses[part.b];
    return std::erase_if(parts, [&](const CutLine& part) { return uses[part.a] == 1 || uses[part.b] == 1; }) > 0;
  }

  const Polygon& polygon_;
  Real tolerance_;
  std::vector<Vec<2>> places_;
  std::vector<CutLine> lines_;
};

/// A spike, or two edges at one place: nothing that can be meshed lies between them.
void check_overlap(const Polygon& polygon)
{
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t other = k + 1; other < n; ++other) {
      const Vec<2>&a = polygon[k], &b = polygon[(k + 1) % n], &c = polygon[other], &d = polygon[(other + 1) % n];
      const Real along = distance(a, b), reach = same_line * std::max(along, distance(c, d));
      if (std::max(std::abs(cross(a, b, c)), std::abs(cross(a, b, d))) > reach * along) continue;
      const auto [low, high] = std::minmax({projection(a, b, c), projection(a, b, d)});
      const Real from = std::max(low, Real{0.0}), to = std::min(high, Real{1.0});
      if ((to - from) * along <= reach) continue;
      throw MeshError(
          fmt::format("the polygon lies on itself: edges {} and {} share the line from {} to {} m\n"
                      "  Give the corners in order along the outline, without a spike.",
              k, other, place_text(between(a, b, from)), place_text(between(a, b, to))));
    }
}

/// Both directions of edge k are 2k and 2k + 1: from its first place to the second, and back.
class FaceWalk {
 public:
  FaceWalk(const std::vector<Vec<2>>& places, const std::vector<std::array<Index, 2>>& edges)
      : places_(places), edges_(edges), leaving_(places.size())
  {
    const Index n = 2 * static_cast<Index>(edges.size());
    for (Index half = 0; half < n; ++half) leaving_[from(half)].push_back(half);
    for (auto& halves : leaving_)
      std::ranges::sort(halves, {}, [&](Index half) {
        const Vec<2> a = places_[from(half)], b = places_[from(half ^ 1)];
        return std::atan2(b[1] - a[1], b[0] - a[0]);
      });
    ring_of_.assign(n, -1);
    for (Index start = 0; start < n; ++start)
      if (ring_of_[start] < 0) walk(start);
    part_.resize(places.size());
    std::iota(part_.begin(), part_.end(), Index{0});
    for (const auto& [a, b] : edges) part_[root(a)] = root(b);
  }

  PlanarFaces faces()
  {
    PlanarFaces found;
    found.rings.emplace_back();
    std::vector<Index> face_of_ring(rings_.size(), 0);
    std::vector<Polygon> corners;
    std::vector<Real> areas;
    for (const FaceRing& ring : rings_) {
      Polygon& outline = corners.emplace_back();
      for (const Index k : ring.places) outline.push_back(places_[k]);
      areas.push_back(area(outline));
    }
    for (std::size_t k = 0; k < rings_.size(); ++k)
      if (areas[k] > 0.0) {
        face_of_ring[k] = static_cast<Index>(found.rings.size());
        found.rings.push_back({rings_[k]});
      }
    for (std::size_t hole = 0; hole < rings_.size(); ++hole) {
      if (areas[hole] > 0.0) continue;
      std::size_t around = rings_.size();
      for (std::size_t k = 0; k < rings_.size(); ++k)
        if (areas[k] > 0.0 && part_of(k) != part_of(hole) && (around == rings_.size() || areas[k] < areas[around]) &&
            holds(corners[k], corners[hole][0]))
          around = k;
      if (around < rings_.size()) face_of_ring[hole] = face_of_ring[around];
      found.rings[face_of_ring[hole]].push_back(rings_[hole]);
    }
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      found.left.push_back(face_of_ring[ring_of_[2 * k]]);
      found.right.push_back(face_of_ring[ring_of_[2 * k + 1]]);
    }
    return found;
  }

 private:
  Index from(Index half) const { return edges_[half / 2][half % 2]; }

  /// The sharpest turn to the left: the one before the way back, counter-clockwise.
  Index next(Index half) const
  {
    const auto& halves = leaving_[from(half ^ 1)];
    const auto back = std::ranges::find(halves, half ^ 1) - halves.begin();
    return halves[(back + static_cast<Index>(halves.size()) - 1) % halves.size()];
  }

  void walk(Index start)
  {
    FaceRing ring;
    for (Index half = start; ring_of_[half] < 0; half = next(half)) {
      ring_of_[half] = static_cast<Index>(rings_.size());
      ring.places.push_back(from(half));
      ring.edges.push_back(half / 2);
    }
    rings_.push_back(std::move(ring));
  }

  Index root(Index k)
  {
    while (part_[k] != k) k = part_[k] = part_[part_[k]];
    return k;
  }
  Index part_of(std::size_t ring) { return root(rings_[ring].places[0]); }

  const std::vector<Vec<2>>& places_;
  const std::vector<std::array<Index, 2>>& edges_;
  std::vector<std::vector<Index>> leaving_;  ///< directions that leave a place, counter-clockwise
  std::vector<Index> ring_of_;
  std::vector<FaceRing> rings_;
  std::vector<Index> part_;  ///< connected part of the map that a place belongs to: another place of it, or itself
};

/// The rings of a face with the directions of their lines.
Face signed_lines(const PlanarMap& map, const std::vector<FaceRing>& rings)
{
  Face face;
  for (const FaceRing& ring : rings) {
    std::vector<Index>& loop = face.emplace_back();
    for (std::size_t k = 0; k < ring.edges.size(); ++k)
      loop.push_back(map.lines[ring.edges[k]].a == ring.places[k] ? ring.edges[k] + 1 : -(ring.edges[k] + 1));
  }
  return face;
}

}  // namespace

PlanarMap cut_polygon(const Polygon& polygon, const std::vector<Polygon>& follow, Real tolerance)
{
  check_overlap(polygon);
  Cutter cutter(polygon, tolerance);
  for (const Polygon& outline : follow) cutter.add_outline(outline);
  cutter.add_crossings();
  PlanarMap map{cutter.places(), cutter.split(), {}};
  std::vector<std::array<Index, 2>> ends;
  for (const CutLine& line : map.lines) ends.push_back({line.a, line.b});
  const PlanarFaces faces = find_faces(map.places, ends);
  for (std::size_t k = 1; k < faces.rings.size(); ++k) map.faces.push_back(signed_lines(map, faces.rings[k]));
  return map;
}

PlanarFaces find_faces(const std::vector<Vec<2>>& places, const std::vector<std::array<Index, 2>>& edges)
{
  return FaceWalk(places, edges).faces();
}

}  // namespace terp
