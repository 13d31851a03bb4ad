// Writes all that a run shows into its folder: see run_writer.hpp.
#include "output/run_writer.hpp"

#include "base/errors.hpp"
#include "output/mesh_file.hpp"
#include "output/summary_json.hpp"
#include "output/table_csv.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::size_t most_waiting = 64;             // rows, mostly

/// Throws FileError if a file holds fewer rows or frames than it must.
void check_length(const std::string& path, const char* unit, std::int64_t n, std::int64_t n_due, const ResumePoint& from)
{
  if (n >= n_due) return;
  const std::string fault = std::filesystem::exists(path) ? fmt::format("it holds {} {} up to there, {} are due", n, unit, n_due) : "it is missing";
  throw FileError(fmt::format("cannot resume from step {}, t = {:.4g} s, without all of {}: {}\n"
                              "  Put the file back, resume from an earlier checkpoint, or start the case anew: terp run {} -o NEW_FOLDER",
                              from.step, from.time, path, fault, path_in(folder_of(path), case_file)));
}

/// Number of frames up to a step. Throws FileError if the file is damaged: HDF5 keeps what belongs to one frame all over the file, so that of one
/// that was cut or altered nothing can be relied on.
template <class File>
std::int64_t count_frames(const File& file, const std::string& path, const ResumePoint& from)
{
  try {
    return file.count_until(from.step);
  } catch (const FileError& error) {
    throw FileError(fmt::format("cannot resume from step {}, t = {:.4g} s: {} was cut or altered, and its frames cannot be read\n"
                                "  {}\n"
                                "  Put a copy of it back, or start the case anew: terp run {} -o NEW_FOLDER\n"
                                "  Nothing was changed; the tables and checkpoints of the folder are as they were.",
                                from.step, from.time, path, error.what(), path_in(folder_of(path), case_file)));
  }
}

void check_files(const std::string& folder, const ResumePoint& from)
{
  const auto check_table = [&](std::string_view name, std::string_view header, std::int64_t n_due) {
    const std::string path = path_in(folder, name);
    check_length(path, "rows", count_rows_until(path, header, from.time), n_due, from);
  };
  const std::string results = path_in(folder, results_file);
  check_length(results, "frames", count_frames(ResultsFile(results), results, from), from.n_frames, from);
  const std::string mesh = path_in(folder, mesh_file);
  check_length(mesh, "frames", count_frames(MeshFile(mesh), mesh, from), from.n_mesh_frames, from);
  check_table(history_file, history_header, from.n_history_rows);
  check_table(ledger_file, ledger_header, from.n_ledger_rows);
  check_table(left_file, left_header, from.n_left_rows);
  check_table(footings_file, footings_header, from.n_footing_rows);
}

}  // namespace

RunWriter::RunWriter(RunWriterSettings settings, FolderLock lock)
    : settings_(std::move(settings)),
      lock_(std::move(lock)),
      results_(path_in(settings_.folder, results_file)),
      history_(open_table(path_in(settings_.folder, history_file), history_header)),
      ledger_(open_table(path_in(settings_.folder, ledger_file), ledger_header)),
      background_(most_waiting)
{
}

std::unique_ptr<RunWriter> RunWriter::start(RunWriterSettings settings, bool force)
{
  FolderLock lock = prepare_run_folder(settings.folder, force);
  write_file_atomically(path_in(settings.folder, case_file), settings.case_text.toml);
  return std::unique_ptr<RunWriter>(new RunWriter(std::move(settings), std::move(lock)));
}

std::unique_ptr<RunWriter> RunWriter::resume(RunWriterSettings settings, FolderLock lock, const ResumePoint& from)
{
  const bool at_start = from.step == 0;  // a run at its start shows that start again
  const std::string folder = settings.folder;
  if (!at_start) check_files(folder, from);
  remove_unfinished(folder);
  const Real time = at_start ? -std::numeric_limits<Real>::infinity() : from.time;
  ResultsFile(path_in(folder, results_file)).truncate_after(at_start ? -1 : from.step);  // first: it may yet be refused, and changes as a whole or not at all
  MeshFile(path_in(folder, mesh_file)).truncate_after(at_start ? -1 : from.step);
  drop_rows_after(path_in(folder, history_file), history_header, time);
  drop_rows_after(path_in(folder, ledger_file), ledger_header, time);
  drop_rows_after(path_in(folder, left_file), left_header, time);
  drop_rows_after(path_in(folder, footings_file), footings_header, time);
  remove_checkpoints_after(folder, from.step);
  remove_old_checkpoints(folder, settings.checkpoint_keep);
  return std::unique_ptr<RunWriter>(new RunWriter(std::move(settings), std::move(lock)));
}

RunWriter::~RunWriter() = default;

void RunWriter::frame(const std::shared_ptr<const Frame>& frame)
{
  if (!last_frame_.expired()) background_.finish();  // at most one waits
  last_frame_ = frame;
  background_.add([this, frame] { results_.append(*frame); });
}

void RunWriter::history(const std::vector<HistoryRow>& rows)
{
  background_.add([this, rows] { history_.append(csv_lines(rows)); });
}

void RunWriter::ledger(const LedgerRow& row)
{
  background_.add([this, row] { ledger_.append(csv_line(row)); });
}

void RunWriter::left(const std::vector<LeftPoint>& points)
{
  background_.add([this, points] { append_to(left_, left_file, left_header, csv_lines(points)); });
}

void RunWriter::footings(const std::vector<FootingRow>& rows)
{
  background_.add([this, rows] { append_to(footings_, footings_file, footings_header, csv_lines(rows)); });
}

void RunWriter::checkpoint(const std::shared_ptr<const StateImage>& image)
{
  if (!last_image_.expired()) background_.finish();
  last_image_ = image;
  background_.add([this, image] { write_checkpoint_part(*image); });
}

void RunWriter::finish() { background_.finish(); }

void RunWriter::append_to(std::optional<AppendFile>& table, std::string_view name, std::string_view header, const std::string& lines)
{
  if (!table) table.emplace(open_table(path_in(settings_.folder, name), header));
  table->append(lines);
}

void RunWriter::write_checkpoint_part(const StateImage& part)
{
  if (part.part == 0) {
    for (const auto name : {results_file, mesh_file, history_file, ledger_file, left_file, footings_file}) {  // on the disk before what relies on them
      const std::string path = path_in(settings_.folder, name);
      if (std::filesystem::exists(path)) sync_to_disk(path);
    }
    checkpoint_.emplace(path_in(settings_.folder, checkpoint_file(part.step)), settings_.case_record);
  }
  checkpoint_->append(part);
  if (!part.last) return;
  checkpoint_.reset();
  remove_old_checkpoints(settings_.folder, settings_.checkpoint_keep);
}

std::string RunWriter::write_failed(const StateImage& image)
{
  finish();
  std::string path = path_in(settings_.folder, failed_file(image.step));
  CheckpointWriter(path, settings_.case_record).append(image);
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

void RunWriter::summary(const Summary& summary, bool finished)
{
  finish();
  write_summary(path_in(settings_.folder, summary_file), summary, finished, settings_.case_text);
}

}  // namespace terp
