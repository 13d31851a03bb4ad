// Between the phreatic line, or the ground where it is lower, and the reference lines the pressure is linear, not
// hydrostatic.

#include "import/dstability/water_column.hpp"

#include "math/interpolate.hpp"

#include <algorithm>
#include <limits>

namespace terp {
namespace {

constexpr Real no_water = -std::numeric_limits<Real>::infinity();

/// Where a vertical line crosses the edge from a to b: elevation and pressure.
struct MeshCut {
  Real z, pressure;
};

/// The two ends of the piece of the vertical line in a triangle; of no length: none.
std::vector<MeshCut> cut(const StixWaterTriangle& triangle, Real x)
{
  std::vector<MeshCut> cuts;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Vec<2> a = triangle.corners[k], b = triangle.corners[next];
    if (a[0] == b[0] || x < std::min(a[0], b[0]) || x > std::max(a[0], b[0])) continue;
    const Real s = (x - a[0]) / (b[0] - a[0]);
    cuts.push_back({std::lerp(a[1], b[1], s), std::lerp(triangle.pressure[k], triangle.pressure[next], s)});
  }
  if (cuts.size() < 2) return {};
  const auto [low, high] = std::ranges::minmax(cuts, {}, &MeshCut::z);
  return low.z < high.z ? std::vector<MeshCut>{high, low} : std::vector<MeshCut>{};
}

}  // namespace

StixWaterColumn::StixWaterColumn(const StixWater& water, Real x, Real ground)
    : is_mesh_(water.is_mesh), unit_weight_(water.unit_weight), ground_(ground), phreatic_(no_water)
{
  if (water.is_mesh)
    read_mesh(water, x);
  else if (water.phreatic)
    read_lines(water, x);
}

void StixWaterColumn::read_lines(const StixWater& water, Real x)
{
  const auto head = [&](std::size_t line) { return interpolate(water.head_lines[line].line, x); };
  phreatic_ = head(*water.phreatic);
  const Real start = std::min(phreatic_, ground_);
  for (const StixReferenceLine& line : water.reference_lines)
    if (const Real z = interpolate(line.line, x); z <= start)
      levels_.push_back({z, unit_weight_ * (head(line.top_head) - z), unit_weight_ * (head(line.bottom_head) - z)});
  std::ranges::stable_sort(levels_, std::ranges::greater{}, &Level::z);
  const Real at_start = unit_weight_ * (phreatic_ - start);
  levels_.insert(levels_.begin(), {start, at_start, at_start});
}

void StixWaterColumn::read_mesh(const StixWater& water, Real x)
{
  const auto x_of = [](const Vec<2>& corner) { return corner[0]; };
  Real left = std::numeric_limits<Real>::infinity(), right = -left;
  for (const StixWaterTriangle& triangle : water.mesh) {
    left = std::min(left, std::ranges::min(triangle.corners, {}, x_of)[0]);
    right = std::max(right, std::ranges::max(triangle.corners, {}, x_of)[0]);
  }
  const Real inside = std::clamp(x, left, std::max(left, right));
  for (const StixWaterTriangle& triangle : water.mesh)
    for (const MeshCut& at : cut(triangle, inside)) levels_.push_back({at.z, at.pressure, at.pressure});
  std::ranges::sort(levels_, std::ranges::greater{}, &Level::z);
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    if (!(levels_[k].above > 0.0)) continue;
    const Level& wet = levels_[k];
    if (k == 0)
      phreatic_ = wet.z + wet.above / unit_weight_;
    else  // where the pressure passes zero between the level above and this one
      phreatic_ = std::lerp(wet.z, levels_[k - 1].z, wet.above / (wet.above - levels_[k - 1].below));
    break;
  }
}

Real StixWaterColumn::free_water() const { return std::max(phreatic_ - ground_, 0.0); }

Real StixWaterColumn::pressure(Real z) const
{
  if (!(z < phreatic_) || levels_.empty()) return 0.0;
  if (z >= levels_.front().z) return unit_weight_ * (phreatic_ - z);
  const auto below = std::ranges::find_if(levels_, [z](const Level& level) { return level.z <= z; });
  const Level& upper = *(below - 1);
  if (below == levels_.end()) return upper.below + unit_weight_ * (upper.z - z);
  const Real between = std::lerp(upper.below, below->above, (upper.z - z) / (upper.z - below->z));
  return is_mesh_ ? std::max(between, 0.0) : between;  // a seepage analysis may have suction under wet soil
}

}  // namespace terp
