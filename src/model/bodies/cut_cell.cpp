// A part of the lattice that no side crosses is whole or nothing, by the body at its middle. A part that is cut is
// shared out exactly, and each piece stands at its centroid. Pieces within round-off of the whole become whole again.
// Then the smallest sliver is merged into the nearest piece that it sees. The taker grows and moves, so the order from
// small to large is part of the result.

#include "model/bodies/cut_cell.hpp"

#include <cmath>
#include <cstdlib>

namespace terp {
namespace {

/// Share of a part of the lattice that is taken for nothing, or for all where as much is missing: outlines that follow
/// the mesh but for the round-off of coordinates far from the origin.
constexpr Real round_off_share = 1e-9;

bool is_cut(const Overlay& overlay, const std::array<Vec<2>, 4>& corners)
{
  const BoundingBox box = box_around(corners);
  for (const Ring& ring : overlay.rings)
    for (std::size_t k = 0; k < ring.corners.size(); ++k)
      if (crosses(box, ring.corners[k], ring.corners[(k + 1) % ring.corners.size()])) return true;
  return false;
}

void add_pieces(
    const Lattice& lattice, const Overlay& overlay, Index body, std::array<Index, 2> part, std::vector<Piece>& pieces)
{
  const Vec<2> middle = Quad4::offset_from_centre(lattice.cell.map, middle_of_part(lattice, part));
  const Real whole_volume = volume_of_part(lattice, part);
  const Piece whole{part, middle, whole_volume, whole_volume, true};
  const auto corners = corners_of_part(lattice, part);
  if (!is_cut(overlay, corners)) {
    if (top_body(overlay, whole.x) == body) pieces.push_back(whole);
    return;
  }
  for (const Part& found : share_out(overlay, corners)) {
    if (found.body != body || found.area < round_off_share * whole_volume) continue;
    const bool is_whole = found.area > (1.0 - round_off_share) * whole_volume;
    pieces.push_back(is_whole ? whole : Piece{part, found.centroid, found.area, whole_volume, false});
  }
}

bool is_too_small(const Piece& piece) { return !piece.is_whole && piece.volume < smallest_share * piece.whole_volume; }

Vec<2> common_centroid(const Piece& a, const Piece& b)
{
  const Real t = b.volume / (a.volume + b.volume);
  return {a.x[0] + t * (b.x[0] - a.x[0]), a.x[1] + t * (b.x[1] - a.x[1])};
}

/// The nearest piece in the same or an adjoining part of the lattice that lies within sight: their common centroid is
/// then in the body.
std::size_t find_taker(const Overlay& overlay, Index body, const std::vector<Piece>& pieces, std::size_t small)
{
  std::size_t best = pieces.size();
  Real least = std::numeric_limits<Real>::infinity();
  const Piece& piece = pieces[small];
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const bool adjoin =
        std::abs(pieces[k].part[0] - piece.part[0]) <= 1 && std::abs(pieces[k].part[1] - piece.part[1]) <= 1;
    const Real distance = std::hypot(pieces[k].x[0] - piece.x[0], pieces[k].x[1] - piece.x[1]);
    if (k == small || !adjoin || distance >= least || !stays_in_body(overlay, body, piece.x, pieces[k].x)) continue;
    best = k;
    least = distance;
  }
  return best;
}

void merge_small_pieces(const Overlay& overlay, Index body, std::vector<Piece>& pieces)
{
  while (true) {
    std::size_t small = pieces.size();
    for (std::size_t k = 0; k < pieces.size(); ++k)
      if (is_too_small(pieces[k]) && !pieces[k].stays_alone &&
          (small == pieces.size() || pieces[k].volume < pieces[small].volume))
        small = k;
    if (small == pieces.size()) return;
    const std::size_t taker = find_taker(overlay, body, pieces, small);
    if (taker == pieces.size()) {
      pieces[small].stays_alone = true;
      continue;
    }
    pieces[taker].x = common_centroid(pieces[taker], pieces[small]);
    pieces[taker].volume += pieces[small].volume;
    pieces[taker].is_whole = false;
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(small));
  }
}

}  // namespace

std::array<Vec<2>, 4> corners_of_part(const Lattice& lattice, std::array<Index, 2> part)
{
  std::array<Vec<2>, 4> corners;
  for (int k = 0; k < 4; ++k) {
    const Index column = part[0] + (k == 1 || k == 2), row = part[1] + (k == 2 || k == 3);
    const Vec<2> local{2.0 * column / lattice.n[0] - 1.0, 2.0 * row / lattice.n[1] - 1.0};
    corners[k] = Quad4::offset_from_centre(lattice.cell.map, local);
  }
  return corners;
}

Vec<2> middle_of_part(const Lattice& lattice, std::array<Index, 2> part)
{
  return {(2.0 * part[0] + 1.0) / lattice.n[0] - 1.0, (2.0 * part[1] + 1.0) / lattice.n[1] - 1.0};
}

Real volume_of_part(const Lattice& lattice, std::array<Index, 2> part)
{
  const auto j = Quad4::jacobian(lattice.cell.map, middle_of_part(lattice, part));
  return 4.0 / (static_cast<Real>(lattice.n[0]) * lattice.n[1]) * Quad4::determinant(j);
}

std::vector<Piece> cut_cell(const Lattice& lattice, const Overlay& overlay, Index body)
{
  std::vector<Piece> pieces;
  for (Index row = 0; row < lattice.n[1]; ++row)
    for (Index column = 0; column < lattice.n[0]; ++column) add_pieces(lattice, overlay, body, {column, row}, pieces);
  merge_small_pieces(overlay, body, pieces);
  return pieces;
}

}  // namespace terp
