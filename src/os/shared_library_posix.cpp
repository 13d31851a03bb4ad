// The head of the file is read first, since dlopen() misleads about a library for another processor. At a file that is
// cut off it even ends the program. The path is made absolute, as a name without a slash would be searched for in the
// folders of the system. Symbols are bound at once, so that a missing one is reported here and not within a step. They
// stay local, so that two libraries may use the same names.

#include "os/shared_library.hpp"

#include "math/errors.hpp"

#include <cfenv>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <elf.h>
#include <filesystem>
#include <fstream>

namespace terp {
namespace {

template <class T>
bool read_at(std::ifstream& file, std::uint64_t offset, T& to)
{
  return static_cast<bool>(
      file.seekg(static_cast<std::streamoff>(offset)).read(reinterpret_cast<char*>(&to), sizeof to));
}

/// The head of a program or library of 64 bits; e_machine of 0: the file is none.
Elf64_Ehdr head_of(std::ifstream& file)
{
  Elf64_Ehdr head{};
  return read_at(file, 0, head) && std::memcmp(head.e_ident, ELFMAG, SELFMAG) == 0 ? head : Elf64_Ehdr{};
}

/// What is wrong with the file where the system has no words for it: it says of a library for another processor that
/// there is no file, and ends the program at a file of which the end is missing. Empty: nothing is known of it.
std::string fault_of_file(const std::string& path)
{
  std::ifstream file(path, std::ios::binary), own("/proc/self/exe", std::ios::binary);
  const Elf64_Ehdr head = head_of(file), program = head_of(own);
  if (head.e_machine == 0) return {};
  if (head.e_ident[EI_CLASS] != ELFCLASS64) return "it is a library of 32 bits, and this program has 64";
  if (program.e_machine != 0 && head.e_machine != program.e_machine) return "it was built for another processor";
  if (head.e_type == ET_REL) return "it is an object file: link it with -shared";
  std::error_code ignored;
  const std::uint64_t size = std::filesystem::file_size(path, ignored);
  for (int k = 0; k < head.e_phnum; ++k) {
    Elf64_Phdr part{};
    const bool is_there = read_at(file, head.e_phoff + std::uint64_t(k) * head.e_phentsize, part);
    if (!is_there || (part.p_type == PT_LOAD && part.p_offset + part.p_filesz > size))
      return "the end of the file is missing";
  }
  return {};
}

}  // namespace

SharedLibrary::SharedLibrary(const std::string& path)
{
  // What code of gfortran writes to the terminal appears at once, also where the program ends within it.
  setenv("GFORTRAN_UNBUFFERED_PRECONNECTED", "y", 0);
  if (const std::string fault = fault_of_file(path); !fault.empty()) throw FileError(path + ": " + fault);
  std::fenv_t environment;  // a library linked with -ffast-math has small numbers flushed to zero
  std::fegetenv(&environment);
  handle_ = dlopen(std::filesystem::absolute(path).c_str(), RTLD_NOW | RTLD_LOCAL);
  const char* error = handle_ == nullptr ? dlerror() : nullptr;
  std::fesetenv(&environment);
  if (handle_ == nullptr) throw FileError(std::string("The system says: ") + (error != nullptr ? error : "nothing"));
}

SharedLibrary::~SharedLibrary() { dlclose(handle_); }

void* SharedLibrary::find(const std::string& symbol) const { return dlsym(handle_, symbol.c_str()); }

}  // namespace terp
