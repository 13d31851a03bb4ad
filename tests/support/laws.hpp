// Libraries with laws that the build of the tests makes (tests/soil/libraries/CMakeLists.txt).
#pragma once

#include "soil/laws/material.hpp"
#include "support/paths.hpp"
#include "soil/libraries/library_case.hpp"

namespace terp::test {

inline std::string law_folder() { return std::filesystem::path(program()).parent_path() / "tests/laws"; }

/// False of Fortran without a compiler.
inline bool is_built(const std::string& library) { return std::filesystem::exists(law_folder() + "/" + library); }

}  // namespace terp::test
