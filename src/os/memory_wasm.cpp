// Memory of a page is there from the start and never shrinks.
#include "os/memory.hpp"

#include <cstdlib>
#include <cstring>
#include <new>

namespace terp {
namespace detail {

void FreePages::operator()(void* p) const { std::free(p); }

std::unique_ptr<void, FreePages> zero_pages(std::size_t n_bytes)
{
  constexpr std::size_t line = 64;  // as of all arrays
  void* const p = std::aligned_alloc(line, (n_bytes + line - 1) / line * line);
  if (p == nullptr) throw std::bad_alloc();
  std::memset(p, 0, n_bytes);
  return {p, FreePages{n_bytes}};
}

}  // namespace detail

void return_large_arrays_when_freed() {}

}  // namespace terp
