// Writes all that a run shows into its folder. The one class that src/cli/ needs from this folder to solve a case.
// Not for: when something is written (run/loop/reporter), nor the formats (the other files here).
#pragma once

#include "io/files/checkpoint.hpp"
#include "io/files/files.hpp"
#include "io/files/point_frames.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/table_csv.hpp"
#include "os/background.hpp"
#include "run/loop/observer.hpp"
#include "run/report/summary.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace terp {

struct RunWriterSettings {
  std::string folder;  ///< "runs/model_2"
  CaseText case_text;
  Index checkpoint_keep = 2;                                 ///< how many of the newest checkpoints are kept; 0: all
  std::string case_record = {};                              ///< what the run began with, for its checkpoints
  std::vector<InputFile> inputs = {};                        ///< files that the case names
  std::vector<std::shared_ptr<const RunTable>> tables = {};  ///< that the run may write
  bool exact_fields = false;                                 ///< fields of the frames in double precision
};

/// A checkpoint, and what the other files of the run must hold up to there.
struct ResumePoint {
  std::int64_t step = 0;
  Real time = 0.0;  ///< [s]
  std::int64_t n_frames = 0, n_mesh_frames = 0;
  std::map<std::string, std::int64_t, std::less<>> n_rows = {};  ///< by table
  std::string tables = {};                                       ///< as the checkpoint has it
};

/// What is shown is written in the order in which it was shown, by a thread of its own, so that the run goes on
/// meanwhile; `finish` waits for it. A write that failed leaves what was there before and throws FileError from a later
/// call; nothing that was shown after it is written.
///
/// Order that a resumed run relies on: at one step, the checkpoint comes after the frame and the rows of that step,
/// and a resumed run does not write those of its first step again, unless that is step 0.
class RunWriter : public Observer {
 public:
  /// A new run: prepares the folder, writes case.toml and copies the files that it names.
  static std::unique_ptr<RunWriter> start(RunWriterSettings settings, bool force);

  /// A run that continues from a checkpoint: drops all that was written after it. If a table is damaged or holds less
  /// than it must, or a file is of another run, throws FileError and changes nothing. Frames that are missing or
  /// damaged do not keep the run from going on: see `warnings`. lock: of the run's folder.
  static std::unique_ptr<RunWriter> resume(RunWriterSettings settings, FolderLock lock, const ResumePoint& from);

  ~RunWriter() override;

  void frame(const std::shared_ptr<const Frame>& frame) override;
  void rows(const std::vector<TableRow>& rows) override;
  void checkpoint(const std::shared_ptr<const StateImage>& image) override;

  /// What `resume` found of frames that are missing or damaged, a sentence each.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Where the frames of the background mesh go.
  FrameSeries& frames_of_mesh() { return mesh_; }

  /// Returns when all is on the disk.
  void finish();

  /// Keeps the state of a run that stopped itself, for a look at it; `resume` does not use it. Returns its path, or why
  /// nothing was kept.
  std::string save_failed(const StateImage& image) override;

  /// summary.json. finished: the run reached its end time.
  void summary(const Summary& summary, bool finished);

 private:
  RunWriter(RunWriterSettings settings, FolderLock lock, FrameSeries points, FrameSeries mesh);

  TableFile& open_table(const RunTable& table);
  void write_checkpoint_part(const StateImage& part);

  RunWriterSettings settings_;
  FolderLock lock_;
  PointFrameWriter points_;
  FrameSeries mesh_;
  std::vector<std::string> warnings_;
  std::map<std::string, TableFile, std::less<>> tables_;  // by file; some only from their first row on
  std::optional<CheckpointWriter> checkpoint_;            // between its first part and its last
  std::weak_ptr<const Frame> last_frame_;
  std::weak_ptr<const StateImage> last_image_;
  Background background_;  // last: its tasks use the rest
};

}  // namespace terp
