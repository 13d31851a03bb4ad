#include "import/dstability/section_pieces.hpp"

#include "import/dstability/soil_text.hpp"

#include <fmt/format.h>

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

}  // namespace terp
