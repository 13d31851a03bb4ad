// UMAT of Abaqus/Standard in plane strain: NTENS 4, NDI 3, NSHR 1, components 11 22 33 12, engineering shear, tension
// positive. A law of three dimensions alone has NTENS 6, NSHR 3: 13 and 23 follow, and are zero. The arrays have room
// for six in any case: many laws count to six, whatever NTENS is. One call for each point. Where the law answers with
// PNEWDT < 1 the increment is taken in parts.
//
// DROT is what Terp turned the stress by before the call: with method.objective_rate = "none" the unit tensor. DFGRD0
// and STRAN are kept for laws that ask for them, and are not a number for others. DDSDDE is not used.

#include "soil/libraries/fenced_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace terp {
namespace {

/// As Fortran passes it; the length of CMNAME comes last.
using Umat = void (*)(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd,
    double* rpl, double* ddsddt, double* drplde, double* drpldt, double* stran, double* dstran, double* time,
    double* dtime, double* temp, double* dtemp, double* predef, double* dpred, char* cmname, int* ndi, int* nshr,
    int* ntens, int* nstatv, double* props, int* nprops, double* coords, double* drot, double* pnewdt, double* celent,
    double* dfgrd0, double* dfgrd1, int* noel, int* npt, int* layer, int* kspt, int* jstep, int* kinc,
    std::size_t length_of_cmname);

constexpr Real not_given = std::numeric_limits<Real>::quiet_NaN();
constexpr Real least_cut = 0.1;  // of a part by one answer
constexpr const char* what_is_not_given =
    "the law with these numbers by itself; then mend the library. Or give `kinematics`, if\n"
    "           it reads STRAN, DFGRD0 or DFGRD1: without that they are not a number";

/// Column-major, as in Fortran.
using Tensor = std::array<double, 9>;
constexpr Tensor unit{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};

/// What stays the same over the parts of a step.
struct PointOfUmat {
  double strain[n_tens], d_strain[n_tens];  ///< engineering shear; of the whole step
  Tensor gradient;                          ///< F at the start of the part
  Tensor rate;                              ///< displacement gradient of the whole step
  Tensor turn;                              ///< DROT of the first part
  bool knows_strain, knows_gradient;
};

/// f = (1 + part * rate) f0
Tensor moved(const PointOfUmat& point, Real part)
{
  Tensor to = point.gradient;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) to[i + 3 * j] += part * point.rate[i + 3 * k] * point.gradient[k + 3 * j];
  return to;
}

class UmatCalls final : public FortranCalls {
 public:
  UmatCalls(void* symbol, const LibraryCase& library, const std::string& material, int n_components)
      : FortranCalls(library, material, n_components),
        umat_(reinterpret_cast<Umat>(symbol)),
        keeps_strain_(keeps(library, "strain")),
        keeps_gradient_(keeps(library, "deformation_gradient"))
  {
    std::ranges::transform(name_, name_.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  }

  /// State of a part and parameters, which the law may overwrite, and the state at the start of the part.
  std::size_t n_scratch() const override { return n_state_ + FencedArrays::n_numbers(n_state_, parameters_.size()); }

  void run(LawPoints& points) const override
  {
    const FencedArrays arrays(points.scratch.data() + n_state_, n_state_, parameters_.size(), points.beyond);
    for (points.at = 0; points.at < points.n; ++points.at) {
      PointOfUmat point = point_of(points, points.at);
      advance(points, arrays, point);
      if (points.failed) return;
      keep(point, points);
    }
    if (!keeps_strain_ || !keeps_gradient_) points.cure = what_is_not_given;
  }

 private:
  PointOfUmat point_of(const LawPoints& points, int p) const
  {
    PointOfUmat point{};
    point.knows_strain = keeps_strain_, point.knows_gradient = keeps_gradient_;
    for (int k = 0; k < n_tens; ++k) {
      const Real factor = k < 3 ? 1.0 : 2.0;
      point.d_strain[k] = factor * points.d_eps[k][p];
      point.strain[k] = keeps_strain_ ? factor * points.state[n_state_ + k][p] : not_given;
    }
    const Real w = points.d_spin[p], shear = points.d_eps[3][p];
    point.rate = {points.d_eps[0][p], shear + w, 0.0, shear - w, points.d_eps[1][p], 0.0, 0.0, 0.0, points.d_eps[2][p]};
    point.turn = unit;
    if (points.turned) {
      point.turn[0] = point.turn[4] = std::cos(w);
      point.turn[1] = std::sin(w), point.turn[3] = -std::sin(w);
    }
    point.gradient.fill(not_given);
    if (!keeps_gradient_) return point;
    const std::size_t first = n_state_ + (keeps_strain_ ? n_strain_rows : 0);
    const auto f = [&](std::size_t k) { return points.state[first + k][p]; };
    point.gradient = {f(0), f(2), 0.0, f(1), f(3), 0.0, 0.0, 0.0, f(4)};
    return point;
  }

  /// What is kept for the law, at the end of the step.
  void keep(const PointOfUmat& point, LawPoints& points) const
  {
    const int p = points.at;
    if (keeps_strain_) {
      std::array<Real, n_tens> e;
      for (int k = 0; k < n_tens; ++k) e[k] = point.strain[k] * (k < 3 ? 1.0 : 0.5);
      for (int k = 0; k < n_tens; ++k) points.state[n_state_ + k][p] = e[k];
    }
    if (!keeps_gradient_) return;
    const std::size_t first = n_state_ + (keeps_strain_ ? n_strain_rows : 0);
    const Tensor& f = point.gradient;
    const Real rows[] = {f[0], f[3], f[1], f[4], f[8]};
    for (std::size_t k = 0; k < n_gradient_rows; ++k) points.state[first + k][p] = rows[k];
  }

  /// The whole step in as many parts as the law asks for.
  void advance(LawPoints& points, const FencedArrays& arrays, PointOfUmat& point) const
  {
    Real done = 0.0, part = 1.0;
    double stress[most_tens] = {};
    double *state = arrays.state(), *before = points.scratch.data();
    take(points, stress, state);
    if (points.turned && point.knows_strain) turn_strain(point);
    while (done < 1.0) {
      const bool is_last = done + part > 1.0 - 0.5 * smallest_part;  // or round-off would be left
      if (is_last) part = 1.0 - done;
      double start[n_tens];
      std::copy_n(stress, n_tens, start);
      std::fill(stress + n_tens, stress + most_tens, 0.0);
      std::copy_n(state, n_state_, before);
      const Real answer = call(points, arrays, point, done, part, stress);
      if (points.failed) return;
      if (answer >= 1.0) {
        if (!is_plane({stress, std::size_t(n_components_)}, stress_unit_, points)) return;
        if (point.knows_gradient) point.gradient = moved(point, part);
        for (int k = 0; k < n_tens; ++k) point.strain[k] += part * point.d_strain[k];
        done = is_last ? 1.0 : done + part;
        continue;
      }
      std::copy_n(start, n_tens, stress);
      std::copy_n(before, n_state_, state);
      part *= std::clamp(answer, least_cut, 0.9);
      if (part >= smallest_part) continue;
      points.cure = smaller_steps;
      return points.fail("the law asks for parts of the step smaller than 1/{:.0f} of it (PNEWDT = {:g})",
          1.0 / smallest_part, answer);
    }
    give_back(stress, state, points);
  }

  /// As the stress was turned.
  static void turn_strain(PointOfUmat& point)
  {
    const Real c = point.turn[0], s = point.turn[1];
    const Real xx = point.strain[0], yy = point.strain[1], xy = 0.5 * point.strain[3];
    point.strain[0] = c * c * xx - 2.0 * c * s * xy + s * s * yy;
    point.strain[1] = s * s * xx + 2.0 * c * s * xy + c * c * yy;
    point.strain[3] = 2.0 * (c * s * (xx - yy) + (c * c - s * s) * xy);
  }

  /// One part of the step, of which `done` is done. Returns PNEWDT.
  Real call(LawPoints& points, const FencedArrays& arrays, const PointOfUmat& point, Real done, Real part,
      double* stress) const
  {
    const int p = points.at;
    double ddsdde[most_tens * most_tens] = {}, ddsddt[most_tens] = {}, drplde[most_tens] = {};
    double sse = 0.0, spd = 0.0, scd = 0.0, rpl = 0.0, drpldt = 0.0, temp = 0.0, dtemp = 0.0, pnewdt = 1.0;
    double predef[1] = {}, dpred[1] = {}, stran[most_tens] = {}, dstran[most_tens] = {};
    const double start = points.time + done * points.dt;
    double time[2] = {start, start}, dtime = part * points.dt, celent = points.cell_size[p];
    double coords[3] = {points.x[0][p], points.x[1][p], 0.0};
    Tensor turn = done == 0.0 ? point.turn : unit, dfgrd0 = point.gradient, dfgrd1 = point.gradient;
    if (point.knows_gradient) dfgrd1 = moved(point, part);
    for (int k = 0; k < n_tens; ++k) stran[k] = point.strain[k], dstran[k] = part * point.d_strain[k];
    int ndi = 3, ntens = n_components_, nshr = ntens - ndi, nstatv = int(n_state_), nprops = int(parameters_.size());
    int noel = points.cell[p] + 1, npt = int(points.id[p]) + 1, layer = 1, kspt = 1, jstep[4] = {1, 0, 0, 0};
    int kinc = int(points.step) + 1;
    char name[name_length];
    std::copy_n(name_.data(), name_length, name);
    std::ranges::copy(parameters_, arrays.parameters());
    umat_(stress, arrays.state(), ddsdde, &sse, &spd, &scd, &rpl, ddsddt, drplde, &drpldt, stran, dstran, time, &dtime,
        &temp, &dtemp, predef, dpred, name, &ndi, &nshr, &ntens, &nstatv, arrays.parameters(), &nprops, coords,
        turn.data(), &pnewdt, &celent, dfgrd0.data(), dfgrd1.data(), &noel, &npt, &layer, &kspt, jstep, &kinc,
        name_length);
    arrays.check(points);
    if (!points.failed && std::isnan(pnewdt)) points.fail("the law returned a PNEWDT that is not a number");
    return pnewdt;
  }

  Umat umat_;
  bool keeps_strain_, keeps_gradient_;
};

}  // namespace

std::unique_ptr<LawCalls> make_umat(
    void* symbol, const LibraryCase& library, const std::string& material, int n_components)
{
  return std::make_unique<UmatCalls>(symbol, library, material, n_components);
}

}  // namespace terp
