#include "results/npz.hpp"

#include "output/compress.hpp"

#include <bit>
#include <stdexcept>

namespace terp {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

constexpr std::uint16_t zip_version = 20;  // 2.0: the least that folders and stored files need (APPNOTE 4.4.3)
constexpr std::uint16_t first_day = 33;    // 1 January 1980 in the format of MS-DOS: equal arrays give equal files

/// Appends a number, little-endian.
template <class T>
void put(std::string& bytes, T value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// NPY format 1.0: magic, length of the header, a Python dictionary padded to a multiple of 64, the values.
std::string npy(const char* type, const std::vector<std::int64_t>& shape, std::string_view values)
{
  std::string header = std::string("{'descr': '") + type + "', 'fortran_order': False, 'shape': (";
  for (const std::int64_t n : shape) header += std::to_string(n) + ",";
  header += "), }";
  constexpr std::size_t before = 10;  // magic, version, length
  header.append(63 - (before + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  put(bytes, static_cast<std::uint16_t>(header.size()));
  bytes += header;
  bytes += values;
  return bytes;
}

/// What local header and directory entry share (APPNOTE 4.3.7): versions, flags, method 0 (stored), time, checksum,
/// sizes, lengths.
std::string entry_head(const std::string& name, const std::string& member)
{
  std::string bytes;
  for (const std::uint16_t v : {zip_version, std::uint16_t{0}, std::uint16_t{0}, std::uint16_t{0}, first_day})
    put(bytes, v);
  const auto size = static_cast<std::uint32_t>(member.size());
  for (const std::uint32_t v : {crc32_of(member), size, size}) put(bytes, v);
  put(bytes, static_cast<std::uint16_t>(name.size()));
  put(bytes, std::uint16_t{0});
  return bytes;
}

}  // namespace

void NpzFile::add(const std::string& name, const std::vector<std::int64_t>& shape, std::span<const Real> values)
{
  members_.emplace_back(name + ".npy", npy("<f8", shape, bytes_of(values)));
}

void NpzFile::add(const std::string& name, const std::vector<std::int64_t>& shape, std::span<const std::int64_t> values)
{
  members_.emplace_back(name + ".npy", npy("<i8", shape, bytes_of(values)));
}

std::string NpzFile::bytes() const
{
  std::string file, directory;
  for (const auto& [name, member] : members_) {
    const std::string head = entry_head(name, member);
    directory += std::string("PK\x01\x02", 4);
    put(directory, zip_version);
    directory += head;
    directory += std::string(10, '\0');  // comment, disk, attributes
    put(directory, static_cast<std::uint32_t>(file.size()));
    directory += name;
    file += std::string("PK\x03\x04", 4) + head + name + member;
    if (file.size() > 0xffffffffu) throw std::length_error("more than 4 GB in one .npz file");
  }
  const auto n = static_cast<std::uint16_t>(members_.size());
  const auto start = static_cast<std::uint32_t>(file.size());
  file += directory + std::string("PK\x05\x06\0\0\0\0", 8);
  put(file, n);
  put(file, n);
  put(file, static_cast<std::uint32_t>(directory.size()));
  put(file, start);
  put(file, std::uint16_t{0});
  return file;
}

}  // namespace terp
