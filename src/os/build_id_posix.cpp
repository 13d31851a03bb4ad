#include "os/build_id.hpp"

#include <cstddef>
#include <cstring>

#include <elf.h>
#include <link.h>

namespace terp {
namespace {

constexpr std::size_t n_bytes = 8;  // of 20: enough to tell builds apart

std::string digits_of_note(const unsigned char* begin, std::size_t size)
{
  const auto padded = [](std::size_t n) { return (n + 3) / 4 * 4; };
  for (std::size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    ElfW(Nhdr) note;
    std::memcpy(&note, begin + at, sizeof note);
    const std::size_t name = at + sizeof note, content = name + padded(note.n_namesz);
    if (content + note.n_descsz > size) break;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(begin + name, "GNU", 4) == 0 &&
        note.n_descsz >= n_bytes) {
      std::string digits;
      for (std::size_t k = 0; k < n_bytes; ++k)
        for (const int shift : {4, 0}) digits += "0123456789abcdef"[begin[content + k] >> shift & 15];
      return digits;
    }
    at = content + padded(note.n_descsz);
  }
  return "";
}

/// Of the first object, which is the program.
int find_note(dl_phdr_info* object, std::size_t, void* found)
{
  for (int k = 0; k < object->dlpi_phnum; ++k) {
    const auto& part = object->dlpi_phdr[k];
    if (part.p_type != PT_NOTE) continue;
    const auto* begin = reinterpret_cast<const unsigned char*>(object->dlpi_addr + part.p_vaddr);
    auto& digits = *static_cast<std::string*>(found);
    if (digits = digits_of_note(begin, part.p_memsz); !digits.empty()) break;
  }
  return 1;
}

}  // namespace

std::string build_id()
{
  std::string digits;
  ::dl_iterate_phdr(find_note, &digits);
  return digits.empty() ? "unknown" : digits;
}

}  // namespace terp
