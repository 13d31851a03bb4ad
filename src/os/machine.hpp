// What this machine can do at most: how fast it streams memory and how fast it multiplies and adds.
// Part of the kernels: each copy measures what its own instructions can do; call by way of mpm/step/kernels.hpp.
// Not for: what Terp makes of it (mpm/step/passes, `terp bench`).
#pragma once

#include "math/types.hpp"

namespace terp {

/// Rate of a[k] = b[k] + s c[k] over arrays of `bytes` in all, on one thread [GB/s]; three streams are counted.
double measure_triad(std::size_t bytes);

/// Rate of multiply-adds on packs that stay in registers, on one thread [GFLOP/s]; a multiply-add counts two.
double measure_multiply_add();

}  // namespace terp
