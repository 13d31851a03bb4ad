#include "model/libraries/law_stiffness.hpp"

#include "model/libraries/law_trial.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real small_strain = 1e-6;
constexpr Real same = 0.02;  // answers there and back that differ by less are those of an elastic law

}  // namespace

LawStiffness measure_stiffness(
    const SoilMaterial& material, const PointBlock<2>& block, Index lane, Real cell_size, Real dt)
{
  LawTrial trial(material, block, cell_size, dt);
  LawStiffness found;
  found.is_elastic = true;
  std::array<std::array<Real, 4>, 4> answer;  // to each component: change of the stress over the strain
  for (std::size_t j = 0; j < 4; ++j) {
    std::array<std::array<Real, 4>, 2> ways;
    for (std::size_t way = 0; way < 2; ++way) {
      const Real strain = way == 0 ? small_strain : -small_strain;
      std::array<Real, 4> d_eps{};
      d_eps[j] = strain;
      trial.prepare(d_eps);
      trial.call();
      found.failed = !material.law->fault().empty();
      if (found.failed) return found;
      ways[way] = trial.stress_change(lane);
      for (Real& change : ways[way]) change /= strain;
    }
    const std::size_t stiffer = ways[1][j] > ways[0][j] ? 1 : 0;
    answer[j] = ways[stiffer];
    for (std::size_t k = 0; k < 4; ++k)
      if (!(std::abs(ways[0][k] - ways[1][k]) <= same * std::abs(answer[j][j]))) found.is_elastic = false;
  }
  found.normal = std::max({answer[0][0], answer[1][1], answer[2][2]});
  found.shear = answer[3][3] / 2.0;
  found.shear_of_axes = (answer[0][0] + answer[1][1] - answer[0][1] - answer[1][0]) / 4.0;
  return found;
}

}  // namespace terp
