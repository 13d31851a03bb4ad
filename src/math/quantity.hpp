// What a run reports, as help, manuals and axes name it. Each table of quantities stands where they are computed.
#pragma once

#include <string_view>

namespace terp {

/// A number, or a name, that a run reports.
struct QuantityInfo {
  std::string_view name;     ///< of the column, the key or the field: "kinetic"
  std::string_view unit;     ///< SI; "-": a number without a unit; "": no number
  std::string_view label;    ///< of an axis
  std::string_view meaning;  ///< of a manual
  bool is_text = false;      ///< a name
  bool is_input = false;     ///< follows from the case and its mesh alone: no result
};

}  // namespace terp
