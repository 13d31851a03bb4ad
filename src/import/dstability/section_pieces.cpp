#include "import/dstability/section_pieces.hpp"

#include "math/plane.hpp"
#include "import/dstability/soil_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace terp {
namespace {

const StixSoil& soil_of(const PieceSources& from, const SectionPiece& piece)
{
  return from.now.project().soils[piece.soil];
}

void add_pieces(
    const PieceSources& from, const CleanRegion& region, std::vector<SectionPiece>& pieces, Real& left_there)
{
  const std::size_t soil = *from.now.stage().layers[from.layers[region.drawn]].soil;
  if (same_above_and_below(from.now.project().soils[soil]))
    pieces.push_back({region, soil, 0});
  else if (from.phreatic.empty())
    pieces.push_back({region, soil, 2});
  else
    for (CutRegion& cut : cut_along(region, from.phreatic, 0.05 * from.layout.cell, left_there))
      pieces.push_back({std::move(cut.region), soil, cut.above ? 2 : 1});
}

bool is_near_ground(const PieceSources& from, const Polygon& outline)
{
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec<2> a = outline[k], b = outline[(k + 1) % outline.size()];
    const int n = static_cast<int>(std::ceil(distance(a, b) / from.layout.cell)) + 1;
    for (int i = 0; i < n; ++i) {
      const Real part = static_cast<Real>(i) / n, z = std::lerp(a[1], b[1], part);
      if (from.now.column(std::lerp(a[0], b[0], part)).ground() - z < face_depth) return true;
    }
  }
  return false;
}

/// Soil that ravels on a slope is cut at the level of the toe: what lies above it is a face.
std::vector<SectionPiece> with_faces(const PieceSources& from, std::vector<SectionPiece> pieces)
{
  if (!from.toe) return pieces;
  std::vector<SectionPiece> all;
  Real slivers = 0.0;
  for (SectionPiece& piece : pieces) {
    const StixSoil& soil = soil_of(from, piece);
    const auto [cohesion, friction] =
        drained_strength(soil, piece.zone == 2 ? soil.above : soil.below, from.now.basis());
    if (!(cohesion < from.face_cohesion) || !(friction > 0.0)) {
      all.push_back(std::move(piece));
      continue;
    }
    for (CutRegion& cut : cut_along(piece.region, {{0.0, *from.toe}}, 0.05 * from.layout.cell, slivers)) {
      all.push_back({std::move(cut.region), piece.soil, piece.zone});
      all.back().is_face = cut.above && is_near_ground(from, all.back().region.polygon);
    }
  }
  return all;
}

void set_preload(const PieceSources& from, SectionPiece& piece)
{
  if (!is_shansep(soil_of(from, piece), piece.zone)) return;
  const LayerPiece layer{&piece.region, from.layers[piece.region.drawn]};
  if (same_ground_until(from.scenario, from.now.history().size() - 1))
    piece.pop = constant_pop(from.now, from.first, layer, from.layout.cell);
  if (!piece.pop) piece.history = pop_history(from.now, layer, from.layout.cell);
}

}  // namespace

SectionPieces pieces_of(const PieceSources& from)
{
  SectionPieces made;
  Real left_there = 0.0, filled = 0.0;
  for (const CleanRegion& region : from.clean.regions) add_pieces(from, region, made.of_file, left_there);
  made.of_file = with_faces(from, std::move(made.of_file));
  for (const CleanRegion& region : base_fill(from.layout, from.clean.regions)) {
    add_pieces(from, region, made.below_base, left_there);
    filled += signed_area(region.polygon);
  }
  for (std::vector<SectionPiece>* pieces : {&made.of_file, &made.below_base})
    for (SectionPiece& piece : *pieces) set_preload(from, piece);
  if (left_there > 0.0)
    made.geometry.push_back(
        fmt::format("{:.3g} m2 in slivers along the phreatic line count with the soil on its other side.", left_there));
  if (!from.phreatic.empty())
    made.geometry.push_back(
        "Soils that differ above and below the phreatic line are cut along the line of the analysed stage. They stay "
        "as they are if you change the line in the case.");
  if (!made.below_base.empty())
    made.geometry.push_back(
        fmt::format("The base of the section is not level: {:.3f} m2 below it, down to {:.2f} m, were filled with the "
                    "soil above (first bodies: {}).",
            filled, from.layout.low[1], made.below_base.size()));
  return made;
}

Real largest_stress(
    const StixSection& section, const std::vector<SectionPiece>& pieces, const SectionPiece& piece, Real step)
{
  const StixSoil& soil = section.project().soils[piece.soil];
  if ((piece.zone == 2 ? soil.above : soil.below) != StixStrengthModel::sigma_tau_table) return 0.0;
  Real largest = 0.0;
  for (const SectionPiece& other : pieces)
    if (other.soil == piece.soil && other.zone == piece.zone)
      for (const Vec<2>& place : places_in(other.region, step))
        if (const auto at = section.at(place)) largest = std::max(largest, at->effective_stress);
  return largest;
}

}  // namespace terp
