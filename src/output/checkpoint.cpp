// checkpoint_<step>.h5: see checkpoint.hpp. Not compressed: speed counts more than size for a file of short life.
#include "output/checkpoint.hpp"

#include "base/errors.hpp"
#include "output/checksum.hpp"
#include "output/files.hpp"
#include "output/hdf5_file.hpp"
#include "output/run_folder.hpp"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <functional>
#include <numeric>
#include <sstream>

#include <fmt/format.h>

namespace terp {
namespace {

static_assert(std::endian::native == std::endian::little, "the checksum is over little-endian bytes");

constexpr std::int64_t format_version = 2;
const std::string format_name = "terp checkpoint";
const std::string arrays = "/arrays";

void check_shape(const NamedArray& array, const std::string& path)
{
  const std::size_t n_values = std::visit([](const auto& values) { return values.size(); }, array.values);
  const auto n_expected = std::accumulate(array.shape.begin(), array.shape.end(), std::int64_t{1}, std::multiplies<>());
  if (n_expected == static_cast<std::int64_t>(n_values)) return;
  throw FileError(fmt::format("cannot write {}: array `{}` holds {} values, its shape says {}", path, array.name,
                              n_values, n_expected));
}

void write_array(Hdf5File& file, const NamedArray& array)
{
  const auto write = [&]<class T>(const std::vector<T>& values) {
    file.write<T>(arrays + "/" + array.name, array.shape, values);
  };
  std::visit(write, array.values);
}

/// The names of the arrays in their order, one per line.
std::string join_names(const StateImage& image)
{
  std::string names;
  for (const auto& array : image.arrays) names += array.name + '\n';
  return names;
}

std::vector<std::string> split_names(const std::string& text)
{
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string name; std::getline(lines, name);) names.push_back(name);
  return names;
}

/// At least what a checkpoint takes on the disk.
std::int64_t largest_size(const StateImage& image)
{
  constexpr std::int64_t header_bytes = 16 << 10;
  std::int64_t n_bytes = header_bytes;
  for (const auto& array : image.arrays) {
    n_bytes += header_bytes + std::visit([](const auto& values) { return std::ssize(values) * 8; }, array.values);
  }
  return n_bytes;
}

void write_image(const std::string& path, const StateImage& image)
{
  Hdf5File file(path, Hdf5File::Mode::create, largest_size(image));
  file.set_text("/", "format", format_name);
  file.set_integers("/", "format_version", {format_version});
  file.set_text("/", "terp_version", TERP_VERSION);
  file.set_real("/", "time", image.time);
  file.set_text("/", "time_unit", "s");
  file.set_integers("/", "step", {image.step});
  file.create_group(arrays);
  file.set_text(arrays, "names", join_names(image));
  for (const auto& array : image.arrays) {
    check_shape(array, path);
    write_array(file, array);
  }
  file.set_text("/", "checksum", fmt::format("{:016x}", checksum_of(image)));
  file.close();
}

/// Throws unless the file is a checkpoint of a format that this version reads.
void check_format(const Hdf5File& file, const std::string& path)
{
  if (file.text("/", "format") != format_name) throw FileError(fmt::format("{} is not a checkpoint of Terp", path));
  const std::int64_t version = file.integers("/", "format_version").at(0);
  if (version == format_version) return;
  throw FileError(fmt::format(
      "cannot read {}: it has checkpoint format {}, written by terp {}; this is terp {}, which reads format {}", path,
      version, file.text("/", "terp_version"), TERP_VERSION, format_version));
}

NamedArray read_array(const Hdf5File& file, const std::string& name)
{
  const std::string place = arrays + "/" + name;
  NamedArray array{name, file.shape(place), {}};
  if (file.holds_reals(place))
    array.values = file.read<Real>(place);
  else
    array.values = file.read<std::int64_t>(place);
  return array;
}

/// Steps of the checkpoints in a folder, newest first.
std::vector<std::int64_t> steps_of_checkpoints(const std::string& folder)
{
  std::error_code error;
  std::vector<std::int64_t> steps;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::int64_t step = step_of_checkpoint(entry.path().filename().string());
    if (step >= 0) steps.push_back(step);
  }
  if (error) throw_file_error("open the run folder", folder, error.value());
  std::sort(steps.begin(), steps.end(), std::greater<>());
  return steps;
}

void remove_checkpoint(const std::string& folder, std::int64_t step)
{
  const std::string path = path_in(folder, checkpoint_file(step));
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error) throw_file_error("remove", path, error.value());
}

}  // namespace

std::uint64_t checksum_of(const StateImage& image)
{
  Fnv1a hash;
  hash.add(&image.time, sizeof image.time);
  hash.add(image.step);
  for (const auto& array : image.arrays) {
    hash.add(array.name.c_str(), array.name.size() + 1);        // with the zero that ends it
    hash.add(static_cast<std::int64_t>(array.values.index()));  // 0 real, 1 integer
    hash.add(std::ssize(array.shape));
    for (const std::int64_t n : array.shape) hash.add(n);
    std::visit([&](const auto& values) { hash.add(values.data(), values.size() * sizeof values[0]); }, array.values);
  }
  return hash.value();
}

void write_checkpoint(const std::string& path, const StateImage& image)
{
  write_whole(path, [&](const std::string& temporary) { write_image(temporary, image); });
}

StateImage read_checkpoint(const std::string& path)
{
  const Hdf5File file(path, Hdf5File::Mode::read);
  check_format(file, path);
  StateImage image;
  image.time = file.real("/", "time");
  image.step = file.integers("/", "step").at(0);
  for (const auto& name : split_names(file.text(arrays, "names"))) image.arrays.push_back(read_array(file, name));
  if (fmt::format("{:016x}", checksum_of(image)) != file.text("/", "checksum")) {
    throw FileError(fmt::format("cannot use {}: its checksum does not match; the file was altered or damaged", path));
  }
  return image;
}

CheckpointSearch newest_good_checkpoint(const std::string& folder)
{
  CheckpointSearch search;
  for (const std::int64_t step : steps_of_checkpoints(folder)) {
    search.path = path_in(folder, checkpoint_file(step));
    try {
      search.image = read_checkpoint(search.path);
      return search;
    } catch (const FileError& error) {
      search.skipped.push_back({search.path, error.what()});
    }
  }
  search.path.clear();
  return search;
}

void remove_old_checkpoints(const std::string& folder, Index n_kept)
{
  if (n_kept == 0) return;
  const auto steps = steps_of_checkpoints(folder);
  for (std::size_t k = static_cast<std::size_t>(n_kept); k < steps.size(); ++k) remove_checkpoint(folder, steps[k]);
}

void remove_checkpoints_after(const std::string& folder, std::int64_t step)
{
  for (const std::int64_t later : steps_of_checkpoints(folder)) {
    if (later > step) remove_checkpoint(folder, later);
  }
}

}  // namespace terp
