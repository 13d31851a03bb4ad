// Units of length that a drawing may have.
#pragma once

#include "math/types.hpp"

namespace terp {

struct DxfUnit {
  int number;  ///< of $INSUNITS
  const char* name;
  Real metres;
};

inline constexpr DxfUnit dxf_units[] = {
    {6, "m", 1.0}, {4, "mm", 1e-3}, {5, "cm", 1e-2}, {14, "dm", 0.1}, {2, "ft", 0.3048}, {1, "in", 0.0254}};

}  // namespace terp
