// Files are opened so that others may rename and remove them meanwhile, as on Linux. Other programs open a file without
// that, for a moment: what then fails is tried again for two seconds (with_patience). Errors of Windows become numbers
// of errno, as the rest of Terp knows these.

#include "os/files.hpp"

#include "os/windows_words.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <io.h>
#include <system_error>
#include <windows.h>

namespace terp {
namespace {

/// Others may read, rename and remove what we have open, as on Linux.
constexpr DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

constexpr DWORD longest_path = 32768;  // [letters] that Windows allows

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor)); }

int last_error() { return errno_of(GetLastError()); }

/// A virus scanner or an indexer opens a file that was just closed, for a moment. Time in between [ms].
constexpr DWORD pauses[] = {10, 20, 40, 80, 160, 320, 640, 730};  // 2 s in all

/// `action` returns true when it is done. Tries again while another program has the file open.
template <class Action>
int with_patience(Action&& action)
{
  for (const DWORD pause : pauses) {
    if (action()) return 0;
    const DWORD error = GetLastError();
    if (error != ERROR_SHARING_VIOLATION && error != ERROR_ACCESS_DENIED && error != ERROR_LOCK_VIOLATION)
      return errno_of(error);
    Sleep(pause);
  }
  return action() ? 0 : last_error();
}

HANDLE open_handle(const std::string& path, DWORD access, DWORD how)
{
  return CreateFileW(wide(path).c_str(), access, shared, nullptr, how, FILE_ATTRIBUTE_NORMAL, nullptr);
}

HANDLE try_to_write(const std::string& path, OpenAs how)
{
  switch (how) {
    case OpenAs::new_file: return open_handle(path, GENERIC_WRITE, CREATE_ALWAYS);
    case OpenAs::end_of_file: return open_handle(path, FILE_APPEND_DATA | FILE_WRITE_DATA, OPEN_ALWAYS);
    default: return open_handle(path, GENERIC_WRITE, OPEN_EXISTING);
  }
}

bool is_folder(const std::string& path)
{
  const DWORD attributes = GetFileAttributesW(wide(path).c_str());
  return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
}

int try_to_open(const std::string& path, DWORD access)
{
  const HANDLE file =
      CreateFileW(wide(path).c_str(), access, shared, nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (file == INVALID_HANDLE_VALUE) return last_error();
  CloseHandle(file);
  return 0;
}

}  // namespace

int open_to_write(const std::string& path, OpenAs how)
{
  HANDLE file = INVALID_HANDLE_VALUE;
  const int error = with_patience([&] { return (file = try_to_write(path, how)) != INVALID_HANDLE_VALUE; });
  if (error != 0) {
    errno = is_folder(path) ? EISDIR : error;
    return -1;
  }
  if (how == OpenAs::end_of_file) SetFilePointer(file, 0, nullptr, FILE_END);
  return _open_osfhandle(reinterpret_cast<std::intptr_t>(file), _O_BINARY);
}

int write_all(int descriptor, std::string_view text)
{
  constexpr std::size_t most = 1 << 30;
  while (!text.empty()) {
    DWORD n = 0;
    if (!WriteFile(handle_of(descriptor), text.data(), static_cast<DWORD>(std::min(text.size(), most)), &n, nullptr))
      return last_error();
    text.remove_prefix(n);
  }
  return 0;
}

std::int64_t size_of(int descriptor)
{
  LARGE_INTEGER size;
  const HANDLE file = handle_of(descriptor);
  return GetFileType(file) == FILE_TYPE_DISK && GetFileSizeEx(file, &size) ? size.QuadPart : -1;
}

int resize(int descriptor, std::int64_t n_bytes)
{
  LARGE_INTEGER end;
  end.QuadPart = n_bytes;
  const HANDLE file = handle_of(descriptor);
  return SetFilePointerEx(file, end, nullptr, FILE_BEGIN) && SetEndOfFile(file) ? 0 : last_error();
}

/// NTFS takes the space when a file is made longer.
int reserve(int descriptor, std::int64_t n_bytes)
{
  const std::int64_t before = size_of(descriptor);
  return before < 0 ? EINVAL : resize(descriptor, before + n_bytes);
}

int close_file(int descriptor) { return _close(descriptor) == 0 ? 0 : errno; }

int wait_for_disk(const std::string& path)
{
  if (is_folder(path)) return 0;  // NTFS writes the names of files by its own journal
  const HANDLE file = open_handle(path, GENERIC_WRITE, OPEN_EXISTING);
  if (file == INVALID_HANDLE_VALUE) return last_error();
  const int error = FlushFileBuffers(file) ? 0 : last_error();
  CloseHandle(file);
  return error;
}

int replace_file(const std::string& from, const std::string& to)
{
  const std::wstring wide_from = wide(from), wide_to = wide(to);
  const int error = with_patience([&] {
    return MoveFileExW(wide_from.c_str(), wide_to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0;
  });
  if (error != EACCES) return error;
  if (is_folder(to)) return EISDIR;
  // A file that another program has open is "access denied" to MoveFileEx: which of the two it is says an attempt.
  return try_to_open(to, DELETE) == EBUSY ? EBUSY : error;
}

void link_or_copy(const std::string& file, const std::string& name) { std::filesystem::copy_file(file, name); }

std::string words_of_errno(int error)
{
  return error == EBUSY ? "another program has it open" : std::generic_category().message(error);
}

/// One on the present drive, "\\folder", is: the drive does not change while we run.
bool is_absolute(const std::string& path)
{
  const std::filesystem::path p(path);
  return p.is_absolute() || p.has_root_directory();
}

int may_read(const std::string& path) { return try_to_open(path, GENERIC_READ); }

int may_write(const std::string& path)
{
  return try_to_open(path, is_folder(path) ? FILE_ADD_FILE : static_cast<DWORD>(GENERIC_WRITE));
}

std::string make_unique_folder(const std::string& start)
{
  constexpr int attempts = 1000;
  const std::string own = start + std::to_string(process_number()) + "_";
  for (int k = 0; k < attempts; ++k) {
    const std::string folder = own + std::to_string(k);
    if (CreateDirectoryW(wide(folder).c_str(), nullptr)) return folder;
    if (GetLastError() != ERROR_ALREADY_EXISTS) return "";
  }
  return "";
}

std::string cache_folder()
{
  const wchar_t* const local = _wgetenv(L"LOCALAPPDATA");
  return local == nullptr ? "" : narrow(local);
}

bool print_to_file(const std::string& path)
{
  const int file = _wopen(wide(path).c_str(), _O_WRONLY | _O_CREAT | _O_APPEND | _O_BINARY | _O_NOINHERIT, 0666);
  return file >= 0 && _dup2(file, _fileno(stdout)) == 0 && _dup2(file, _fileno(stderr)) == 0;
}

std::string program_file()
{
  std::wstring path(longest_path, 0);
  path.resize(GetModuleFileNameW(nullptr, path.data(), longest_path));
  return narrow(path);
}

long process_number() { return static_cast<long>(GetCurrentProcessId()); }

}  // namespace terp
