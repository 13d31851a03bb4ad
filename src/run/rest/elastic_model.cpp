// The elastic twin of a law takes the moduli from the law itself, at each place where any of its parameters varies. The
// twin keeps what decides where pore pressure goes and what stress is stored; else its state would not fit the model
// that takes it over. Rows of points are a union: those of the real laws ride along with their initial values. Rows of
// the twin's own varying parameters are struck out of the image, since the model that takes it over has no such rows.

#include "run/rest/elastic_model.hpp"

#include "soil/laws/elastic_constants.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/parts/setup.hpp"
#include "run/report/state_image.hpp"

#include <algorithm>
#include <limits>

namespace terp {
namespace {

bool has_strength(const MaterialType& law)
{
  return std::ranges::any_of(law.parameters, [](const ParameterInfo& p) { return is_strength(p.reduction); });
}

std::vector<Real> elastic_parameters(Moduli m) { return {m.shear, poisson_ratio_of(m)}; }

/// linear_elastic with the moduli of a law, at each place if any of its parameters varies. It lies where the soil lies,
/// and stores the stress that the soil stores.
MaterialCase elastic_twin(const MaterialCase& material, const MaterialType& law)
{
  MaterialCase twin{
      material.name, "linear_elastic", material.density, elastic_parameters(law.make(material.parameters)->moduli())};
  twin.drainage = material.stores_effective() ? Drainage::drained : Drainage::undrained;
  twin.k0 = material.k0;
  twin.permeability = material.permeability;
  twin.soil = material.soil;
  twin.zone = material.zone;
  if (material.fields.empty()) return twin;
  for (std::size_t k = 0; k < twin.parameters.size(); ++k)
    twin.fields.push_back({k, [material, &law, k](const PlaceInSoil& at) {
                             return elastic_parameters(law.make(parameters_at(material, law, at))->moduli())[k];
                           }});
  return twin;
}

/// The rows of both tables. Those of the second that the elastic soil does not look at keep their initial values.
RowTable joined(RowTable table, const RowTable& other)
{
  for (const RowInfo& row : other.added()) table.add(row);
  return table;
}

/// The case without a limit to any strength: laws are elastic, contact planes that hold along themselves do not let go.
/// No stage could give the soil its laws back.
Case elastic_case(Case c)
{
  c.stages.clear();
  c.at_strength = 1.0;
  for (MaterialCase& material : c.materials) {
    const MaterialType* law = find_material(material.model);
    if (has_strength(*law)) material = elastic_twin(material, *law);
  }
  for (SideCondition& side : c.sides)
    if (side.adhesion > 0.0 || side.friction > 0.0) side.adhesion = std::numeric_limits<Real>::infinity();
  return c;
}

}  // namespace

Model build_elastic_model(const Case& c, const SharedMesh& mesh, int threads, const RowTable& others)
{
  Model model = build_model(elastic_case(c), mesh, threads);
  model.rows = joined(model.rows, others);
  return model;
}

/// Parameters of the elastic soil that vary go.
StateImage image_of_rows(const State& state, const RowTable& table)
{
  StateImage image = make_image(state);
  const auto is_row = [&](const std::string& name) {
    return std::ranges::any_of(table.entries(), [&](const RowInfo& row) { return "points/" + row.name == name; });
  };
  std::erase_if(image.arrays,
      [&](const NamedArray& array) { return array.name.starts_with("points/parameter_") && !is_row(array.name); });
  return image;
}

}  // namespace terp
