// How high the soil is, against which quantities are compared.
#pragma once

#include "model/parts/model.hpp"
#include "run/loop/state.hpp"

#include <array>
#include <string>

namespace terp {

struct SoilSize {
  Real g = 0.0;       ///< [m/s^2]
  Real height = 0.0;  ///< between its lowest and its highest point along gravity [m]
  Real cell = 0.0;    ///< typical size of the cells [m]
};

SoilSize measure_soil(const Model& model, const State& state);

/// Least and largest x of the points at t = 0 [m].
std::array<Real, 2> ends_of_soil(const State& state);

/// Whether soil fills half of a cell or more, shape [n_cells].
std::vector<bool> cells_of_soil(const Model& model, const State& state);

/// Whether a body has points of the material.
bool is_used(const Model& model, const std::string& material);

}  // namespace terp
