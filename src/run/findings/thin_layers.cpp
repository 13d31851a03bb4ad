// The section is looked at along vertical lines, a cell apart. On each line the bodies give a row of pieces from the
// top down. A piece of a layer has stronger soil below it, and stronger soil or nothing above. Strengths are compared
// at the pressure of the weight above, so that friction counts.

#include "run/findings/thin_layers.hpp"

#include "model/ground/ground_section.hpp"
#include "run/findings/soil_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace terp {
namespace {

constexpr Real stronger = 1.5;         // times the strength of the layer
constexpr Real most_of_it = 0.5;       // of a material
constexpr Real slender = 5.0;          // length over thickness: less is a lens
constexpr Real between_layers = 1e-3;  // of a cell: what coordinates in millimetres leave between outlines that touch

/// At a pressure [Pa]; infinite of soil that never yields, not a number where the law does not say it.
Real strength_of(const Model& model, Index m, Real pressure)
{
  const SoilMaterial& soil = model.materials[m];
  const std::vector<Real>& values = model.description.materials[static_cast<std::size_t>(m)].parameters;
  if (row_of(soil, Role::plastic_strain) < 0) return soil.law->shear_modulus() > 0.0 ? INFINITY : 0.0;
  Real cohesion = NAN, angle = NAN;  // of several, as peak and residual, the first
  for (std::size_t k = 0; k < soil.type->parameters.size() && !soil.type->by_library; ++k) {
    const ParameterInfo& info = soil.type->parameters[k];
    if (info.reduction == Reduction::divide && info.unit == "Pa" && std::isnan(cohesion)) cohesion = values[k];
    if (info.reduction == Reduction::divide_tangent && std::isnan(angle)) angle = values[k];
  }
  const Real friction = std::isnan(angle) ? 0.0 : pressure * std::tan(angle * std::numbers::pi / 180.0);
  return std::isnan(cohesion) ? NAN : cohesion + friction;
}

class LayerSearch {
 public:
  LayerSearch(const Model& model, const State& state)
      : model_(model), columns_(columns_of_section(*model.mesh)), pieces_(model, between_layers * columns_.width)
  {
    const Real g = std::hypot(model.gravity[0], model.gravity[1]);
    if (g > 0.0) down_ = {model.gravity[0] / g, model.gravity[1] / g};
    g_ = g;
    std::vector<Real> n(model.materials.size(), 0.0);
    sizes_.assign(n.size(), 0.0);
    for_each_block(state.points, [&](const PointBlock<2>& block) {
      sizes_[block.material] += std::sqrt(model.mesh->geometry(block.cell).volume);
      n[block.material] += 1.0;
    });
    for (std::size_t m = 0; m < n.size(); ++m) sizes_[m] /= n[m];
  }

  std::vector<ThinLayer> find()
  {
    std::vector<Real> whole(model_.materials.size(), 0.0);
    std::vector<SoilPiece> before;
    for (Index c = 0; c < columns_.n; ++c) {
      const std::vector<SoilPiece> pieces = pieces_.at(columns_.left + (static_cast<Real>(c) + 0.5) * columns_.width);
      for (const SoilPiece& piece : pieces)
        if (piece.material >= 0) whole[piece.material] += piece.height();
      look_at(pieces, before);
      before = pieces;
    }
    std::vector<ThinLayer> layers;
    for (const auto& [key, sum] : sums_) {
      const Real n = static_cast<Real>(sum.n), slopes = std::max<Real>(1.0, static_cast<Real>(sum.n_slopes));
      const Real thickness = sum.height / n / std::hypot(1.0, sum.slope / slopes);
      if (sum.height < most_of_it * whole[key.first] || n * columns_.width < slender * thickness) continue;
      layers.push_back({key.first, key.second, thickness, sizes_[key.first], sum.driving / slopes});
    }
    return layers;
  }

 private:
  struct Sum {
    Index n = 0, n_slopes = 0;
    Real height = 0.0, slope = 0.0, driving = 0.0;
  };

  bool is_stronger(Index than, Index other, Real pressure) const
  {
    if (other < 0) return false;
    const Real own = strength_of(model_, than, pressure);
    return std::isfinite(own) && strength_of(model_, other, pressure) >= stronger * own;
  }

  void look_at(const std::vector<SoilPiece>& pieces, const std::vector<SoilPiece>& before)
  {
    Real pressure = 0.0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const auto [m, top, base] = pieces[k];
      const Real above = pressure;
      if (m < 0) continue;
      pressure += model_.materials[m].density * g_ * (top - base);
      const bool at_surface = k == 0, covered = !at_surface && is_stronger(m, pieces[k - 1].material, above);
      if (!(at_surface || covered) || k + 1 == pieces.size() || !is_stronger(m, pieces[k + 1].material, pressure))
        continue;
      Sum& sum = sums_[{m, at_surface}];
      sum.n += 1, sum.height += top - base;
      const auto same = std::ranges::find(before, m, &SoilPiece::material);
      if (same == before.end()) continue;
      const Real slope = (base - same->base) / columns_.width;
      sum.n_slopes += 1, sum.slope += std::abs(slope);
      sum.driving += std::abs(down_[0] + slope * down_[1]) / std::hypot(1.0, slope);
    }
  }

  const Model& model_;
  Columns columns_;
  SoilPieces pieces_;
  std::vector<Real> sizes_;                     ///< of the cells of each material, in the mean [m]
  Vec<2> down_{};                               ///< of length 1; zero without gravity
  Real g_ = 0.0;                                ///< [m/s^2]
  std::map<std::pair<Index, bool>, Sum> sums_;  ///< by material, and whether it is the surface
};

}  // namespace

std::vector<ThinLayer> find_layers(const Model& model, const State& state)
{
  if (!has_outlines(model)) return {};
  return LayerSearch(model, state).find();
}

}  // namespace terp
