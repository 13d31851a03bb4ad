#include "model/ground/ground_section.hpp"

#include "model/meshes/setup_mesh.hpp"
#include "mpm/mesh/locate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace terp {

namespace {

/// Empty: all materials are ground, or none is.
std::vector<std::uint8_t> some_of(std::vector<std::uint8_t> ground)
{
  const auto n = std::ranges::count(ground, 1);
  return n > 0 && n < std::ssize(ground) ? std::move(ground) : std::vector<std::uint8_t>{};
}

}  // namespace

std::vector<std::uint8_t> ground_of(const Model& model)
{
  std::vector<std::uint8_t> ground;
  for (const SoilMaterial& material : model.materials) ground.push_back(material.is_ground);
  return some_of(std::move(ground));
}

std::vector<Vec<2>> ground_line(const Case& c, const Mesh<2>& mesh, const SoilPoints& soil)
{
  std::vector<std::uint8_t> is_ground;
  for (const MaterialCase& material : c.materials) is_ground.push_back(material.ground && !material.is_fluid());
  const std::vector<std::uint8_t> ground = some_of(std::move(is_ground));
  PointBlocks<2> points(mesh.n_cells(), 0);
  std::vector<Real> rows(static_cast<std::size_t>(points.n_rows()), 0.0);
  for (std::size_t p = 0; p < soil.places.size(); ++p) {
    const Vec<2>& x = soil.places[p];
    rows[Rows::x] = x[0], rows[Rows::x + 1] = x[1], rows[Rows::volume] = soil.volumes[p];
    points.add({locate(mesh, x).cell, soil.materials[p], 0}, rows);
  }
  points.update_occupied();
  const Columns columns = columns_of_section(mesh);
  const StandingGround standing = look_at_ground(mesh, points, {.columns = columns, .ground = ground});
  std::vector<Vec<2>> line;
  for (Index k = 0; k < columns.n; ++k)
    if (const Real y = standing.heights[static_cast<std::size_t>(k)]; std::isfinite(y))
      line.push_back({columns.left + (k + 0.5) * columns.width, y});
  return line;
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
