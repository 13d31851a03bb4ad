// The frames of a run, read one field of one frame at a time (docs/formats.md).
// Not for: writing them (io/files/point_frames).
#pragma once

#include "math/sentence.hpp"
#include "io/files/frame_files.hpp"

#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// A field of all material points, as the files have it.
struct ResultField {
  std::string name, unit;
  int n_components = 1;  ///< of a vector 3, with z = 0; of a tensor 4: xx yy zz xy
};

/// Each reading opens the file of its frame. Frames that a run adds meanwhile are not seen. Frames that are missing or
/// damaged are left out: frame k is the k-th of the others.
///
/// Row p is the same material point in every frame. Where there is no soil of it, its place and all of its values are
/// NaN: its body is not placed yet or was removed, or it left through an open side.
class Frames {
 public:
  /// Of a run folder. Throws FileError if it holds no frame that can be read, or frames of different runs.
  explicit Frames(const std::string& folder);

  std::int64_t n_points() const { return n_points_; }
  const std::vector<Real>& times() const { return times_; }           ///< [s], shape [n_frames]
  const std::vector<std::int64_t>& steps() const { return steps_; }   ///< shape [n_frames]
  const std::vector<ResultField>& fields() const { return fields_; }  ///< in the order of the file
  bool has(std::string_view name) const { return find(name) != nullptr; }

  /// Places in frame k [m], shape [n_points, 2].
  std::vector<Real> places(std::size_t k) const;
  /// A field in frame k, shape [n_points, n_components]. Throws CaseError that lists the fields if there is none of
  /// that name, FileError if the frame is damaged.
  std::vector<Real> read(std::string_view name, std::size_t k) const;
  const ResultField& field(std::string_view name) const;

  /// Reads every value once and leaves out the frames that turn out to be damaged.
  void leave_out_damaged();
  /// Throws FileError unless the first frame of the run and the last that its index lists can be read, every value.
  void require_first_and_last() const;
  /// A sentence for each frame that was left out.
  const std::vector<Sentence>& warnings() const { return warnings_; }

 private:
  const ResultField* find(std::string_view name) const;
  void add_frame(std::int64_t number);
  void leave_out(const std::string& path, const std::string& why);
  /// The rows of a dataset in frame k, which must be n_points; NaN without soil.
  std::vector<Real> read_rows(const std::string& name, int n_components, std::size_t k) const;

  std::string folder_, run_;
  std::int64_t n_points_ = -1;
  std::vector<std::int64_t> numbers_;
  std::vector<Real> times_;
  std::vector<std::int64_t> steps_;
  std::vector<ResultField> fields_;
  std::vector<Sentence> warnings_;
  mutable std::vector<bool> all_soil_;  ///< whether a reading of a frame has seen so
};

/// Whether there is soil of point p. places: of a frame.
inline bool is_soil(std::span<const Real> places, std::size_t p) { return !std::isnan(places[2 * p]); }

/// Size of a vector in each row of a field, shape [n_rows] (of a scalar: its absolute value).
std::vector<Real> magnitudes(const std::vector<Real>& values, int n_components);

}  // namespace terp
