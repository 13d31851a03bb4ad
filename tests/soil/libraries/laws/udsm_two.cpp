// A library of Plaxis with two user-defined soil models in C++: (1) elastic soil, (2) soil whose stiffness follows its
// pressure, K = K0 p/p_ref, which ends the calculation in tension.
// Props: (1) G, nu; (2) G, K0, p_ref. StVar of (2): the largest pressure.

#include <algorithm>

extern "C" void User_Mod(int* task, int* model, int*, int*, int*, int*, int*, double*, double*, double*, double*,
    double*, double* props, double* sig0, double*, double* stvar0, double* deps, double*, double*, double* sig, double*,
    double* stvar, int*, int* n_stat, int*, int*, int*, int*, int*, int*, int* abort)
{
  const double pressure = -(sig0[0] + sig0[1] + sig0[2]) / 3.0;
  if (*model < 1 || *model > 2) *n_stat = -1;
  if (*task == 1 && *model == 2) stvar0[0] = pressure;
  if (*task == 4) *n_stat = *model == 1 ? 0 : *model == 2 ? 1 : -1;
  if (*task != 2) return;
  const double g = props[0];
  const double bulk =
      *model == 1 ? 2.0 * g * (1.0 + props[1]) / (3.0 * (1.0 - 2.0 * props[1])) : props[1] * pressure / props[2];
  const double volume = deps[0] + deps[1] + deps[2];
  for (int k = 0; k < 3; ++k) sig[k] = sig0[k] + bulk * volume + 2.0 * g * (deps[k] - volume / 3.0);
  for (int k = 3; k < 6; ++k) sig[k] = sig0[k] + g * deps[k];
  if (*model == 1) return;
  stvar[0] = std::max(stvar0[0], -(sig[0] + sig[1] + sig[2]) / 3.0);
  if (pressure <= 0.0) *abort = 7;
}
