// What single keys cannot show: keys that contradict each other, names that lead nowhere, a law's own limits.
// Not for: geometry against the mesh (model/parts/setup), nor quantities that are compared with the size of the soil
// (run/findings/scale_warnings).
#pragma once

#include "io/case/document.hpp"
#include "io/case/values.hpp"
#include "model/case/case.hpp"

namespace terp {

/// Adds what is wrong or doubtful. `values` were read from `root`; what could not be read is left out of the checks.
void check_case(const Node& root, const Case& values, Findings& findings);

void check_mesh(const Node& root, const MeshCase& mesh, Findings& findings);

/// Turns the polygon of a mesh counter-clockwise; its edges keep their places and take their new numbers.
void turn_counter_clockwise(MeshCase& mesh);

/// The end of a run that may end before or has stages, from what they say. Where a run, or its last stage, says neither
/// when nor with what it ends, and there is a verdict, that ends it.
void set_end_of_run(const Node& root, Case& values);

/// How soil starts that the file says nothing of: at rest under gravity, where there is water or a river.
void set_start(const Node& root, Case& values, Findings& findings);

/// What moves for ever, or changes for ever: rest would say nothing, or never come. Of a case, or a stage, that is to
/// end at rest.
void check_what_goes_on(const Case& values, std::vector<Problem>& warnings);

void check_stages(const Node& root, const Case& values, Findings& findings);

/// Options of [method] that the file sets and that do nothing, or work against each other.
void check_method(const Node& root, const Case& values, std::vector<Problem>& warnings);

/// What parameters that vary need: water, gravity, outlines. The values may be incomplete.
void check_fields(const Case& values, std::vector<Problem>& problems);

/// Softening that cannot be, or does nothing. The values may be incomplete.
void check_softening(const Node& root, const Case& values, Findings& findings);

/// Drainage of the materials: soil whose law does not go with it. The values may be incomplete.
void check_drainage(const Node& root, const Case& values, Findings& findings);

/// [water]: lines that contradict each other; and drainage. The values may be incomplete.
void check_water(const Node& root, const Case& values, Findings& findings);

/// What can be computed but is hardly meant, and shows before a mesh is made: gravity, damping. The values may be
/// incomplete.
void check_physics(const Node& root, const Case& values, std::vector<Problem>& warnings);

}  // namespace terp
