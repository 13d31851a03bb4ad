#include "os/folder_claim.hpp"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace terp {
namespace {

/// how: LOCK_EX or LOCK_SH. descriptor: of the folder, open and locked; -1 unless it is taken.
ClaimResult lock(const std::string& folder, int how, int& descriptor)
{
  descriptor = -1;
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return ClaimResult::no_folder;
  if (::flock(opened, how | LOCK_NB) == 0) {
    descriptor = opened;
    return ClaimResult::taken;
  }
  const bool held = errno == EWOULDBLOCK;
  ::close(opened);
  return held ? ClaimResult::held_by_another : ClaimResult::without_locks;
}

}  // namespace

ClaimResult claim_folder(const std::string& folder, int& claim) { return lock(folder, LOCK_EX, claim); }

void release_claim(int claim)
{
  if (claim >= 0) ::close(claim);
}

ClaimResult look_at_claim(const std::string& folder)
{
  int descriptor = -1;
  const ClaimResult result = lock(folder, LOCK_SH, descriptor);
  release_claim(descriptor);
  return result;
}

}  // namespace terp
