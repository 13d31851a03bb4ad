// The ground of a model in columns: what slopes, moved soil and the water it holds are measured against.
#pragma once

#include "model/ground/barrier.hpp"
#include "model/ground/section.hpp"
#include "model/parts/model.hpp"

#include <optional>

namespace terp {

/// Which materials are ground; empty: all. Where none is, as in a column of fluid alone, what there is takes its place.
std::vector<std::uint8_t> ground_of(const Model& model);

/// Columns of the width of a typical cell over the whole mesh.
Columns columns_of_section(const Mesh<2>& mesh);

/// Points of soil as files have them: places [m], volumes [m^2], numbers of materials, shape [n_points].
struct SoilPoints {
  std::vector<Vec<2>> places;
  std::vector<Real> volumes;
  std::vector<int> materials;
};

/// The surface of the ground that stands, left to right: x and height in the middle of each column that has some [m].
std::vector<Vec<2>> ground_line(const Case& c, const Mesh<2>& mesh, const SoilPoints& soil);

/// The surface of the ground as it is.
Section first_section(const Model& model, const PointBlocks<2>& points, Ground ground);

/// The ground that stands, looked at `level` [m]; left out: where the water of [flood] stands, if it is known.
StandingGround standing_ground(
    const Model& model, const PointBlocks<2>& points, std::optional<Real> level = std::nullopt);

}  // namespace terp
