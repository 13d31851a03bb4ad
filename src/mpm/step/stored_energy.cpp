#include "mpm/step/stored_energy.hpp"

#include "mpm/step/balance_sums.hpp"

namespace terp {

Real elastic_energy(Moduli moduli, std::array<Real, 4> sigma, Real volume)
{
  return volume * ElasticEnergy<Real>(moduli)(sigma[0], sigma[1], sigma[2], sigma[3]);
}

Real elastic_energy(const SoilMaterial& material, std::span<Real> values)
{
  const LawRows at = material.view(values.data(), 1);
  SymTensor<Real, 2> sigma;
  for (int k = 0; k < n_sym<2>; ++k) sigma[k] = values[Rows::sigma + k];
  const Real volume = values[Rows::volume];
  Real energy = material.type->stiffness_by_stress ? volume * material.law->stored_energy(at, sigma)
                                                   : elastic_energy(material.law->moduli(at), sigma.c, volume);
  if (material.water_stiffness > 0.0)
    energy += volume * values[material.excess_row] * values[material.excess_row] / (2.0 * material.water_stiffness);
  return energy;
}

Real energy_of_left(const StepState& state)
{
  Real energy = 0.0;
  for (const LeftPoint& p : state.left) energy += 0.5 * p.mass * (p.v[0] * p.v[0] + p.v[1] * p.v[1]) + p.elastic;
  return energy;
}

Real kinetic_and_stored_energy(const StepModel& model, const StepState& state)
{
  BalanceSums balance;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    const SoilMaterial& material = model.materials[block.material];
    const ElasticEnergy<Real> energy(material.law->moduli());
    for (Index p = 0; p < block.n; p += pack_width) balance.enter(material, energy, block, p);
  });
  return 0.5 * sum(balance.twice_kinetic) + sum(balance.elastic) + sum(balance.pore_elastic) + energy_of_left(state);
}

}  // namespace terp
