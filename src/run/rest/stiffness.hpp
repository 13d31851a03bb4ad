// The elastic stiffness of the soil on the background mesh.
// Not for: the stress that it leads to, which is that of the laws (statics.hpp).
#pragma once

#include "math/sparse_cholesky.hpp"
#include "model/parts/model.hpp"
#include "mpm/step/workspace.hpp"
#include "run/loop/state.hpp"

namespace terp {

/// K = sum over cells and blocks of sum_g w_g B^T D B, with B-bar and the mean moduli of each block; sides hold by a
/// large stiffness. Unknowns: x and y of each active node, in their order.
SparseCholesky factor_stiffness(const Model& model, const State& state, const Workspace& work);

}  // namespace terp
