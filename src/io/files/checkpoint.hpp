// checkpoint_<step>.h5: everything a run needs to go on, to the bit, with a checksum (docs/formats.md).
// Not for: looking at results (vtkhdf).
#pragma once

#include "math/checksum.hpp"
#include "io/files/files.hpp"
#include "run/loop/observer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace terp {

/// Writes a checkpoint part by part under a temporary name and moves it into place: a full disk or a crash leaves no
/// half one. Names of arrays are unique; a '/' in them makes groups in the file.
class CheckpointWriter {
 public:
  /// case_record: what the run began with; tables: what its tables hold. Kept as they are; may be empty.
  explicit CheckpointWriter(std::string path, std::string case_record = {}, std::string tables = {});

  /// The parts of an image in their order; the last ends the checkpoint.
  void append(const StateImage& part);

 private:
  void write_part(const StateImage& part);
  void enter(const NamedArray& array);
  void check_complete() const;

  std::string path_;
  TemporaryFile place_;  // removed if the last part does not come
  std::string case_record_, tables_, names_;
  std::string array_;                            // the newest
  std::int64_t n_written_ = 0, n_expected_ = 0;  // values of it
  Fnv1a checksum_;
};

/// Throws FileError with the file and what is wrong unless every bit is as it was written.
StateImage read_checkpoint(const std::string& path);

/// FNV-1a, 64 bit, over the time, the step, the case record, the tables, and each array's name, type, shape and values,
/// in their order. Of a whole image.
std::uint64_t checksum_of(const StateImage& image);

struct SkippedCheckpoint {
  std::string path, reason;
};

struct CheckpointSearch {
  std::optional<StateImage> image;         ///< none if the folder holds no good checkpoint
  std::string path;                        ///< of the good one
  std::vector<SkippedCheckpoint> skipped;  ///< newer ones that are bad, newest first
};

/// The checkpoint of the latest step in a run folder that can be read.
CheckpointSearch newest_good_checkpoint(const std::string& folder);

/// Removes all but the `n_kept` newest checkpoints; 0 keeps all.
void remove_old_checkpoints(const std::string& folder, Index n_kept);

void remove_checkpoints_after(const std::string& folder, std::int64_t step);

}  // namespace terp
