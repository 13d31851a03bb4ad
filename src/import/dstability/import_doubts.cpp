// Each function has its own limits of what is usual. Empty places are found between the x of all corners, where no edge
// begins or ends: from below, each edge enters or leaves its region, and where none is open there is no soil.

#include "import/dstability/import_doubts.hpp"

#include "math/interpolate.hpp"
#include "import/dstability/reported_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace terp {
namespace {

constexpr Real small = 0.1;      // of a cell: a smaller gap or overlap changes nothing
constexpr Real no_pop = 1.0;     // [Pa]
constexpr Real touches = 0.05;   // [m] between a state line and a layer: the same
constexpr Real far_below = 2.0;  // heights of the dike between the ground and a phreatic line that is hardly meant
constexpr std::size_t columns = 112;

/// A state line that does not touch a layer, where it is nearest to it.
struct FarLine {
  Real x, distance;  ///< upright [m]
  bool is_below;
  Real pop = 0.0;  ///< that the layer has of it there [Pa]
};

/// Which layers of each stage have a state of their own: a point, or a line that runs through them or along them.
class StatesOfLayers {
 public:
  explicit StatesOfLayers(const StixSection& section) : stages_(section.history()), has_one_(stages_.size())
  {
    constexpr int n = 500;
    for (std::size_t k = 0; k < stages_.size(); ++k) {
      for (const StixStatePoint& point : stages_[k]->state_points) {
        const auto layer = std::ranges::find(stages_[k]->layers, point.layer, &StixLayer::id);
        has_one_[k].insert(static_cast<std::size_t>(layer - stages_[k]->layers.begin()));
      }
      if (stages_[k]->state_lines.empty()) continue;
      const BoundingBox box = box_around(stages_[k]->layers);
      for (int i = 0; i <= n; ++i) {
        const Real x = std::lerp(box.low[0] + just_inside, box.high[0] - just_inside, static_cast<Real>(i) / n);
        for (const SoilBand& band : soil_bands(*stages_[k], x))
          if (const auto line = nearest_line(k, x, band); line && line->distance <= touches)
            has_one_[k].insert(band.layer);
      }
    }
  }

  bool has_one(std::size_t stage, std::size_t layer) const { return has_one_[stage].contains(layer); }

  std::optional<SoilBand> band(std::size_t stage, Vec<2> place) const
  {
    const std::vector<SoilBand> bands = soil_bands(*stages_[stage], place[0]);
    const SoilBand* const found = band_at(bands, place[1]);
    return found == nullptr ? std::nullopt : std::optional(*found);
  }

  std::optional<FarLine> nearest_line(std::size_t stage, Real x, const SoilBand& band) const
  {
    std::optional<FarLine> nearest;
    for (const StixStateLine& line : stages_[stage]->state_lines) {
      const Real z = interpolate(line.line, x), distance = std::max({band.bottom - z, z - band.top, 0.0});
      if (!nearest || distance < nearest->distance) nearest = FarLine{x, distance, z < band.bottom};
    }
    return nearest;
  }

 private:
  const std::vector<const StixStage*>& stages_;
  std::vector<std::set<std::size_t>> has_one_;  ///< layers by stage
};

std::string names_of(const std::vector<int>& numbers, const std::vector<DrawnRegion>& drawn)
{
  std::string text;
  for (const int k : numbers)
    if (k >= 0 && k < static_cast<int>(drawn.size())) text += (text.empty() ? "`" : ", `") + drawn[k].name + '`';
  return text;
}

/// What no region covers below one of them.
struct EmptyPlace {
  Real left = 1e30, right = -1e30, height = 0.0, area = 0.0;  ///< [m, m^2]
};

struct EdgeOver {
  Real left = 0.0, right = 0.0;  ///< elevation at both ends of an interval [m]
  int drawn = -1;
  std::size_t region = 0;
};

/// The edges of all outlines over an interval without corners, from below.
std::vector<EdgeOver> edges_over(const std::vector<CleanRegion>& regions, Real left, Real right)
{
  std::vector<EdgeOver> edges;
  const auto add = [&](const Polygon& outline, std::size_t region) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
      Vec<2> a = outline[k], b = outline[(k + 1) % outline.size()];
      if (a[0] > b[0]) std::swap(a, b);
      if (a[0] > left || b[0] < right) continue;
      const auto at = [&](Real x) { return std::lerp(a[1], b[1], (x - a[0]) / (b[0] - a[0])); };
      edges.push_back({at(left), at(right), regions[region].drawn, region});
    }
  };
  for (std::size_t k = 0; k < regions.size(); ++k) {
    add(regions[k].polygon, k);
    for (const Polygon& hole : regions[k].holes) add(hole, k);
  }
  std::ranges::sort(edges, {}, [](const EdgeOver& edge) { return edge.left + edge.right; });
  return edges;
}

/// By the drawn region above, also where the place is open at an end of the section or under an overhang.
std::map<int, EmptyPlace> empty_places(const std::vector<CleanRegion>& regions)
{
  std::set<Real> corners;
  for (const CleanRegion& region : regions) {
    for (const Vec<2>& x : region.polygon) corners.insert(x[0]);
    for (const Polygon& hole : region.holes)
      for (const Vec<2>& x : hole) corners.insert(x[0]);
  }
  std::map<int, EmptyPlace> places;
  if (corners.empty()) return places;
  for (auto left = corners.begin(), right = std::next(left); right != corners.end(); left = right++) {
    std::set<std::size_t> inside;
    const EdgeOver* below = nullptr;
    const std::vector<EdgeOver> edges = edges_over(regions, *left, *right);
    for (const EdgeOver& edge : edges) {
      if (below && inside.empty() && edge.left + edge.right > below->left + below->right) {
        EmptyPlace& place = places[edge.drawn];
        place.left = std::min(place.left, *left);
        place.right = std::max(place.right, *right);
        place.height = std::max({place.height, edge.left - below->left, edge.right - below->right});
        place.area += 0.5 * (edge.left + edge.right - below->left - below->right) * (*right - *left);
      }
      if (!inside.erase(edge.region)) inside.insert(edge.region);
      below = &edge;
    }
  }
  return places;
}

/// One text to a line, in lines of at most 120 columns.
std::string list_of_sentences(const std::vector<Sentence>& sentences, std::string Sentence::*language)
{
  std::string text = "[";
  for (const Sentence& sentence : sentences) {
    std::string rest = in_quotes(sentence.*language);
    rest = "\"\"\"" + rest.substr(1, rest.size() - 2) + "\"\"\"";
    text += "\n  ";
    while (rest.size() > columns) {
      std::size_t cut = rest.rfind(' ', columns);
      if (cut == std::string::npos || cut < 4) break;
      text += rest.substr(0, cut + 1) + "\\\n    ";
      rest = rest.substr(cut + 1);
    }
    text += rest + ",";
  }
  return text + "\n]";
}

}  // namespace

std::vector<Sentence> doubts_of_reading(const StixProject& project, std::size_t scenario, std::size_t stage)
{
  std::vector<Sentence> doubts;
  std::map<std::string, std::string> of_history;  // English -> Dutch
  for (std::size_t k = 0; k <= stage; ++k) {
    const Sentence name = filled<reported_texts::stage_number>(scenario + 1, k + 1);
    of_history[name.en] = name.nl;
  }
  for (const StixRemark& remark : project.remarks) {
    const bool is_of_stage = remark.where.starts_with("scenario "), is_of_result = remark.where.starts_with("results/");
    const bool is_of_others = !remark.stages.empty() && std::ranges::none_of(remark.stages, [&](const auto& of) {
      return of.first == scenario && of.second <= stage;
    });
    const auto named = of_history.find(remark.where);
    if (is_of_others || remark.is_of_format || is_of_result || (is_of_stage && named == of_history.end())) continue;
    const std::string& where_nl = named == of_history.end() ? remark.where : named->second;
    doubts.push_back({remark.where + ": " + remark.what, where_nl + ": " + remark.what_nl});
  }
  return doubts;
}

std::vector<Sentence> doubts_of_water(const StixScenario& scenario, std::size_t stage, bool has_shansep)
{
  std::vector<Sentence> doubts;
  for (std::size_t k = has_shansep ? 0 : stage; k <= stage; ++k)
    if (const StixStage& of = scenario.stages[k]; !of.water.is_mesh && !of.water.phreatic)
      doubts.push_back(k < stage ? filled<reported_texts::no_phreatic_line_before>(of.label)
                                 : filled<reported_texts::no_phreatic_line>(of.label));
  return doubts;
}

std::vector<Sentence> doubts_of_datum(const StixSection& section, bool has_shansep, Real height)
{
  constexpr int n = 200;
  std::vector<Sentence> doubts;
  const std::vector<const StixStage*>& stages = section.history();
  for (std::size_t k = has_shansep ? 0 : stages.size() - 1; k < stages.size(); ++k) {
    const StixStage& stage = *stages[k];
    if (stage.water.is_mesh || !stage.water.phreatic) continue;
    const BoundingBox box = box_around(stage.layers);
    Real highest = -1e30, least_depth = 1e30;
    for (int i = 0; i <= n; ++i) {
      const Real x = std::lerp(box.low[0] + just_inside, box.high[0] - just_inside, static_cast<Real>(i) / n);
      const StixStageColumn column(section.project(), stage, x);
      highest = std::max(highest, column.water().phreatic());
      if (std::isfinite(column.ground()))
        least_depth = std::min(least_depth, column.ground() - column.water().phreatic());
    }
    if (highest < box.low[1])
      doubts.push_back(filled<reported_texts::water_below_all>(stage.label, highest, box.low[1]));
    else if (least_depth > far_below * height)
      doubts.push_back(filled<reported_texts::deep_water>(stage.label, least_depth, height));
  }
  return doubts;
}

std::vector<Sentence> doubts_of_embankment(
    const StixSection& section, const std::string& river, const SectionLayout& layout)
{
  const StixEmbankment& at = section.stage().embankment;
  struct Point {
    Sentence name;
    Real x;
    Real side;   // 1: at the land's side of the crest, -1: at the water's
    Real slack;  // [m] by which it may lie beyond the highest ground
  };
  const BoundingBox box = box_around(section.stage().layers);
  std::vector<Sentence> doubts;
  std::vector<Point> given;
  for (const Point& point : {Point{filled<reported_texts::toe_water>(), at.toe_water, -1.0, 0.0},
           {filled<reported_texts::top_water>(), at.top_water, -1.0, layout.height},
           {filled<reported_texts::top_land>(), at.top_land, 1.0, layout.height},
           {filled<reported_texts::shoulder_land>(), at.shoulder_land, 1.0, 0.0},
           {filled<reported_texts::toe_land>(), at.toe_land, 1.0, 0.0}})
    if (std::isfinite(point.x)) given.push_back(point);
  for (const Point& point : given)
    if (point.x < box.low[0] - beyond_end || point.x > box.high[0] + beyond_end)
      doubts.push_back(filled<reported_texts::point_without_ground>(point.name, point.x));
  const auto goes_back = [](Real sign) {
    return [sign](const Point& one, const Point& next) { return sign * (next.x - one.x) < 0.0; };
  };
  const Real sign = given.size() > 1 && given.back().x < given.front().x ? -1.0 : 1.0;
  if (const auto wrong = std::ranges::adjacent_find(given, goes_back(sign)); wrong != given.end())
    doubts.push_back(
        filled<reported_texts::points_in_no_order>(wrong->name, wrong->x, std::next(wrong)->name, std::next(wrong)->x));
  if (!doubts.empty() || river.empty()) return doubts;
  const Real to_land = river == "left" ? 1.0 : -1.0, crest = layout.crest[0];
  for (const Point& point : given)
    if (to_land * point.side * (point.x - crest) < -point.slack)
      doubts.push_back(filled<reported_texts::point_on_other_side>(point.name, point.x, crest,
          river == "left" ? filled<reported_texts::left_end>() : filled<reported_texts::right_end>()));
  return doubts;
}

std::vector<Sentence> doubts_of_numbers(const StixSection& section)
{
  constexpr Vec<2> of_water{9.5e3, 10.5e3}, of_soil{8e3, 25e3};  // [N/m^3]
  constexpr Real largest_load = 200e3;                           // [Pa]; a lorry is 10 to 20 kPa
  const StixStage& stage = section.stage();
  std::vector<Sentence> doubts;
  const auto look = [&](const Sentence& what, Real weight, Vec<2> usual) {
    if (weight < usual[0] || weight > usual[1])
      doubts.push_back(filled<reported_texts::unusual_weight>(what, weight / 1e3, usual[0] / 1e3, usual[1] / 1e3));
  };
  if (stage.water.is_mesh || stage.water.phreatic)
    look(filled<reported_texts::water_of_stage>(), stage.water.unit_weight, of_water);
  std::set<std::size_t> soils;
  for (const StixLayer& layer : stage.layers)
    if (layer.soil && soils.insert(*layer.soil).second) {
      const StixSoil& soil = section.project().soils[*layer.soil];
      look(filled<reported_texts::soil_above>(soil.name), soil.weight_above, of_soil);
      look(filled<reported_texts::soil_below>(soil.name), soil.weight_below, of_soil);
    }
  for (const StixUniformLoad& load : stage.loads)
    if (std::abs(load.magnitude) > largest_load)
      doubts.push_back(filled<reported_texts::large_load>(load.label, load.magnitude / 1e3, load.magnitude / 18e3));
  return doubts;
}

std::vector<Sentence> doubts_of_preload(const StixSection& section, const std::vector<LayerPiece>& pieces, Real cell)
{
  const StatesOfLayers states(section);
  struct Preload {
    Real largest = 0.0;  ///< POP of any stage and place [Pa]
    bool has_state = false;
    std::optional<FarLine> line = {};
  };
  std::map<std::size_t, Preload> by_layer;
  for (const LayerPiece& piece : pieces)
    for (const auto& [x, z] : places_in(*piece.region, 2.0 * cell)) {
      const StixColumn column = section.column(x);
      if (const auto place = column.at(z); !place || place->layer != piece.layer) continue;
      Preload& preload = by_layer[piece.layer];
      const std::vector<Real> pops = column.pops(z);
      for (std::size_t k = 0; k < pops.size(); ++k) {
        preload.largest = std::max(preload.largest, pops[k]);
        const std::optional<SoilBand> band = states.band(k, {x, z});
        if (!band) continue;
        preload.has_state = preload.has_state || states.has_one(k, band->layer);
        const auto line = states.nearest_line(k, x, *band);
        if (!line || (preload.line && preload.line->distance <= line->distance)) continue;
        preload.line = line;
        preload.line->pop = pops[k];
      }
    }
  std::vector<Sentence> doubts;
  for (const auto& [layer, preload] : by_layer) {
    const std::string name = name_of_layer(section.project(), section.stage().layers[layer]);
    if (!(preload.largest > no_pop))
      doubts.push_back(filled<reported_texts::no_pop>(name));
    else if (!preload.has_state && preload.line)
      doubts.push_back(filled<reported_texts::pop_of_a_far_line>(name, preload.line->pop / 1e3, preload.line->distance,
          preload.line->is_below ? filled<reported_texts::below_it>() : filled<reported_texts::above_it>(),
          preload.line->x));
  }
  return doubts;
}

std::vector<Sentence> doubts_of_outlines(
    const CleanSection& clean, const std::vector<DrawnRegion>& drawn, const std::vector<CleanRegion>& fills, Real cell)
{
  std::vector<Sentence> doubts;
  for (const auto& [above, empty] : empty_places(clean.regions))
    if (empty.area > small * cell * cell)
      doubts.push_back(
          filled<reported_texts::empty_below>(drawn[above].name, empty.area, empty.height, empty.left, empty.right));
  for (const DrawingFault& both : clean.overlaps)
    if (both.area > small * cell * cell)
      doubts.push_back(
          filled<reported_texts::layers_overlap>(names_of(both.drawn, drawn), both.area, both.x[0], both.x[1]));
  std::map<int, std::pair<Real, Real>> below;  // area and thickness by drawn region [m^2, m]
  for (const CleanRegion& fill : fills) {
    auto& [area, thickness] = below[fill.drawn];
    area += signed_area(fill.polygon);
    const auto [low, high] = std::ranges::minmax(fill.polygon, {}, [](const Vec<2>& x) { return x[1]; });
    thickness = std::max(thickness, high[1] - low[1]);
  }
  for (const auto& [k, fill] : below)
    if (fill.second > cell)
      doubts.push_back(filled<reported_texts::filled_below>(drawn[k].name, fill.second, fill.first));
  return doubts;
}

CaseTableText doubts_table(
    const std::vector<Sentence>& doubts, const std::vector<Sentence>& assumed, const std::string& imported)
{
  CaseTableText table{"[reference]",
      doubts.empty()
          ? ""
          : "What speaks against this case. Every command that reads it says so; take out what you have looked "
            "at.",
      {}};
  for (const auto& [key, sentences] : {std::pair{"doubts", &doubts}, {"assumed", &assumed}}) {
    if (sentences->empty()) continue;
    table.lines.push_back({key, list_of_sentences(*sentences, &Sentence::en), ""});
    table.lines.push_back({fmt::format("{}_nl", key), list_of_sentences(*sentences, &Sentence::nl), ""});
  }
  if (!imported.empty())
    table.lines.push_back({"imported", in_quotes(imported), "this case as it was imported, to name what you change"});
  return table;
}

}  // namespace terp
