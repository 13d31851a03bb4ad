// Points, lines and surfaces have the numbers of the map plus one: by them generate.cpp knows which nodes may move. The
// turned squares and the points of distance fields have numbers beyond these, which begin with the same one, so input
// refuses refinement in a turned mesh. target_size computes what size_fields asks of gmsh: change both together.

#include "model/meshes/geo_text.hpp"

#include "model/meshes/mesh_error.hpp"
#include "model/meshes/turned_squares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace terp {
namespace {

constexpr Real clearance = 1.2;  // of the turned squares from the polygon, over the size of a cell, measured

Real distance_to_lines(const std::vector<Vec<2>>& line, Vec<2> x)
{
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t k = 1; k < line.size(); ++k) least = std::min(least, distance_to_line(line[k - 1], line[k], x));
  return least;
}

Real distance_to_box(const Refinement& refine, Vec<2> x)
{
  const Real dx = std::max({refine.low[0] - x[0], x[0] - refine.high[0], 0.0});
  const Real dy = std::max({refine.low[1] - x[1], x[1] - refine.high[1], 0.0});
  return std::hypot(dx, dy);
}

/// "1, 2, -3".
template <class T>
std::string listed(const std::vector<T>& numbers)
{
  std::string text;
  for (const T& number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
  return text;
}

/// Lines of the turned squares, which have the numbers beyond those of the map.
std::vector<Index> beyond(std::size_t n_lines, std::span<const Index> lines)
{
  const auto n = static_cast<Index>(n_lines);
  std::vector<Index> numbers;
  for (const Index line : lines) numbers.push_back(line > 0 ? line + n : line - n);
  return numbers;
}

TurnedSquares squares_inside(const PolygonMesh& mesh)
{
  const Real side = 2.0 * mesh.cell;
  TurnedSquares grid = turned_squares(mesh.polygon, side, mesh.turn, clearance * mesh.cell);
  if (grid.squares.empty())
    throw MeshError(
        fmt::format("no square of {:g} m, two by two cells, fits into the mesh at {:g} degrees\n  Use smaller cells.",
            side, mesh.turn));
  return grid;
}

/// Each square is a surface of one quadrilateral, which is halved as all others.
std::string squares_text(const TurnedSquares& grid, const PlanarMap& map, std::size_t& n_loops)
{
  const std::size_t n_places = map.places.size(), n_lines = map.lines.size(), n_faces = map.faces.size();
  std::string text;
  for (std::size_t i = 0; i < grid.places.size(); ++i)
    text +=
        fmt::format("Point({}) = {{{:.17g}, {:.17g}, 0}};\n", n_places + i + 1, grid.places[i][0], grid.places[i][1]);
  for (std::size_t k = 0; k < grid.lines.size(); ++k)
    text += fmt::format("Line({}) = {{{}, {}}};\n", n_lines + k + 1,
        n_places + static_cast<std::size_t>(grid.lines[k][0]) + 1,
        n_places + static_cast<std::size_t>(grid.lines[k][1]) + 1);
  for (std::size_t k = 0; k < grid.squares.size(); ++k)
    text += fmt::format("Curve Loop({0}) = {{{1}}};\nPlane Surface({2}) = {{{0}}};\n", ++n_loops,
        listed(beyond(n_lines, grid.squares[k])), n_faces + k + 1);
  return text + fmt::format("Transfinite Curve {{{}:{}}} = 2;\nTransfinite Surface {{{}:{}}};\n", n_lines + 1,
                    n_lines + grid.lines.size(), n_faces + 1, n_faces + grid.squares.size());
}

std::string geometry(const PolygonMesh& mesh, const PlanarMap& map)
{
  TurnedSquares grid;
  if (mesh.turn != 0.0) grid = squares_inside(mesh);
  std::string text;
  for (std::size_t i = 0; i < map.places.size(); ++i)
    text += fmt::format("Point({}) = {{{:.17g}, {:.17g}, 0}};\n", i + 1, map.places[i][0], map.places[i][1]);
  for (std::size_t k = 0; k < map.lines.size(); ++k)
    text += fmt::format("Line({}) = {{{}, {}}};\n", k + 1, map.lines[k].a + 1, map.lines[k].b + 1);
  std::size_t n_loops = 0;
  if (!grid.squares.empty()) text += squares_text(grid, map, n_loops);
  std::vector<std::size_t> surfaces;
  for (const Face& face : map.faces) {
    std::vector<std::size_t> loops;
    const auto add = [&](const std::vector<Index>& lines) {
      loops.push_back(++n_loops);
      text += fmt::format("Curve Loop({}) = {{{}}};\n", n_loops, listed(lines));
    };
    for (const auto& loop : face) add(loop);
    for (const auto& loop : grid.outline) add(beyond(map.lines.size(), loop));
    surfaces.push_back(surfaces.size() + 1);
    text += fmt::format("Plane Surface({}) = {{{}}};\n", surfaces.back(), listed(loops));
  }
  for (std::size_t k = 0; k < grid.squares.size(); ++k) surfaces.push_back(surfaces.size() + 1);
  return text + fmt::format("Physical Surface(\"domain\") = {{{}}};\n", listed(surfaces));
}

std::string sides(const PolygonMesh& mesh, const PlanarMap& map)
{
  std::string text;
  for (const NamedEdges& named : mesh.edges) {
    std::vector<std::size_t> lines;
    for (std::size_t k = 0; k < map.lines.size(); ++k)
      if (std::ranges::count(named.edges, map.lines[k].edge) > 0) lines.push_back(k + 1);
    if (!lines.empty()) text += fmt::format("Physical Curve(\"{}\") = {{{}}};\n", named.side, listed(lines));
  }
  return text;
}

/// The line as loose places, half a cell apart: gmsh measures distances to them.
std::string distance_field(const Refinement& refine, std::size_t field, std::size_t& n_points)
{
  std::string text;
  const std::size_t first = n_points + 1;
  for (std::size_t k = 1; k < refine.line.size(); ++k) {
    const Vec<2>&a = refine.line[k - 1], &b = refine.line[k];
    const int n = std::max(1, static_cast<int>(std::ceil(std::hypot(b[0] - a[0], b[1] - a[1]) / (0.5 * refine.cell))));
    for (int i = k == 1 ? 0 : 1; i <= n; ++i)
      text += fmt::format("Point({}) = {{{:.17g}, {:.17g}, 0}};\n", ++n_points, a[0] + (b[0] - a[0]) * i / n,
          a[1] + (b[1] - a[1]) * i / n);
  }
  return text + fmt::format("Field[{0}] = Distance;\nField[{0}].PointsList = {{{1}:{2}}};\n", field, first, n_points);
}

/// Between 0.97 and 1.03 times the size: waves about seven triangles long, shifted by the number of the variant.
std::string wavering_field(std::size_t field, Real size, int variant)
{
  const Real wave = 2.0 * std::numbers::pi / (7.0 * size);
  return fmt::format(
      "Field[{0}] = MathEval;\nField[{0}].F = \"{1:.17g}*(1+0.03*Sin({2:.17g}*x+{3})*Cos({2:.17g}*y+{4}))\";\n", field,
      size, wave, 1.7 * variant, 2.9 * variant);
}

/// Fields whose least value is the size of the triangles.
std::string size_fields(const PolygonMesh& mesh, const PlanarMap& map, const Recipe& recipe)
{
  const Real factor = 2.0 * recipe.size_factor;
  std::string text;
  std::vector<std::size_t> fields;
  std::size_t n_fields = 0, n_points = map.places.size();
  for (const Refinement& refine : mesh.refine) {
    const Real near = std::min(refine.cell, mesh.cell) * factor, far = mesh.cell * factor;
    if (refine.line.empty()) {
      text += fmt::format(
          "Field[{0}] = Box;\nField[{0}].VIn = {1:.17g};\nField[{0}].VOut = {2:.17g};\nField[{0}].Thickness = "
          "{3:.17g};\n"
          "Field[{0}].XMin = {4:.17g};\nField[{0}].XMax = {5:.17g};\nField[{0}].YMin = {6:.17g};\nField[{0}].YMax = "
          "{7:.17g};\n"
          "Field[{0}].ZMin = -1;\nField[{0}].ZMax = 1;\n",
          ++n_fields, near, far, refine.distance, refine.low[0], refine.high[0], refine.low[1], refine.high[1]);
    } else {
      text += distance_field(refine, ++n_fields, n_points);
      text += fmt::format(
          "Field[{0}] = Threshold;\nField[{0}].InField = {1};\nField[{0}].DistMin = {2:.17g};\n"
          "Field[{0}].DistMax = {3:.17g};\nField[{0}].SizeMin = {4:.17g};\nField[{0}].SizeMax = {5:.17g};\n",
          n_fields + 1, n_fields, refine.cell, refine.cell + std::max(refine.distance, refine.cell), near, far);
      ++n_fields;
    }
    fields.push_back(n_fields);
  }
  if (recipe.variant > 0) {
    fields.push_back(++n_fields);
    text += wavering_field(n_fields, mesh.cell * factor, recipe.variant);
  }
  if (fields.empty()) return text;
  return text + fmt::format("Field[{0}] = Min;\nField[{0}].FieldsList = {{{1}}};\nBackground Field = {0};\n",
                    n_fields + 1, listed(fields));
}

/// Fixed seed, nothing from the geometry's points: only the fields and the target size decide.
std::string options(const PolygonMesh& mesh, const Recipe& recipe)
{
  const Real largest = recipe.variant > 0 ? 1.03 : 1.0;  // see wavering_field
  return fmt::format(
      "Mesh.Algorithm = {};\nMesh.RecombinationAlgorithm = {};\nMesh.RandomSeed = 1;\nMesh.MeshSizeMax = {:.17g};\n"
      "Mesh.RecombineAll = 1;\nMesh.SubdivisionAlgorithm = 1;\nMesh.Smoothing = 10;\nMesh.MeshSizeExtendFromBoundary = "
      "0;\n"
      "Mesh.MeshSizeFromPoints = 0;\nMesh.MshFileVersion = 4.1;\nMesh.Binary = 1;\nMesh.SaveAll = 0;\n",
      recipe.algorithm, recipe.recombination, 2.0 * largest * recipe.size_factor * mesh.cell);
}

}  // namespace

Real target_size(const PolygonMesh& mesh, Vec<2> x)
{
  Real size = mesh.cell;
  for (const Refinement& refine : mesh.refine) {
    const bool box = refine.line.empty();
    const Real away = box ? distance_to_box(refine, x) : std::max(0.0, distance_to_lines(refine.line, x) - refine.cell);
    const Real over = box ? refine.distance : std::max(refine.distance, refine.cell);
    const Real part = over > 0.0 ? std::min(1.0, away / over) : (away > 0.0 ? 1.0 : 0.0);
    size = std::min(size, refine.cell + part * (mesh.cell - refine.cell));
  }
  return size;
}

std::string geo_text(const PolygonMesh& mesh, const PlanarMap& map, const Recipe& recipe)
{
  for (const NamedEdges& named : mesh.edges)
    if (named.side.empty() || named.side.find_first_of("\"\\\n") != std::string::npos)
      throw MeshError(fmt::format("a side cannot be named `{}`: use letters, digits, spaces and _", named.side));
  return geometry(mesh, map) + sides(mesh, map) + size_fields(mesh, map, recipe) + options(mesh, recipe);
}

}  // namespace terp
