// A frame is found by its name, its time and step are read from the file itself, whose metadata carry checksums. The
// index is for ParaView; Terp asks it only which frame is the last.
#include "io/files/frame_files.hpp"

#include "math/errors.hpp"
#include "io/files/run_folder.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".vtkhdf";

std::string folder_of_frames(const std::string& folder) { return path_in(folder, frames_folder); }

std::string component_names(int n_columns)
{
  switch (n_columns) {
    case 3: return "x y z";
    case 4: return "xx yy zz xy";
    case 6: return "xx yy zz xy yz zx";
    default: return "";
  }
}

std::vector<Real> with_z(std::span<const Real> values)
{
  std::vector<Real> rows(values.size() / 2 * 3, 0.0);
  for (std::size_t k = 0; k < values.size() / 2; ++k) {
    rows[3 * k] = values[2 * k];
    rows[3 * k + 1] = values[2 * k + 1];
  }
  return rows;
}

}  // namespace

std::string frame_file(const FrameKind& kind, std::int64_t number)
{
  return fmt::format("{}/{}{:05}{}", frames_folder, kind.prefix, number, ending);
}

std::int64_t number_of_frame(const FrameKind& kind, std::string_view file_name)
{
  return number_in_name(file_name, kind.prefix, ending);
}

FrameHead read_head(const Hdf5File& file)
{
  return {file.integer("/", "frame"), file.real("/", "time"), file.integer("/", "step"), file.text("/", "case")};
}

std::int64_t last_in_index(const std::string& folder, const FrameKind& kind)
{
  const std::string path = path_in(folder, kind.index);
  try {
    const std::string name = nlohmann::json::parse(read_file(path)).at("files").back().at("name");
    return number_of_frame(kind, fs::path(name).filename().string());
  } catch (const nlohmann::json::exception&) {
    throw FileError(fmt::format("cannot read {}: it is not the list of frames that terp wrote there", path));
  }
}

std::vector<std::int64_t> list_frames(const std::string& folder, const FrameKind& kind)
{
  std::vector<std::int64_t> numbers;
  std::error_code none;
  const std::string frames = folder_of_frames(folder);
  fs::directory_iterator entries(frames, none);
  if (none && fs::exists(frames)) throw_file_error("read", frames, none.value());
  for (const auto& entry : entries) {
    const std::int64_t number = number_of_frame(kind, entry.path().filename().string());
    if (number >= 0) numbers.push_back(number);
  }
  std::ranges::sort(numbers);
  return numbers;
}

FrameCheck check_frames(const std::string& folder, const FrameKind& kind, std::int64_t n_due, const std::string& run)
{
  FrameCheck check;
  for (std::int64_t k = 0; k < n_due; ++k) {
    const std::string path = path_in(folder, frame_file(kind, k));
    std::error_code none;
    if (!fs::exists(path, none)) {
      check.faults.push_back(fmt::format("{} is missing; the run goes on without it", path));
      continue;
    }
    check_readable(path);
    FrameHead head;
    try {
      const Hdf5File file(path, Hdf5File::Mode::read);
      head = read_head(file);
      file.check_values();
      if (head.number != k) throw FileError(fmt::format("it is frame {}", head.number));
    } catch (const FileError& error) {
      check.faults.push_back(fmt::format("{} is damaged; the run goes on without it: {}", path, error.what()));
      continue;
    }
    if (head.run != run) check.stranger = path;
    check.good.push_back(head);
  }
  return check;
}

void remove_frames_from(const std::string& folder, const FrameKind& kind, std::int64_t first)
{
  for (const std::int64_t k : list_frames(folder, kind)) {
    if (k < first) continue;
    const std::string path = path_in(folder, frame_file(kind, k));
    std::error_code error;
    fs::remove(path, error);
    if (error) throw_file_error("remove", path, error);
  }
}

FrameSeries::FrameSeries(
    std::string folder, const FrameKind& kind, std::string run, std::int64_t next, std::vector<FrameHead> before)
    : folder_(std::move(folder)), run_(std::move(run)), kind_(kind), next_(next), frames_(std::move(before))
{
}

Hdf5File& FrameSeries::begin(Real time, std::int64_t step, std::int64_t n_reserved)
{
  pending_.reset();
  if (!frames_.empty() && !fs::exists(folder_of_frames(folder_)))
    throw FileError(fmt::format("{}: it was removed while the run went on", folder_of_frames(folder_)));
  make_folder(folder_of_frames(folder_));
  TemporaryFile place(path_in(folder_, frame_file(kind_, next_)));
  const std::string temporary = place.name();
  pending_.reset(new Pending{std::move(place), {temporary, Hdf5File::Mode::create, n_reserved}});
  Hdf5File& file = pending_->file;
  vtkhdf::write_head(file, run_);
  file.set_integers("/", "frame", {next_});
  file.set_integers("/", "step", {step});
  file.set_real("/", "time", time);
  next_head_ = {next_, time, step, run_};
  return file;
}

void FrameSeries::end()
{
  const auto done = std::move(pending_);
  done->file.close();
  done->place.move_into_place();
  frames_.push_back(next_head_);
  ++next_;
  write_index();
}

void FrameSeries::require_all() const
{
  for (const FrameHead& frame : frames_)
    if (const std::string path = path_in(folder_, frame_file(kind_, frame.number)); !fs::exists(path))
      throw FileError(fmt::format("{}: it was removed while the run went on", path));
}

void FrameSeries::write_index() const
{
  const std::string path = path_in(folder_, kind_.index);
  if (frames_.empty()) {
    fs::remove(path);
    return;
  }
  nlohmann::ordered_json index{{"file-series-version", "1.0"}, {"files", nlohmann::ordered_json::array()}};
  for (const FrameHead& frame : frames_)
    index["files"].push_back({{"name", frame_file(kind_, frame.number)}, {"time", frame.time}});
  write_file_atomically(path, index.dump(1) + '\n');
}

namespace vtkhdf {

void write_head(Hdf5File& file, const std::string& run)
{
  file.create_group(root);
  file.set_integers(root, "Version", {1, 0});
  file.set_text(root, "Type", "UnstructuredGrid");
  file.set_text("/", "terp_version", TERP_VERSION);
  file.set_text("/", "case", run);
}

void write_sizes(Hdf5File& file, std::int64_t n_points, std::int64_t n_cells, std::int64_t n_connectivity)
{
  const std::pair<const char*, std::int64_t> sizes[] = {
      {"/NumberOfPoints", n_points}, {"/NumberOfCells", n_cells}, {"/NumberOfConnectivityIds", n_connectivity}};
  for (const auto& [name, n] : sizes) file.write<std::int64_t>(root + name, {1}, std::span(&n, 1), 0, exact);
}

void write_field(Hdf5File& file, const FieldRows& field, std::span<const Real> values, const Hdf5File::Layout& layout)
{
  const std::vector<Real> rows = field.n_components == 2 ? with_z(values) : std::vector<Real>();
  const int n_columns = field.n_components == 2 ? 3 : field.n_components;
  std::vector<std::int64_t> shape{field.n_rows};
  if (n_columns > 1) shape.push_back(n_columns);
  file.write<Real>(field.name, shape, rows.empty() ? values : rows, field.first_row, layout);
  if (field.first_row > 0) return;
  file.set_text(field.name, "unit", field.unit);
  if (const std::string names = component_names(n_columns); !names.empty())
    file.set_text(field.name, "components", names);
}

}  // namespace vtkhdf

}  // namespace terp
