// The part of HDF5 that Terp needs, with errors that name the file. Only hdf5_file.cpp includes hdf5.h.
// Not for: what the datasets mean (vtkhdf, checkpoint).
#pragma once

#include "base/types.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace terp {

/// An HDF5 file. Objects are named by their path, e.g. "/VTKHDF/Points"; numbers are stored little-endian.
/// T is Real, std::int64_t or std::uint8_t. Every failure throws FileError.
///
/// What is read may come from anywhere: an attribute of another kind or number of values than asked for, and a dataset
/// that claims more values than the file can hold, or keeps them in another file, throw as well. Links to other files
/// are not followed.
///
/// The file is not locked, so that it can be looked at while a run writes it. One that is opened with Mode::commit is
/// left with the old content or the new, whatever happens (committed_file.hpp).
class Hdf5File {
 public:
  /// commit: an existing file that keeps its old content until `close`.
  enum class Mode { read, create, change, commit };

  /// n_reserved: bytes that are set aside on the disk before anything is written; what is left over goes back on
  /// closing. HDF5 1.10 may lose the whole file, or crash, when it meets a full disk half way.
  Hdf5File(std::string path, Mode mode, std::int64_t n_reserved = 0);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  void flush();
  /// The destructor closes too, but cannot say when that fails (full disk), and drops the changes of Mode::commit.
  void close();

  void create_group(const std::string& name);
  bool exists(const std::string& name) const;
  /// Names in a group, in the order of their creation.
  std::vector<std::string> members(const std::string& group) const;

  /// A table grows by rows. n_columns = 0: one-dimensional, shape [n_rows]; else shape [n_rows, n_columns].
  struct TableLayout {
    std::int64_t n_columns = 0;
    std::int64_t chunk_rows = 64;
    int compression = 0;  ///< deflate level after shuffling bytes; 0: none
  };
  template <class T>
  void create_table(const std::string& name, const TableLayout& layout);
  /// Writes rows first_row... and makes them the last of the table.
  template <class T>
  void write_rows(const std::string& name, std::int64_t first_row, std::span<const T> values);
  /// Drops the rows after the first n_rows.
  void cut_rows(const std::string& name, std::int64_t n_rows);

  /// A dataset that does not grow; groups in its name are made as needed. values: product of shape entries, row-major;
  /// or fewer rows, and the rest later, from `first_row` on.
  template <class T>
  void write(const std::string& name, const std::vector<std::int64_t>& shape, std::span<const T> values,
      std::int64_t first_row = 0);
  template <class T>
  std::vector<T> read(const std::string& name) const;
  /// Rows first_row ... first_row + n_rows - 1 of a table, row-major. Throws FileError if it has fewer.
  template <class T>
  std::vector<T> read_rows(const std::string& name, std::int64_t first_row, std::int64_t n_rows) const;
  std::vector<std::int64_t> shape(const std::string& name) const;
  /// True for floating-point numbers, false for whole ones.
  bool holds_reals(const std::string& name) const;

  void set_text(const std::string& object, const std::string& attribute, const std::string& value);
  void set_real(const std::string& object, const std::string& attribute, Real value);
  /// One value: a scalar; more: an array.
  void set_integers(const std::string& object, const std::string& attribute, const std::vector<std::int64_t>& values);
  bool has_attribute(const std::string& object, const std::string& attribute) const;
  std::string text(const std::string& object, const std::string& attribute) const;
  Real real(const std::string& object, const std::string& attribute) const;
  std::int64_t integer(const std::string& object, const std::string& attribute) const;
  std::vector<std::int64_t> integers(const std::string& object, const std::string& attribute) const;

 private:
  std::string path_;
  Mode mode_;
  std::int64_t file_ = -1;  ///< HDF5's identifier
};

}  // namespace terp
