// Later paths cover earlier ones, so the water at the start is drawn first. Names of lines are collected and put last:
// only then is it known which would lie on one another. Free water is drawn as many vertical strokes from the phreatic
// line to the ground, so no outline of it is needed.

#include "io/files/section_water.hpp"

#include "model/soils/overburden.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr const char *first_colour = "#1f5fa8", *later_colour = "#2f7ed8", *level_colour = "#0b3d6e";
constexpr const char *head_colour = "#0e7c86", *head_dashes = "10 3 2 3";

bool has_head(const WaterSituation& of, const HeadLine& line)
{
  return std::ranges::any_of(
      of.head_lines, [&](const HeadLine& other) { return other.name == line.name && other.places == line.places; });
}

std::string sample(const char* colour, Real width, const char* dashes)
{
  return fmt::format(
      "<path d=\"M0 0H24\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\"/>", colour, width, dashes);
}

std::string name_of(const WaterSituation& of) { return of.name.empty() ? fmt::format("t = {:g} s", of.time) : of.name; }

}  // namespace

std::string SectionWater::over_section(const std::vector<Vec<2>>& line) const
{
  std::string path = fmt::format("M{:.2f} {:.2f}", px(low_[0]), py(elevation_at(line, low_[0])));
  for (const Vec<2>& x : line)
    if (x[0] > low_[0] && x[0] < high_[0]) path += fmt::format("L{:.2f} {:.2f}", px(x[0]), py(x[1]));
  return path + fmt::format("L{:.2f} {:.2f}", px(high_[0]), py(elevation_at(line, high_[0])));
}

std::string SectionWater::below_water() const
{
  return over_section(model_.description.water.start.phreatic_line) +
         fmt::format("V{:.2f}H{:.2f}Z", py(low_[1]), px(low_[0]));
}

void SectionWater::first_water()
{
  const WaterSituation& water = terp::first_water(model_.description.water);
  const std::vector<Vec<2>> table = table_of(water);
  if (table.empty()) return;
  constexpr int n = 400;  // samples over the width of the mesh
  const Overburden overburden(model_);
  std::string free;
  for (int k = 0; k <= n; ++k) {
    const Real x = low_[0] + (high_[0] - low_[0]) * k / n, y = elevation_at(table, x);
    if (const Real ground = std::max(overburden.ground(x).value_or(low_[1]), low_[1]); y > ground)
      free += fmt::format("M{0:.2f} {1:.2f}V{2:.2f}", px(x), py(y), py(ground));
  }
  put("<path d=\"{}\" stroke=\"#5b9bd5\" stroke-opacity=\"0.35\" stroke-width=\"{:.2f}\"/>", free,
      scale_ * (high_[0] - low_[0]) / n + 0.2);
  put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"8 4\"/>", over_section(table),
      first_colour);
  for (const ReferenceLine& reference : water.reference_lines)
    put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\" stroke-dasharray=\"2 4\"/>",
        over_section(reference.places), first_colour);
}

/// Each head with its name: those at t = 0 named at the right end, those of another situation at the left.
void SectionWater::heads(const WaterSituation& of, bool is_first)
{
  for (const HeadLine& line : of.head_lines) {
    if (!is_first && has_head(terp::first_water(model_.description.water), line)) continue;
    put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-dasharray=\"{}\"/>",
        over_section(line.places), head_colour, is_first ? 1.8 : 1.2, head_dashes);
    name_line(is_first, elevation_at(line.places, is_first ? high_[0] : low_[0]),
        "head `" + line.name + (is_first ? "`" : "`, " + name_of(of)), head_colour);
  }
}

void SectionWater::heads_and_later_water()
{
  const WaterCase& water = model_.description.water;
  heads(terp::first_water(water), true);
  for (const WaterSituation& of : water.situations) {
    heads(of, false);
    const std::vector<Vec<2>> table = table_of(of);
    if (table.empty() || table == table_of(terp::first_water(water))) continue;
    put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" stroke-dasharray=\"3 3\"/>",
        over_section(table), later_colour);
    name_line(false, elevation_at(table, low_[0]), name_of(of), later_colour);
  }
  if (const FloodLevel& level = model_.flood_level; level.is_known()) {
    put("<path d=\"M{:.2f} {:.2f}H{:.2f}\" stroke=\"{}\" stroke-width=\"1.2\" stroke-dasharray=\"12 3 2 3\"/>",
        px(low_[0]), py(level.value), px(high_[0]), level_colour);
    name_line(true, level.value, fmt::format("level of [flood] {:.4g} m", level.value), level_colour);
  }
  put_names();
}

void SectionWater::name_line(bool at_right, Real y, std::string words, const char* colour)
{
  constexpr Real least = 72.0;  // below the title [px]
  names_.push_back({at_right, std::max(py(y) - 5.0, least), std::move(words), colour});
}

/// From above to below; one that would lie on another is moved down.
void SectionWater::put_names()
{
  constexpr Real apart = 14.0;  // [px]
  std::ranges::stable_sort(names_, {}, &Name::y);
  Real lowest[2] = {-INFINITY, -INFINITY};  // so far, at each end [px]
  for (const Name& name : names_) {
    Real& above = lowest[name.at_right ? 1 : 0];
    above = std::max(name.y, above + apart);
    text(name.at_right ? px(high_[0]) - 4.0 : px(low_[0]) + 6.0, above, name.words, name.at_right ? "end" : "start",
        fmt::format("font-size=\"12\" fill=\"{}\" {}", name.colour, white_edge));
  }
  names_.clear();
}

void SectionWater::water_legend(
    bool heads_and_later, const std::function<void(const std::string&, const std::string&)>& entry) const
{
  const WaterCase& all = model_.description.water;
  const WaterSituation& water = terp::first_water(all);
  const std::vector<Vec<2>> first = table_of(water);
  if (!first.empty())
    entry(sample(first_colour, 2.0, "8 4"), heads_and_later ? "phreatic line at the start" : "phreatic line");
  if (!water.reference_lines.empty()) entry(sample(first_colour, 1.2, "2 4"), "reference line");
  if (!heads_and_later) return;
  const auto has_heads = [](const WaterSituation& of) { return !of.head_lines.empty(); };
  if (has_heads(water) || std::ranges::any_of(all.situations, has_heads))
    entry(sample(head_colour, 1.8, head_dashes), "head of a layer");
  const auto is_another = [&](const WaterSituation& of) {
    const std::vector<Vec<2>> table = table_of(of);
    return !table.empty() && table != first;
  };
  if (std::ranges::any_of(all.situations, is_another))
    entry(sample(later_colour, 1.6, "3 3"), "phreatic line of another situation");
}

}  // namespace terp
