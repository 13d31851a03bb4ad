// Texts that functions make, as they stand in a file of the repository. What the program prints: tests/golden.
#pragma once

#include "support/process.hpp"

#include <cstdlib>

namespace terp::test {

/// The text is that of the file `path`; where TERP_UPDATE_GOLDEN is set, it is written there: look at the difference.
inline void expect_golden(const std::string& path, const std::string& text)
{
  if (std::getenv("TERP_UPDATE_GOLDEN") != nullptr) write_text(source_path(path), text);
  EXPECT_EQ(text_of(source_path(path)), text) << "if it is right: TERP_UPDATE_GOLDEN=1 and the same test once more";
}

}  // namespace terp::test
