// results.vtkhdf: all material points at the output times, as ParaView and h5py read it (docs/formats.md).
// Not for: restarting a run (checkpoint).
#pragma once

#include "output/hdf5_file.hpp"
#include "simulation/observer.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace terp {

/// A frame is added as a whole (committed_file.hpp): the file may be opened at any time, and a run that is killed loses
/// no frame.
class ResultsFile {
 public:
  /// Touches nothing. The first frame makes the file if there is none. run: digits of its case, which go into a new
  /// file.
  explicit ResultsFile(std::string path, std::string run = {}) : path_(std::move(path)), run_(std::move(run)) {}

  /// Adds a frame, or the next part of one, which counts when its last part is there. Its points, and the names and
  /// sizes of its fields, must be those of the frames before.
  void append(const Frame& frame);

  /// Frames of steps up to `step`; 0 without a file.
  std::int64_t count_until(std::int64_t step) const;

  /// The file, ready for `cut_after`; nothing without a file. What is done to it is on the disk when it is closed, and
  /// dropped otherwise.
  std::unique_ptr<Hdf5File> open_to_cut() const;

  /// Drops the frames of later steps: for a run that continues from `step`. Throws FileError and changes nothing if a
  /// table does not hold what it must. fields: those of the run; their values do not count.
  static void cut_after(Hdf5File& file, std::int64_t step, const std::vector<PointField>& fields);

 private:
  std::string path_, run_;
  std::unique_ptr<Hdf5File> open_;  // between the parts of a frame
};

}  // namespace terp
