// A folder that is open for DELETE, and not shared for it, cannot be opened so once more: by no process, and over a
// network by no other machine. Files in it are not touched by this.

#include "system/folder_claim.hpp"

#include "system/windows_words.hpp"

#include <cerrno>
#include <cstdint>
#include <io.h>
#include <windows.h>

namespace terp {
namespace {

ClaimResult open_for_delete(const std::string& folder, DWORD sharing, int& descriptor)
{
  descriptor = -1;
  const std::wstring path = wide(folder);
  const DWORD attributes = GetFileAttributesW(path.c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES || (attributes & FILE_ATTRIBUTE_DIRECTORY) == 0) {
    errno = attributes == INVALID_FILE_ATTRIBUTES ? errno_of(GetLastError()) : ENOTDIR;
    return ClaimResult::no_folder;
  }
  const HANDLE opened =
      CreateFileW(path.c_str(), DELETE, sharing, nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (opened != INVALID_HANDLE_VALUE) {
    descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(opened), 0);
    return ClaimResult::taken;
  }
  return GetLastError() == ERROR_SHARING_VIOLATION ? ClaimResult::held_by_another : ClaimResult::without_locks;
}

}  // namespace

ClaimResult claim_folder(const std::string& folder, int& claim)
{
  return open_for_delete(folder, FILE_SHARE_READ | FILE_SHARE_WRITE, claim);
}

void release_claim(int claim)
{
  if (claim >= 0) _close(claim);
}

ClaimResult look_at_claim(const std::string& folder)
{
  int descriptor = -1;
  const ClaimResult result =
      open_for_delete(folder, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, descriptor);
  release_claim(descriptor);
  return result;
}

}  // namespace terp
