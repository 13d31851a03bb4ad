// What every step does at Gauss points, for the schemes that integrate there: kernels of the core (core_kernels.cpp).
// Not for: what a scheme keeps of them.
#pragma once

#include "mpm/step/now.hpp"

namespace terp {

/// After the sums of a layer.
inline void enter_volume(LayerNow& now)
{
  for (int g = 0; g < Quad4::n_gauss; ++g) now.at.volume[g] += now.gauss.volume[g];
}

inline void set_geometry(GroupNow& now)
{
  now.geometry = geometry_of(now.group);
  now.within = Pack(1.0);
}

inline void take_means(LayerNow& now)
{
  set_weights(now.at.geometry, now.at.volume, now.at.step.model.method, now.gauss);  // R3
  divide_by_volume(now.gauss);                                                       // Eq. (1)
  smooth_pressure(now.gauss);                                                        // Eqs. (2), (3)
}

inline void add_force(LayerNow& now)
{
  add_internal_force(now.at.group, now.at.geometry, now.layer, now.gauss, now.at.step.model.method.b_bar);  // Eq. (4)
}

inline void set_strain_geometry(GroupNow& now) { now.geometry = geometry_of(now.group); }

inline void set_strain(GroupNow& now)
{
  now.strain = strain_of_group(now.geometry, *now.strained, now.step.model.method.b_bar);  // Step 2
}

inline void set_strain_of_cells(GroupNow& now)
{
  set_strain(now);
  now.strain_of_cell = strain_by_cell(now.strain);
}

}  // namespace terp
