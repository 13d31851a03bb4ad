// The section of a case as a drawing: mesh, bodies by material, conditions of the sides, named points, footings.
// Not for: results of a run (the report page, python/terp).
#pragma once

#include "model/bodies/body_outline.hpp"
#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <string>
#include <vector>

namespace terp {

/// What a result adds to the section. Without words for the subtitle there is none.
struct SectionOverlay {
  struct Shade {
    Vec<2> x{0.0, 0.0};
    Real size = 0.0;   ///< side of the square [m]
    Real value = 0.0;  ///< 0: not shown, to 1: full colour
  };
  struct Arrow {
    Vec<2> from{0.0, 0.0}, along{0.0, 0.0};  ///< [m]
  };
  struct Curves {
    std::vector<Side> pieces = {};
    std::string colour = {}, words = {};  ///< of them and for the legend
  };
  std::string subtitle;
  std::vector<Curves> curves = {};
  std::vector<Shade> shades;
  std::vector<Arrow> arrows;
  std::vector<Vec<2>> line;                   ///< [m]
  std::string of_shades, of_arrows, of_line;  ///< words of the legend
};

/// SVG text of the model before its first step; lengths in metres beside the axes. With an overlay that has a subtitle:
/// without the lines of the cells, the named points and the words along the sides.
std::string draw_section(const Model& model, const State& state, const SectionOverlay& overlay = {});

}  // namespace terp
