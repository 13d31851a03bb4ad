// The part of HDF5 that Terp needs, with errors that name the file. Only hdf5_file.cpp includes hdf5.h.
// Not for: what the datasets mean (vtkhdf, checkpoint).
#pragma once

#include "math/types.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace terp {

/// More than a dataset takes in a file besides its values.
inline constexpr std::int64_t hdf5_header_bytes = 16 << 10;

/// An HDF5 file. Objects are named by their path, e.g. "/VTKHDF/Points"; numbers are stored little-endian.
/// T is Real, std::int64_t or std::uint8_t. Every failure throws FileError.
///
/// What is read may come from anywhere: an attribute of another kind or number of values than asked for, and a dataset
/// that claims more values than the file can hold, or keeps them in another file, throw as well. Links to other files
/// are not followed.
///
/// The file is not locked, so that it can be looked at while a run writes it. No time stamps are stored: equal content
/// gives equal bytes.
class Hdf5File {
 public:
  enum class Mode { read, create, change };

  /// n_reserved: bytes that are set aside on the disk before anything is written; what is left over goes back on
  /// closing. HDF5 1.10 may lose the whole file, or crash, when it meets a full disk half way.
  Hdf5File(std::string path, Mode mode, std::int64_t n_reserved = 0);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// The destructor closes too, but cannot report that it fails (full disk).
  void close();

  /// With the groups above it.
  void create_group(const std::string& name);
  bool exists(const std::string& name) const;
  /// Names in a group, in the order of their creation.
  std::vector<std::string> members(const std::string& group) const;

  /// How a dataset lies on the disk. packed: in chunks, compressed (shuffle, deflate) and with a checksum (Fletcher-32)
  /// that every reader of HDF5 verifies; else as it lies in memory, without a checksum of its own.
  enum class Number { as_in_memory, float32, int32 };
  struct Layout {
    bool packed = false;
    Number number = Number::as_in_memory;
  };

  /// values: product of the entries of shape, row-major; or fewer rows, and the rest later, from `first_row` on. The
  /// groups in its name are made as needed.
  template <class T>
  void write(const std::string& name, const std::vector<std::int64_t>& shape, std::span<const T> values,
      std::int64_t first_row, Layout layout);
  template <class T>
  void write(const std::string& name, const std::vector<std::int64_t>& shape, std::span<const T> values,
      std::int64_t first_row = 0)
  {
    write(name, shape, values, first_row, Layout{});
  }
  template <class T>
  std::vector<T> read(const std::string& name) const;
  /// Reads every dataset once, so that all checksums are verified. Throws FileError at the first that does not agree.
  void check_values() const;
  std::vector<std::int64_t> shape(const std::string& name) const;
  /// True for floating-point numbers, false for whole ones.
  bool holds_reals(const std::string& name) const;

  void set_text(const std::string& object, const std::string& attribute, const std::string& value);
  void set_real(const std::string& object, const std::string& attribute, Real value);
  /// One value: a scalar; more: an array.
  void set_integers(const std::string& object, const std::string& attribute, const std::vector<std::int64_t>& values);
  std::string text(const std::string& object, const std::string& attribute) const;
  Real real(const std::string& object, const std::string& attribute) const;
  std::int64_t integer(const std::string& object, const std::string& attribute) const;
  std::vector<std::int64_t> integers(const std::string& object, const std::string& attribute) const;

 private:
  void make_group_of(const std::string& name);

  std::string path_;
  std::int64_t file_ = -1;  ///< HDF5's identifier
};

}  // namespace terp
