// The part of HDF5 that Terp needs: see hdf5_file.hpp.
#include "output/hdf5_file.hpp"

#include "base/errors.hpp"
#include "output/committed_file.hpp"
#include "output/files.hpp"
#include "output/hdf5_driver.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hdf5.h>
#include <algorithm>
#include <type_traits>
#include <utility>

namespace terp {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>, "Hdf5File keeps the identifier as std::int64_t");

/// An HDF5 identifier that closes itself.
class Id {
 public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Id()
  {
    if (id_ >= 0) close_(id_);
  }
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  operator hid_t() const { return id_; }
  herr_t close() { return close_(release()); }
  hid_t release() { return std::exchange(id_, -1); }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

herr_t keep_first_description(unsigned, const H5E_error2_t* error, void* text)
{
  auto& first = *static_cast<std::string*>(text);
  if (first.empty() && error->desc) first = error->desc;
  return 0;
}

/// Why the last HDF5 call failed: the system's words where there are any, else the innermost of HDF5's own.
std::string reason()
{
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first_description, &text);
  const std::string mark = "error message = '";
  const auto begin = text.find(mark);
  if (begin == std::string::npos) return text.empty() ? "unknown HDF5 error" : text;
  return text.substr(begin + mark.size(), text.find('\'', begin + mark.size()) - begin - mark.size());
}

/// Passes a result of HDF5 on; a negative one becomes a FileError.
template <class Result>
Result checked(Result result, std::string_view doing, const std::string& path, const std::string& object = "")
{
  if (result >= 0) return result;
  const std::string why = reason();
  throw FileError(object.empty() ? fmt::format("cannot {} {}: {}", doing, path, why)
                                 : fmt::format("cannot {} {} in {}: {}", doing, object, path, why));
}

/// Closes what was written. HDF5 may keep values back until here, so this is where a full disk is noticed.
void finish(Id& dataset, const std::string& path, const std::string& name)
{
  checked(dataset.close(), "write", path, name);
}

template <class T>
hid_t memory_type()
{
  if constexpr (std::is_same_v<T, Real>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

template <class T>
hid_t disk_type()
{
  if constexpr (std::is_same_v<T, Real>) return H5T_IEEE_F64LE;
  if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_STD_U8LE;
}

std::vector<hsize_t> to_hsize(const std::vector<std::int64_t>& shape) { return {shape.begin(), shape.end()}; }

Id make_space(const std::vector<hsize_t>& shape)
{
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose};
}

std::vector<hsize_t> extent_of(hid_t space)
{
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

[[noreturn]] void refuse(const std::string& path, const std::string& object, const std::string& why)
{
  throw FileError(fmt::format("cannot read {} in {}: {}", object, path, why));
}

/// A dataset whose values lie in this file: in another they may be a pipe, which would be waited for without end, or
/// somebody else's.
Id open_dataset(hid_t file, const std::string& path, const std::string& name)
{
  Id dataset{checked(H5Dopen2(file, name.c_str(), H5P_DEFAULT), "open", path, name), H5Dclose};
  const Id properties{H5Dget_create_plist(dataset), H5Pclose};
  if (H5Pget_layout(properties) == H5D_VIRTUAL || H5Pget_external_count(properties) > 0)
    refuse(path, name, "its values are in another file");
  return dataset;
}

/// Rows and columns of a table; 1 column where it has one dimension.
std::pair<std::int64_t, hsize_t> size_of_table(
    const std::vector<hsize_t>& extent, const std::string& path, const std::string& name)
{
  if (extent.empty() || extent.size() > 2 || (extent.size() == 2 && extent[1] == 0))
    refuse(path, name, "it is no table");
  return {static_cast<std::int64_t>(extent[0]), extent.size() == 2 ? extent[1] : 1};
}

/// Most values that one stored value can stand for: deflate shrinks 1032 times at best, what is not compressed does not
/// shrink.
hsize_t greatest_compression(hid_t properties)
{
  const bool compressed = H5Pget_layout(properties) == H5D_CHUNKED && H5Pget_nfilters(properties) > 0;
  return compressed ? 1032 : 1;
}

/// True if a box of this shape has no more than `most` items.
bool has_at_most(hsize_t most, const std::vector<hsize_t>& shape)
{
  if (std::find(shape.begin(), shape.end(), 0u) != shape.end()) return true;
  for (const hsize_t n : shape) most /= n;  // divided instead of multiplied, which may overflow
  return most > 0;
}

/// Throws where a dataset asks for more than its file can hold, in values, in values per chunk or in chunks (HDF5 takes
/// some 400 bytes for each to read them): memory is asked for by what it says.
void check_size(
    hid_t dataset, hid_t file, std::size_t n_bytes_in_memory, const std::string& path, const std::string& name)
{
  const Id properties{H5Dget_create_plist(dataset), H5Pclose};
  const std::vector<hsize_t> extent = extent_of(Id{H5Dget_space(dataset), H5Sclose});
  std::vector<hsize_t> chunk = extent, n_chunks(extent.size(), 1);
  if (H5Pget_layout(properties) == H5D_CHUNKED) {
    H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
    for (std::size_t k = 0; k < chunk.size(); ++k) n_chunks[k] = extent[k] / chunk[k] + (extent[k] % chunk[k] > 0);
  }
  hsize_t n_bytes = 0;
  checked(H5Fget_filesize(file, &n_bytes), "read", path);
  const hsize_t size = std::max<hsize_t>(n_bytes_in_memory, H5Tget_size(Id{H5Dget_type(dataset), H5Tclose}));
  const hsize_t most = n_bytes * greatest_compression(properties) / size, most_chunks = n_bytes / sizeof(haddr_t);
  if (has_at_most(most, extent) && has_at_most(most, chunk) && has_at_most(most_chunks, n_chunks)) return;
  refuse(path, name,
      fmt::format("its shape is {} in pieces of {}, more than a file of {} bytes can hold", fmt::join(extent, " x "),
          fmt::join(chunk, " x "), n_bytes));
}

/// A dataset that can be read into memory.
Id open_to_read(hid_t file, std::size_t n_bytes_in_memory, const std::string& path, const std::string& name)
{
  Id dataset = open_dataset(file, path, name);
  check_size(dataset, file, n_bytes_in_memory, path, name);
  return dataset;
}

/// Opens an attribute for writing. One that is there is written in place if its type and size are the same.
Id make_attribute(hid_t object, const std::string& name, hid_t type, hid_t space)
{
  if (H5Aexists(object, name.c_str()) > 0) {
    Id there{H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose};
    const bool same_type = H5Tequal(Id{H5Aget_type(there), H5Tclose}, type) > 0;
    if (same_type && H5Sextent_equal(Id{H5Aget_space(there), H5Sclose}, space) > 0) return there;
    H5Adelete(object, name.c_str());
  }
  return {H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
}

/// File access: no lock; metadata with checksums (format of HDF5 1.8), so that a damaged file is noticed on opening.
Id access_properties()
{
  Id access{H5Pcreate(H5P_FILE_ACCESS), H5Pclose};
  H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
  H5Pset_file_locking(access, false, true);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST);
  return access;
}

/// A file with nothing in it, on a disk that has room for n_reserved bytes.
void make_empty(const std::string& path, std::int64_t n_reserved)
{
  if (n_reserved > 0) {
    const AppendFile made{path};
    reserve_space(path, n_reserved);
  }
  const Id access = access_properties();
  Id made{H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose};
  checked<hid_t>(made, "write", path);
  checked(made.close(), "write", path);
}

hid_t open_existing(const std::string& path, bool change)
{
  const Id access = access_properties();
  return checked(
      H5Fopen(path.c_str(), change ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access), change ? "change" : "read", path);
}

/// A file that keeps its old content until it is closed.
hid_t open_committed(const std::string& path, std::int64_t n_reserved)
{
  finish_commit(path);
  const Id access = access_properties();
  use_committed_driver(access);
  Id file{checked(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), "change", path), H5Fclose};
  start_changes(file, n_reserved);
  return file.release();
}

hid_t open_file(const std::string& path, Hdf5File::Mode mode, std::int64_t n_reserved)
{
  static const herr_t without_exit_handler =
      H5dont_atexit();  // at exit HDF5 1.10 would close once more, and crash on, a file whose closing failed
  static_cast<void>(without_exit_handler);
  static const herr_t without_links_to_other_files = (H5open(), H5Lunregister(H5L_TYPE_EXTERNAL));
  static_cast<void>(without_links_to_other_files);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown, not printed
  if (mode != Hdf5File::Mode::create) check_is_file(path);
  if (mode == Hdf5File::Mode::commit) return open_committed(path, n_reserved);
  if (mode == Hdf5File::Mode::create) make_empty(path, n_reserved);
  if (n_reserved > 0) reserve_space(path, n_reserved);
  return open_existing(path, mode != Hdf5File::Mode::read);
}

}  // namespace

Hdf5File::Hdf5File(std::string path, Mode mode, std::int64_t n_reserved)
    : path_(std::move(path)), mode_(mode), file_(open_file(path_, mode, n_reserved))
{
}

Hdf5File::~Hdf5File()
{
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5File::flush() { checked(H5Fflush(file_, H5F_SCOPE_LOCAL), "write", path_); }

void Hdf5File::close()
{
  flush();
  if (mode_ == Mode::commit) commit_on_close(file_);
  const hid_t file = file_;
  file_ = -1;
  checked(H5Fclose(file), "write", path_);
}

void Hdf5File::create_group(const std::string& name)
{
  const Id properties{H5Pcreate(H5P_GROUP_CREATE), H5Pclose};
  H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const Id group{H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose};
  checked<hid_t>(group, "create", path_, name);
}

bool Hdf5File::exists(const std::string& name) const { return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0; }

std::vector<std::string> Hdf5File::members(const std::string& group) const
{
  const Id opened{checked(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), "open", path_, group), H5Gclose};
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  checked(H5Literate(opened, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, add, &names), "list", path_, group);
  return names;
}

template <class T>
void Hdf5File::create_table(const std::string& name, const TableLayout& layout)
{
  const int rank = layout.n_columns == 0 ? 1 : 2;
  const auto n_columns = static_cast<hsize_t>(layout.n_columns);
  const hsize_t start[] = {0, n_columns};
  const hsize_t limit[] = {H5S_UNLIMITED, n_columns};
  const hsize_t chunk[] = {static_cast<hsize_t>(std::max<std::int64_t>(1, layout.chunk_rows)), n_columns};
  const Id space{H5Screate_simple(rank, start, limit), H5Sclose};
  const Id properties{H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
  H5Pset_chunk(properties, rank, chunk);
  if (layout.compression > 0) {
    H5Pset_shuffle(properties);
    H5Pset_deflate(properties, static_cast<unsigned>(layout.compression));
  }
  Id table{H5Dcreate2(file_, name.c_str(), disk_type<T>(), space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose};
  checked<hid_t>(table, "create", path_, name);
  finish(table, path_, name);
}

template <class T>
void Hdf5File::write_rows(const std::string& name, std::int64_t first_row, std::span<const T> values)
{
  Id table = open_dataset(file_, path_, name);
  std::vector<hsize_t> count = extent_of(Id{H5Dget_space(table), H5Sclose});
  count[0] = values.size() / size_of_table(count, path_, name).second;
  std::vector<hsize_t> extent = count, start(count.size(), 0);
  start[0] = static_cast<hsize_t>(first_row);
  extent[0] = start[0] + count[0];
  checked(H5Dset_extent(table, extent.data()), "extend", path_, name);
  const Id space{H5Dget_space(table), H5Sclose};
  H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const Id memory = make_space(count);
  checked(H5Dwrite(table, memory_type<T>(), memory, space, H5P_DEFAULT, values.data()), "write", path_, name);
  finish(table, path_, name);
}

void Hdf5File::cut_rows(const std::string& name, std::int64_t n_rows)
{
  Id table = open_dataset(file_, path_, name);
  std::vector<hsize_t> extent = extent_of(Id{H5Dget_space(table), H5Sclose});
  extent[0] = static_cast<hsize_t>(std::min(size_of_table(extent, path_, name).first, n_rows));
  checked(H5Dset_extent(table, extent.data()), "cut", path_, name);
  finish(table, path_, name);
}

template <class T>
void Hdf5File::write(
    const std::string& name, const std::vector<std::int64_t>& shape, std::span<const T> values, std::int64_t first_row)
{
  const Id links{H5Pcreate(H5P_LINK_CREATE), H5Pclose};
  H5Pset_create_intermediate_group(links, 1);
  const auto make = [&] {
    return H5Dcreate2(
        file_, name.c_str(), disk_type<T>(), make_space(to_hsize(shape)), links, H5P_DEFAULT, H5P_DEFAULT);
  };
  Id dataset = first_row == 0 ? Id{checked(make(), "create", path_, name), H5Dclose} : open_dataset(file_, path_, name);
  const Id space{H5Dget_space(dataset), H5Sclose};
  std::vector<hsize_t> count = to_hsize(shape), start(count.size(), 0);
  if (const hssize_t n_values = H5Sget_simple_extent_npoints(space); !count.empty() && n_values > 0) {
    start[0] = static_cast<hsize_t>(first_row);
    count[0] = values.size() * count[0] / static_cast<hsize_t>(n_values);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  }
  checked(
      H5Dwrite(dataset, memory_type<T>(), make_space(count), space, H5P_DEFAULT, values.data()), "write", path_, name);
  finish(dataset, path_, name);
}

template <class T>
std::vector<T> Hdf5File::read(const std::string& name) const
{
  const Id dataset = open_to_read(file_, sizeof(T), path_, name);
  const Id space{H5Dget_space(dataset), H5Sclose};
  std::vector<T> values(static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space), "read", path_, name)));
  checked(H5Dread(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read", path_, name);
  return values;
}

template <class T>
std::vector<T> Hdf5File::read_rows(const std::string& name, std::int64_t first_row, std::int64_t n_rows) const
{
  const Id table = open_to_read(file_, sizeof(T), path_, name);
  const Id space{H5Dget_space(table), H5Sclose};
  std::vector<hsize_t> count = extent_of(space), start(count.size(), 0);
  const auto [n_there, n_columns] = size_of_table(count, path_, name);
  if (first_row < 0 || n_rows < 0 || n_rows > n_there - first_row)
    throw FileError(fmt::format(
        "cannot read rows {} to {} of {} in {}: it has {}", first_row, first_row + n_rows - 1, name, path_, n_there));
  start[0] = static_cast<hsize_t>(first_row);
  count[0] = static_cast<hsize_t>(n_rows);
  H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
  const Id memory = make_space(count);
  std::vector<T> values(static_cast<std::size_t>(n_rows) * n_columns);
  checked(H5Dread(table, memory_type<T>(), memory, space, H5P_DEFAULT, values.data()), "read", path_, name);
  return values;
}

std::vector<std::int64_t> Hdf5File::shape(const std::string& name) const
{
  const Id dataset = open_dataset(file_, path_, name);
  const auto extent = extent_of(Id{H5Dget_space(dataset), H5Sclose});
  return {extent.begin(), extent.end()};
}

bool Hdf5File::holds_reals(const std::string& name) const
{
  const Id dataset = open_dataset(file_, path_, name);
  return H5Tget_class(Id{H5Dget_type(dataset), H5Tclose}) == H5T_FLOAT;
}

void Hdf5File::set_text(const std::string& object, const std::string& attribute, const std::string& value)
{
  const Id opened{checked(H5Oopen(file_, object.c_str(), H5P_DEFAULT), "open", path_, object), H5Oclose};
  const Id type{H5Tcopy(H5T_C_S1), H5Tclose};  // ASCII, fixed length
  H5Tset_size(type, std::max<std::size_t>(1, value.size()));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const Id made = make_attribute(opened, attribute, type, Id{H5Screate(H5S_SCALAR), H5Sclose});
  checked(H5Awrite(made, type, value.c_str()), "write", path_, attribute);
}

void Hdf5File::set_real(const std::string& object, const std::string& attribute, Real value)
{
  const Id opened{checked(H5Oopen(file_, object.c_str(), H5P_DEFAULT), "open", path_, object), H5Oclose};
  const Id made = make_attribute(opened, attribute, H5T_IEEE_F64LE, Id{H5Screate(H5S_SCALAR), H5Sclose});
  checked(H5Awrite(made, H5T_NATIVE_DOUBLE, &value), "write", path_, attribute);
}

void Hdf5File::set_integers(
    const std::string& object, const std::string& attribute, const std::vector<std::int64_t>& values)
{
  const Id opened{checked(H5Oopen(file_, object.c_str(), H5P_DEFAULT), "open", path_, object), H5Oclose};
  const Id space = values.size() == 1 ? make_space({}) : make_space({values.size()});
  const Id made = make_attribute(opened, attribute, H5T_STD_I64LE, space);
  checked(H5Awrite(made, H5T_NATIVE_INT64, values.data()), "write", path_, attribute);
}

namespace {

Id open_attribute(hid_t file, const std::string& path, const std::string& object, const std::string& name)
{
  return {checked(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "find", path, name),
      H5Aclose};
}

std::size_t count_values(hid_t attribute)
{
  return static_cast<std::size_t>(
      std::max<hssize_t>(0, H5Sget_simple_extent_npoints(Id{H5Aget_space(attribute), H5Sclose})));
}

/// The one value of an attribute.
template <class T>
T read_single(hid_t file, const std::string& path, const std::string& object, const std::string& attribute)
{
  const Id opened = open_attribute(file, path, object, attribute);
  if (const std::size_t n = count_values(opened); n != 1)
    refuse(path, attribute, fmt::format("it has {} values, one is expected", n));
  T value{};
  checked(H5Aread(opened, memory_type<T>(), &value), "read", path, attribute);
  return value;
}

}  // namespace

bool Hdf5File::has_attribute(const std::string& object, const std::string& attribute) const
{
  return H5Aexists_by_name(file_, object.c_str(), attribute.c_str(), H5P_DEFAULT) > 0;
}

std::string Hdf5File::text(const std::string& object, const std::string& attribute) const
{
  const Id opened = open_attribute(file_, path_, object, attribute);
  const Id type{H5Aget_type(opened), H5Tclose};
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 || count_values(opened) != 1)
    refuse(path_, attribute, "it is no text of fixed length");
  std::string value(H5Tget_size(type), '\0');
  checked(H5Aread(opened, type, value.data()), "read", path_, attribute);
  return value.substr(0, value.find('\0'));
}

Real Hdf5File::real(const std::string& object, const std::string& attribute) const
{
  return read_single<Real>(file_, path_, object, attribute);
}

std::vector<std::int64_t> Hdf5File::integers(const std::string& object, const std::string& attribute) const
{
  const Id opened = open_attribute(file_, path_, object, attribute);
  std::vector<std::int64_t> values(count_values(opened));
  checked(H5Aread(opened, H5T_NATIVE_INT64, values.data()), "read", path_, attribute);
  return values;
}

std::int64_t Hdf5File::integer(const std::string& object, const std::string& attribute) const
{
  return read_single<std::int64_t>(file_, path_, object, attribute);
}

#define TERP_HDF5_TYPE(T)                                                                      \
  template void Hdf5File::create_table<T>(const std::string&, const TableLayout&);             \
  template void Hdf5File::write_rows<T>(const std::string&, std::int64_t, std::span<const T>); \
  template void Hdf5File::write<T>(                                                            \
      const std::string&, const std::vector<std::int64_t>&, std::span<const T>, std::int64_t); \
  template std::vector<T> Hdf5File::read<T>(const std::string&) const;                         \
  template std::vector<T> Hdf5File::read_rows<T>(const std::string&, std::int64_t, std::int64_t) const;
TERP_HDF5_TYPE(Real)
TERP_HDF5_TYPE(std::int64_t)
TERP_HDF5_TYPE(std::uint8_t)
#undef TERP_HDF5_TYPE

}  // namespace terp
