// An event of the system whose name has the numbers of the folder: it is there as long as who made it. Other machines
// do not see it, so that a folder on a network disk is held on one machine alone. The folder itself is not left open:
// Windows would then refuse to list it, or to rename files in it, by what else it allows.

#include "os/folder_claim.hpp"

#include "os/windows_words.hpp"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <windows.h>

namespace terp {
namespace {

/// Of the disk and of the folder on it, whatever path leads there.
ClaimResult find_name(const std::string& folder, char (&name)[64])
{
  const HANDLE opened =
      CreateFileW(wide(folder).c_str(), FILE_READ_ATTRIBUTES, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
          nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (opened == INVALID_HANDLE_VALUE) {
    errno = errno_of(GetLastError());
    return ClaimResult::no_folder;
  }
  BY_HANDLE_FILE_INFORMATION about{};
  const bool known = GetFileInformationByHandle(opened, &about) != 0;
  CloseHandle(opened);
  if (!known) return ClaimResult::without_locks;
  if ((about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0) {
    errno = ENOTDIR;
    return ClaimResult::no_folder;
  }
  std::snprintf(name, sizeof name, "Global\\terp-%08lx-%08lx%08lx", about.dwVolumeSerialNumber, about.nFileIndexHigh,
      about.nFileIndexLow);
  return ClaimResult::taken;
}

/// The number of a handle has 32 bits, in programs of 64 bits as well.
HANDLE handle_of(int claim) { return reinterpret_cast<HANDLE>(static_cast<std::intptr_t>(claim)); }

}  // namespace

ClaimResult claim_folder(const std::string& folder, int& claim)
{
  claim = -1;
  char name[64];
  if (const ClaimResult result = find_name(folder, name); result != ClaimResult::taken) return result;
  const HANDLE made = CreateEventA(nullptr, TRUE, FALSE, name);
  const DWORD error = GetLastError();
  if (made != nullptr && error != ERROR_ALREADY_EXISTS) {
    claim = static_cast<int>(reinterpret_cast<std::intptr_t>(made));
    return ClaimResult::taken;
  }
  if (made != nullptr) CloseHandle(made);
  const bool of_another_user = made == nullptr && error == ERROR_ACCESS_DENIED;
  return made != nullptr || of_another_user ? ClaimResult::held_by_another : ClaimResult::without_locks;
}

void release_claim(int claim)
{
  if (claim >= 0) CloseHandle(handle_of(claim));
}

ClaimResult look_at_claim(const std::string& folder)
{
  char name[64];
  if (const ClaimResult result = find_name(folder, name); result != ClaimResult::taken) return result;
  const HANDLE found = OpenEventA(SYNCHRONIZE, FALSE, name);
  if (found == nullptr && GetLastError() != ERROR_ACCESS_DENIED) return ClaimResult::taken;
  if (found != nullptr) CloseHandle(found);
  return ClaimResult::held_by_another;
}

}  // namespace terp
