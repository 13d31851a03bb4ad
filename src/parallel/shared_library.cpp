#include "parallel/shared_library.hpp"

#include "base/errors.hpp"

#include <cfenv>
#include <filesystem>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace terp {

#ifdef _WIN32

SharedLibrary::SharedLibrary(const std::string& path)
{
  std::fenv_t environment;
  std::fegetenv(&environment);
  handle_ = LoadLibraryW(std::filesystem::absolute(std::filesystem::path(path)).c_str());
  const auto error = GetLastError();
  std::fesetenv(&environment);
  if (handle_ == nullptr) throw FileError("LoadLibrary: error " + std::to_string(error));
}

SharedLibrary::~SharedLibrary() { FreeLibrary(static_cast<HMODULE>(handle_)); }

void* SharedLibrary::find(const std::string& symbol) const
{
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle_), symbol.c_str()));
}

#else

SharedLibrary::SharedLibrary(const std::string& path)
{
  std::fenv_t environment;  // a library linked with -ffast-math has small numbers flushed to zero
  std::fegetenv(&environment);
  handle_ = dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  const char* error = handle_ == nullptr ? dlerror() : nullptr;
  std::fesetenv(&environment);
  if (handle_ == nullptr) throw FileError(error != nullptr ? error : "the system gives no reason");
}

SharedLibrary::~SharedLibrary() { dlclose(handle_); }

void* SharedLibrary::find(const std::string& symbol) const { return dlsym(handle_, symbol.c_str()); }

#endif

}  // namespace terp
