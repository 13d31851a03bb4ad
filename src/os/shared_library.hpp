// A shared library that the user names, opened while the program runs.
// Not for: what its functions are (user_laws).
#pragma once

#include <memory>
#include <string>

namespace terp {

/// Closed when nobody uses it any more.
class SharedLibrary {
 public:
  /// Opening a library runs code of it; the floating-point environment is put back afterwards. Throws FileError:
  /// what is wrong with the file, or the words of the system.
  explicit SharedLibrary(const std::string& path);
  ~SharedLibrary();
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  /// nullptr if the library offers nothing of that name.
  void* find(const std::string& symbol) const;

 private:
  void* handle_ = nullptr;
};

}  // namespace terp
