// results.vtkhdf: all material points at the output times, as ParaView and h5py read it (docs/formats.md).
// Not for: restarting a run (checkpoint).
#pragma once

#include "simulation/observer.hpp"

#include <cstdint>
#include <string>

namespace terp {

/// A frame is added as a whole (committed_file.hpp): the file may be opened at any time, and a run that is killed loses no frame.
class ResultsFile {
 public:
  /// Touches nothing. The first frame makes the file if there is none.
  explicit ResultsFile(std::string path) : path_(std::move(path)) {}

  /// Adds a frame. Its points, and the names and sizes of its fields, must be those of the frames before.
  void append(const Frame& frame);

  /// Frames of steps up to `step`; 0 without a file.
  std::int64_t count_until(std::int64_t step) const;

  /// Drops the frames of later steps: for a run that continues from `step`.
  void truncate_after(std::int64_t step);

 private:
  std::string path_;
};

}  // namespace terp
