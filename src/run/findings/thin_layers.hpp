// Weak layers of few cells between or on stronger soil, found in the outlines of the bodies.
// Not for: what is said of them (limit_warnings.cpp).
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <vector>

namespace terp {

/// Most of a material, where it lies on stronger soil: below stronger soil too, or at the surface.
struct ThinLayer {
  Index material = -1;
  bool at_surface = false;
  Real thickness = 0.0;  ///< across the layer, in the mean [m]
  Real cell = 0.0;       ///< size of the cells that it lies in [m]
  Real driving = 0.0;    ///< share of gravity along its lower side, in the mean [-]
  Real cells() const { return thickness / cell; }
};

/// Of soil that yields, where a neighbour has at least 1.5 times its strength. None with a body that came as points.
std::vector<ThinLayer> find_layers(const Model& model, const State& state);

}  // namespace terp
