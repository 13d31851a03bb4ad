// A word to the processor: these numbers will be needed soon. Changes no result.
#pragma once

#include "math/types.hpp"

#include <cstddef>

namespace terp {

/// Fetches n numbers from p on into the second cache while the program goes on..
inline void prefetch(const Real* p, std::ptrdiff_t n)
{
  constexpr std::ptrdiff_t line = 8;  // numbers in 64 bytes, which processors fetch at once
  for (std::ptrdiff_t k = 0; k < n; k += line) __builtin_prefetch(p + k, 1, 2);
  asm volatile("");  // GCC takes a function that does nothing but prefetch for one without effect, and drops its calls
}

}  // namespace terp
