// The crest, how it retreats, and the slides that make it retreat. Definitions: docs/formats.md.
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
  std::vector<Real> kinetic;          ///< kinetic energy of all soil, of the nodes [J per m]; may be empty: then nobody knows when a slide stops
};

/// A slide: the crest retreats by much within a short time. Definition: docs/formats.md.
struct Slide {
  Real begins = 0.0;                    ///< [s]
  std::optional<Real> stops;            ///< [s]; none if the next slide begins, or the run ends, before
  Real crest_from = 0.0, crest_to = 0.0;  ///< before, and when the crest has settled or the run ends [m]
  Real kinetic_peak = 0.0;              ///< largest nodal kinetic energy until the next slide [J per m]
};

/// A crest history that starts with the surface as it is now.
CrestHistory start_crest_history(const PointBlocks<2>& points, Real left, Real right, Real column_width);

/// Height of the first surface over the lowest point [m].
Real first_height(const CrestHistory& crest);

/// Displacement from which on soil counts as moved: a twentieth of that height [m].
Real moved_distance(const CrestHistory& crest);

/// Largest x from which the surface to the left is within 0.05 m of its height at t = 0.
Real find_crest(const CrestHistory& crest, const PointBlocks<2>& points);

/// Height of the surface at the last column before the crest [m]; NaN if the whole surface has moved.
Real crest_height(const CrestHistory& crest, const PointBlocks<2>& points, Real crest_x);

/// The slides so far, in order of time.
std::vector<Slide> find_slides(const CrestHistory& crest);

/// Time at which the crest, after the first slide has settled, begins to retreat again [s].
std::optional<Real> second_failure_time(const CrestHistory& crest);

}  // namespace terp
