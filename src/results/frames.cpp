#include "results/frames.hpp"

#include "base/errors.hpp"
#include "input/case_file.hpp"
#include "output/committed_file.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

const std::string root = "/VTKHDF";
const std::string point_data = root + "/PointData";
constexpr std::int64_t most_columns = 1000;
constexpr std::int64_t known_version =
    2;  // the first number of the format's version; the second adds what an old reader passes over

/// Digits of the case that a file is of; empty if it does not say.
std::string case_of(const Hdf5File& file) { return file.has_attribute("/", "case") ? file.text("/", "case") : ""; }

}  // namespace

Frames::Frames(const std::string& path) : path_(path)
{
  read_between_commits(path_, [this] { read_contents(Hdf5File(path_, Hdf5File::Mode::read)); });
}

void Frames::read_contents(const Hdf5File& file)
{
  const auto version = file.integers(root, "Version");
  if (version.empty() || version[0] != known_version)
    throw FileError(
        fmt::format("cannot read {}: it is of VTKHDF version {}, terp {} reads version {}\n  A newer terp wrote it: "
                    "read it with that one.",
            path_, fmt::join(version, "."), TERP_VERSION, known_version));
  case_ = case_of(file);
  const std::string steps = root + "/Steps";
  n_points_ = file.read_rows<std::int64_t>(root + "/NumberOfPoints", 0, 1)[0];
  const std::int64_t n_frames = file.integer(steps, "NSteps");
  times_ = file.read_rows<Real>(steps + "/Values", 0, n_frames);
  steps_ = file.read_rows<std::int64_t>(steps + "/step", 0, n_frames);
  if (times_.empty() || n_points_ == 0)
    throw FileError(
        fmt::format("{}: it holds no {}; there is nothing to show", path_, times_.empty() ? "frame yet" : "points"));
  if (check_table(file, root + "/Points") != 3)
    throw FileError(fmt::format("cannot read {}: its points have no three coordinates", path_));
  fields_.clear();
  for (const auto& name : file.members(point_data)) {
    const std::string table = point_data + "/" + name;
    if (name != "id") fields_.push_back({name, file.text(table, "unit"), check_table(file, table)});
  }
}

int Frames::check_table(const Hdf5File& file, const std::string& name) const
{
  const auto shape = file.shape(name);
  const std::int64_t n_columns = shape.size() == 1 ? 1 : shape.size() == 2 ? shape[1] : 0;
  if (n_columns < 1 || n_columns > most_columns)
    throw FileError(fmt::format(
        "cannot read {} in {}: its shape is {}, no table of numbers per point", name, path_, fmt::join(shape, " x ")));
  if (n_points_ < 0 || (n_points_ > 0 && shape[0] / n_points_ < std::ssize(times_)))
    throw FileError(fmt::format("cannot read {} in {}: it has {} rows, {} frames of {} points take more", name, path_,
        shape[0], times_.size(), n_points_));
  return static_cast<int>(n_columns);
}

std::vector<Real> Frames::read_frame(const std::string& table, std::size_t k) const
{
  std::vector<Real> rows;
  read_between_commits(path_, [&] {
    const Hdf5File file(path_, Hdf5File::Mode::read);
    if (case_of(file) != case_)
      throw FileError(fmt::format("cannot read {}: it has become the file of another case", path_));
    rows = file.read_rows<Real>(table, static_cast<std::int64_t>(k) * n_points_, n_points_);
  });
  return rows;
}

std::vector<Real> Frames::places(std::size_t k) const
{
  const auto rows = read_frame(root + "/Points", k);
  std::vector<Real> x(2 * static_cast<std::size_t>(n_points_));
  for (std::size_t p = 0; p < static_cast<std::size_t>(n_points_); ++p) {
    x[2 * p] = rows[3 * p];
    x[2 * p + 1] = rows[3 * p + 1];
  }
  return x;
}

std::vector<Real> Frames::read(std::string_view name, std::size_t k) const
{
  return read_frame(point_data + "/" + field(name).name, k);
}

const ResultField* Frames::find(std::string_view name) const
{
  const auto found = std::find_if(fields_.begin(), fields_.end(), [&](const ResultField& f) { return f.name == name; });
  return found == fields_.end() ? nullptr : &*found;
}

const ResultField& Frames::field(std::string_view name) const
{
  if (const ResultField* found = find(name)) return *found;
  std::vector<std::string> names;
  for (const auto& f : fields_) names.push_back(f.name);
  throw CaseError(fmt::format("error: {} has no field `{}`\n  It has: {}\n", path_, name, fmt::join(names, ", ")));
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
