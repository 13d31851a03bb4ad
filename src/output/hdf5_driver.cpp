// HDF5 writes through a CommittedFile: see hdf5_driver.hpp. HDF5 is C: nothing may be thrown through it.
#include "output/hdf5_driver.hpp"

#include "base/errors.hpp"
#include "output/committed_file.hpp"

#include <hdf5.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>

namespace terp {
namespace {

/// What HDF5 knows of an open file comes first.
struct DriverFile {
  H5FD_t known;
  CommittedFile* file;
  haddr_t end;  ///< of what HDF5 has allocated
  bool commit;
};

DriverFile& own(H5FD_t* file) { return *reinterpret_cast<DriverFile*>(file); }
const DriverFile& own(const H5FD_t* file) { return *reinterpret_cast<const DriverFile*>(file); }

/// The system's words at the end of a FileError: Hdf5File tells the file itself.
std::string reason_of(const std::exception& error)
{
  const std::string text = error.what();
  const auto colon = text.rfind(": ");
  return colon == std::string::npos ? text : text.substr(colon + 2);
}

/// Does something that may throw; the reason goes where Hdf5File looks for it.
template <class F>
herr_t guarded(F&& what)
{
  try {
    what();
    return 0;
  } catch (const std::exception& error) {
    H5Epush2(H5E_DEFAULT, __FILE__, "guarded", __LINE__, H5E_ERR_CLS, H5E_IO, H5E_WRITEERROR, "error message = '%s'",
        reason_of(error).c_str());
    return -1;
  }
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t, haddr_t)
{
  if ((flags & (H5F_ACC_TRUNC | H5F_ACC_CREAT)) != 0) return nullptr;
  DriverFile* opened = nullptr;
  guarded([&] {
    auto file = std::make_unique<CommittedFile>(name);
    opened = new DriverFile{{}, file.release(), 0, false};
  });
  return reinterpret_cast<H5FD_t*>(opened);
}

herr_t close_file(H5FD_t* file)
{
  DriverFile& f = own(file);
  const herr_t result = f.commit ? guarded([&] { f.file->commit(static_cast<std::int64_t>(f.end)); }) : 0;
  delete f.file;
  delete &f;
  return result;
}

herr_t query(const H5FD_t*, unsigned long* flags)
{
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t get_eoa(const H5FD_t* file, H5FD_mem_t) { return own(file).end; }

herr_t set_eoa(H5FD_t* file, H5FD_mem_t, haddr_t end)
{
  own(file).end = end;
  return 0;
}

haddr_t get_eof(const H5FD_t* file, H5FD_mem_t) { return static_cast<haddr_t>(own(file).file->size()); }

herr_t get_handle(H5FD_t* file, hid_t, void** handle)
{
  *handle = file;
  return 0;
}

herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t n_bytes, void* to)
{
  return guarded([&] {
    own(file).file->read(
        static_cast<std::int64_t>(at), static_cast<std::int64_t>(n_bytes), static_cast<unsigned char*>(to));
  });
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, std::size_t n_bytes, const void* from)
{
  return guarded([&] {
    own(file).file->write(
        static_cast<std::int64_t>(at), static_cast<std::int64_t>(n_bytes), static_cast<const unsigned char*>(from));
  });
}

herr_t flush(H5FD_t*, hid_t, hbool_t) { return 0; }     // on closing, by the commit
herr_t truncate(H5FD_t*, hid_t, hbool_t) { return 0; }  // the same

H5FD_class_t describe_driver()
{
  H5FD_class_t driver = {};
  driver.name = "terp_committed";
  driver.maxaddr = static_cast<haddr_t>(INT64_MAX);
  driver.fc_degree = H5F_CLOSE_STRONG;
  driver.open = open_file;
  driver.close = close_file;
  driver.query = query;
  driver.get_eoa = get_eoa;
  driver.set_eoa = set_eoa;
  driver.get_eof = get_eof;
  driver.get_handle = get_handle;
  driver.read = read;
  driver.write = write;
  driver.flush = flush;
  driver.truncate = truncate;
  const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), driver.fl_map);
  return driver;
}

DriverFile& opened(hid_t file)
{
  void* handle = nullptr;
  if (H5Fget_vfd_handle(file, H5P_DEFAULT, &handle) < 0) throw FileError("cannot reach the driver of an HDF5 file");
  return *static_cast<DriverFile*>(handle);
}

}  // namespace

void use_committed_driver(std::int64_t access)
{
  static const H5FD_class_t description = describe_driver();
  static const hid_t driver = H5FDregister(&description);
  if (H5Pset_driver(access, driver, nullptr) < 0) throw FileError("cannot set the driver of an HDF5 file");
}

void start_changes(std::int64_t file, std::int64_t n_reserved)
{
  DriverFile& f = opened(file);
  f.file->start_changes(static_cast<std::int64_t>(f.end), n_reserved);
}

void commit_on_close(std::int64_t file) { opened(file).commit = true; }

}  // namespace terp
