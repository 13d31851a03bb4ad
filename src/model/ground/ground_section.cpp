#include "model/ground/ground_section.hpp"

#include "model/meshes/setup_mesh.hpp"

namespace terp {

std::vector<std::uint8_t> ground_of(const Model& model)
{
  std::vector<std::uint8_t> ground;
  bool some = false, all = true;
  for (const SoilMaterial& material : model.materials) {
    ground.push_back(material.is_ground);
    some |= material.is_ground, all &= material.is_ground;
  }
  return some && !all ? ground : std::vector<std::uint8_t>{};
}

Columns columns_of_section(const Mesh<2>& mesh)
{
  const Vec<2> x = extent_in_x(mesh);
  return columns_between(x[0], x[1], typical_cell_size(mesh));
}

Section first_section(const Model& model, const PointBlocks<2>& points, Ground ground)
{
  return look_at_section(*model.mesh, points, columns_of_section(*model.mesh), ground);
}

StandingGround standing_ground(const Model& model, const PointBlocks<2>& points, std::optional<Real> level)
{
  const std::vector<std::uint8_t> ground = ground_of(model);
  std::vector<int> strain;
  for (const SoilMaterial& material : model.materials) strain.push_back(row_of(material, Role::plastic_strain));
  return look_at_ground(*model.mesh, points,
      {.columns = columns_of_section(*model.mesh),
          .ground = ground,
          .strain = strain,
          .intact_below = model.description.flood.intact_below,
          .level = level.value_or(model.flood_level.value)});
}

}  // namespace terp
