// The section of a case as a drawing: mesh, bodies by material, conditions of the sides, named points, footings.
// Not for: results of a run (the report page, python/terp).
#pragma once

#include "simulation/model.hpp"
#include "simulation/state.hpp"

#include <string>

namespace terp {

/// SVG text of the model before its first step; lengths in metres beside the axes.
std::string draw_section(const Model& model, const State& state);

}  // namespace terp
