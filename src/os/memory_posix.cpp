#include "os/memory.hpp"

#include <malloc.h>
#include <new>
#include <sys/mman.h>

namespace terp {
namespace detail {

void FreePages::operator()(void* p) const { munmap(p, n_bytes); }

std::unique_ptr<void, FreePages> zero_pages(std::size_t n_bytes)
{
  void* p = mmap(nullptr, n_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (p == MAP_FAILED) throw std::bad_alloc();
  return {p, FreePages{n_bytes}};
}

}  // namespace detail

void return_large_arrays_when_freed()
{
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  mallopt(M_TRIM_THRESHOLD, 1 << 22);
  mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace terp
