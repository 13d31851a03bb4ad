// The water of a case on the drawing of its section: phreatic lines, free water, heads, reference lines.
// Not for: bodies, sides, legend of the soils (section_svg.cpp).
#pragma once

#include "io/files/section_canvas.hpp"
#include "model/parts/model.hpp"
#include "model/water/water_pressure.hpp"

#include <functional>

namespace terp {

class SectionWater : protected SectionCanvas {
 public:
  explicit SectionWater(const Model& model) : SectionCanvas(*model.mesh), model_(model) {}

 protected:
  /// Draws the phreatic line at t = 0, free water down to the ground, and reference lines.
  void first_water();
  /// Draws the heads of the layers at t = 0, the lines of the other situations, and the level of [flood].
  void heads_and_later_water();
  /// All of the section below the phreatic line of the start, as a path.
  std::string below_water() const;
  /// Calls entry(sample, words) for each kind of line that is drawn; heads_and_later: these too.
  void water_legend(
      bool heads_and_later, const std::function<void(const std::string&, const std::string&)>& entry) const;

  const Model& model_;

 private:
  std::vector<Vec<2>> table_of(const WaterSituation& of) const
  {
    return water_table(model_.description.water, of, low_, high_);
  }
  std::string over_section(const std::vector<Vec<2>>& line) const;
  void heads(const WaterSituation& of, bool is_first);
  /// Names a line at an end of the section, once all lines are drawn.
  void name_line(bool at_right, Real y, std::string words, const char* colour);
  void put_names();

  struct Name {
    bool at_right;
    Real y;  ///< [px]
    std::string words;
    const char* colour;
  };
  std::vector<Name> names_;
};

}  // namespace terp
