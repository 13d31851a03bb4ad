// The crest, how it retreats, and the second failure. Definitions: docs/formats.md.
#pragma once

#include "events/surface.hpp"

#include <optional>

namespace terp {

/// Where the crest was, one entry per ledger row.
struct CrestHistory {
  Columns columns;
  std::vector<Real> initial_heights;  ///< of the surface at t = 0 [m], shape [columns.n]
  Real base = 0.0;                    ///< height of the lowest point at t = 0 [m]
  std::vector<Real> time;             ///< [s]
  std::vector<Real> x;                ///< crest [m]; left edge of the first column if the whole surface has moved
};

/// A crest history that starts with the surface as it is now.
CrestHistory start_crest_history(const PointBlocks<2>& points, Real left, Real right, Real column_width);

/// Largest x from which the surface to the left is within 0.05 m of its height at t = 0.
Real find_crest(const CrestHistory& crest, const PointBlocks<2>& points);

/// Time at which the crest, after the first slide has settled, begins to retreat again [s].
std::optional<Real> second_failure_time(const CrestHistory& crest);

}  // namespace terp
