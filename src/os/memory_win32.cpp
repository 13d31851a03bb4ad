#include "os/memory.hpp"

#include <new>
#include <windows.h>

namespace terp {
namespace detail {

void FreePages::operator()(void* p) const { VirtualFree(p, 0, MEM_RELEASE); }

std::unique_ptr<void, FreePages> zero_pages(std::size_t n_bytes)
{
  void* const p = VirtualAlloc(nullptr, n_bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
  if (p == nullptr) throw std::bad_alloc();
  return {p, FreePages{n_bytes}};
}

}  // namespace detail

void return_large_arrays_when_freed() {}  // the heap of Windows does so

}  // namespace terp
