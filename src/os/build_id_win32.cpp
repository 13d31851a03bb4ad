#include "os/build_id.hpp"

#include "math/checksum.hpp"
#include "os/files.hpp"

#include <filesystem>
#include <fstream>
#include <vector>

namespace terp {

/// The linker of mingw-w64 gives none.
std::string build_id()
{
  static const std::string digits = [] {
    std::ifstream file(std::filesystem::path(program_file()), std::ios::binary);
    std::vector<char> part(1 << 20);
    Fnv1a hash;
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
      hash.add(part.data(), static_cast<std::size_t>(file.gcount()));
    return file.eof() ? hash.digits() : "unknown";
  }();
  return digits;
}

}  // namespace terp
