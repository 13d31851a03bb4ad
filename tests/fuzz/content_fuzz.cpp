// Checkpoints that HDF5 takes for sound, with anything in the place of what belongs there: they give an image, or a
// FileError. HDF5's checksums keep the changes of checkpoint_fuzz.cpp from what lies behind them. Each byte of the
// input decides how the next item of the file is written.
#include "math/errors.hpp"
#include "io/files/checkpoint.hpp"
#include "io/files/hdf5_file.hpp"
#include "scratch_file.hpp"

#include <algorithm>

namespace {

using namespace terp;
using Integers = std::vector<std::int64_t>;

/// The bytes of the input, then zeros.
class Bytes {
 public:
  Bytes(const unsigned char* data, std::size_t size) : next_(data), end_(data + size) {}
  unsigned char operator()() { return next_ == end_ ? 0 : *next_++; }

 private:
  const unsigned char *next_, *end_;
};

std::int64_t strange_number(unsigned char which)
{
  const std::int64_t numbers[] = {
      -1, 0, 2, 3, 4, 5, 1000, std::int64_t{1} << 32, std::int64_t{1} << 61, INT64_MAX, INT64_MIN};
  return numbers[which % std::size(numbers)];
}

template <class T>
void write_shaped(Hdf5File& file, const std::string& name, Bytes& bytes)
{
  Integers shape(bytes() % 4u);
  std::size_t n = 1;
  for (std::int64_t& rows : shape) n *= static_cast<std::size_t>(rows = bytes() % 9);
  file.write<T>(name, shape, std::vector<T>(n, static_cast<T>(bytes())));
}

/// A table of which only the first row is written, of a size that may be far off.
template <class T>
void write_far(Hdf5File& file, const std::string& name, Bytes& bytes)
{
  const std::int64_t n_columns = bytes() % 3;
  const std::vector<std::int64_t> shape{std::int64_t{1} << (bytes() % 31), std::max<std::int64_t>(1, n_columns)};
  file.write<T>(name, shape, std::vector<T>(static_cast<std::size_t>(shape[1]), T{1}), 0, {.packed = true});
}

void write_values(Hdf5File& file, const std::string& name, unsigned char how, Bytes& bytes)
{
  switch (how % 7) {
    case 0: return write_shaped<Real>(file, name, bytes);
    case 1: return write_shaped<std::int64_t>(file, name, bytes);
    case 2: return write_shaped<std::uint8_t>(file, name, bytes);
    case 3: return write_far<Real>(file, name, bytes);
    case 4: return write_far<std::int64_t>(file, name, bytes);
    case 5: return file.create_group(name);
    default: return;  // left out
  }
}

void set_value(Hdf5File& file, const std::string& object, const std::string& name, unsigned char how, Bytes& bytes)
{
  switch (how % 6) {
    case 0: return file.set_text(object, name, std::string(bytes(), static_cast<char>(bytes())));
    case 1: return file.set_real(object, name, static_cast<Real>(strange_number(bytes())));
    case 2: return file.set_integers(object, name, {strange_number(bytes())});
    case 3: return file.set_integers(object, name, Integers(bytes() * 31u, strange_number(bytes())));
    case 4: return file.set_text(object, name, "a\nb\n\n/\n.\n../case\n" + std::string(bytes() * 250u, 'a'));
    default: return;  // left out
  }
}

/// Writes one item of a checkpoint; as it should be where the byte for it is even.
template <class Write>
bool as_it_should_be(Bytes& bytes, Write&& write_otherwise)
{
  const unsigned char how = bytes();
  if (how % 2 == 0) return true;
  write_otherwise(static_cast<unsigned char>(how / 2));
  return false;
}

void write_file(const std::string& path, Bytes bytes)
{
  Hdf5File file(path, Hdf5File::Mode::create);
  const auto attribute = [&](const std::string& object, const std::string& name, auto&& write) {
    if (as_it_should_be(bytes, [&](unsigned char how) { set_value(file, object, name, how, bytes); })) write();
  };
  const auto dataset = [&](const std::string& name, auto&& write) {
    if (as_it_should_be(bytes, [&](unsigned char how) { write_values(file, name, how, bytes); })) write();
  };
  attribute("/", "format", [&] { file.set_text("/", "format", "terp checkpoint"); });
  attribute("/", "format_version", [&] { file.set_integers("/", "format_version", {8 - bytes() % 2}); });
  attribute("/", "terp_version", [&] { file.set_text("/", "terp_version", "0.1.0"); });
  attribute("/", "time", [&] { file.set_real("/", "time", 0.5); });
  attribute("/", "step", [&] { file.set_integers("/", "step", {500}); });
  const std::vector<std::uint8_t> text{'a', '\n'};
  dataset("/case", [&] { file.write<std::uint8_t>("/case", {2}, text); });
  dataset("/tables", [&] { file.write<std::uint8_t>("/tables", {2}, text); });
  if (bytes() != 1) file.create_group("/arrays");
  dataset("/arrays/a", [&] { file.write<Real>("/arrays/a", {2, 2}, std::vector<Real>{1.0, 2.0, 3.0, 4.0}); });
  dataset("/arrays/b", [&] { file.write<std::int64_t>("/arrays/b", {2}, std::vector<std::int64_t>{5, 6}); });
  attribute(file.exists("/arrays") ? "/arrays" : "/", "names",
      [&] { file.set_text(file.exists("/arrays") ? "/arrays" : "/", "names", "a\nb\n"); });
  attribute("/", "checksum", [&] { file.set_text("/", "checksum", "0123456789abcdef"); });
  file.close();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  static const std::string path = test::scratch_file();
  try {
    write_file(path, {data, size});
  } catch (const FileError&) {  // HDF5 does not write this
    return 0;
  }
  try {
    read_checkpoint(path);
  } catch (const FileError&) {
  }
  return 0;
}
