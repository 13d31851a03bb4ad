#include "parallel/shared_library.hpp"

#include "base/errors.hpp"

#include <cfenv>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>

namespace terp {

SharedLibrary::SharedLibrary(const std::string& path)
{
  // What code of gfortran writes to the terminal appears at once, also where the program ends within it.
  setenv("GFORTRAN_UNBUFFERED_PRECONNECTED", "y", 0);
  std::fenv_t environment;  // a library linked with -ffast-math has small numbers flushed to zero
  std::fegetenv(&environment);
  handle_ = dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  const char* error = handle_ == nullptr ? dlerror() : nullptr;
  std::fesetenv(&environment);
  if (handle_ == nullptr) throw FileError(error != nullptr ? error : "the system gives no reason");
}

SharedLibrary::~SharedLibrary() { dlclose(handle_); }

void* SharedLibrary::find(const std::string& symbol) const { return dlsym(handle_, symbol.c_str()); }

}  // namespace terp
