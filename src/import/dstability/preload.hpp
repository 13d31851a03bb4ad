// How the yield stress of a SHANSEP soil is said in a case: as one POP, or on a grid. docs/dstability.md.
// Not for: the yield stress at a place (section.hpp), the text of a material (soil_text.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/drawing/clean_regions.hpp"
#include "import/dstability/section.hpp"

#include <optional>
#include <string>
#include <vector>

namespace terp {

struct LayerPiece {
  const CleanRegion* region;
  std::size_t layer;  ///< number in StixStage::layers of the analysed stage
};

/// True if all stages up to this one have the same outlines, soils and excavations.
bool same_outlines_until(const StixScenario& scenario, std::size_t stage);

/// The same, and no loads before it. Then the first stage of the case is that of the file.
bool same_ground_until(const StixScenario& scenario, std::size_t stage);

/// The one number that the yield stress of the stage exceeds the effective stress of the first one by [Pa]; none where
/// it varies by more than 0.1 kPa, or loads stand over all of the piece. What lies under a load does not count:
/// undrained soil of a case gains no strength from it.
std::optional<Real> constant_pop(const StixSection& now, const StixSection& first, const LayerPiece& piece, Real cell);

/// What makes the yield stress of a layer its own: POP of each stage, or, where that varies in it, the layer. Pieces
/// with one text may share a grid.
std::string pop_history(const StixSection& now, const LayerPiece& piece, Real cell);

struct YieldGrid {
  std::string csv;       ///< x,y,value: m, Pa; every x with every y
  Real deviation = 0.0;  ///< largest difference from the file's yield stress in the pieces, bilinear [Pa]
};

/// Yield stresses of pieces of layers with one history. Beyond the pieces they go on as at their edge, so that no other
/// layer has a share in them. At least 1 kPa. less: a POP that the case adds to them [Pa].
YieldGrid yield_grid(const StixSection& now, const std::vector<LayerPiece>& pieces, Real cell, Real less = 0.0);
/// How near it is to the file; soil: its name in the case.
Sentence sentence_on(const YieldGrid& grid, const std::string& soil);

}  // namespace terp
