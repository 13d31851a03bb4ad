// Which outlines lie around a face follows from parity: to cross an edge is to enter or leave the outlines along it.
// The walk begins at face 0, outside of all. Joining moves lines, so the areas that regions shall have are corrected by
// those of the outlines as drawn. Simplified boundaries are accepted only if their faces give the regions back.
// Otherwise the joined ones are taken, with balanced areas, and if that fails too, without.

#include "import/drawing/clean_regions.hpp"

#include "math/errors.hpp"
#include "math/plane.hpp"
#include "model/bodies/body_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace terp {
namespace {

constexpr Real grid = 1e-3;  // [m]: files have coordinates in mm

Real perimeter(const PlanarGraph& graph, const std::vector<FaceRing>& rings)
{
  Real sum = 0.0;
  for (const FaceRing& ring : rings)
    for (std::size_t k = 0; k < ring.places.size(); ++k)
      sum += distance(graph.places[ring.places[k]], graph.places[ring.places[(k + 1) % ring.places.size()]]);
  return sum;
}

std::vector<Problem> problems_of_outlines(const std::vector<DrawnRegion>& drawn)
{
  std::vector<Problem> problems;
  for (const DrawnRegion& region : drawn)
    for (const std::string& text : check_outline({region.polygon, {1, 1}}))
      problems.push_back({region.name, "this outline is no layer", text + ". Correct it in the drawing.", ""});
  return problems;
}

void check_drawn(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations)
{
  std::vector<Problem> problems = problems_of_outlines(drawn);
  for (const DrawnExcavation& line : excavations)
    if (line.places.size() < 2)
      problems.push_back({line.name, "this excavation is no line",
          fmt::format("It has {} places; it needs at least 2.", line.places.size()), ""});
  if (drawn.empty()) problems.push_back({"", "the drawing has no layer", "A section needs at least one outline.", ""});
  if (!problems.empty()) throw InputError(std::move(problems));
}

/// Outlines as they are, excavations closed high above them.
std::vector<DrawnLine> lines_of(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations)
{
  std::vector<DrawnLine> lines;
  Real top = drawn[0].polygon[0][1], bottom = top;
  for (const DrawnRegion& region : drawn) {
    lines.push_back({region.polygon, true, static_cast<int>(lines.size())});
    for (const Vec<2>& x : region.polygon) top = std::max(top, x[1]), bottom = std::min(bottom, x[1]);
  }
  for (const DrawnExcavation& line : excavations) {
    DrawnLine pit{line.places, true, static_cast<int>(lines.size())};
    for (const Vec<2>& x : line.places) top = std::max(top, x[1]);
    const Real above = top + (top - bottom) + 1.0;
    pit.places.push_back({line.places.back()[0], above});
    pit.places.push_back({line.places.front()[0], above});
    lines.push_back(std::move(pit));
  }
  return lines;
}

class Assignment {
 public:
  Assignment(const std::vector<DrawnRegion>& drawn, const PlanarGraph& graph, const PlanarFaces& faces)
      : n_(static_cast<int>(drawn.size())), graph_(graph), faces_(faces), owners_(faces.rings.size())
  {
    for (const DrawnRegion& region : drawn) outline_areas_.push_back(std::abs(signed_area(region.polygon)));
    for (const auto& rings : faces.rings) face_areas_.push_back(area_of_face(graph, rings));
    find_owners();
  }

  /// By face, -1: none. Faults and dug soil go to the section.
  std::vector<int> assign(Real thin, CleanSection& section)
  {
    std::vector<int> region(owners_.size(), -1);
    for (std::size_t face = 1; face < owners_.size(); ++face) {
      region[face] = winner(owners_[face]);
      if (region[face] >= 0 && owners_[face].back() >= n_) {
        section.dug_area += face_areas_[face];
        region[face] = -1;
      }
    }
    fill_gaps(thin, region, section);
    note_overlaps(region, section);
    return region;
  }

  /// Area that each region shall have: that of its faces, corrected by what joining the lines did to its outline.
  std::vector<Real> areas_asked(const std::vector<int>& region) const
  {
    std::vector<Real> asked(n_, 0.0), joined(n_, 0.0);
    for (std::size_t face = 1; face < owners_.size(); ++face) {
      if (region[face] >= 0) asked[region[face]] += face_areas_[face];
      for (const int owner : owners_[face])
        if (owner < n_) joined[owner] += face_areas_[face];
    }
    for (int k = 0; k < n_; ++k) {
      const Real change = outline_areas_[k] - joined[k];
      asked[k] += change;
      if (const int around = region_around(k); around >= 0) asked[around] -= change;
    }
    return asked;
  }

 private:
  /// From face to face: an edge that an outline runs along parts its inside from its outside.
  void find_owners()
  {
    std::vector<std::vector<Index>> edges_of(owners_.size());
    for (std::size_t k = 0; k < graph_.edges.size(); ++k) {
      edges_of[faces_.left[k]].push_back(static_cast<Index>(k));
      edges_of[faces_.right[k]].push_back(static_cast<Index>(k));
    }
    std::vector<char> known(owners_.size(), 0);
    std::deque<Index> next{0};
    known[0] = 1;
    for (; !next.empty(); next.pop_front())
      for (const Index k : edges_of[next.front()]) {
        const Index other = faces_.left[k] == next.front() ? faces_.right[k] : faces_.left[k];
        if (known[other]) continue;
        known[other] = 1;
        std::ranges::set_symmetric_difference(
            owners_[next.front()], graph_.edges[k].owners, std::back_inserter(owners_[other]));
        next.push_back(other);
      }
  }

  /// The smallest of the outlines around a face; of equal ones the last.
  int winner(const std::vector<int>& owners) const
  {
    int best = -1;
    for (const int k : owners)
      if (k < n_ && (best < 0 || outline_areas_[k] <= outline_areas_[best])) best = k;
    return best;
  }

  void fill_gaps(Real thin, std::vector<int>& region, CleanSection& section)
  {
    for (std::size_t face = 1; face < owners_.size(); ++face) {
      if (!owners_[face].empty()) continue;
      std::vector<Real> shared(n_, 0.0);
      for (std::size_t k = 0; k < graph_.edges.size(); ++k) {
        const bool is_left = faces_.left[k] == static_cast<Index>(face);
        if (!is_left && faces_.right[k] != static_cast<Index>(face)) continue;
        const int other = region[is_left ? faces_.right[k] : faces_.left[k]];
        if (other >= 0) shared[other] += distance(graph_.places[graph_.edges[k].a], graph_.places[graph_.edges[k].b]);
      }
      const auto most = std::ranges::max_element(shared);
      const bool is_thin = 2.0 * face_areas_[face] <= thin * perimeter(graph_, faces_.rings[face]);
      DrawingFault gap{graph_.places[faces_.rings[face][0].places[0]], face_areas_[face], {}};
      if (is_thin && *most > 0.0) {
        region[face] = static_cast<int>(most - shared.begin());
        gap.drawn.push_back(region[face]);
      }
      section.gaps.push_back(gap);
    }
  }

  void note_overlaps(const std::vector<int>& region, CleanSection& section) const
  {
    for (std::size_t face = 1; face < owners_.size(); ++face) {
      if (owners_[face].size() < 2 || region[face] < 0) continue;
      const int top = region[face];
      const bool lies_in_all = std::ranges::all_of(owners_[face], [&](int k) { return k == top || lies_in(top, k); });
      if (!lies_in_all)
        section.overlaps.push_back({graph_.places[faces_.rings[face][0].places[0]], face_areas_[face], owners_[face]});
    }
  }

  bool lies_in(int inner, int outer) const
  {
    for (std::size_t face = 1; face < owners_.size(); ++face)
      if (std::ranges::binary_search(owners_[face], inner) && !std::ranges::binary_search(owners_[face], outer))
        return false;
    return true;
  }

  /// The smallest region that a region lies in, or -1.
  int region_around(int inner) const
  {
    int best = -1;
    for (int k = 0; k < n_; ++k)
      if (k != inner && outline_areas_[k] > outline_areas_[inner] && lies_in(inner, k) &&
          (best < 0 || outline_areas_[k] < outline_areas_[best]))
        best = k;
    return best;
  }

  int n_;
  const PlanarGraph& graph_;
  const PlanarFaces& faces_;
  std::vector<std::vector<int>> owners_;  ///< by face, ascending; excavations after the regions
  std::vector<Real> outline_areas_, face_areas_;
};

/// A region that lies in a hole of another one comes after it; otherwise in the order of the drawing.
void put_in_order(std::vector<CleanRegion>& regions)
{
  const auto size = [](const CleanRegion& region) { return signed_area(region.polygon); };
  std::ranges::stable_sort(regions, [&](const CleanRegion& a, const CleanRegion& b) { return a.drawn < b.drawn; });
  for (std::size_t k = 0; k < regions.size(); ++k)
    for (std::size_t inner = 0; inner < k; ++inner)
      if (!regions[k].holes.empty() && size(regions[inner]) < size(regions[k]) &&
          contains(regions[k].polygon, regions[inner].polygon[0])) {
        std::rotate(regions.begin() + static_cast<std::ptrdiff_t>(inner),
            regions.begin() + static_cast<std::ptrdiff_t>(k), regions.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        break;
      }
}

Real area_of(const CleanRegion& region)
{
  Real sum = signed_area(region.polygon);
  for (const Polygon& hole : region.holes) sum += signed_area(hole);
  return sum;
}

}  // namespace

std::optional<std::vector<CleanRegion>> regions_between(const ChainMap& map)
{
  const PlanarGraph graph = graph_of(map);
  if (!lines_are_apart(graph)) return std::nullopt;
  const PlanarFaces faces = find_faces(graph);
  const std::optional<std::vector<int>> region = regions_by_edges(graph, faces);
  if (!region) return std::nullopt;
  std::vector<CleanRegion> regions;
  for (std::size_t face = 1; face < faces.rings.size(); ++face) {
    if ((*region)[face] < 0) continue;
    CleanRegion& piece = regions.emplace_back(CleanRegion{(*region)[face], {}, {}});
    for (const FaceRing& ring : faces.rings[face]) piece.holes.push_back(corners_of(graph, ring));
    piece.polygon = std::move(piece.holes.front());
    piece.holes.erase(piece.holes.begin());
  }
  return regions;
}

void check_outlines(const std::vector<DrawnRegion>& drawn)
{
  if (std::vector<Problem> problems = problems_of_outlines(drawn); !problems.empty())
    throw InputError(std::move(problems));
}

CleanSection clean_regions(const std::vector<DrawnRegion>& drawn, const std::vector<DrawnExcavation>& excavations,
    const CleaningOptions& options)
{
  check_drawn(drawn, excavations);
  CleanSection section;
  const PlanarGraph graph = join_lines(lines_of(drawn, excavations), options.snap);
  section.snaps = graph.counts;
  const PlanarFaces faces = find_faces(graph);
  Assignment assignment(drawn, graph, faces);
  const std::vector<int> region = assignment.assign(options.shortest_edge, section);
  const std::vector<Real> asked = assignment.areas_asked(region);
  const ChainMap joined = find_chains(graph, faces, region, edge_reach * options.snap);
  for (const bool simpler : {true, false}) {
    ChainMap map = joined;
    section.simplified = {};
    if (simpler && options.tolerance > 0.0)
      simplify(map, {options.shortest_edge, options.tolerance, grid}, section.simplified);
    balance_areas(map, asked, std::max(options.tolerance, options.snap), section.simplified);
    auto regions = regions_between(map);
    if (!regions && !simpler) regions = regions_between(joined);
    if (!regions && !simpler) throw std::logic_error("the regions of a drawing overlap");
    if (!regions) continue;
    section.regions = std::move(*regions);
    break;
  }
  put_in_order(section.regions);
  for (const DrawnRegion& r : drawn) section.corners_drawn += static_cast<Index>(r.polygon.size());
  for (std::size_t k = 0; k < drawn.size(); ++k) section.changes.push_back({asked[k], 0.0, 0});
  for (const CleanRegion& r : section.regions) {
    section.changes[r.drawn].area += area_of(r);
    ++section.changes[r.drawn].pieces;
    section.corners += static_cast<Index>(r.polygon.size());
    for (const Polygon& hole : r.holes) section.corners += static_cast<Index>(hole.size());
  }
  return section;
}

std::vector<std::string> describe(
    const CleanSection& section, const std::vector<DrawnRegion>& drawn, const CleaningOptions& options)
{
  std::vector<std::string> lines;
  const auto names = [&](const std::vector<int>& all) {
    std::string text;
    for (const int k : all)
      if (k < static_cast<int>(drawn.size())) text += (text.empty() ? "" : ", ") + drawn[k].name;
    return text;
  };
  lines.push_back(fmt::format("{} corners were drawn, {} remain. Boundaries lie within {:.3f} m of the drawn ones.",
      section.corners_drawn, section.corners,
      section.snaps.largest + section.simplified.largest + section.simplified.area_move));
  if (const SnapCounts& s = section.snaps; s.merged + s.joined + s.crossings > 0)
    lines.push_back(
        fmt::format("Joined within {:.2g} m: {} corners with others, {} edges with corners beside them; {} "
                    "crossings of edges became corners.",
            options.snap, s.merged, s.joined, s.crossings));
  if (section.simplified.removed + section.simplified.merged > 0)
    lines.push_back(fmt::format(
        "Taken out: {} corners, and {} junctions that stood closer than {:g} m. Each layer "
        "keeps its area: for that one corner of a boundary moved by up to {:.1g} m.",
        section.simplified.removed, section.simplified.merged, options.shortest_edge, section.simplified.area_move));
  if (section.dug_area > 0.0)
    lines.push_back(fmt::format("Excavations take away {:.3f} m2 of soil.", section.dug_area));
  for (const DrawingFault& gap : section.gaps)
    lines.push_back(fmt::format("A gap of {:.3g} m2 at {:.3f}, {:.3f} m {}.", gap.area, gap.x[0], gap.x[1],
        gap.drawn.empty() ? "stays empty" : "was filled with " + names(gap.drawn)));
  for (const DrawingFault& both : section.overlaps)
    lines.push_back(
        fmt::format("{} overlap by {:.3g} m2 at {:.3f}, {:.3f} m: the one with the smaller outline is "
                    "there.",
            names(both.drawn), both.area, both.x[0], both.x[1]));
  for (std::size_t k = 0; k < drawn.size(); ++k)
    if (const RegionChange& c = section.changes[k]; c.pieces == 0)
      lines.push_back(fmt::format("Nothing is left of {}: others lie over all of it, or it is thinner than {:.2g} m.",
          drawn[k].name, options.snap));
    else if (std::abs(c.area - c.drawn_area) > 1e-9 * c.drawn_area)
      lines.push_back(fmt::format("{} has {:.9g} m2, its outline {:.9g} m2.", drawn[k].name, c.area, c.drawn_area));
  return lines;
}

}  // namespace terp
