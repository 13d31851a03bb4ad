#include "model/libraries/law_cost.hpp"

#include "model/libraries/law_trial.hpp"

#include <algorithm>
#include <chrono>

namespace terp {

LawCost time_law(const SoilMaterial& material, const PointBlock<2>& block, Real cell_size, Real dt)
{
  constexpr double long_enough = 0.02;  // [s]
  constexpr Real shear_strain = 1e-6;
  LawTrial trial(material, block, cell_size, dt);
  using Clock = std::chrono::steady_clock;
  std::int64_t calls = 0;
  double seconds = 0.0;
  while (seconds < long_enough && material.law->fault().empty()) {
    trial.prepare({0.0, 0.0, 0.0, shear_strain});
    const auto start = Clock::now();
    trial.call();
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
    ++calls;
  }
  return {seconds / static_cast<double>(std::max<std::int64_t>(1, calls) * std::max<Index>(1, block.n)),
      material.law->fault()};
}

}  // namespace terp
