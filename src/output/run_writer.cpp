// Writes all that a run shows into its folder: see run_writer.hpp.
#include "output/run_writer.hpp"

#include "base/errors.hpp"
#include "output/files.hpp"
#include "output/mesh_file.hpp"
#include "output/summary_json.hpp"
#include "output/vtkhdf_steps.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::size_t most_waiting = 64;  // rows, mostly

/// Throws FileError if a file holds fewer rows or frames than it must.
void check_length(
    const std::string& path, const char* unit, std::int64_t n, std::int64_t n_due, const ResumePoint& from)
{
  if (n >= n_due) return;
  const std::string fault = std::filesystem::exists(path)
                                ? fmt::format("it holds {} {} up to there, {} are due", n, unit, n_due)
                                : "it is missing";
  throw FileError(fmt::format(
      "cannot resume from step {}, t = {:.4g} s, without all of {}: {}\n"
      "  Put the file back, resume from an earlier checkpoint, or start the case anew: terp run {} -o NEW_FOLDER",
      from.step, from.time, path, fault, path_in(folder_of(path), case_file)));
}

/// Throws FileError for a file that is there and cannot be gone on with.
[[noreturn]] void refuse(const std::string& path, const ResumePoint& from, const std::string& fault)
{
  throw FileError(
      fmt::format("cannot resume from step {}, t = {:.4g} s: {} {}\n"
                  "  Put a copy of it back, or start the case anew: terp run {} -o NEW_FOLDER\n"
                  "  Nothing was changed; the other files of the folder are as they were.",
          from.step, from.time, path, fault, path_in(folder_of(path), case_file)));
}

/// What is dropped: all that comes later. A run at its start shows that start again.
std::int64_t last_step(const ResumePoint& from) { return from.step == 0 ? -1 : from.step; }
Real last_time(const ResumePoint& from) { return from.step == 0 ? -std::numeric_limits<Real>::infinity() : from.time; }

/// One line per table of a run, "ledger.csv = 85944171f73967e8": its checksum.
std::string table_line(std::string_view name, const std::string& checksum)
{
  return fmt::format("{} = {}\n", name, checksum);
}

/// Throws FileError unless the rows up to the checkpoint are those that the run wrote.
void check_table(const std::string& folder, const RunTable& table, const ResumePoint& from)
{
  const std::string path = path_in(folder, table.file());
  const TablePart part = read_part_until(path, header_of(table), last_time(from));
  const auto n_due = from.n_rows.find(table.name);
  check_length(path, "rows", part.n_rows, from.step == 0 || n_due == from.n_rows.end() ? 0 : n_due->second, from);
  const bool same = from.tables.find(table_line(table.file(), part.checksum)) != std::string::npos;
  if (!from.tables.empty() && part.n_rows > 0 && !same)
    refuse(path, from, "is not what this run wrote: rows of it were altered, or it is of another run");
}

/// The file without what comes after the checkpoint, on the disk when it is closed; nothing if there is none. Throws
/// FileError if it is damaged: HDF5 keeps what belongs to one frame all over the file, so that of one that was cut or
/// altered nothing can be relied on.
template <class File, class CutAfter>
std::unique_ptr<Hdf5File> cut(const File& file, const std::string& path, std::int64_t n_due,
    const vtkhdf::GridSize& grid, const std::string& run, const ResumePoint& from, CutAfter&& cut_after)
{
  const auto unless_damaged = [&](auto&& read) {
    try {
      return read();
    } catch (const FileError& error) {
      refuse(path, from, fmt::format("was cut or altered, and its frames cannot be read\n  {}", error.what()));
    }
  };
  check_is_file(path);
  const std::int64_t n = unless_damaged([&] { return file.count_until(from.step); });
  check_length(path, "frames", n, from.step == 0 ? 0 : n_due, from);
  std::unique_ptr<Hdf5File> opened = file.open_to_cut();
  if (!opened) return opened;
  const std::string other = unless_damaged([&] { return vtkhdf::why_of_another_run(*opened, run, grid); });
  if (!other.empty()) refuse(path, from, "is not of this run: " + other);
  unless_damaged([&] {
    cut_after(*opened);
    opened->flush();
    return true;
  });
  return opened;
}

}  // namespace

RunWriter::RunWriter(RunWriterSettings settings, FolderLock lock)
    : settings_(std::move(settings)),
      lock_(std::move(lock)),
      results_(path_in(settings_.folder, results_file), digits_of(settings_.case_record)),
      background_(most_waiting)
{
  for (const auto& table : settings_.tables)
    if (table->from_start || std::filesystem::exists(path_in(settings_.folder, table->file()))) open_table(*table);
}

std::unique_ptr<RunWriter> RunWriter::start(RunWriterSettings settings, bool force)
{
  FolderLock lock = prepare_run_folder(settings.folder, force);
  write_file_atomically(path_in(settings.folder, case_file), settings.case_text.toml);
  return std::unique_ptr<RunWriter>(new RunWriter(std::move(settings), std::move(lock)));
}

std::unique_ptr<RunWriter> RunWriter::resume(RunWriterSettings settings, FolderLock lock, const ResumePoint& from)
{
  const std::string folder = settings.folder, run = from.tables.empty() ? "" : digits_of(settings.case_record);
  const std::string results_path = path_in(folder, results_file), mesh_path = path_in(folder, mesh_file);
  const auto results = cut(ResultsFile(results_path), results_path, from.n_frames, {from.n_points, from.n_points}, run,
      from, [&](Hdf5File& file) { ResultsFile::cut_after(file, last_step(from), from.fields); });
  const auto mesh = cut(MeshFile(mesh_path), mesh_path, from.n_mesh_frames, {from.n_nodes, from.n_cells}, run, from,
      [&](Hdf5File& file) { MeshFile::cut_after(file, last_step(from)); });
  for (const auto& table : settings.tables) check_table(folder, *table, from);
  check_is_file(path_in(folder, summary_file));
  if (results) results->close();  // all agree: from here on the folder changes
  if (mesh) mesh->close();
  remove_unfinished(folder);
  for (const auto& table : settings.tables)
    drop_rows_after(path_in(folder, table->file()), header_of(*table), last_time(from));
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

void RunWriter::rows(const std::vector<TableRow>& rows)
{
  background_.add([this, rows] { open_table(*rows.front().table).append(csv_lines(rows)); });
}

void RunWriter::checkpoint(const std::shared_ptr<const StateImage>& image)
{
  if (!last_image_.expired()) background_.finish();
  last_image_ = image;
  background_.add([this, image] { write_checkpoint_part(*image); });
}

void RunWriter::finish() { background_.finish(); }

TableFile& RunWriter::open_table(const RunTable& table)
{
  return tables_.try_emplace(table.file(), path_in(settings_.folder, table.file()), header_of(table)).first->second;
}

void RunWriter::write_checkpoint_part(const StateImage& part)
{
  if (part.part == 0) {
    std::vector<std::string> files{std::string(results_file), std::string(mesh_file)};
    std::string written;
    for (const auto& [file, table] : tables_) {
      files.push_back(file);
      written += table_line(file, table.checksum());
    }
    for (const std::string& file : files)  // on the disk before what relies on them
      if (const std::string path = path_in(settings_.folder, file); std::filesystem::exists(path)) sync_to_disk(path);
    checkpoint_.emplace(
        path_in(settings_.folder, checkpoint_file(part.step)), settings_.case_record, std::move(written));
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
