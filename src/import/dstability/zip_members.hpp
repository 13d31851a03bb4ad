// The members of a zip file, in memory, within limits: a file of a few kB may unpack to all memory there is.
// Not for: what stands in them. The only file that uses libzip is zip_members.cpp.
#pragma once

#include "math/errors.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// What a file may ask for. Real files have some 200 members, 20 MB unpacked, packed to a tenth.
struct ZipLimits {
  std::size_t members = 20000;
  std::uint64_t member_bytes = std::uint64_t{256} << 20U;  ///< one, unpacked
  std::uint64_t total_bytes = std::uint64_t{1} << 30U;     ///< all that is read, unpacked
  std::uint64_t ratio = 200;  ///< unpacked over packed, of a member above 1 MB; deflate reaches 1032
};

class ZipMembers {
 public:
  /// path: for messages. Throws InputError if `bytes` is no zip file, or has too many members or a name twice.
  ZipMembers(std::string path, std::string bytes, ZipLimits limits = {});
  ~ZipMembers();
  ZipMembers(ZipMembers&&) noexcept;

  /// Names with one `/` between folders, whatever the file has, in its order; folders are left out.
  const std::vector<std::string>& names() const;
  /// Unpacked. Throws InputError if it is damaged, encrypted, or beyond the limits.
  std::string text(std::size_t number);

 private:
  struct Archive;
  std::unique_ptr<Archive> archive_;
};

/// The bytes of a zip file of these members: name, contents. All have one date, so that the same members give the same
/// bytes.
std::string zip_of(const std::vector<std::pair<std::string, std::string>>& members);

}  // namespace terp
