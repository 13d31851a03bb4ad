// The colour of each soil in pictures: as the case says, else by its name, as sections of the ground are usually drawn.
#pragma once

#include "model/case/case.hpp"

#include <string>
#include <vector>

namespace terp {

/// "#rrggbb" of each material, in their order. The part of a soil above the phreatic line is lighter than that
/// below.
std::vector<std::string> soil_colours(const std::vector<MaterialCase>& materials);

}  // namespace terp
