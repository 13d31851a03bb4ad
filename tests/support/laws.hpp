// Libraries with laws that the build of the tests makes (tests/user_laws/CMakeLists.txt).
#pragma once

#include "materials/material.hpp"
#include "support/paths.hpp"
#include "user_laws/library_case.hpp"

namespace terp::test {

inline std::string law_folder() { return std::filesystem::path(program()).parent_path() / "tests/laws"; }

/// False of Fortran without a compiler.
inline bool is_built(const std::string& library) { return std::filesystem::exists(law_folder() + "/" + library); }

}  // namespace terp::test
