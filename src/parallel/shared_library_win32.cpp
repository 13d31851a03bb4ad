#include "parallel/shared_library.hpp"

#include "base/errors.hpp"

#include <cfenv>
#include <cstdlib>
#include <filesystem>
#include <windows.h>

namespace terp {

SharedLibrary::SharedLibrary(const std::string& path)
{
  _putenv("GFORTRAN_UNBUFFERED_PRECONNECTED=y");  // as in shared_library_posix.cpp
  std::fenv_t environment;
  std::fegetenv(&environment);
  handle_ = LoadLibraryW(std::filesystem::absolute(std::filesystem::path(path)).c_str());
  const auto error = GetLastError();
  std::fesetenv(&environment);
  if (handle_ == nullptr) throw FileError("The system says: LoadLibrary, error " + std::to_string(error));
}

SharedLibrary::~SharedLibrary() { FreeLibrary(static_cast<HMODULE>(handle_)); }

void* SharedLibrary::find(const std::string& symbol) const
{
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle_), symbol.c_str()));
}

}  // namespace terp
