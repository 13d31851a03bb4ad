// What speaks against an imported section: sentences that name layers, for the terminal, the report and the case.
// Not for: what was assumed or moved without doubt (folder_report.hpp), the side of the river (river_side.hpp).
#pragma once

#include "dstability/case_text.hpp"
#include "dstability/preload.hpp"
#include "dstability/sentence.hpp"

#include <string>
#include <vector>

namespace terp {

/// What the reader said of the stages up to this one, and of members that they may be made of.
std::vector<std::string> doubts_of_reading(const StixProject& project, std::size_t scenario, std::size_t stage);

/// A stage without water; has_shansep: earlier ones count, too, as strengths remember what they carried.
std::vector<std::string> doubts_of_water(const StixScenario& scenario, std::size_t stage, bool has_shansep);

/// Points of the embankment of the last stage that lie outside of the ground, or in an order that no dike has.
std::vector<std::string> doubts_of_embankment(const StixSection& section);

/// Weights of water and soils, and loads of the last stage, that are hardly meant: most likely of another unit.
std::vector<std::string> doubts_of_numbers(const StixSection& section);

/// Pieces of SHANSEP soil that no state of any stage gives a POP: one sentence for each layer.
std::vector<std::string> doubts_of_preload(
    const StixSection& section, const std::vector<LayerPiece>& pieces, Real cell);

/// Places where layers are missing or lie in each other, larger than a tenth of a cell, and what was put below a base
/// that is not level, if it is thicker than a cell anywhere.
std::vector<std::string> doubts_of_outlines(
    const CleanSection& clean, const std::vector<DrawnRegion>& drawn, const std::vector<CleanRegion>& fills, Real cell);

/// [reference] with the doubts, which each command then repeats, and with what was assumed, which the page shows.
CaseTableText doubts_table(const std::vector<std::string>& doubts, const std::vector<Sentence>& assumed);

}  // namespace terp
