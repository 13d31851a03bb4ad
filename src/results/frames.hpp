// The frames of results.vtkhdf, read one field of one frame at a time (docs/formats.md).
// Not for: writing them (output/vtkhdf).
#pragma once

#include "output/hdf5_file.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// A field of all material points, as the file has it.
struct ResultField {
  std::string name, unit;
  int n_components = 1;  ///< of a vector 3, with z = 0; of a tensor 4: xx yy zz xy
};

/// Each reading opens the file, and is repeated if a frame came into it. Frames that a run adds meanwhile are not seen.
class Frames {
 public:
  /// Throws FileError if the file is missing, not of the format, or does not hold what it says.
  explicit Frames(const std::string& path);

  std::int64_t n_points() const { return n_points_; }
  const std::vector<Real>& times() const { return times_; }           ///< [s], shape [n_frames]
  const std::vector<std::int64_t>& steps() const { return steps_; }   ///< shape [n_frames]
  const std::vector<ResultField>& fields() const { return fields_; }  ///< without id
  bool has(std::string_view name) const { return find(name) != nullptr; }

  /// Places in frame k [m], shape [n_points, 2]. Row p is the same material point in every frame.
  std::vector<Real> places(std::size_t k) const;
  /// A field in frame k, shape [n_points, n_components]. Throws FileError that lists the fields if there is none of
  /// that name.
  std::vector<Real> read(std::string_view name, std::size_t k) const;
  const ResultField& field(std::string_view name) const;

 private:
  const ResultField* find(std::string_view name) const;
  void read_contents(const Hdf5File& file);
  /// Columns of a table that holds a row for each point in each frame; throws FileError if it does not.
  int check_table(const Hdf5File& file, const std::string& name) const;
  /// The rows of frame k of a table. Throws FileError if the file has become that of another case.
  std::vector<Real> read_frame(const std::string& table, std::size_t k) const;

  std::string path_;
  std::string case_;  ///< digits of the case; empty if the file does not say
  std::int64_t n_points_ = 0;
  std::vector<Real> times_;
  std::vector<std::int64_t> steps_;
  std::vector<ResultField> fields_;
};

/// Size of a vector in each row of a field, shape [n_rows] (of a scalar: its absolute value).
std::vector<Real> magnitudes(const std::vector<Real>& values, int n_components);

}  // namespace terp
