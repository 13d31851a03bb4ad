// Force of the water in and around the soil on the corners of a cell. docs/methods.md, "Water".
//
// With p the pressure in the water, interpolated from the nodes, and s its tension above the phreatic line:
//   drained soil, which stores effective stress:   f_i = -sum_g w_g (N_i grad p + B_i s)
//   undrained soil, which stores total stress:     f_i = -sum_g w_g (N_i grad p + B_i p)
//   undrained soil, which stores effective stress: as drained soil, with s - u for s; u: its excess pore pressure
// Weights and operator are those of the internal force, Eq. (4) (decision 0047). By parts the second is the traction -p
// n on the surface of the soil. The pull of grad p on drained soil is that on the volume m/rho that the soil had at t =
// 0: water that enters as it opens brings its own weight, which that water carries.
#pragma once

#include "mpm/points/rows_of_packs.hpp"
#include "mpm/kernels/nodal_pressure.hpp"
#include "mpm/kernels/point_gradients.hpp"
#include "mpm/mesh/geometry_lanes.hpp"
#include "mpm/kernels/method_options.hpp"

namespace terp {

/// Values of the nodes at the corners of one cell, or of eight in packs.
template <class Element, class R = Real>
struct CornerPore {
  PerCorner<Element, R> pressure;  ///< whose gradient pulls: p [Pa]
  PerCorner<Element, R> inside;    ///< that the stored stress holds or lacks: p of undrained soil, s of drained [Pa]
};

/// N_i of all corners at each Gauss point, shape [g][corner].
template <class Element>
std::array<PerCorner<Element>, Element::n_gauss> shapes_at_gauss_points()
{
  std::array<PerCorner<Element>, Element::n_gauss> shapes{};
  for (int g = 0; g < Element::n_gauss; ++g) shapes[g] = Element::shape_functions(Element::gauss_place(g));
  return shapes;
}

/// f_i -= sum_g w_g (N_i grad p + q B_i), q: p of undrained soil or s of drained at each Gauss point. With B-bar as in
/// the internal force: q its mean, B that of the centre.
template <class Geometry, class Element, class R>
void add_pore_force(const Geometry& cell, const PerGauss<Element, R>& weight, const PerCorner<Element, R>& pressure,
    const PerGauss<Element, R>& inside, bool b_bar, CornerVectors<Element, R>& force)
{
  const auto shapes = shapes_at_gauss_points<Element>();
  R centre(0.0);  // sum of q_g w_g
  for (int g = 0; g < Element::n_gauss; ++g) {
    const R q = weight[g] * inside[g];
    centre += q;
    for (int d = 0; d < Element::dim; ++d) {
      R gradient(0.0);
      for (int i = 0; i < Element::n_corners; ++i) gradient += pressure[i] * R(cell.gradient[i][d][g]);
      gradient *= weight[g];
      for (int i = 0; i < Element::n_corners; ++i) {
        force[d][i] -= R(shapes[g][i]) * gradient;
        if (!b_bar) force[d][i] -= R(cell.gradient[i][d][g]) * q;
      }
    }
  }
  if (b_bar)
    for (int d = 0; d < Element::dim; ++d)
      for (int i = 0; i < Element::n_corners; ++i) force[d][i] -= R(cell.centre_gradient[i][d]) * centre;
}

/// Volume at t = 0 of the points of a block over that of now [-].
template <int dim>
Real first_volume_over_present(const PointBlock<dim>& block, Real density)
{
  using Rows = PointRows<dim>;
  Real mass = 0.0, volume = 0.0;
  for (Index p = 0; p < block.n; ++p) {
    mass += block.row(Rows::mass)[p];
    volume += block.row(Rows::volume)[p];
  }
  return mass / (density * volume);
}

/// grad p at eight points of a cell, 0 where p is not above 0. pressure: at the corners; negative above the water [Pa].
template <class Element>
std::array<Pack, Element::dim> pressure_slope(const PerCorner<Element, Pack>& N,
    const PerCorner<Element, std::array<Pack, Element::dim>>& gradient, const PerCorner<Element>& pressure)
{
  Pack p(0.0);
  auto slope = zero_packs<Element::dim>();
  for (int i = 0; i < Element::n_corners; ++i) {
    p += N[i] * Pack(pressure[i]);
    for (int d = 0; d < Element::dim; ++d) slope[d] += gradient[i][d] * Pack(pressure[i]);
  }
  for (Pack& of_direction : slope) of_direction = select(p > Pack(0.0), of_direction, Pack(0.0));
  return slope;
}

/// Adds the part of grad p alone, N_i grad p, with the volumes and the places of the points of a block: as its weight
/// acts. density: as below. Returns the sum over the points [N per m].
template <class Element>
Vec<Element::dim> add_pull_of_points(const CellGeometry<Element>& cell, const PointBlock<Element::dim>& block,
    const PerCorner<Element>& pressure, Real density, CornerVectors<Element>* force)
{
  constexpr int dim = Element::dim;
  using Rows = PointRows<dim>;
  auto sums = zero_packs<dim, Element::n_corners>();
  auto all = zero_packs<dim>();
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto local = load_rows<dim>(block, Rows::xi, p);
    const auto N = Element::shape_functions(local);
    const auto slope = pressure_slope<Element>(N, gradients_at(cell, local), pressure);
    const Pack pulled = density > 0.0 ? Pack::load(block.row(Rows::mass) + p) * Pack(1.0 / density)
                                      : Pack::load(block.row(Rows::volume) + p);
    for (int d = 0; d < dim; ++d) {
      const Pack pull = pulled * slope[d];
      all[d] += pull;
      for (int i = 0; i < Element::n_corners; ++i) sums[d][i] -= N[i] * pull;
    }
  }
  Vec<dim> pull;
  for (int d = 0; d < dim; ++d) {
    pull[d] = sum(all[d]);
    if (force != nullptr) add_lanes(sums[d], (*force)[d]);
  }
  return pull;
}

/// The same with the volumes and the places of the points of a block instead of Gauss weights. density: of drained
/// soil, whose volume at t = 0 is pulled; 0: of other soil [kg/m^3].
template <class Element>
void add_pore_force_of_points(const CellGeometry<Element>& cell, const PointBlock<Element::dim>& block,
    const CornerPore<Element>& pore, Real density, CornerVectors<Element>& force)
{
  constexpr int dim = Element::dim;
  using Rows = PointRows<dim>;
  auto sums = zero_packs<dim, Element::n_corners>();
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto local = load_rows<dim>(block, Rows::xi, p);
    const auto N = Element::shape_functions(local);
    const auto gradient = gradients_at(cell, local);
    const Pack volume = Pack::load(block.row(Rows::volume) + p);
    const Pack pulled = density > 0.0 ? Pack::load(block.row(Rows::mass) + p) * Pack(1.0 / density) : volume;
    Pack inside(0.0);
    for (int i = 0; i < Element::n_corners; ++i) inside += N[i] * Pack(pore.inside[i]);
    for (int d = 0; d < dim; ++d) {
      Pack slope(0.0);
      for (int i = 0; i < Element::n_corners; ++i) slope += gradient[i][d] * Pack(pore.pressure[i]);
      for (int i = 0; i < Element::n_corners; ++i)
        sums[d][i] -= pulled * N[i] * slope + volume * gradient[i][d] * inside;
    }
  }
  for (int d = 0; d < dim; ++d) add_lanes(sums[d], force[d]);
}

/// f_i += sum_p Omega_p u_p B_i, the force of the excess pressure of the points of a block: that of the stress -u I.
template <class Element>
void add_excess_force_of_points(
    const CellGeometry<Element>& cell, const PointBlock<Element::dim>& block, int row, CornerVectors<Element>& force)
{
  constexpr int dim = Element::dim;
  using Rows = PointRows<dim>;
  auto sums = zero_packs<dim, Element::n_corners>();
  for (Index p = 0; p < block.n; p += pack_width) {
    const auto gradient = gradients_at(cell, load_rows<dim>(block, Rows::xi, p));
    const Pack weighted = Pack::load(block.row(Rows::volume) + p) * Pack::load(block.row(row) + p);
    for (int d = 0; d < dim; ++d)
      for (int i = 0; i < Element::n_corners; ++i) sums[d][i] = fma(weighted, gradient[i][d], sums[d][i]);
  }
  for (int d = 0; d < dim; ++d) add_lanes(sums[d], force[d]);
}

}  // namespace terp
