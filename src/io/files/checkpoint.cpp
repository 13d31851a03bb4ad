// Not compressed: speed counts more than size for a file of short life.
#include "io/files/checkpoint.hpp"

#include "math/errors.hpp"
#include "io/files/hdf5_file.hpp"
#include "io/files/run_folder.hpp"
#include "model/case/method_form.hpp"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <functional>
#include <new>
#include <numeric>
#include <sstream>

#include <fmt/format.h>

namespace terp {
namespace {

static_assert(std::endian::native == std::endian::little, "the checksum is over little-endian bytes");

constexpr std::int64_t format_version = 8;  // 7: [method] had other defaults
const std::string format_name = "terp checkpoint";
const std::string arrays = "/arrays", case_place = "/case", tables_place = "/tables";

void write_array(Hdf5File& file, const NamedArray& array)
{
  const auto write = [&]<class T>(const std::vector<T>& values) {
    file.write<T>(arrays + "/" + array.name, array.shape, values, array.first);
  };
  std::visit(write, array.values);
}

std::vector<std::string> split_names(const std::string& text)
{
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string name; std::getline(lines, name);) names.push_back(name);
  return names;
}

/// At least what a part takes on the disk.
std::int64_t largest_size(const StateImage& part)
{
  std::int64_t n_bytes = hdf5_header_bytes;
  for (const auto& array : part.arrays) {
    n_bytes += hdf5_header_bytes + std::visit([](const auto& values) { return std::ssize(values) * 8; }, array.values);
  }
  return n_bytes;
}

/// Adds the next part of an image to its checksum, and with the first what goes before the arrays.
void add_part(const StateImage& part, const std::string& case_record, const std::string& tables, Fnv1a& hash)
{
  if (part.part == 0) {
    hash.add(&part.time, sizeof part.time);
    hash.add(part.step);
    hash.add(case_record);
    hash.add(tables);
  }
  for (const auto& array : part.arrays) {
    if (array.first == 0) {
      hash.add(array.name.c_str(), array.name.size() + 1);        // with the zero that ends it
      hash.add(static_cast<std::int64_t>(array.values.index()));  // 0 real, 1 integer
      hash.add(std::ssize(array.shape));
      for (const std::int64_t n : array.shape) hash.add(n);
    }
    std::visit([&](const auto& values) { hash.add(values.data(), values.size() * sizeof values[0]); }, array.values);
  }
}

void write_text(Hdf5File& file, const std::string& place, const std::string& text)
{
  file.write<std::uint8_t>(
      place, {std::ssize(text)}, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void write_head(Hdf5File& file, const StateImage& part, const std::string& case_record, const std::string& tables)
{
  file.set_text("/", "format", format_name);
  file.set_integers("/", "format_version", {format_version});
  file.set_text("/", "terp_version", TERP_VERSION);
  file.set_real("/", "time", part.time);
  file.set_text("/", "time_unit", "s");
  file.set_integers("/", "step", {part.step});
  write_text(file, case_place, case_record);
  write_text(file, tables_place, tables);
  file.create_group(arrays);
}

void check_format(const Hdf5File& file, const std::string& path)
{
  if (file.text("/", "format") != format_name) throw FileError(fmt::format("{} is not a checkpoint of Terp", path));
  const std::int64_t version = file.integer("/", "format_version");
  if (version == format_version) return;
  throw FileError(fmt::format(
      "cannot read {}: it has checkpoint format {}, written by terp {}; this is terp {}, which reads format {}\n"
      "  Go on with the terp that wrote it, or solve the case anew.{}",
      path, version, file.text("/", "terp_version"), TERP_VERSION, format_version,
      version < format_version ? fmt::format("\n  {}", defaults_before) : ""));
}

/// The bytes of a file that nothing accounts for yet. A checkpoint is not compressed: what says that it holds more
/// would only take memory.
class Room {
 public:
  explicit Room(std::string path) : path_(std::move(path)), left_(static_cast<Real>(std::filesystem::file_size(path_)))
  {
  }

  void take(const std::string& place, const std::vector<std::int64_t>& shape, std::size_t n_bytes_each)
  {
    left_ -= std::accumulate(shape.begin(), shape.end(), static_cast<Real>(n_bytes_each),
        [](Real n, std::int64_t rows) { return n * static_cast<Real>(rows); });
    if (left_ < 0.0)
      throw FileError(fmt::format("cannot read {}: its values are more than it can hold, at {}", path_, place));
  }

 private:
  std::string path_;
  Real left_;
};

std::string read_text(const Hdf5File& file, const std::string& place, Room& room)
{
  room.take(place, file.shape(place), 1);
  const auto bytes = file.read<std::uint8_t>(place);
  return {bytes.begin(), bytes.end()};
}

NamedArray read_array(const Hdf5File& file, const std::string& name, Room& room)
{
  const std::string place = arrays + "/" + name;
  NamedArray array{name, file.shape(place), {}};
  room.take(place, array.shape, sizeof(Real));
  if (file.holds_reals(place))
    array.values = file.read<Real>(place);
  else
    array.values = file.read<std::int64_t>(place);
  return array;
}

std::vector<std::int64_t> steps_of_checkpoints(const std::string& folder)
{
  std::error_code error;
  std::vector<std::int64_t> steps;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::int64_t step = step_of_checkpoint(entry.path().filename().string());
    std::error_code unreadable;  // a pipe of that name would be waited for
    if (step >= 0 && entry.is_regular_file(unreadable)) steps.push_back(step);
  }
  if (error) throw_file_error("open the run folder", folder, error);
  std::ranges::sort(steps, std::greater<>());
  return steps;
}

void remove_checkpoint(const std::string& folder, std::int64_t step)
{
  const std::string path = path_in(folder, checkpoint_file(step));
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error) throw_file_error("remove", path, error);
}

}  // namespace

std::uint64_t checksum_of(const StateImage& image)
{
  Fnv1a hash;
  add_part(image, image.case_record, image.tables, hash);
  return hash.value();
}

CheckpointWriter::CheckpointWriter(std::string path, std::string case_record, std::string tables)
    : path_(std::move(path)), place_(path_), case_record_(std::move(case_record)), tables_(std::move(tables))
{
}

void CheckpointWriter::check_complete() const
{
  if (n_written_ == n_expected_) return;
  throw FileError(fmt::format(
      "cannot write {}: array `{}` holds {} values, its shape says {}", path_, array_, n_written_, n_expected_));
}

/// Counts the values of the array, or of the next of its rows, before they are written.
void CheckpointWriter::enter(const NamedArray& array)
{
  if (array.first == 0) {
    check_complete();
    array_ = array.name;
    names_ += array.name + '\n';
    n_written_ = 0;
    n_expected_ = std::accumulate(array.shape.begin(), array.shape.end(), std::int64_t{1}, std::multiplies<>());
  }
  n_written_ += std::visit([](const auto& values) { return std::ssize(values); }, array.values);
  if (n_written_ > n_expected_) check_complete();
}

void CheckpointWriter::write_part(const StateImage& part)
{
  Hdf5File file(place_.name(), part.part == 0 ? Hdf5File::Mode::create : Hdf5File::Mode::change,
      largest_size(part) + std::ssize(case_record_));
  if (part.part == 0) write_head(file, part, case_record_, tables_);
  for (const auto& array : part.arrays) {
    enter(array);
    write_array(file, array);
  }
  add_part(part, case_record_, tables_, checksum_);
  if (part.last) {
    check_complete();
    file.set_text(arrays, "names", names_);  // in their order, one per line
    file.set_text("/", "checksum", checksum_.digits());
  }
  file.close();
}

void CheckpointWriter::append(const StateImage& part)
{
  write_part(part);
  if (!part.last) return;
  place_.move_into_place();
}

StateImage read_checkpoint(const std::string& path)
{
  const Hdf5File file(path, Hdf5File::Mode::read);
  check_format(file, path);
  StateImage image;
  image.time = file.real("/", "time");
  image.step = file.integer("/", "step");
  Room room(path);
  image.case_record = read_text(file, case_place, room);
  image.tables = read_text(file, tables_place, room);
  for (const auto& name : split_names(file.text(arrays, "names"))) image.arrays.push_back(read_array(file, name, room));
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
    } catch (const std::bad_alloc&) {
      search.skipped.push_back({search.path, fmt::format("cannot read {}: not enough memory", search.path)});
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
