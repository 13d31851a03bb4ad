// Texts are converted in two calls: the first asks for the length, the second fills the text. Many errors of Windows
// share one number of errno, so that Terp can decide by errno alone. What has no place there is EIO. The words for the
// user come from Windows itself, with its number.

#include "os/windows_words.hpp"

#include <cerrno>
#include <windows.h>

namespace terp {

std::wstring wide(std::string_view text)
{
  const int n_bytes = static_cast<int>(text.size());
  std::wstring result(static_cast<std::size_t>(MultiByteToWideChar(CP_UTF8, 0, text.data(), n_bytes, nullptr, 0)), 0);
  MultiByteToWideChar(CP_UTF8, 0, text.data(), n_bytes, result.data(), static_cast<int>(result.size()));
  return result;
}

std::string narrow(std::wstring_view text)
{
  const int n = static_cast<int>(text.size());
  const int n_bytes = WideCharToMultiByte(CP_UTF8, 0, text.data(), n, nullptr, 0, nullptr, nullptr);
  std::string result(static_cast<std::size_t>(n_bytes), 0);
  WideCharToMultiByte(CP_UTF8, 0, text.data(), n, result.data(), n_bytes, nullptr, nullptr);
  return result;
}

int errno_of(unsigned long error)
{
  switch (error) {
    case ERROR_SUCCESS: return 0;
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_DRIVE:
    case ERROR_BAD_NETPATH:
    case ERROR_BAD_PATHNAME: return ENOENT;
    case ERROR_INVALID_NAME: return EINVAL;
    case ERROR_DIRECTORY: return ENOTDIR;
    case ERROR_ACCESS_DENIED: return EACCES;
    case ERROR_WRITE_PROTECT: return EROFS;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_USER_MAPPED_FILE: return EBUSY;  // another program has it open
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS: return EEXIST;
    case ERROR_DIR_NOT_EMPTY: return ENOTEMPTY;
    case ERROR_HANDLE_DISK_FULL:
    case ERROR_DISK_FULL: return ENOSPC;
    case ERROR_NOT_ENOUGH_MEMORY:
    case ERROR_OUTOFMEMORY:
    case ERROR_COMMITMENT_LIMIT: return ENOMEM;
    case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
    case ERROR_TOO_MANY_OPEN_FILES: return EMFILE;
    case ERROR_NO_DATA:
    case ERROR_BROKEN_PIPE: return EPIPE;
    default: return EIO;
  }
}

std::string words_of_error(unsigned long error)
{
  wchar_t* text = nullptr;
  const DWORD n =
      FormatMessageW(FORMAT_MESSAGE_ALLOCATE_BUFFER | FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS,
          nullptr, error, 0, reinterpret_cast<wchar_t*>(&text), 0, nullptr);
  std::string words = n > 0 ? narrow({text, n}) : "";
  LocalFree(text);
  words.erase(words.find_last_not_of(" \r\n.") + 1);
  return words + " (error " + std::to_string(error) + " of Windows)";
}

}  // namespace terp
