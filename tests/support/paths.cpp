#include "support/paths.hpp"

#include <unistd.h>

namespace terp::test {

std::string program() { return TERP_PROGRAM; }

std::string source_path(const std::string& relative) { return std::string(TERP_SOURCE_DIR) + "/" + relative; }

ScratchFolder::ScratchFolder()
{
  std::string pattern = (std::filesystem::temp_directory_path() / "terp_test_XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make a scratch folder");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace terp::test
