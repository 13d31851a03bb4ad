// The film at the top of an aquifer: where water pushes from below, soil slides in the upper centimetres of the drained
// soil, whose effective stress is nearly nothing there. A row of cells carries more than its top. So one row gets the
// strength of the border (docs/dstability.md, "The film"). Not for: the case that it becomes part of (case_folder.hpp).
#pragma once

#include "math/sentence.hpp"
#include "import/dstability/soil_text.hpp"

namespace terp {

/// A stretch of a border with drained soil below and another soil above.
struct Film {
  std::size_t layer = 0;         ///< below the border, number in StixStage::layers
  Polygon outline;               ///< from the border to a row of cells below it, or to the end of the layer [m]
  std::vector<Vec<2>> friction;  ///< over x: tan of the friction angle that gives the row the strength of its top [-]
  Real least = 0.0, most = 0.0;  ///< strength of the border [Pa]
  Real carried_more = 0.0;       ///< what the row would carry more than its top without the film [N per m]
  Vec<2> weakest{0.0, 0.0};      ///< place on the border with the least effective stress [m]
};

/// Films between two x, for rows of this height [m]: where the effective stress on the border is less than that of five
/// rows of the soil below, in this stage or in the first, and water pushes from below. From left to right.
std::vector<Film> films_of(const StixSection& now, const StixSection& first, Vec<2> between, Real row);

/// A base less than a row above `low`, from which a row of cells begins on the border of the weakest film [m]; none: it
/// does so from `low`, or the film lies no row above it.
std::optional<Real> base_with_row_at(const std::vector<Film>& films, Real low, Real row);

/// Films end at the base [m]; one that lies on it or below is left out.
void cut_at(std::vector<Film>& films, Real base);

/// Two x [m] moved apart until 20 m of the section lie beyond ground that lifts, with less than 1 kPa of effective
/// stress on such a border; not at the end of the river, "left" or "right".
Vec<2> with_uplift(const StixSection& section, const std::string& river, Vec<2> between);

/// The soil of a film, from the text of the soil that it is of. csv: name of the file of its friction angles.
SoilText film_text(SoilText of_soil, const std::string& name, const std::string& csv);
/// Friction angles of a film as a table x,y,value [m, degrees].
std::string film_csv(const Film& film);
/// What is assumed of it. soil: name of the layer below; row: height of a row [m].
Sentence film_sentence(const Film& film, const std::string& soil, Real row);

}  // namespace terp
