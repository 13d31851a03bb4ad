#include "os/shared_library.hpp"

#include "math/errors.hpp"

#include <cfenv>
#include <cstdlib>
#include <filesystem>
#include <windows.h>

namespace terp {
namespace {

std::string words_for(DWORD error)
{
  const std::string call = "LoadLibrary, error " + std::to_string(error);
  if (error == ERROR_MOD_NOT_FOUND) return "Another library that it needs was not found (" + call + ").";
  if (error == ERROR_BAD_EXE_FORMAT) return "This is no library for 64-bit Windows (" + call + ").";
  return "The system says: " + call;
}

}  // namespace

SharedLibrary::SharedLibrary(const std::string& path)
{
  _putenv("GFORTRAN_UNBUFFERED_PRECONNECTED=y");  // as in shared_library_posix.cpp
  std::fenv_t environment;
  std::fegetenv(&environment);
  handle_ = LoadLibraryW(std::filesystem::absolute(std::filesystem::path(path)).c_str());
  const auto error = GetLastError();
  std::fesetenv(&environment);
  if (handle_ == nullptr) throw FileError(words_for(error));
}

SharedLibrary::~SharedLibrary() { FreeLibrary(static_cast<HMODULE>(handle_)); }

void* SharedLibrary::find(const std::string& symbol) const
{
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle_), symbol.c_str()));
}

}  // namespace terp
