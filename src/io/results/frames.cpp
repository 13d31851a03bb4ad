// The first frame that can be read states points, fields and run; the others must agree with it.
#include "io/results/frames.hpp"

#include "math/errors.hpp"
#include "math/nan.hpp"
#include "io/case/case_file.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

using vtkhdf::root;

const std::string point_data = root + "/PointData";
constexpr std::int64_t known_version = 1;  // the first number of the version; the second adds what may be passed over

constexpr SentenceForm is_missing{"{} is missing", "{} ontbreekt"};
constexpr SentenceForm frame_left_out{"{} is left out: {}", "{} is weggelaten: {}"};

/// Throws FileError if one is no table of numbers per point.
std::vector<ResultField> read_fields(const Hdf5File& file, std::int64_t n_points)
{
  std::vector<ResultField> fields;
  for (const auto& name : file.members(point_data)) {
    const std::string table = point_data + "/" + name;
    const auto shape = file.shape(table);
    constexpr std::int64_t most_columns = 1000;
    const std::int64_t n_columns = shape.size() == 1 ? 1 : shape.size() == 2 ? shape[1] : 0;
    if (n_columns < 1 || n_columns > most_columns || shape[0] != n_points)
      throw FileError(fmt::format("the shape of {} is {}, for {} points", name, fmt::join(shape, " x "), n_points));
    fields.push_back({name, file.text(table, "unit"), static_cast<int>(n_columns)});
  }
  return fields;
}

/// Fields of which one tells where there is soil: 0 and more if `holds_zero`, else above 0.
struct SoilSign {
  const char* field;
  bool holds_zero;
};
constexpr SoilSign soil_signs[] = {{"material", true}, {"cell", true}, {"volume", false}};

/// NaN where there is no soil; false if there is soil everywhere. A frame without any of those fields does not tell:
/// all of it counts as soil.
bool leave_out_absent(const Hdf5File& file, std::vector<Real>& rows)
{
  for (const auto& [field, holds_zero] : soil_signs) {
    const std::string name = point_data + "/" + field;
    if (!file.exists(name)) continue;
    const std::vector<Real> sign = file.read<Real>(name);
    const std::size_t n = rows.size() / std::max<std::size_t>(1, sign.size());
    bool any = false;
    for (std::size_t p = 0; p < sign.size(); ++p)
      if (!(sign[p] > 0.0 || (holds_zero && sign[p] == 0.0))) any = true, std::fill_n(&rows[n * p], n, nan);
    return any;
  }
  return false;
}

}  // namespace

Frames::Frames(const std::string& folder) : folder_(folder)
{
  std::int64_t next = 0;
  for (const std::int64_t number : list_frames(folder, point_frames)) {
    for (; next < number; ++next)
      warnings_.push_back(filled<is_missing>(path_in(folder, frame_file(point_frames, next))));
    ++next;
    add_frame(number);
  }
  if (numbers_.empty())
    throw FileError(fmt::format("{}: it holds no frame that can be read; there is nothing to show{}{}", folder,
        warnings_.empty() ? "" : "\n  ", fmt::join(in_english(warnings_), "\n  ")));
  if (n_points_ == 0) throw FileError(fmt::format("{}: it holds no points; there is nothing to show", folder));
}

void Frames::leave_out(const std::string& path, const std::string& why)
{
  warnings_.push_back(filled<frame_left_out>(path, why));
}

void Frames::add_frame(std::int64_t number)
{
  const std::string path = path_in(folder_, frame_file(point_frames, number));
  check_readable(path);
  FrameHead head;
  try {
    const Hdf5File file(path, Hdf5File::Mode::read);
    head = read_head(file);
    const auto sizes = file.read<std::int64_t>(root + "/NumberOfPoints");
    if (head.number != number || sizes.size() != 1) throw FileError("its name or size is not what is written in it");
    const auto version = file.integers(root, "Version");
    if (version.empty() || version[0] != known_version)
      throw FileError(fmt::format("it is of VTKHDF version {}, terp {} reads version {}", fmt::join(version, "."),
          TERP_VERSION, known_version));
    const auto fields = read_fields(file, sizes[0]);
    if (numbers_.empty()) n_points_ = sizes[0], run_ = head.run, fields_ = fields;
    const auto same = [](const ResultField& a, const ResultField& b) {
      return a.name == b.name && a.n_components == b.n_components;
    };
    if (head.run == run_ &&
        (sizes[0] != n_points_ || !std::equal(fields.begin(), fields.end(), fields_.begin(), fields_.end(), same)))
      throw FileError("its points or fields are not those of the other frames");
  } catch (const FileError& error) {
    return leave_out(path, error.what());
  }
  if (head.run != run_)
    throw FileError(fmt::format("cannot read {}: it is of a run of another case than the frames before it", path));
  numbers_.push_back(number);
  times_.push_back(head.time);
  steps_.push_back(head.step);
}

void Frames::leave_out_damaged()
{
  all_soil_.clear();
  for (std::size_t k = 0; k < numbers_.size();) {
    const std::string path = path_in(folder_, frame_file(point_frames, numbers_[k]));
    try {
      Hdf5File(path, Hdf5File::Mode::read).check_values();
      ++k;
    } catch (const FileError& error) {
      leave_out(path, error.what());
      const auto at = static_cast<std::ptrdiff_t>(k);
      numbers_.erase(numbers_.begin() + at);
      times_.erase(times_.begin() + at);
      steps_.erase(steps_.begin() + at);
    }
  }
  if (numbers_.empty()) throw FileError(fmt::format("{}: all of its frames are damaged", folder_));
}

void Frames::require_first_and_last() const
{
  for (const std::int64_t number : {std::int64_t{0}, std::max(last_in_index(folder_, point_frames), numbers_.back())}) {
    const std::string path = path_in(folder_, frame_file(point_frames, number));
    std::string fault;
    if (!std::ranges::binary_search(numbers_, number))
      fault = std::filesystem::exists(path) ? "it is damaged" : "it is missing";
    else
      try {
        Hdf5File(path, Hdf5File::Mode::read).check_values();
      } catch (const FileError& error) {
        fault = error.what();
      }
    if (!fault.empty())
      throw FileError(
          fmt::format("{}: {}\n  It has the {} of the run, and no other frame takes its place. Copy the "
                      "folder again, or solve the case again.",
              path, fault, number == 0 ? "start" : "end"));
  }
}

std::vector<Real> Frames::read_rows(const std::string& name, int n_components, std::size_t k) const
{
  if (k >= numbers_.size())
    throw FileError(fmt::format("{}: there is no frame {}, it has {}", folder_, k, numbers_.size()));
  const std::string path = path_in(folder_, frame_file(point_frames, numbers_[k]));
  const Hdf5File file(path, Hdf5File::Mode::read);
  if (file.text("/", "case") != run_)
    throw FileError(fmt::format("cannot read {}: it has become the file of another case", path));
  std::vector<Real> rows = file.read<Real>(name);
  if (std::ssize(rows) != n_points_ * n_components)
    throw FileError(fmt::format("cannot read {} in {}: it has {} values, {} points of {} are due", name, path,
        rows.size(), n_points_, n_components));
  all_soil_.resize(numbers_.size());
  if (!all_soil_[k]) all_soil_[k] = !leave_out_absent(file, rows);
  return rows;
}

std::vector<Real> Frames::places(std::size_t k) const
{
  const auto rows = read_rows(root + "/Points", 3, k);
  std::vector<Real> x(2 * static_cast<std::size_t>(n_points_));
  for (std::size_t p = 0; p < static_cast<std::size_t>(n_points_); ++p) {
    x[2 * p] = rows[3 * p];
    x[2 * p + 1] = rows[3 * p + 1];
  }
  return x;
}

std::vector<Real> Frames::read(std::string_view name, std::size_t k) const
{
  const ResultField& wanted = field(name);
  return read_rows(point_data + "/" + wanted.name, wanted.n_components, k);
}

const ResultField* Frames::find(std::string_view name) const
{
  const auto found = std::ranges::find_if(fields_, [&](const ResultField& f) { return f.name == name; });
  return found == fields_.end() ? nullptr : &*found;
}

const ResultField& Frames::field(std::string_view name) const
{
  if (const ResultField* found = find(name)) return *found;
  std::vector<std::string> names;
  for (const auto& f : fields_) names.push_back(f.name);
  throw CaseError(fmt::format("error: {} has no field `{}`\n  It has: {}\n", folder_, name, fmt::join(names, ", ")));
}

std::vector<Real> magnitudes(const std::vector<Real>& values, int n_components)
{
  const auto n = static_cast<std::size_t>(n_components);
  std::vector<Real> sizes(values.size() / n);
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    Real square = 0.0;
    for (std::size_t c = 0; c < n; ++c) square += values[n * p + c] * values[n * p + c];
    sizes[p] = std::sqrt(square);
  }
  return sizes;
}

}  // namespace terp
