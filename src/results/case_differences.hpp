// In what the cases of two runs differ, key by key: what must be known before their results are set side by side.
#pragma once

#include <string>
#include <vector>

namespace terp {

/// "mesh.cell (0.1 against 0.2)" for each key with another value, in the order of the first case. The scheme, which is
/// there to be compared, the title, the end and what is written do not count. Of a text that is not TOML nothing.
std::vector<std::string> case_differences(const std::string& first_toml, const std::string& other_toml);

}  // namespace terp
