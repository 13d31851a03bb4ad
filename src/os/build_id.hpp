// Which build of the program this is.
#pragma once

#include <string>

namespace terp {

/// 16 hexadecimal digits of the build id that the linker gave the program of this process: equal for equal code, built
/// with equal options. "unknown" where the linker gives none. On Windows: digits of the program's file.
std::string build_id();

}  // namespace terp
