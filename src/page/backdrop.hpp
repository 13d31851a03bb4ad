// What stands behind the points: the background mesh, the first outline, the free surface over time.
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "io/results/run_results.hpp"
#include "model/case/case.hpp"

#include <optional>
#include <span>
#include <vector>

namespace terp {

/// Lines of the background mesh, each once: x0, y0, x1, y1 [m], shape [n_edges, 4].
std::vector<float> mesh_edges(const Mesh<2>& mesh);

/// Outlines of the bodies at t = 0: x, y [m], shape [n, 2]; closed polylines, with NaN, NaN between them. Bodies that
/// come as points have none.
std::vector<float> first_outline(const Case& description, const Mesh<2>& mesh);

/// The phreatic line at a time, over the width of the mesh: x, y [m], shape [n, 2]; empty without one. begin: time with
/// which the run begins, not 0 where it goes on from another one [s].
std::vector<float> phreatic_line(
    const Case& description, const std::vector<StageSummary>& stages, const Mesh<2>& mesh, Real begin, Real time);

/// Columns for the free surface, and how far the soil of a point reaches above it [m].
struct SurfaceColumns {
  Real width = 0.0, half_point = 0.0;
};

/// The top of the highest point in each column, from left to right: x, y [m], shape [n, 2]. Columns without a point are
/// left out. places: of all points of a frame.
std::vector<float> surface_line(const std::vector<Real>& places, const SurfaceColumns& columns);

/// x, y, x, y, ... as places.
std::vector<Vec<2>> places_of(std::span<const float> line);

/// The highest corner of an outline that lies within `reach` of x [m]: its place; none without one. A crest is seen as
/// the edge of a column, and its true edge is a corner of the drawing near by. outline: as of first_outline.
std::optional<Real> corner_near(std::span<const float> outline, Real x, Real reach);

/// The phreatic line where soil has moved by more than a quarter of a column: the top of the highest soil that lay
/// below it at t = 0. Free water stays. first, now: places of all points; line: x, y [m], shape [n, 2].
std::vector<float> water_in_moved_soil(const std::vector<Real>& first, const std::vector<Real>& now,
    std::span<const float> line, const SurfaceColumns& columns);

}  // namespace terp
