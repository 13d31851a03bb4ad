// What an engineer reads from computed water: uplift and heave over the land, gradients where water comes out, lines of
// equal head and of flow. Not for: the water itself (computed_water.hpp).
#pragma once

#include "model/seepage/computed_water.hpp"

#include <optional>
#include <vector>

namespace terp {

/// The cover of a more permeable layer below bare or flooded land.
struct UpliftPlace {
  Vec<2> x{};           ///< at the base of the cover [m]
  Real ground = 0.0;    ///< elevation of its top [m]
  Real stress = 0.0;    ///< total vertical stress at its base, free water included [Pa]
  Real pressure = 0.0;  ///< of the water there [Pa]
  Real gradient = 0.0;  ///< of the head over the cover, upwards [-]

  Real factor() const { return pressure > 0.0 ? stress / pressure : std::numeric_limits<Real>::infinity(); }
};

/// Over the land, in the middle of each column of the section: at the border below which the soil is ten times as
/// permeable as the soil above where the factor is the least. Land: ground that the river does not cover, beyond the
/// crest. situation: solved, of the description of the model.
std::vector<UpliftPlace> uplift_over_land(
    const Model& model, const SeepageSection& section, const WaterSituation& situation);

/// The steepest way of the water out of the ground, over the height of a cell.
struct ExitGradient {
  Vec<2> x{};
  Real gradient = 0.0;  ///< [-]; 0: no water comes out
};

ExitGradient steepest_exit(const Mesh<2>& mesh, const SeepageSection& section, const ComputedWater& water);

/// Streamlines are where this is constant; by nodes [m2/s]. Of the flow k_r k grad h, nearest in the mean.
std::vector<Real> stream_function(const Mesh<2>& mesh, const ComputedWater& water, Real band);

/// Lines on which values of the nodes are equal, in saturated soil; a piece for each cell and level.
std::vector<Side> lines_of_equal(const Mesh<2>& mesh, const SeepageSection& section, const ComputedWater& water,
    std::span<const Real> values, Real step);

}  // namespace terp
