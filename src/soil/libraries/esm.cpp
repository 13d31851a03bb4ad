// ESM, the external soil model of Anura3D, in plane strain: NTENS 4, components 11 22 33 12, engineering shear, tension
// positive; or NTENS 6, and room for six in any case, as in umat.cpp. One call for each point. It has no way to ask for
// a smaller step, and is not told of rotations.
//
// Laws set their state variables when IStep and TimeStep are 1, which Anura3D has in its very first step. Here a point
// has it in the first call for its soil, which a row of its own remembers.

#include "soil/libraries/fenced_arrays.hpp"

#include <limits>

namespace terp {
namespace {

using Esm = void (*)(int* npt, int* noel, int* idset, double* stress, double* eunloading, double* plasticmultiplier,
    double* dstran, int* nstatev, double* statev, int* naddvar, double* additionalvar, char* cmname, int* nprops,
    double* props, int* numberofphases, int* ntens, std::size_t length_of_cmname);

constexpr int n_additional = 12;
constexpr Real not_known = std::numeric_limits<Real>::quiet_NaN();

class EsmCalls final : public FortranCalls {
 public:
  EsmCalls(void* symbol, const LibraryCase& library, const std::string& material, int n_components)
      : FortranCalls(library, material, n_components), esm_(reinterpret_cast<Esm>(symbol)), porosity_(library.porosity)
  {
  }

  /// State of a point and parameters, which the law may overwrite.
  std::size_t n_scratch() const override { return FencedArrays::n_numbers(n_state_, parameters_.size()); }

  void run(LawPoints& points) const override
  {
    const FencedArrays arrays(points.scratch.data(), n_state_, parameters_.size(), points.beyond);
    for (points.at = 0; points.at < points.n; ++points.at) {
      call(points, arrays, points.at);
      if (points.failed) return;
    }
  }

 private:
  void call(LawPoints& points, const FencedArrays& arrays, int p) const
  {
    double stress[most_tens] = {}, dstran[most_tens] = {}, unloading = 0.0, multiplier = 0.0;
    double *state = arrays.state(), *props = arrays.parameters();
    take(points, stress, state);
    for (int k = 0; k < n_tens; ++k) dstran[k] = (k < 3 ? 1.0 : 2.0) * points.d_eps[k][p];
    std::ranges::copy(parameters_, props);
    Real& was_called = points.state[n_state_][p];
    const double step = was_called > 0.0 ? static_cast<double>(points.step) + 2.0 : 1.0;
    double additional[n_additional] = {
        porosity_, not_known, not_known, 0.0, 0.0, 1.0, points.time, points.time, points.dt, 1.0, step, not_known};
    int npt = int(points.id[p]) + 1, noel = points.cell[p] + 1, idset = 1, nstatev = int(n_state_);
    int naddvar = n_additional, nprops = int(parameters_.size()), phases = 1, ntens = n_components_;
    char name[name_length];
    std::copy_n(name_.data(), name_length, name);
    esm_(&npt, &noel, &idset, stress, &unloading, &multiplier, dstran, &nstatev, state, &naddvar, additional, name,
        &nprops, props, &phases, &ntens, name_length);
    arrays.check(points);
    if (!is_plane({stress, std::size_t(n_components_)}, stress_unit_, points)) return;
    give_back(stress, state, points);
    was_called = 1.0;
  }

  Esm esm_;
  Real porosity_;
};

}  // namespace

std::unique_ptr<LawCalls> make_esm(
    void* symbol, const LibraryCase& library, const std::string& material, int n_components)
{
  return std::make_unique<EsmCalls>(symbol, library, material, n_components);
}

}  // namespace terp
