// The border is looked at along vertical lines, half a row apart and at each corner of the layer below. Lines with a
// film that follow each other make a stretch. Its strength is drained: with tan phi_film = tan phi* sigma'(top) over
// sigma'(middle of the row), a row of cells carries what its top does, and still follows the weight above.

#include "import/dstability/film.hpp"

#include "import/dstability/reported_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace terp {
namespace {

constexpr Real in_degrees = 180.0 / std::numbers::pi;
constexpr Real no_cohesion = 1e3;     // c* of soil that has next to none [Pa]
constexpr Real rows_of_stress = 5.0;  // with more a row carries less than 10 % more than its top
constexpr Real pushes = 500.0;        // pressure above that of the water over the border [Pa]
constexpr Real lifted = 1e3;          // effective stress of ground on the point of uplift [Pa]
constexpr Real beyond_uplift = 20.0;  // of the section [m]
constexpr Real least_friction = 0.5;  // [degrees]
constexpr Real aside = 1e-6;          // from a corner, and from a border [m]

/// The border on one vertical line.
struct BorderPlace {
  Real x = 0.0, z = 0.0, thickness = 0.0;  ///< of the layer below [m]
  std::size_t layer = 0;
  Real stress = 0.0;        ///< effective, on the border, in this stage [Pa]
  Real least_stress = 0.0;  ///< in this stage and the first [Pa]
  Real weight = 0.0;        ///< of the soil below in water [N/m^3]
  Real friction = 0.0;      ///< tan phi* [-]
  bool is_pushed = false;   ///< the water below has more pressure than that above
};

bool is_pushed(const StixStageColumn& column, Real z)
{
  const StixWaterColumn& water = column.water();
  return water.pressure(z) > water.unit_weight() * std::max(water.phreatic() - z, 0.0) + pushes;
}

/// All borders of drained soil below other soil on a vertical line.
std::vector<BorderPlace> borders_at(const StixSection& now, const StixSection& first, Real x)
{
  const StixColumn column = now.column(x);
  const StixColumn before = first.column(x);
  const std::vector<SoilBand>& bands = column.now().bands();
  const StixStage& stage = now.stage();
  std::vector<BorderPlace> found;
  for (std::size_t k = 1; k < bands.size(); ++k) {
    const SoilBand &above = bands[k - 1], &below = bands[k];
    if (stage.layers[above.layer].soil == stage.layers[below.layer].soil) continue;
    const std::optional<StixPlace> soil = column.at(below.top - aside);
    if (!soil || !soil->below_water || !(soil->cohesion < no_cohesion) || !(soil->friction > 0.0)) continue;
    BorderPlace at{.x = x, .z = below.top, .thickness = below.top - below.bottom, .layer = below.layer};
    at.stress = column.now().effective_stress(at.z);
    at.least_stress = at.stress;
    at.is_pushed = is_pushed(column.now(), at.z);
    if (std::isfinite(before.ground()) && before.ground() > at.z) {
      at.least_stress = std::min(at.stress, before.now().effective_stress(at.z));
      at.is_pushed |= is_pushed(before.now(), at.z);
    }
    at.weight = soil->soil->weight_below - column.now().water().unit_weight();
    at.friction = std::tan(soil->friction / in_degrees);
    found.push_back(at);
  }
  return found;
}

/// x between two limits: half a row apart, and both sides of each corner of a layer.
std::set<Real> places_along(const StixStage& stage, Vec<2> between, Real row)
{
  std::set<Real> places;
  const auto insert = [&](Real x) { places.insert(std::clamp(x, between[0] + aside, between[1] - aside)); };
  for (Real x = between[0]; x < between[1]; x += 0.5 * row) insert(x);
  insert(between[1]);
  for (const StixLayer& layer : stage.layers)
    for (const Vec<2>& corner : layer.outline)
      if (corner[0] >= between[0] && corner[0] <= between[1])
        for (const Real x : {corner[0] - aside, corner[0] + aside}) insert(x);
  return places;
}

/// Without places on the straight line between their neighbours.
std::vector<Vec<2>> without_straight_places(const std::vector<Vec<2>>& line)
{
  std::vector<Vec<2>> kept;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (k > 0 && k + 1 < line.size()) {
      const Vec<2> a = kept.back(), b = line[k], c = line[k + 1];
      const Real on_line = std::lerp(a[1], c[1], c[0] > a[0] ? (b[0] - a[0]) / (c[0] - a[0]) : 0.0);
      if (std::abs(b[1] - on_line) < 1e-4) continue;
    }
    kept.push_back(line[k]);
  }
  return kept;
}

Film film_along(const std::vector<BorderPlace>& stretch, Real row)
{
  Film film;
  film.layer = stretch.front().layer;
  film.least = 1e30;
  std::vector<Vec<2>> top, bottom;
  Real least_stress = 1e30;
  for (std::size_t k = 0; k < stretch.size(); ++k) {
    const BorderPlace& at = stretch[k];
    const Real height = std::min(row, at.thickness), more = 0.5 * at.weight * height;
    top.push_back({at.x, at.z});
    bottom.push_back({at.x, at.z - height});
    film.friction.push_back({at.x, at.friction * at.stress / (at.stress + more)});
    film.least = std::min(film.least, at.friction * at.stress);
    film.most = std::max(film.most, at.friction * at.stress);
    if (k > 0) film.carried_more += at.friction * more * (at.x - stretch[k - 1].x);
    if (at.stress < least_stress) least_stress = at.stress, film.weakest = {at.x, at.z};
  }
  film.outline = without_straight_places(bottom);
  std::ranges::reverse(top = without_straight_places(top));
  film.outline.insert(film.outline.end(), top.begin(), top.end());
  for (Vec<2>& corner : film.outline)
    corner[0] = std::round(corner[0] * 1e4) * 1e-4;  // on the corner that it is beside
  return film;
}

}  // namespace

std::vector<Film> films_of(const StixSection& now, const StixSection& first, Vec<2> between, Real row)
{
  std::vector<std::vector<BorderPlace>> open;  // a stretch for each layer that has one at the last x
  std::vector<Film> films;
  const auto close = [&](const std::vector<BorderPlace>& stretch) {
    const bool pushed = std::ranges::any_of(stretch, &BorderPlace::is_pushed);
    if (pushed && stretch.back().x - stretch.front().x > row) films.push_back(film_along(stretch, row));
  };
  for (const Real x : places_along(now.stage(), between, row)) {
    std::vector<std::vector<BorderPlace>> going_on;
    for (const BorderPlace& at : borders_at(now, first, x)) {
      if (!(at.least_stress < rows_of_stress * at.weight * row) || !(at.weight > 0.0)) continue;
      const auto before = std::ranges::find_if(open, [&](const auto& s) { return s.back().layer == at.layer; });
      if (before == open.end()) {
        going_on.push_back({at});
      } else {
        going_on.push_back(std::move(*before));
        going_on.back().push_back(at);
        open.erase(before);
      }
    }
    for (const auto& stretch : open) close(stretch);
    open = std::move(going_on);
  }
  for (const auto& stretch : open) close(stretch);
  std::ranges::sort(films, {}, [](const Film& film) { return film.friction.front()[0]; });
  return films;
}

std::optional<Real> base_with_row_at(const std::vector<Film>& films, Real low, Real row)
{
  const Real border = std::ranges::min_element(films, {}, &Film::least)->weakest[1];
  const Real rows = std::floor((border - low) / row + 1e-9), base = border - rows * row;
  if (rows < 1.0 || base - low < 1e-6) return std::nullopt;
  return base;
}

void cut_at(std::vector<Film>& films, Real base)
{
  constexpr Real nothing = 1e-6;  // [m^2]
  for (Film& film : films)
    for (Vec<2>& x : film.outline) x[1] = std::max(x[1], base);
  std::erase_if(films, [](const Film& film) { return std::abs(signed_area(film.outline)) < nothing; });
}

Vec<2> with_uplift(const StixSection& section, const std::string& river, Vec<2> between)
{
  const BoundingBox box = box_around(section.stage().layers);
  for (const Real x : places_along(section.stage(), {box.low[0], box.high[0]}, 1.0))
    for (const BorderPlace& at : borders_at(section, section, x)) {
      if (!at.is_pushed || !(at.stress < lifted)) continue;
      if (river != "left") between[0] = std::max(std::min(between[0], x - beyond_uplift), box.low[0]);
      if (river != "right") between[1] = std::min(std::max(between[1], x + beyond_uplift), box.high[0]);
    }
  return between;
}

SoilText film_text(SoilText of_soil, const std::string& name, const std::string& csv)
{
  CaseMaterialText& material = of_soil.material;
  material.comment = fmt::format(
      "Film at the top of {}: a row of cells with the strength of the border above it.", in_quotes(material.name));
  material.name = name;
  for (CaseLine& line : material.lines) {
    if (line.key == "friction_angle")
      line = {line.key, fmt::format("{{ csv = {} }}", in_quotes(csv)), "degrees; of the border"};
    if (line.key == "cohesion") line = {line.key, "\"0.1 kPa\"", "so that no point of it is without strength"};
    if (line.key == "dilatancy_angle") line = {line.key, "0", "degrees"};
  }
  of_soil.assumed.clear();  // said of the soil already
  return of_soil;
}

std::string film_csv(const Film& film)
{
  const BoundingBox box = box_around(film.outline);
  std::string csv = "x,y,value\n";
  for (const auto& [x, tangent] : film.friction)
    for (const Real y : {box.low[1], box.high[1]})
      csv += fmt::format(
          "{:.6f},{},{:.4f}\n", x, number_text(y), std::max(in_degrees * std::atan(tangent), least_friction));
  return csv;
}

Sentence film_sentence(const Film& film, const std::string& soil, Real row)
{
  return filled<reported_texts::film>(soil, film.friction.front()[0], film.friction.back()[0], row, film.least / 1e3,
      film.most / 1e3, film.carried_more / 1e3);
}

}  // namespace terp
