// Outlines of the points reach above the ground and are cut there, so that the ground is that of the profile. Layers
// have no holes: a region is cut through the middle of each. Corners of one layer on a side of another become corners
// of both.

#include "import/dstability/stix_export.hpp"

#include "math/errors.hpp"
#include "math/plane.hpp"
#include "import/drawing/point_section.hpp"
#include "import/drawing/section_export.hpp"
#include "import/dstability/case_text.hpp"
#include "import/dstability/read_stix.hpp"
#include "import/dstability/section_layout.hpp"
#include "import/dstability/stix_stage.hpp"
#include "io/files/files.hpp"
#include "model/bodies/body_outline.hpp"
#include "model/water/water_pressure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real on_a_side = 1e-5;  // [m]

/// Regions of the points, and how wide they lie [m].
struct PointsAtEnd {
  std::vector<CleanRegion> regions;
  BoundingBox box;
};

PointsAtEnd points_at_end(const SoilPoints& soil, Real tolerance)
{
  PointRegions of =
      regions_of_points(soil.places, soil.volumes, soil.materials, {.tolerance = tolerance, .reaches_above = true});
  PointsAtEnd end{std::move(of.regions), box_around(soil.places)};
  const Real half = of.box / 6.0;  // of a point
  for (int d = 0; d < 2; ++d) end.box.low[d] -= half, end.box.high[d] += half;
  return end;
}

/// The soil that a material was made of: of those whose key its name begins with the longest.
const StixSoil* soil_of(const StixProject& project, const std::string& material)
{
  const std::string film = "film_";
  const std::string name = (material.starts_with(film) ? material.substr(film.size()) : material) + "_";
  const StixSoil* found = nullptr;
  std::size_t longest = 0;
  for (const StixSoil& soil : project.soils)
    if (const std::string key = key_of_name(soil.name) + "_"; name.starts_with(key) && key.size() > longest)
      found = &soil, longest = key.size();
  return found;
}

/// Without holes: what other regions fill lies between the pieces, and a gap that no other fills is filled.
void add_without_holes(CleanRegion region, const std::vector<CleanRegion>& all, std::vector<CleanRegion>& pieces)
{
  std::erase_if(region.holes, [&](Polygon hole) {
    std::ranges::reverse(hole);
    return std::ranges::none_of(all, [&](const CleanRegion& other) { return contains(hole, place_in(other.polygon)); });
  });
  if (region.holes.empty()) return pieces.push_back(std::move(region));
  const BoundingBox box = box_around(region.holes.front());
  Real slivers = 0.0;
  for (CutRegion& cut : cut_along(region, {{box.low[0], 0.5 * (box.low[1] + box.high[1])}}, 0.0, slivers))
    add_without_holes(std::move(cut.region), all, pieces);
}

void share_corners(std::vector<CleanRegion>& regions)
{
  std::vector<Vec<2>> corners;
  for (const CleanRegion& region : regions) corners.insert(corners.end(), region.polygon.begin(), region.polygon.end());
  std::ranges::sort(corners);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (CleanRegion& region : regions) {
    Polygon shared;
    for (std::size_t k = 0; k < region.polygon.size(); ++k) {
      const Vec<2> a = region.polygon[k], b = region.polygon[(k + 1) % region.polygon.size()];
      const Real length = distance(a, b);
      std::vector<std::pair<Real, Vec<2>>> between;
      for (auto at = std::ranges::lower_bound(corners, Vec<2>{std::min(a[0], b[0]) - on_a_side, -1e9});
           at != corners.end() && (*at)[0] <= std::max(a[0], b[0]) + on_a_side; ++at) {
        const Real along = ((b[0] - a[0]) * ((*at)[0] - a[0]) + (b[1] - a[1]) * ((*at)[1] - a[1])) / length;
        if (along > on_a_side && along < length - on_a_side && std::abs(cross(a, b, *at)) < on_a_side * length)
          between.emplace_back(along, *at);
      }
      std::ranges::sort(between);
      shared.push_back(a);
      for (const auto& [along, x] : between) shared.push_back(x);
    }
    region.polygon = std::move(shared);
  }
}

/// In whole micrometres, without corners that are there twice in a row.
void round_corners(Polygon& polygon)
{
  for (Vec<2>& x : polygon)
    for (Real& value : x) value = std::round(value * 1e6) * 1e-6;
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
}

std::vector<CleanRegion> layers_of(const PointsAtEnd& end, const std::vector<Vec<2>>& ground)
{
  std::vector<CleanRegion> below, layers;
  Real slivers = 0.0;
  for (const CleanRegion& region : end.regions)
    for (CutRegion& cut : cut_along(region, ground, 0.0, slivers))
      if (!cut.above) below.push_back(std::move(cut.region));
  for (const CleanRegion& region : below) add_without_holes(region, below, layers);
  for (CleanRegion& layer : layers) {
    layer.polygon = clip_to_box(layer.polygon, end.box);  // boxes reach beyond the last points
    round_corners(layer.polygon);
  }
  std::erase_if(layers, [](const CleanRegion& layer) { return layer.polygon.size() < 3; });
  share_corners(layers);
  return layers;
}

/// The water in which the run ended; null: of none, or of a formula or grid.
const WaterSituation* water_at_end(const Case& c, std::size_t n_stages)
{
  if (!c.water.is_given()) return nullptr;
  const WaterSituation* water = &first_water(c.water);
  for (std::size_t k = 0; k < std::min(n_stages, c.stages.size()); ++k)
    if (!c.stages[k].water.empty()) water = &situation_of(c.water, situation_number(c.water, c.stages[k].water));
  return water->phreatic_line.empty() ? nullptr : water;
}

}  // namespace

StixExport export_stix(const RunResults& run, const StixExportOptions& options)
{
  const auto [description, frames, soil_at_end, before_it, ground] = ends_of(run);
  const std::string bytes = read_file(options.original);
  const StixProject project = read_stix(options.original);
  StixExport result{.bytes = {}, .time = frames.times().back(), .n_layers = 0, .notes = {}};
  const std::string& before = project.scenarios.at(options.scenario).stages.at(options.stage).label;
  AddedStage added{options.scenario, options.stage, before + " (after the run)", {}, {}};
  std::vector<Problem> problems;
  for (CleanRegion& layer : layers_of(points_at_end(soil_at_end, options.tolerance), ground)) {
    const std::string& name = description.materials.at(static_cast<std::size_t>(layer.drawn)).called();
    const StixSoil* soil = soil_of(project, name);
    if (soil == nullptr)
      problems.push_back({options.original, fmt::format("has no soil for the material `{}` of the run", name),
          "Materials of an import begin with the name of their soil. Give the file that the case was made of.", ""});
    for (const std::string& fault : check_outline(BodyOutline{layer.polygon, {1, 1}}))
      problems.push_back({run.folder, fmt::format("an outline of `{}` is none that a layer can have", name),
          fault + " Give another --tolerance.", ""});
    if (soil != nullptr) added.layers.push_back({name, soil->id, std::move(layer.polygon)});
  }
  if (!problems.empty()) throw InputError(problems);
  const WaterSituation* water = water_at_end(description, run.summary.values.stages.size());
  if (water != nullptr)
    added.water = WaterOfLines{*water, description.water.unit_weight};
  else
    result.notes.emplace_back("the water is that of the stage before it: that of the run cannot be said with lines");
  result.n_layers = added.layers.size();
  result.bytes = with_added_stage(bytes, options.original, added);
  read_stix_bytes(result.bytes, options.original);  // what cannot be read back is not written
  return result;
}

}  // namespace terp
