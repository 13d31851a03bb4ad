// A grid that counts its cells has the size of the root of their mean area; all sizes of a polygon scale together, so
// that meshes of a study stay similar. Sizes that would leave a part of a cell are refused, and those that fit are
// named.

#include "io/case/cell_size.hpp"

#include "io/case/printable.hpp"
#include "model/bodies/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace terp {
namespace {

constexpr Real most_rounding = 0.02;  // of a number of cells, relative: the sizes then are those asked for within 2 %

[[noreturn]] void refuse(const CaseFile& file, Real cell, const std::string& what, const std::string& detail)
{
  throw CaseError(printable(fmt::format("error: {}: cells of {:g} m: {}\n  {}\n", file.path, cell, what, detail)));
}

/// Outline of a mapped grid: bottom, right, top and left once around, ends twice.
std::vector<Vec<2>> outline_of(const MeshCase& mesh)
{
  std::vector<Vec<2>> corners;
  for (int side = 0; side < 4; ++side) {
    const auto& line = mesh.sides[side];
    if (side < 2)
      corners.insert(corners.end(), line.begin(), line.end());
    else
      corners.insert(corners.end(), line.rbegin(), line.rend());
  }
  return corners;
}

/// Smaller side of the box around the mesh [m].
Real height_of(const MeshCase& mesh)
{
  constexpr Real far = std::numeric_limits<Real>::infinity();
  std::vector<Vec<2>> corners = mesh.kind == MeshKind::polygon ? mesh.polygon : outline_of(mesh);
  if (mesh.kind == MeshKind::rectangle || mesh.kind == MeshKind::graded) return std::min(mesh.size[0], mesh.size[1]);
  Vec<2> low{far, far}, high{-far, -far};
  for (const Vec<2>& x : corners)
    for (int d = 0; d < 2; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  return std::min(high[0] - low[0], high[1] - low[1]);
}

/// Of a grid that counts its cells: as many times more as they shall be smaller.
std::vector<std::string> changes_of_grid(const CaseFile& file, Real cell)
{
  const MeshCase& mesh = file.values.mesh;
  const Real area =
      mesh.kind == MeshKind::graded ? mesh.size[0] * mesh.size[1] : std::abs(signed_area(outline_of(mesh)));
  const auto [nx, ny] = mesh.cells;
  const Real present = std::sqrt(area / (static_cast<Real>(nx) * static_cast<Real>(ny))), more = present / cell;
  const Real x = static_cast<Real>(nx) * more, y = static_cast<Real>(ny) * more;
  const auto fits = [](Real n) { return std::round(n) >= 1.0 && std::abs(std::round(n) - n) <= most_rounding * n; };
  if (!fits(x) || !fits(y)) {
    std::vector<std::string> sizes;
    for (const Real factor : {4.0, 2.0, 1.0, 0.5, 0.25})
      if (fits(static_cast<Real>(nx) / factor) && fits(static_cast<Real>(ny) / factor))
        sizes.push_back(fmt::format("{:.4g}", present * factor));
    refuse(file, cell, "the grid is not a whole number of such cells",
        fmt::format("It has {} by {} cells of {:.4g} m (root of their mean area); {:g} m would make {:.4g} by {:.4g}.\n"
                    "  Sizes that fit: {} m",
            nx, ny, present, cell, x, y, fmt::join(sizes, ", ")));
  }
  return {fmt::format("mesh.cells=[{:.0f}, {:.0f}]", std::round(x), std::round(y))};
}

/// Of a rectangle with cells of this shape (height over width); the nearest sizes that make whole numbers of cells.
std::vector<std::string> changes_of_rectangle(const CaseFile& file, Real cell)
{
  constexpr Real rounded = 1e-6;  // relative, as for mesh.cell
  const MeshCase& mesh = file.values.mesh;
  const Real shape = mesh.cell[1] / mesh.cell[0], width = mesh.size[0], height = mesh.size[1];
  const auto is_whole = [](Real n) { return std::round(n) >= 1.0 && std::abs(n - std::round(n)) <= rounded * n; };
  const auto fits = [&](Real size) { return is_whole(width / size) && is_whole(height / (size * shape)); };
  if (fits(cell) && shape == 1.0) return {fmt::format("mesh.cell={}", cell)};
  if (fits(cell)) return {fmt::format("mesh.cell=[{}, {}]", cell, cell * shape)};
  std::vector<std::string> sizes;
  const Real n = std::round(width / cell);
  for (const int step : {-1, 1})
    for (Real k = n; k >= 1.0 && k <= 4.0 * n + 4.0; k += step)
      if (fits(width / k)) {
        sizes.push_back(fmt::format("{:.9g}", width / k));
        break;
      }
  refuse(file, cell, "the mesh is not a whole number of such cells",
      fmt::format("It is {:g} m by {:g} m. The nearest sizes that fit: {} m", width, height, fmt::join(sizes, ", ")));
}

std::vector<std::string> changes_of_polygon(const MeshCase& mesh, Real cell)
{
  std::vector<std::string> changes{fmt::format("mesh.cell={}", cell)};
  for (std::size_t k = 0; k < mesh.refine.size(); ++k)
    changes.push_back(fmt::format("mesh.refine[{}].cell={}", k, mesh.refine[k].cell * (cell / mesh.cell[0])));
  return changes;
}

}  // namespace

std::vector<std::string> changes_to_cell_size(const CaseFile& file, Real cell)
{
  const MeshCase& mesh = file.values.mesh;
  if (mesh.kind == MeshKind::file)
    refuse(file, cell, fmt::format("the mesh is a file of its own, {}, and has the cells that it has", mesh.file),
        "Let the case describe the mesh (terp explain mesh), as by a polygon; or mesh each size yourself, solve each\n"
        "  with terp run, and set them side by side with terp compare.");
  if (const Real height = height_of(mesh); cell > height)
    refuse(file, cell, "they are larger than the mesh",
        fmt::format("It is {:.4g} m high or wide. Give sizes of a tenth of the soil's height and less.", height));
  switch (mesh.kind) {
    case MeshKind::graded:
    case MeshKind::mapped: return changes_of_grid(file, cell);
    case MeshKind::polygon: return changes_of_polygon(mesh, cell);
    default: return changes_of_rectangle(file, cell);
  }
}

std::vector<Real> descending_sizes(std::vector<Real> cells)
{
  std::ranges::sort(cells, std::ranges::greater{});
  if (const auto twice = std::ranges::adjacent_find(cells); twice != cells.end())
    throw CaseError(fmt::format("error: --cells: the size {:g} m is given twice\n  Give each size once.\n", *twice));
  return cells;
}

}  // namespace terp
