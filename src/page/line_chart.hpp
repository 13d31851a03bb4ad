// A chart of lines as inline SVG that can be read in print: lines differ in dashes and marks, not in colour alone.
// Not for: the charts of the report page, which web/ draws.
#pragma once

#include "math/types.hpp"

#include <string>
#include <vector>

namespace terp {

struct ChartLine {
  std::string name;                 ///< in the legend; empty: none
  std::vector<Vec<2>> points = {};  ///< in the units of the axes; a point that is not finite interrupts the line
  std::size_t style = 0;            ///< number of its colour and its mark
  int dashes = 0;                   ///< 0: a full line; 1, 2, ...: dashes, shorter and shorter
  bool marks = false;               ///< at each point
};

/// A value with the range in which it lies, upright beside the lines.
struct ChartBar {
  Vec<2> at;
  Real half = 0.0;  ///< of the range
  std::size_t style = 0;
};

struct LineChart {
  std::string title, x_label = {}, y_label = {};  ///< labels with their units
  std::vector<ChartLine> lines = {};
  std::vector<ChartBar> bars = {};
  bool x_from_zero = false;
};

/// An <svg> element; empty if no line has a point.
std::string draw_chart(const LineChart& chart);

}  // namespace terp
