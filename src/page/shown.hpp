// The points, places and fields of a run that a report shows, as codes; made smaller until they fit.
// Not for: texts, tables, the mesh (payload, backdrop).
#pragma once

#include "page/codec.hpp"
#include "io/results/run_results.hpp"

#include <functional>
#include <string>
#include <vector>

namespace terp {

/// A field that the page can colour by.
struct ShownField {
  std::string name, symbol, label, unit;
  std::string kind;            ///< "sequential", "diverging" or "category"
  Real low = 0.0, high = 1.0;  ///< of the colour scale, before the reader changes it
  Scale scale = {};
  std::vector<Codes> frames = {};  ///< one if it never changes
  int shares = -1;                 ///< the field whose codes it has, with another scale; -1: its own
  bool of_places = false;          ///< it has no codes: the page measures how far a point is from its first place
};

struct ShownRun {
  std::int64_t n_points = 0;            ///< of the run
  std::vector<std::uint32_t> ids = {};  ///< of the points shown, ascending
  std::size_t n_frames_in_run = 0;
  std::vector<std::size_t> frames = {};           ///< which of them are shown
  std::vector<Real> times = {};                   ///< of those [s]
  std::vector<Real> moments = {};                 ///< whose frames are not left out to save bytes [s]
  Scale x = {}, y = {};                           ///< [m]
  std::vector<Codes> x_codes = {}, y_codes = {};  ///< by frame; `no_value` in both: there is no soil of the point
  std::vector<ShownField> fields = {};            ///< the first is shown first
  Real point_size = 0.0;                          ///< typical distance of the points shown [m]
  std::array<Real, 4> bounds{};  ///< of the points shown in all frames: low x, low y, high x, high y [m]
};

/// Called with the places of all points, frame after frame, once the points that are shown are chosen.
using LookAtPlaces = std::function<void(const ShownRun&, const std::vector<Real>& places)>;

/// Reads what is shown. n_most: points, by chance but always the same, if the run has more.
ShownRun read_shown(
    const Frames& frames, std::int64_t n_most, const LookAtPlaces& look = [](const auto&, const auto&) {});

/// Size of the codes of the runs after gzip, from a part of the points [bytes].
std::size_t estimate_bytes(const std::vector<ShownRun>& runs);

/// Leaves out all other frames. kept: ascending.
void keep_frames(ShownRun& run, const std::vector<std::size_t>& kept);

/// Leaves out frames that nobody misses where the codes are more than a light page has. Then coarsens values, leaves
/// out frames and points, as little as brings the codes to `most_bytes`.
void fit(std::vector<ShownRun>& runs, std::size_t most_bytes);

}  // namespace terp
