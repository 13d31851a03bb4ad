// What speaks against an imported section: sentences that name layers, for the terminal, the report and the case.
// Not for: what was assumed or moved without doubt (folder_report.hpp), the side of the river (river_side.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/dstability/case_text.hpp"
#include "import/dstability/preload.hpp"
#include "import/dstability/section_layout.hpp"

#include <string>
#include <vector>

namespace terp {

/// What the reader said of the stages up to this one, and of members that they may be made of.
std::vector<Sentence> doubts_of_reading(const StixProject& project, std::size_t scenario, std::size_t stage);

/// A stage without water; has_shansep: earlier ones count, too, as strengths remember what they carried.
std::vector<Sentence> doubts_of_water(const StixScenario& scenario, std::size_t stage, bool has_shansep);

/// A phreatic line below all soil, or far below the ground: most likely of another datum. Of the last stage, and of
/// those before it if has_shansep. height: of the dike [m].
std::vector<Sentence> doubts_of_datum(const StixSection& section, bool has_shansep, Real height);

/// Points of the embankment of the last stage that lie outside of the ground, in an order that no dike has, or on the
/// wrong side of the crest. river: the end that it is at, "left" or "right"; empty: not known.
std::vector<Sentence> doubts_of_embankment(
    const StixSection& section, const std::string& river, const SectionLayout& layout);

/// Weights of water and soils, and loads of the last stage, that are hardly meant: most likely of another unit.
std::vector<Sentence> doubts_of_numbers(const StixSection& section);

/// Pieces of SHANSEP soil that no state of any stage gives a POP, or only a state line that does not touch them: one
/// sentence for each layer.
std::vector<Sentence> doubts_of_preload(const StixSection& section, const std::vector<LayerPiece>& pieces, Real cell);

/// Places where layers are missing or lie in each other, larger than a tenth of a cell, and what was put below a base
/// that is not level, if it is thicker than a cell anywhere.
std::vector<Sentence> doubts_of_outlines(
    const CleanSection& clean, const std::vector<DrawnRegion>& drawn, const std::vector<CleanRegion>& fills, Real cell);

/// [reference] with the doubts, which each command then repeats, with what was assumed, which the page shows, and with
/// the file of the case as it was imported, if it has a name.
CaseTableText doubts_table(
    const std::vector<Sentence>& doubts, const std::vector<Sentence>& assumed, const std::string& imported = "");

}  // namespace terp
