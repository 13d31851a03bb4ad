// The geometry of eight cells, one per lane, for work that is the same in each.
#pragma once

#include "mesh/cell_geometry.hpp"
#include "parallel/lanes.hpp"

#include <algorithm>

namespace terp {

/// What the work at Gauss points needs; names and shapes as in CellGeometry<2>.
struct GeometryLanes {
  std::array<std::array<std::array<Pack, 4>, 2>, 4> gradient;
  std::array<std::array<Pack, 2>, 4> centre_gradient;
  std::array<Pack, 4> gauss_volume;
  Pack volume;
};

/// All lanes of one geometry.
inline GeometryLanes repeat_in_lanes(const CellGeometry<2>& cell)
{
  GeometryLanes lanes;
  for (int i = 0; i < 4; ++i)
    for (int d = 0; d < 2; ++d) {
      for (int g = 0; g < 4; ++g) lanes.gradient[i][d][g] = Pack(cell.gradient[i][d][g]);
      lanes.centre_gradient[i][d] = Pack(cell.centre_gradient[i][d]);
    }
  for (int g = 0; g < 4; ++g) lanes.gauss_volume[g] = Pack(cell.gauss_volume[g]);
  lanes.volume = Pack(cell.volume);
  return lanes;
}

inline GeometryLanes geometry_lanes(const std::array<const CellGeometry<2>*, pack_width>& cells)
{
  if (std::all_of(cells.begin(), cells.end(), [&](const auto* cell) { return cell == cells[0]; }))
    return repeat_in_lanes(*cells[0]);
  GeometryLanes lanes;
  for (int i = 0; i < 4; ++i)
    for (int d = 0; d < 2; ++d) lanes.gradient[i][d] = to_lanes([&](int c) { return cells[c]->gradient[i][d].data(); });
  for (int i = 0; i < 4; i += 2) {
    const auto pairs = to_lanes([&](int c) { return cells[c]->centre_gradient[i].data(); });
    lanes.centre_gradient[i] = {pairs[0], pairs[1]};
    lanes.centre_gradient[i + 1] = {pairs[2], pairs[3]};
  }
  lanes.gauss_volume = to_lanes([&](int c) { return cells[c]->gauss_volume.data(); });
  alignas(64) Real volume[pack_width];
  for (int c = 0; c < pack_width; ++c) volume[c] = cells[c]->volume;
  lanes.volume = Pack::load(volume);
  return lanes;
}

}  // namespace terp
