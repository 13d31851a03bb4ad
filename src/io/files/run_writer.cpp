// The run hands over what it shows, a thread of its own writes it in that order. What tasks use of the members the run
// must not touch before finish(). Tables are on the disk before the checkpoint that has their checksums. resume() looks
// at all files first and changes them only if all agree. Frames may be lost, rows of tables may not.

#include "io/files/run_writer.hpp"

#include "math/errors.hpp"
#include "io/files/summary_json.hpp"

#include <filesystem>
#include <limits>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::size_t most_waiting = 64;  // rows, mostly

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

std::string folder_of_run(const std::string& path)
{
  const std::string folder = folder_of(path);
  return std::filesystem::path(folder).filename() == frames_folder ? folder_of(folder) : folder;
}

[[noreturn]] void refuse(const std::string& path, const ResumePoint& from, const std::string& fault)
{
  throw FileError(
      fmt::format("cannot resume from step {}, t = {:.4g} s: {} {}\n"
                  "  Put a copy of it back, or start the case anew: terp run {} -o NEW_FOLDER\n"
                  "  Nothing was changed; the other files of the folder are as they were.",
          from.step, from.time, path, fault, path_in(folder_of_run(path), case_file)));
}

/// What is dropped: all that comes later. A run at its start shows that start again.
Real last_time(const ResumePoint& from) { return from.step == 0 ? -std::numeric_limits<Real>::infinity() : from.time; }

void check_table(const std::string& folder, const RunTable& table, const ResumePoint& from)
{
  const std::string path = path_in(folder, table.file());
  const TablePart part = read_part_until(path, header_of(table), last_time(from));
  const auto n_due = from.n_rows.find(table.name);
  check_length(path, "rows", part.n_rows, from.step == 0 || n_due == from.n_rows.end() ? 0 : n_due->second, from);
  const bool same = from.tables.find(table_line(table.file(), part.checksum)) != std::string::npos;
  if (part.n_rows > 0 && !same)
    refuse(path, from, "is not what this run wrote: rows of it were altered, or it is of another run");
}

/// The frames of one kind up to the checkpoint. Throws FileError if one is of another run.
FrameCheck frames_until(const std::string& folder, const FrameKind& kind, std::int64_t n_due, const std::string& run,
    const ResumePoint& from)
{
  FrameCheck check = check_frames(folder, kind, n_due, run);
  if (!check.stranger.empty()) refuse(check.stranger, from, "is of a run of another case");
  return check;
}

/// Why mesh.vtkhdf must be written again; empty if it is whole, or not there.
std::string fault_of_mesh(const std::string& path, const std::string& run)
{
  if (!std::filesystem::exists(path)) return "";
  check_is_file(path);
  check_readable(path);
  try {
    const Hdf5File file(path, Hdf5File::Mode::read);
    file.check_values();
    return file.text("/", "case") == run ? "" : path + " is of another run; it is written again";
  } catch (const FileError& error) {
    return fmt::format("{} is damaged; it is written again: {}", path, error.what());
  }
}

/// The end of a stage is a checkpoint, too. It is written as the former first, so that a run that was killed between
/// the two makes the end of the stage again.
void keep_as_checkpoint(const std::string& stage, const std::string& folder, std::int64_t step)
{
  const std::string path = path_in(folder, checkpoint_file(step));
  std::error_code error;
  std::filesystem::remove(path, error);
  std::filesystem::create_hard_link(stage, path, error);
  if (error) write_file_atomically(path, read_file(stage));  // a file system without them
}

}  // namespace

RunWriter::RunWriter(RunWriterSettings settings, FolderLock lock, FrameSeries points, FrameSeries mesh)
    : settings_(std::move(settings)),
      lock_(std::move(lock)),
      points_(std::move(points), settings_.exact_fields),
      mesh_(std::move(mesh)),
      background_(most_waiting)
{
  for (const auto& table : settings_.tables)
    if (table->from_start || std::filesystem::exists(path_in(settings_.folder, table->file()))) open_table(*table);
}

std::unique_ptr<RunWriter> RunWriter::start(RunWriterSettings settings, bool force)
{
  FolderLock lock = prepare_run_folder(settings.folder, force, settings.inputs);
  write_file_atomically(path_in(settings.folder, case_file), settings.case_text.toml);
  const std::string folder = settings.folder, run = digits_of(settings.case_record);
  return std::unique_ptr<RunWriter>(
      new RunWriter(std::move(settings), std::move(lock), {folder, point_frames, run}, {folder, mesh_frames, run}));
}

std::unique_ptr<RunWriter> RunWriter::resume(RunWriterSettings settings, FolderLock lock, const ResumePoint& from)
{
  const std::string folder = settings.folder, run = digits_of(settings.case_record);
  const std::int64_t n_points = from.step == 0 ? 0 : from.n_frames, n_mesh = from.step == 0 ? 0 : from.n_mesh_frames;
  const FrameCheck points = frames_until(folder, point_frames, n_points, run, from),
                   mesh = frames_until(folder, mesh_frames, n_mesh, run, from);
  for (const auto& table : settings.tables) check_table(folder, *table, from);
  check_is_file(path_in(folder, summary_file));
  const std::string mesh_path = path_in(folder, mesh_file), mesh_fault = fault_of_mesh(mesh_path, run);
  // All agree: from here on the folder changes.
  remove_unfinished(folder);
  FrameSeries point_series{folder, point_frames, run, n_points, points.good},
      mesh_series{folder, mesh_frames, run, n_mesh, mesh.good};
  point_series.write_index();  // first: what it lists is there
  mesh_series.write_index();
  remove_frames_from(folder, point_frames, n_points);
  remove_frames_from(folder, mesh_frames, n_mesh);
  if (!mesh_fault.empty()) std::filesystem::remove(mesh_path);
  for (const auto& table : settings.tables)
    drop_rows_after(path_in(folder, table->file()), header_of(*table), last_time(from));
  remove_checkpoints_after(folder, from.step);
  remove_old_checkpoints(folder, settings.checkpoint_keep);
  std::unique_ptr<RunWriter> writer(
      new RunWriter(std::move(settings), std::move(lock), std::move(point_series), std::move(mesh_series)));
  for (const auto* check : {&points, &mesh})
    writer->warnings_.insert(writer->warnings_.end(), check->faults.begin(), check->faults.end());
  if (!mesh_fault.empty()) writer->warnings_.push_back(mesh_fault);
  return writer;
}

RunWriter::~RunWriter() = default;

void RunWriter::frame(const std::shared_ptr<const Frame>& frame)
{
  if (!last_frame_.expired()) background_.finish();  // at most one waits
  last_frame_ = frame;
  background_.add([this, frame] { points_.append(*frame); });
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
    std::string written;
    for (const auto& [file, table] : tables_) {
      sync_to_disk(path_in(settings_.folder, file));  // on the disk before what relies on them
      written += table_line(file, table.checksum());
    }
    const std::string file = part.stage.empty() ? checkpoint_file(part.step) : part.stage;
    checkpoint_.emplace(path_in(settings_.folder, file), settings_.case_record, std::move(written));
  }
  checkpoint_->append(part);
  if (!part.last) return;
  checkpoint_.reset();
  if (!part.stage.empty()) keep_as_checkpoint(path_in(settings_.folder, part.stage), settings_.folder, part.step);
  remove_old_checkpoints(settings_.folder, settings_.checkpoint_keep);
}

std::string RunWriter::save_failed(const StateImage& image)
{
  try {
    finish();
    std::string path = path_in(settings_.folder, failed_file(image.step));
    CheckpointWriter(path, settings_.case_record).append(image);
    return path;
  } catch (const FileError& error) {
    return fmt::format("nothing: {}", error.what());
  }
}

void RunWriter::summary(const Summary& summary, bool finished)
{
  finish();
  std::vector<WrittenTable> written;
  for (const auto& [file, table] : tables_) {
    const std::string path = path_in(settings_.folder, file);
    std::error_code gone;
    if (std::filesystem::file_size(path, gone) != static_cast<std::uintmax_t>(table.n_bytes()) || gone)
      throw FileError(fmt::format("{}: it was removed or changed while the run wrote it", path));
    written.push_back({file, table.n_bytes(), table.checksum()});
  }
  if (finished) points_.frames().require_all(), mesh_.require_all();
  write_summary(path_in(settings_.folder, summary_file), summary, finished, settings_.case_text, written);
}

}  // namespace terp
