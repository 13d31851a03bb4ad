#include "run/findings/soil_pieces.hpp"

#include "model/bodies/setup_points.hpp"

#include <algorithm>

namespace terp {

SoilPieces::SoilPieces(const Model& model, Real tolerance) : model_(model), tolerance_(tolerance)
{
  for (const BodyOutline& outline : outlines_of(model)) sides_.push_back(outline_sides(*model.mesh, outline));
}

std::vector<SoilPiece> SoilPieces::at(Real x) const
{
  std::vector<Real> levels;
  for (std::size_t b = 0; b < sides_.size(); ++b)
    if (model_.description.bodies[b].is_there)
      std::ranges::copy(crossings_of_vertical(sides_[b], x), std::back_inserter(levels));
  std::ranges::sort(levels, std::greater());
  std::vector<SoilPiece> pieces;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    if (!(levels[k] - levels[k + 1] > tolerance_)) continue;
    const Index m = material_at(x, 0.5 * (levels[k] + levels[k + 1]));
    if (!pieces.empty() && pieces.back().material == m)
      pieces.back().base = levels[k + 1];
    else
      pieces.push_back({m, levels[k], levels[k + 1]});
  }
  return pieces;
}

/// Where bodies overlap, the last one is there.
Index SoilPieces::material_at(Real x, Real y) const
{
  for (std::size_t b = sides_.size(); b-- > 0;) {
    if (!model_.description.bodies[b].is_there) continue;
    if (encloses(sides_[b], {x, y})) return material_number(model_, model_.description.bodies[b].material);
  }
  return -1;
}

bool has_outlines(const Model& model)
{
  return std::ranges::none_of(model.description.bodies, [](const BodyCase& body) { return !body.points_file.empty(); });
}

}  // namespace terp
