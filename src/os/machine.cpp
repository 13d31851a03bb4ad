// Each rate is the best of a few trials, since whatever else runs on the machine can only make it lower. The size of
// the arrays decides which cache, or the memory, is measured. The multiply-adds run in independent chains to hide
// latency, and their numbers tend to 1, so that none overflows or becomes denormal.

#include "os/machine.hpp"

#include "math/pack.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

namespace terp {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double trial_seconds = 0.05;  // of one measurement
constexpr int trials = 5;               // the best of which counts: the others met another process

/// Best rate of `work` per call of f, per second.
template <class F>
double best_rate(double work, F&& f)
{
  double best = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto start = Clock::now();
    double seconds = 0.0, calls = 0.0;
    while (seconds < trial_seconds) {
      f();
      calls += 1.0;
      seconds = std::chrono::duration<double>(Clock::now() - start).count();
    }
    best = std::max(best, work * calls / seconds);
  }
  return best;
}

/// Tells the compiler that memory may be read: the loops before it may not be dropped.
void keep(const void* p) { asm volatile("" : : "r"(p) : "memory"); }

}  // namespace

double measure_triad(std::size_t bytes)
{
  const std::size_t n = std::max<std::size_t>(bytes / (3 * sizeof(Real)), pack_width);
  std::vector<Real> a(n), b(n, 1.0), c(n, 2.0);
  return best_rate(3e-9 * sizeof(Real) * static_cast<double>(n), [&] {
    for (std::size_t k = 0; k < n; ++k) a[k] = b[k] + 3.0 * c[k];
    keep(a.data());
  });
}

double measure_multiply_add()
{
  constexpr int chains = 10, repeats = 10000;  // enough independent chains to hide the latency of two units
  std::array<Pack, chains> x;
  for (int k = 0; k < chains; ++k) x[k] = Pack(1.0 + k);
  return best_rate(2e-9 * chains * repeats * pack_width, [&] {
    for (int r = 0; r < repeats; ++r)
      for (Pack& value : x) value = fma(value, Pack(0.999999), Pack(1e-6));
    keep(x.data());
  });
}

}  // namespace terp
