// The history at the Gauss points: rows of the law, the law, and its works.
#include "mpm/schemes/mixed_law.hpp"

namespace terp {
namespace {

bool rotates(const SchemeContext& context) { return context.method.objective_rate == ObjectiveRate::jaumann; }

/// Means over the sub-cells. A parameter that varies comes as such a mean.
void divide_rows(const GaussValues<Quad4, Pack>& gauss, const SoilMaterial& material, GaussRow<Quad4>* rows)
{
  const SubCellMeans mean(gauss);
  for (int k = 0; k < material.n_rows(); ++k) mean(rows[k]);
}

/// Each state variable says how it is averaged (reading R9).
void average_rows(const GaussValues<Quad4, Pack>& gauss, const SoilMaterial& material, GaussRow<Quad4>* rows)
{
  for (int k = 0; k < material.n_state(); ++k)
    if (material.type->state[k].averaging == Averaging::cell) average_over_cell(gauss.weight, rows[k]);
}

/// Runs a law that looks around: lanes whose cell has no such soil are marked.
void update_with_surroundings(const SchemeContext& context, const CellGroup<Quad4>& group, const BlockLayer& layer,
    const GaussStrain<Quad4, Pack>& strain, StressArrays<2> arrays)
{
  std::array<Index, pack_width> cells;
  std::array<Real, pack_width> sizes{};
  alignas(64) Real x[2][Quad4::n_gauss * pack_width] = {};
  cells.fill(-1);
  for (int c = 0; c < group.n(); ++c) {
    if (layer.block[c] < 0) continue;
    cells[c] = group.cells[c];
    sizes[c] = std::sqrt(group.mesh.geometry(cells[c]).volume);
    for (int g = 0; g < Quad4::n_gauss; ++g) {
      const auto N = Quad4::shape_functions(Quad4::gauss_place(g));
      for (int d = 0; d < 2; ++d)
        for (int i = 0; i < Quad4::n_corners; ++i)
          x[d][g * pack_width + c] += N[i] * group.mesh.nodes[group.mesh.cells[cells[c]][i]][d];
    }
  }
  Surroundings<2> around{.time = context.time,
      .step = context.step,
      .cells = cells,
      .cell_sizes = sizes,
      .d_spin = numbers_of(strain.d_spin),
      .turned = rotates(context)};
  for (int d = 0; d < 2; ++d) around.x[d] = x[d];
  arrays.around = &around;
  context.materials[layer.material].law->update(arrays);
}

void rotate_gauss_points(const GaussStrain<Quad4, Pack>& strain, GaussValues<Quad4, Pack>& gauss)
{
  for (int g = 0; g < Quad4::n_gauss; ++g) {
    SymTensor<Pack, 2> at;
    for (int k = 0; k < n_sym<2>; ++k) at[k] = gauss.sigma[k][g];
    rotate_stress(at, strain.d_spin[g]);
    for (int k = 0; k < n_sym<2>; ++k) gauss.sigma[k][g] = at[k];
  }
}

}  // namespace

void take_means_of_rows(LayerNow& now)
{
  divide_rows(now.gauss, now.material, now.rows);
  average_rows(now.gauss, now.material, now.rows);
}

GaussWork update_gauss_points(LayerNow& now)
{
  const SchemeContext& context = now.at.step.context;
  const CellGroup<Quad4>& group = now.at.group;
  const SoilMaterial& material = now.material;
  GaussValues<Quad4, Pack>& gauss = now.gauss;
  const GaussStrain<Quad4, Pack>& strain = *now.strain;
  GaussRow<Quad4>& plastic_work = now.law.plastic_work;
  GaussWork work;
  for (int g = 0; g < Quad4::n_gauss; ++g) {
    SymTensor<Pack, 2> sigma, d_eps;
    for (int k = 0; k < n_sym<2>; ++k) sigma[k] = gauss.sigma[k][g], d_eps[k] = strain.d_eps[k][g];
    work.power += gauss.volume[g] * double_dot(sigma, d_eps);
  }
  if (rotates(context)) rotate_gauss_points(strain, gauss);
  constexpr Index n = Quad4::n_gauss * pack_width;  // numbers of a row
  StressArrays<2> arrays{};
  for (int k = 0; k < n_sym<2>; ++k) arrays.sigma[k] = numbers_of(gauss.sigma[k]);
  for (int k = 0; k < n_sym<2>; ++k) arrays.d_eps[k] = numbers_of(strain.d_eps[k]);
  arrays.law.state = {.data = reinterpret_cast<Real*>(now.rows), .stride = n};
  arrays.law.parameters = {.data = arrays.law.state(material.n_state()), .stride = n};
  arrays.plastic_work = numbers_of(plastic_work);
  arrays.n = arrays.n_points = n;
  arrays.dt = context.dt;
  arrays.at_strength = context.at_strength;
  PerGauss<Quad4, Pack> scale;
  if (!material.softening_scale.empty()) {
    alignas(64) Real of_cells[pack_width];
    std::fill_n(of_cells, pack_width, 1.0);
    for (int c = 0; c < group.n(); ++c) of_cells[c] = material.softening_scale[group.cells[c]];
    scale.fill(Pack::load(of_cells));
    arrays.softening_scale = numbers_of(scale);
  }
  if (material.type->looks_around)
    update_with_surroundings(context, group, now.layer, strain, arrays);
  else
    material.law->update(arrays);

  for (int g = 0; g < Quad4::n_gauss; ++g) {
    work.plastic += plastic_work[g] * (*now.booked)[g];
    work.plastic_beside += plastic_work[g] * (gauss.volume[g] - (*now.booked)[g]);
  }
  return work;
}

}  // namespace terp
