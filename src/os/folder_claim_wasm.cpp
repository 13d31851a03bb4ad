// The files of a page are its own.
#include "os/folder_claim.hpp"

#include <cerrno>
#include <filesystem>

namespace terp {

ClaimResult claim_folder(const std::string& folder, int& claim)
{
  claim = -1;
  return look_at_claim(folder);
}

void release_claim(int) {}

ClaimResult look_at_claim(const std::string& folder)
{
  std::error_code none;
  if (std::filesystem::is_directory(folder, none)) return ClaimResult::taken;
  errno = ENOENT;
  return ClaimResult::no_folder;
}

}  // namespace terp
