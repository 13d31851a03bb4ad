#include "dstability/import_doubts.hpp"

#include "dstability/section_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace terp {
namespace {

constexpr Real small = 0.1;        // of a cell: a smaller gap or overlap changes nothing
constexpr Real beyond_end = 0.01;  // [m] beyond an end: coordinates of drawings are in cm
constexpr Real no_pop = 1.0;       // [Pa]
constexpr std::size_t columns = 112;

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
std::string list_of_sentences(const std::vector<std::string>& sentences)
{
  std::string text = "[";
  for (const std::string& sentence : sentences) {
    std::string rest = in_quotes(sentence);
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

std::vector<std::string> doubts_of_reading(const StixProject& project, std::size_t scenario, std::size_t stage)
{
  std::vector<std::string> doubts;
  std::set<std::string> of_history;
  for (std::size_t k = 0; k <= stage; ++k) of_history.insert(fmt::format("scenario {}, stage {}", scenario + 1, k + 1));
  for (const StixRemark& remark : project.remarks) {
    const bool is_of_stage = remark.where.starts_with("scenario "), is_of_result = remark.where.starts_with("results/");
    const bool is_of_others = !remark.stages.empty() && std::ranges::none_of(remark.stages, [&](const auto& of) {
      return of.first == scenario && of.second <= stage;
    });
    if (is_of_others || remark.is_of_format || is_of_result || (is_of_stage && !of_history.contains(remark.where)))
      continue;
    doubts.push_back(fmt::format("{}: {}", remark.where, remark.what));
  }
  return doubts;
}

std::vector<std::string> doubts_of_water(const StixScenario& scenario, std::size_t stage, bool has_shansep)
{
  std::vector<std::string> doubts;
  for (std::size_t k = has_shansep ? 0 : stage; k <= stage; ++k)
    if (const StixStage& of = scenario.stages[k]; !of.water.is_mesh && !of.water.phreatic)
      doubts.push_back(fmt::format("Stage `{}` has no phreatic line: all of its soil counts as dry{}.", of.label,
          k < stage ? ", and yield stresses are at least what it carries then" : ""));
  return doubts;
}

std::vector<std::string> doubts_of_embankment(const StixSection& section)
{
  const StixEmbankment& at = section.stage().embankment;
  const std::pair<const char*, Real> named[] = {{"toe at the water side", at.toe_water},
      {"top at the water side", at.top_water}, {"top at the land side", at.top_land},
      {"base of the shoulder at the land side", at.shoulder_land}, {"toe at the land side", at.toe_land}};
  std::vector<std::string> doubts;
  std::vector<std::pair<const char*, Real>> given;
  for (const auto& [name, x] : named)
    if (std::isfinite(x)) given.emplace_back(name, x);
  Real left = 1e30, right = -1e30;
  for (const StixLayer& layer : section.stage().layers)
    for (const Vec<2>& x : layer.outline) left = std::min(left, x[0]), right = std::max(right, x[0]);
  for (const auto& [name, x] : given)
    if (x < left - beyond_end || x > right + beyond_end)
      doubts.push_back(
          fmt::format("The file has the {} of its embankment at x = {:.2f} m, where there is no ground.", name, x));
  const auto goes_back = [](Real sign) {
    return [sign](const auto& one, const auto& next) { return sign * (next.second - one.second) < 0.0; };
  };
  const Real sign = given.size() > 1 && given.back().second < given.front().second ? -1.0 : 1.0;
  if (const auto wrong = std::ranges::adjacent_find(given, goes_back(sign)); wrong != given.end())
    doubts.push_back(fmt::format(
        "The points of the embankment of the file are in no order: the {} is at x = {:.2f} m, the {} at x = {:.2f} m.",
        wrong->first, wrong->second, std::next(wrong)->first, std::next(wrong)->second));
  return doubts;
}

std::vector<std::string> doubts_of_numbers(const StixSection& section)
{
  constexpr Vec<2> of_water{9.5e3, 10.5e3}, of_soil{8e3, 25e3};  // [N/m^3]
  constexpr Real largest_load = 200e3;                           // [Pa]; a lorry is 10 to 20 kPa
  const StixStage& stage = section.stage();
  std::vector<std::string> doubts;
  const auto look = [&](const std::string& what, Real weight, Vec<2> usual) {
    if (weight < usual[0] || weight > usual[1])
      doubts.push_back(fmt::format("{} weighs {:g} kN/m3: {:g} to {:g} kN/m3 are usual. Is it in another unit?", what,
          weight / 1e3, usual[0] / 1e3, usual[1] / 1e3));
  };
  if (stage.water.is_mesh || stage.water.phreatic) look("The water of the stage", stage.water.unit_weight, of_water);
  std::set<std::size_t> soils;
  for (const StixLayer& layer : stage.layers)
    if (layer.soil && soils.insert(*layer.soil).second) {
      const StixSoil& soil = section.project().soils[*layer.soil];
      look(fmt::format("The soil `{}` above the phreatic line", soil.name), soil.weight_above, of_soil);
      look(fmt::format("The soil `{}` below the phreatic line", soil.name), soil.weight_below, of_soil);
    }
  for (const StixUniformLoad& load : stage.loads)
    if (std::abs(load.magnitude) > largest_load)
      doubts.push_back(fmt::format("The load `{}` is {:g} kPa, as much as {:.0f} m of soil. Is it in another unit?",
          load.label, load.magnitude / 1e3, load.magnitude / 18e3));
  return doubts;
}

std::vector<std::string> doubts_of_preload(const StixSection& section, const std::vector<LayerPiece>& pieces, Real cell)
{
  std::map<std::size_t, Real> largest;  // POP by layer, of any stage and place [Pa]
  for (const LayerPiece& piece : pieces)
    for (const auto& [x, z] : places_in(*piece.region, 2.0 * cell)) {
      const StixColumn column = section.column(x);
      if (const auto place = column.at(z); !place || place->layer != piece.layer) continue;
      Real& most = largest.try_emplace(piece.layer, 0.0).first->second;
      for (const Real pop : column.pops(z)) most = std::max(most, pop);
    }
  std::vector<std::string> doubts;
  for (const auto& [layer, most] : largest) {
    if (most > no_pop) continue;
    const StixLayer& of = section.stage().layers[layer];
    doubts.push_back(
        fmt::format("The layer `{}` has SHANSEP strength, but no state point or state line of any stage gives it a POP "
                    "above zero: it "
                    "counts as normally consolidated, the weakest that it can be.",
            name_of_layer(section.project(), of)));
  }
  return doubts;
}

std::vector<std::string> doubts_of_outlines(
    const CleanSection& clean, const std::vector<DrawnRegion>& drawn, const std::vector<CleanRegion>& fills, Real cell)
{
  std::vector<std::string> doubts;
  for (const auto& [above, empty] : empty_places(clean.regions))
    if (empty.area > small * cell * cell)
      doubts.push_back(fmt::format(
          "Below the layer `{}` no layer covers {:.3g} m2, up to {:.2f} m high, between x = {:.2f} and {:.2f} m: it is "
          "empty. Is a layer missing?",
          drawn[above].name, empty.area, empty.height, empty.left, empty.right));
  for (const DrawingFault& both : clean.overlaps)
    if (both.area > small * cell * cell)
      doubts.push_back(fmt::format(
          "The layers {} overlap by {:.3g} m2 at {:.2f}, {:.2f} m: the one with the smaller outline counts.",
          names_of(both.drawn, drawn), both.area, both.x[0], both.x[1]));
  std::map<int, std::pair<Real, Real>> below;  // area and thickness by drawn region [m^2, m]
  for (const CleanRegion& fill : fills) {
    auto& [area, thickness] = below[fill.drawn];
    area += signed_area(fill.polygon);
    const auto [low, high] = std::ranges::minmax(fill.polygon, {}, [](const Vec<2>& x) { return x[1]; });
    thickness = std::max(thickness, high[1] - low[1]);
  }
  for (const auto& [k, fill] : below)
    if (fill.second > cell)
      doubts.push_back(fmt::format(
          "Below the layer `{}` the file has no soil, down to {:.2f} m under it: {:.1f} m2 were filled with "
          "that layer. Is a layer missing?",
          drawn[k].name, fill.second, fill.first));
  return doubts;
}

CaseTableText doubts_table(const std::vector<std::string>& doubts, const std::vector<Sentence>& assumed)
{
  std::vector<std::string> dutch;
  for (const Sentence& sentence : assumed) dutch.push_back(sentence.nl);
  const std::vector<std::string> english = in_english(assumed);
  CaseTableText table{"[reference]",
      doubts.empty()
          ? ""
          : "What speaks against this case. Every command that reads it says so; take out what you have looked "
            "at.",
      {}};
  for (const auto& [key, texts] : {std::pair{"doubts", &doubts}, {"assumed", &english}, {"assumed_nl", &dutch}})
    if (!texts->empty()) table.lines.push_back({key, list_of_sentences(*texts), ""});
  return table;
}

}  // namespace terp
