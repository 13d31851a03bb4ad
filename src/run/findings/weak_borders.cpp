// The section is looked at in the middle of columns of a cell's width. Places of one soil in neighbouring columns make
// a stretch, if none is more than two rows above or below the last.

#include "run/findings/weak_borders.hpp"

#include "model/bodies/setup_points.hpp"
#include "model/ground/ground_section.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/water/water_pressure.hpp"
#include "run/findings/soil_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace terp {
namespace {

constexpr Real rows_of_stress = 5.0;  // with more a row carries less than a tenth more than its top
constexpr Real no_cohesion = 1e3;     // of soil that has next to none [Pa]
constexpr Real pushes = 500.0;        // pressure above that of the phreatic line [Pa]
constexpr Real just_below = 1e-9;     // of a cell
constexpr Real gaps = 1e-3;           // of a cell: what coordinates in millimetres leave between outlines that touch

/// Where drained soil has next to no cohesion: tan of its friction angle. Else zero.
Real loose_friction(const Model& model, Index m, const PlaceInSoil& at)
{
  const MaterialCase& soil = model.description.materials[static_cast<std::size_t>(m)];
  const MaterialType* law = soil.type();
  if (law == nullptr || law->by_library || !soil.stores_effective() || soil.has_excess_pressure()) return 0.0;
  const std::vector<Real> values = parameters_at(soil, *law, at);
  Real cohesion = 0.0, friction = 0.0;
  for (std::size_t k = 0; k < law->parameters.size(); ++k) {
    if (law->parameters[k].name == "cohesion") cohesion = values[k];
    if (law->parameters[k].name == "friction_angle") friction = std::tan(values[k] * std::numbers::pi / 180.0);
  }
  return cohesion < no_cohesion ? friction : 0.0;
}

bool has_given_friction(const MaterialCase& soil)
{
  const MaterialType* law = soil.type();
  return law != nullptr && std::ranges::any_of(soil.fields, [&](const ParameterField& field) {
    return law->parameters[field.parameter].name == "friction_angle";
  });
}

class BorderSearch {
 public:
  BorderSearch(const Model& model, const WaterSituation& situation)
      : model_(model),
        situation_(situation),
        columns_(columns_of_section(*model.mesh)),
        pieces_(model, gaps * columns_.width),
        overburden_(model)
  {
    const Real right = columns_.left + static_cast<Real>(columns_.n) * columns_.width;
    const auto [low, high] = std::ranges::minmax(model.mesh->nodes, {}, [](const Vec<2>& x) { return x[1]; });
    table_ = water_table(overburden_.water(), situation, {columns_.left, low[1]}, {right, high[1]});
  }

  std::vector<WeakBorder> find(Real row) const
  {
    std::vector<WeakBorder> found, open;
    const auto close = [&](WeakBorder& border) {
      if (std::ranges::any_of(border.places, &BorderPlace::is_pushed)) found.push_back(std::move(border));
    };
    for (Index c = 0; c < columns_.n && !table_.empty(); ++c) {
      std::vector<WeakBorder> going_on;
      for (auto& [material, place] : borders_at(columns_.left + (static_cast<Real>(c) + 0.5) * columns_.width)) {
        if (!(place.carried_more(row) > 0.0)) continue;
        const auto before = std::ranges::find_if(open, [&, m = material, y = place.x[1]](const WeakBorder& border) {
          return border.material == m && std::abs(border.places.back().x[1] - y) < 2.0 * row;
        });
        WeakBorder border{material, columns_.width, {}};
        if (before != open.end()) border = std::move(*before), open.erase(before);
        border.places.push_back(place);
        going_on.push_back(std::move(border));
      }
      std::ranges::for_each(open, close);
      open = std::move(going_on);
    }
    std::ranges::for_each(open, close);
    return found;
  }

 private:
  std::vector<std::pair<Index, BorderPlace>> borders_at(Real x) const
  {
    std::vector<std::pair<Index, BorderPlace>> found;
    const std::vector<SoilPiece> pieces = pieces_.at(x);
    const auto& materials = model_.description.materials;
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      const SoilPiece &above = pieces[k - 1], &below = pieces[k];
      if (above.material < 0 || below.material < 0 || !(below.top < elevation_at(table_, x))) continue;
      const auto m = material_number(model_, materials[static_cast<std::size_t>(below.material)].called(), Zone::below);
      const Vec<2> at{x, below.top - just_below * columns_.width};  // the head there is that below a reference line
      const Real friction = loose_friction(model_, m, {at, &overburden_});
      if (!(friction > 0.0) || loose_friction(model_, above.material, {at, &overburden_}) > 0.0) continue;
      if (has_given_friction(materials[static_cast<std::size_t>(m)])) continue;
      const Real unit_weight = overburden_.water().unit_weight, g = -model_.gravity[1];
      BorderPlace place{
          at, overburden_.effective(at, situation_), model_.materials[m].density * g - unit_weight, friction};
      place.is_pushed =
          overburden_.pore_pressure(at, situation_) > unit_weight * (elevation_at(table_, x) - at[1]) + pushes;
      found.emplace_back(m, place);
    }
    return found;
  }

  const Model& model_;
  const WaterSituation& situation_;
  Columns columns_;
  SoilPieces pieces_;
  Overburden overburden_;
  std::vector<Vec<2>> table_;  ///< [m]
};

}  // namespace

Real BorderPlace::carried_more(Real row) const
{
  return stress < rows_of_stress * weight * row ? friction * weight * 0.5 * row : 0.0;
}

Real WeakBorder::carried_more(Real row) const
{
  Real sum = 0.0;
  for (const BorderPlace& place : places) sum += width * place.carried_more(row);
  return sum;
}

std::vector<WeakBorder> find_weak_borders(const Model& model, const WaterSituation& situation, Real row)
{
  if (!has_outlines(model) || !situation.is_given() || !(model.gravity[1] < 0.0)) return {};
  return BorderSearch(model, situation).find(row);
}

}  // namespace terp
