#include "os/shared_library.hpp"

#include "math/errors.hpp"

namespace terp {

SharedLibrary::SharedLibrary(const std::string& path)
{
  throw FileError(path + ": a page of a browser opens no libraries: laws from libraries need Terp on a machine");
}

SharedLibrary::~SharedLibrary() = default;

void* SharedLibrary::find(const std::string&) const { return nullptr; }

}  // namespace terp
