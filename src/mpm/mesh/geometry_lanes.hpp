// The geometry of eight cells, one per lane, for work that is the same in each.
#pragma once

#include "mpm/mesh/cell_geometry.hpp"
#include "math/lanes.hpp"

#include <algorithm>

namespace terp {

/// What the work at Gauss points needs; names and shapes as in CellGeometry.
template <class E>
struct GeometryLanes {
  using Element = E;
  PerCorner<E, PerDirection<E, PerGauss<E, Pack>>> gradient;
  PerCorner<E, PerDirection<E, Pack>> centre_gradient;
  PerGauss<E, Pack> gauss_volume;
  Pack volume;
};

/// All lanes of one geometry.
template <class Element>
inline GeometryLanes<Element> repeat_in_lanes(const CellGeometry<Element>& cell)
{
  GeometryLanes<Element> lanes;
  for (int i = 0; i < Element::n_corners; ++i)
    for (int d = 0; d < Element::dim; ++d) {
      for (int g = 0; g < Element::n_gauss; ++g) lanes.gradient[i][d][g] = Pack(cell.gradient[i][d][g]);
      lanes.centre_gradient[i][d] = Pack(cell.centre_gradient[i][d]);
    }
  for (int g = 0; g < Element::n_gauss; ++g) lanes.gauss_volume[g] = Pack(cell.gauss_volume[g]);
  lanes.volume = Pack(cell.volume);
  return lanes;
}

/// The numbers of cells one lane per cell: value(c) of cell c.
template <class Value>
inline Pack pack_of(Value&& value)
{
  alignas(64) Real numbers[pack_width];
  for (int c = 0; c < pack_width; ++c) numbers[c] = value(c);
  return Pack::load(numbers);
}

template <class Element>
inline GeometryLanes<Element> geometry_lanes(const std::array<const CellGeometry<Element>*, pack_width>& cells)
{
  if (std::all_of(cells.begin(), cells.end(), [&](const auto* cell) { return cell == cells[0]; }))
    return repeat_in_lanes(*cells[0]);
  GeometryLanes<Element> lanes;
  for (int i = 0; i < Element::n_corners; ++i)
    for (int d = 0; d < Element::dim; ++d) {
      lanes.gradient[i][d] = to_lanes([&](int c) { return cells[c]->gradient[i][d].data(); });
      lanes.centre_gradient[i][d] = pack_of([&](int c) { return cells[c]->centre_gradient[i][d]; });
    }
  lanes.gauss_volume = to_lanes([&](int c) { return cells[c]->gauss_volume.data(); });
  lanes.volume = pack_of([&](int c) { return cells[c]->volume; });
  return lanes;
}

}  // namespace terp
