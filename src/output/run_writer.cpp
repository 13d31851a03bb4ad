// Writes all that a run shows into its folder: see run_writer.hpp.
#include "output/run_writer.hpp"

#include "base/errors.hpp"
#include "output/checkpoint.hpp"
#include "output/summary_json.hpp"
#include "output/table_csv.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

namespace terp {

RunWriter::RunWriter(RunWriterSettings settings, FolderLock lock)
    : settings_(std::move(settings)),
      lock_(std::move(lock)),
      results_(path_in(settings_.folder, results_file)),
      history_(open_table(path_in(settings_.folder, history_file), history_header)),
      ledger_(open_table(path_in(settings_.folder, ledger_file), ledger_header))
{
}

std::unique_ptr<RunWriter> RunWriter::start(RunWriterSettings settings, bool force)
{
  FolderLock lock = prepare_run_folder(settings.folder, force);
  write_file_atomically(path_in(settings.folder, case_file), settings.case_text.toml);
  return std::unique_ptr<RunWriter>(new RunWriter(std::move(settings), std::move(lock)));
}

std::unique_ptr<RunWriter> RunWriter::resume(RunWriterSettings settings, std::int64_t step, Real time)
{
  const std::string folder = settings.folder;
  FolderLock lock(folder);
  if (step == 0) {  // a run at its start shows that start again
    time = -std::numeric_limits<Real>::infinity();
    step = -1;
  }
  drop_rows_after(path_in(folder, history_file), history_header, time);
  drop_rows_after(path_in(folder, ledger_file), ledger_header, time);
  drop_rows_after(path_in(folder, left_file), left_header, time);
  ResultsFile(path_in(folder, results_file)).truncate_after(step);
  remove_checkpoints_after(folder, std::max<std::int64_t>(step, 0));
  return std::unique_ptr<RunWriter>(new RunWriter(std::move(settings), std::move(lock)));
}

void RunWriter::frame(const Frame& frame) { results_.append(frame); }

void RunWriter::history(const std::vector<HistoryRow>& rows) { history_.append(csv_lines(rows)); }

void RunWriter::ledger(const LedgerRow& row) { ledger_.append(csv_line(row)); }

void RunWriter::left(const std::vector<LeftPoint>& points)
{
  if (!left_) left_.emplace(open_table(path_in(settings_.folder, left_file), left_header));
  left_->append(csv_lines(points));
}

void RunWriter::checkpoint(const StateImage& image)
{
  for (const auto name : {results_file, history_file, ledger_file, left_file}) {  // on the disk before what relies on them
    const std::string path = path_in(settings_.folder, name);
    if (std::filesystem::exists(path)) sync_to_disk(path);
  }
  write_checkpoint(path_in(settings_.folder, checkpoint_file(image.step)), image);
  remove_old_checkpoints(settings_.folder, settings_.checkpoint_keep);
}

std::string RunWriter::write_failed(const StateImage& image) const
{
  const std::string path = path_in(settings_.folder, failed_file(image.step));
  write_checkpoint(path, image);
  return path;
}

std::string RunWriter::save_failed(const StateImage& image)
{
  try {
    return write_failed(image);
  } catch (const FileError& error) {
    return fmt::format("nothing: {}", error.what());
  }
}

void RunWriter::summary(const Summary& summary, bool finished) const
{
  write_summary(path_in(settings_.folder, summary_file), summary, finished, settings_.case_text);
}

}  // namespace terp
