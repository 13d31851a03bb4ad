// What is written may fail as late as at closing, when HDF5 writes what it kept back. So datasets are closed by
// finish() and the file by close(), which throw; destructors are for what has failed already. Each public function
// takes its turn; turns of one thread may be nested.

#include "io/files/hdf5_file.hpp"

#include "math/errors.hpp"
#include "io/files/files.hpp"
#include "os/turn.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hdf5.h>
#include <algorithm>
#include <type_traits>
#include <utility>

namespace terp {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>, "Hdf5File keeps the identifier as std::int64_t");

/// HDF5 may have been built without locks of its own, as for Windows, and a run writes frames of points and of the mesh
/// in two threads.
using Hdf5Turn = Turn<Hdf5File>;

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
hid_t disk_type(Hdf5File::Number number)
{
  if (number == Hdf5File::Number::float32) return H5T_IEEE_F32LE;
  if (number == Hdf5File::Number::int32) return H5T_STD_I32LE;
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
  if (std::ranges::find(shape, 0u) != shape.end()) return true;
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

Id open_to_read(hid_t file, std::size_t n_bytes_in_memory, const std::string& path, const std::string& name)
{
  Id dataset = open_dataset(file, path, name);
  check_size(dataset, file, n_bytes_in_memory, path, name);
  return dataset;
}

struct AttributePlace {
  hid_t file;
  const std::string &path, &object, &name;
};

struct AttributeValues {
  hid_t disk_type, type, space;
  const void* data;
};

/// One that is there already is replaced.
void write_attribute(const AttributePlace& at, const AttributeValues& values)
{
  const Id opened{checked(H5Oopen(at.file, at.object.c_str(), H5P_DEFAULT), "open", at.path, at.object), H5Oclose};
  if (H5Aexists(opened, at.name.c_str()) > 0) H5Adelete(opened, at.name.c_str());
  const Id made{checked(H5Acreate2(opened, at.name.c_str(), values.disk_type, values.space, H5P_DEFAULT, H5P_DEFAULT),
                    "write", at.path, at.name),
      H5Aclose};
  checked(H5Awrite(made, values.type, values.data), "write", at.path, at.name);
}

/// File access: no lock; the format of HDF5 1.10, in which all metadata carry checksums, so that a damaged file is
/// noticed.
Id access_properties()
{
  Id access{H5Pcreate(H5P_FILE_ACCESS), H5Pclose};
  H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
  H5Pset_file_locking(access, false, true);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_LATEST);
  return access;
}

Id without_time(hid_t what)
{
  Id properties{H5Pcreate(what), H5Pclose};
  H5Pset_obj_track_times(properties, false);
  return properties;
}

/// Chunks of about equal size that fill the dataset, each at most HDF5's default chunk cache.
void set_chunks(hid_t properties, const std::vector<std::int64_t>& shape)
{
  constexpr hsize_t chunk_bytes = 1 << 20;
  constexpr unsigned compression = 1;  // level 3: half a per cent smaller, a quarter slower (docs/formats.md)
  const hsize_t n_rows = static_cast<hsize_t>(shape.at(0));
  hsize_t row_bytes = sizeof(Real);
  for (std::size_t k = 1; k < shape.size(); ++k) row_bytes *= static_cast<hsize_t>(shape[k]);
  const hsize_t n_chunks = n_rows * row_bytes / chunk_bytes + 1;
  std::vector<hsize_t> chunk = to_hsize(shape);
  chunk[0] = std::max<hsize_t>(1, (n_rows + n_chunks - 1) / n_chunks);
  H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(properties);
  H5Pset_deflate(properties, compression);
  H5Pset_fletcher32(properties);
}

void make_empty(const std::string& path, std::int64_t n_reserved)
{
  if (n_reserved > 0) {
    const AppendFile made{path};
    reserve_space(path, n_reserved);
  }
  const Id access = access_properties(), creation{without_time(H5P_FILE_CREATE)};
  Id made{H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose};
  checked<hid_t>(made, "write", path);
  checked(made.close(), "write", path);
}

hid_t open_existing(const std::string& path, bool change)
{
  const Id access = access_properties();
  return checked(
      H5Fopen(path.c_str(), change ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access), change ? "change" : "read", path);
}

hid_t open_file(const std::string& path, Hdf5File::Mode mode, std::int64_t n_reserved)
{
  const Hdf5Turn turn;
  static const herr_t without_exit_handler =
      H5dont_atexit();  // at exit HDF5 1.10 would close once more, and crash on, a file whose closing failed
  static_cast<void>(without_exit_handler);
  static const herr_t without_links_to_other_files = (H5open(), H5Lunregister(H5L_TYPE_EXTERNAL));
  static_cast<void>(without_links_to_other_files);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // errors are thrown, not printed
  if (mode != Hdf5File::Mode::create) check_is_file(path);
  if (mode == Hdf5File::Mode::create) make_empty(path, n_reserved);
  if (n_reserved > 0) reserve_space(path, n_reserved);
  return open_existing(path, mode != Hdf5File::Mode::read);
}

/// Sizes what a dataset is read into. A sparse file may hold more values than there is memory for.
template <class T>
void make_room(hssize_t n, const std::string& path, const std::string& name, std::vector<T>& values)
{
  try {
    values.resize(static_cast<std::size_t>(n));
  } catch (const std::bad_alloc&) {
    refuse(path, name, fmt::format("it holds {} values, more than there is memory for", n));
  }
}

}  // namespace

Hdf5File::Hdf5File(std::string path, Mode mode, std::int64_t n_reserved)
    : path_(std::move(path)), file_(open_file(path_, mode, n_reserved))
{
}

Hdf5File::~Hdf5File()
{
  const Hdf5Turn turn;
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5File::close()
{
  const Hdf5Turn turn;
  checked(H5Fflush(file_, H5F_SCOPE_LOCAL), "write", path_);
  const hid_t file = std::exchange(file_, -1);
  checked(H5Fclose(file), "write", path_);
}

void Hdf5File::make_group_of(const std::string& name)
{
  const Hdf5Turn turn;
  const std::string group = name.substr(0, name.rfind('/'));
  if (!group.empty() && group != name && !exists(group)) create_group(group);
}

void Hdf5File::create_group(const std::string& name)
{
  const Hdf5Turn turn;
  make_group_of(name);
  const Id properties = without_time(H5P_GROUP_CREATE);
  H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  const Id group{H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose};
  checked<hid_t>(group, "create", path_, name);
}

bool Hdf5File::exists(const std::string& name) const
{
  const Hdf5Turn turn;
  return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::members(const std::string& group) const
{
  const Hdf5Turn turn;
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
void Hdf5File::write(const std::string& name, const std::vector<std::int64_t>& shape, std::span<const T> values,
    std::int64_t first_row, Layout layout)
{
  const Hdf5Turn turn;
  const auto make = [&] {
    make_group_of(name);
    const Id properties = without_time(H5P_DATASET_CREATE);
    if (layout.packed) set_chunks(properties, shape);
    return H5Dcreate2(file_, name.c_str(), disk_type<T>(layout.number), make_space(to_hsize(shape)), H5P_DEFAULT,
        properties, H5P_DEFAULT);
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
  const Hdf5Turn turn;
  const Id dataset = open_to_read(file_, sizeof(T), path_, name);
  const Id space{H5Dget_space(dataset), H5Sclose};
  std::vector<T> values;
  make_room(checked(H5Sget_simple_extent_npoints(space), "read", path_, name), path_, name, values);
  checked(H5Dread(dataset, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read", path_, name);
  return values;
}

void Hdf5File::check_values() const
{
  const Hdf5Turn turn;
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5O_info_t* info, void* list) -> herr_t {
    if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  checked(H5Ovisit2(file_, H5_INDEX_NAME, H5_ITER_INC, add, &names, H5O_INFO_BASIC), "list", path_);
  std::vector<unsigned char> values;
  for (const std::string& name : names) {
    const Id dataset = open_to_read(file_, 1, path_, name);
    const Id type{H5Dget_type(dataset), H5Tclose}, space{H5Dget_space(dataset), H5Sclose};
    if (H5Tdetect_class(type, H5T_VLEN) > 0 || H5Tis_variable_str(type) > 0) refuse(path_, name, "it is no array");
    const auto size = static_cast<hssize_t>(H5Tget_size(type));
    make_room(size * checked(H5Sget_simple_extent_npoints(space), "read", path_, name), path_, name, values);
    checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read", path_, name);
  }
}

std::vector<std::int64_t> Hdf5File::shape(const std::string& name) const
{
  const Hdf5Turn turn;
  const Id dataset = open_dataset(file_, path_, name);
  const auto extent = extent_of(Id{H5Dget_space(dataset), H5Sclose});
  return {extent.begin(), extent.end()};
}

bool Hdf5File::holds_reals(const std::string& name) const
{
  const Hdf5Turn turn;
  const Id dataset = open_dataset(file_, path_, name);
  return H5Tget_class(Id{H5Dget_type(dataset), H5Tclose}) == H5T_FLOAT;
}

void Hdf5File::set_text(const std::string& object, const std::string& attribute, const std::string& value)
{
  const Hdf5Turn turn;
  const Id type{H5Tcopy(H5T_C_S1), H5Tclose};  // ASCII, fixed length
  H5Tset_size(type, std::max<std::size_t>(1, value.size()));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  const Id space{H5Screate(H5S_SCALAR), H5Sclose};
  write_attribute({file_, path_, object, attribute}, {type, type, space, value.c_str()});
}

void Hdf5File::set_real(const std::string& object, const std::string& attribute, Real value)
{
  const Hdf5Turn turn;
  const Id space{H5Screate(H5S_SCALAR), H5Sclose};
  write_attribute({file_, path_, object, attribute}, {H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space, &value});
}

void Hdf5File::set_integers(
    const std::string& object, const std::string& attribute, const std::vector<std::int64_t>& values)
{
  const Hdf5Turn turn;
  const Id space = values.size() == 1 ? make_space({}) : make_space({values.size()});
  write_attribute({file_, path_, object, attribute}, {H5T_STD_I64LE, H5T_NATIVE_INT64, space, values.data()});
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

std::string Hdf5File::text(const std::string& object, const std::string& attribute) const
{
  const Hdf5Turn turn;
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
  const Hdf5Turn turn;
  return read_single<Real>(file_, path_, object, attribute);
}

std::vector<std::int64_t> Hdf5File::integers(const std::string& object, const std::string& attribute) const
{
  const Hdf5Turn turn;
  const Id opened = open_attribute(file_, path_, object, attribute);
  std::vector<std::int64_t> values(count_values(opened));
  checked(H5Aread(opened, H5T_NATIVE_INT64, values.data()), "read", path_, attribute);
  return values;
}

std::int64_t Hdf5File::integer(const std::string& object, const std::string& attribute) const
{
  const Hdf5Turn turn;
  return read_single<std::int64_t>(file_, path_, object, attribute);
}

#define TERP_HDF5_TYPE(T)                                                                              \
  template void Hdf5File::write<T>(                                                                    \
      const std::string&, const std::vector<std::int64_t>&, std::span<const T>, std::int64_t, Layout); \
  template std::vector<T> Hdf5File::read<T>(const std::string&) const;
TERP_HDF5_TYPE(Real)
TERP_HDF5_TYPE(std::int64_t)
TERP_HDF5_TYPE(std::uint8_t)
#undef TERP_HDF5_TYPE

}  // namespace terp
