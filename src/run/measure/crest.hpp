// The crests of a section, how they retreat, and the slides that make them retreat. Definitions: docs/formats.md.
#pragma once

#include "model/ground/section.hpp"

#include <optional>
#include <span>

namespace terp {

/// Where the crest of a slope was, one entry per ledger row.
struct CrestHistory {
  Slope slope;
  Real width = 0.0;           ///< of a column [m]
  std::vector<Real> time;     ///< [s]
  std::vector<Real> x;        ///< crest [m]; the far side of the mesh if nothing stands
  std::vector<Real> kinetic;  ///< kinetic energy of all soil, of the nodes [J per m]; may be empty: then nobody knows
                              ///< when a slide stops
  std::optional<Real> ends = {};  ///< with another slope behind: the far edge of the crest. Once nothing of it is left,
                                  ///< nothing more slides from it [m]
};

/// A slide: the crest retreats by much within a short time. Definition: docs/formats.md.
struct Slide {
  Real begins = 0.0;                      ///< [s]
  std::optional<Real> stops;              ///< [s]; none if the next slide begins, or the run ends, before
  Real crest_from = 0.0, crest_to = 0.0;  ///< before, and when the next slide begins or the run ends [m]
  Real kinetic_peak = 0.0;                ///< largest nodal kinetic energy until the next slide [J per m]
  Facing facing = Facing::right;          ///< of the slope that slides
};

/// The ground that still stands, as columns first ... last - 1; none if first == last.
struct Standing {
  Index first = 0, last = 0;
};

/// Columns whose surface is within 0.05 m, or a fortieth of slope.relief if that is more, of their first height,
/// without a gap. If a section has this slope alone: from the side behind it on. Otherwise of all from there to the
/// crest those that hold the highest ground that stands. heights: the surface now [m]. kept: by column, 1: stands
/// whatever its height, as one that slid down another slope; may be empty.
Standing find_standing(const Section& section, const Slope& slope, bool alone, const std::vector<Real>& heights,
    std::span<const std::uint8_t> kept = {});

/// How far the surface of ground that stands may leave its first height [m].
Real standing_tolerance(Real relief);

/// The edge of the standing ground towards a slope, at most the first crest [m]; NaN if nothing stands.
Real find_crest(const Section& section, const Slope& slope, const Standing& standing);

/// Height of the surface in the last column before that edge [m]; NaN if nothing stands.
Real crest_height(
    const Section& section, const Slope& slope, const Standing& standing, const std::vector<Real>& heights);

/// The edge of the columns behind a slope [m]: where its crest is when nothing stands.
Real back_of(const Section& section, const Slope& slope);

/// The slides so far, in order of time.
std::vector<Slide> find_slides(const CrestHistory& crest);

/// Time at which the crest, after the first slide has settled, begins to retreat again [s].
std::optional<Real> second_failure_time(const CrestHistory& crest);

}  // namespace terp
