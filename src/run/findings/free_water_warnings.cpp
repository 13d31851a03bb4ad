// Free water on the ground: where it stands, and whether it could. Checks against the ground need drawn outlines: where
// bodies come as points, they are left out. A situation has from the start what it does not give itself, so what equals
// the start is passed over.

#include "run/findings/water_warnings.hpp"
#include "run/findings/soil_size.hpp"

#include "model/ground/ground_section.hpp"
#include "model/water/free_water.hpp"
#include "model/soils/overburden.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace terp {
namespace {

/// The numbers of the situations that the case asks for after the start, each once.
std::vector<std::size_t> later_situations(const Case& whole)
{
  std::vector<std::size_t> numbers;
  for (const std::size_t number : situations_asked_for(whole, whole.stages.size()))
    if (number > 0 && std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
  return numbers;
}

/// The start and the later ones; the start alone where stages change the ground that is drawn.
std::vector<std::size_t> situations_on_drawn_ground(const Case& whole)
{
  const auto digs = [](const StageCase& stage) { return !stage.place.empty() || !stage.remove.empty(); };
  std::vector<std::size_t> numbers{0};
  if (std::ranges::any_of(whole.stages, digs)) return numbers;
  std::ranges::copy(later_situations(whole), std::back_inserter(numbers));
  return numbers;
}

std::string phreatic_key(std::size_t number) { return fmt::format("water.situation[{}].phreatic_line", number - 1); }

/// The river changes its side: the end of the section that is high at the start gets lower, or held free water then,
/// and the other end rises above it. A river that falls below the polder, or rises from below it, does neither.
void find_swapped_river(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  const Overburden overburden(model);
  const auto& first = whole.water.start.phreatic_line;
  if (first.empty() || !overburden.is_known()) return;
  const auto ends = ends_of_soil(state);
  const std::array<const char*, 2> names{"left", "right"};
  const auto level = [&](const std::vector<Vec<2>>& line, std::size_t end) { return elevation_at(line, ends[end]); };
  const std::size_t high = level(first, 0) > level(first, 1) ? 0 : 1, other = 1 - high;
  const auto is_free = [&](std::size_t end) {
    return level(first, end) > overburden.ground(ends[end]).value_or(INFINITY);
  };
  for (const std::size_t number : later_situations(whole)) {
    const WaterSituation& of = situation_of(whole.water, number);
    if (of.phreatic_line.empty()) continue;
    const Real before = level(first, high), after = level(of.phreatic_line, high), land = level(first, other),
               river = level(of.phreatic_line, other);
    const bool falls = after < before || (is_free(high) && !is_free(other));
    if (!(before > land && river > after && river > land && falls)) continue;
    warnings.push_back({phreatic_key(number),
        fmt::format("the river changes its side: in the water{} it stands on the {}",
            of.name.empty() ? "" : fmt::format(" `{}`", of.name), names[other]),
        fmt::format("At the start the water stands at {:.4g} m on the {} and at {:.4g} m on the {}; here at {:.4g} m "
                    "and {:.4g} m.\nTurn the line about, if the river is on the {}.",
            before, names[high], land, names[other], after, river, names[high]),
        "water.phreatic_line", false, {"water"}});
  }
}

/// Where a line of free water meets a slope it may cut the ground over few cells, by less than one; in a ditch, too.
/// Out to the end of the section free water is level.
constexpr Real few_columns = 10.0, little_fall = 0.05;

/// Free water that slopes: a line that was not drawn along the ground, ground that was left out, or the wrong sign of a
/// level.
void find_sloping_free_water(const Model& model, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  const Overburden overburden(model);
  if (!overburden.is_known()) return;
  const Columns columns = columns_of_section(*model.mesh);
  for (const std::size_t number : situations_on_drawn_ground(whole)) {
    const WaterSituation& of = situation_of(whole.water, number);
    if (of.phreatic_line.empty() || (number > 0 && of.phreatic_line == whole.water.start.phreatic_line)) continue;
    struct Stretch {
      Real from = INFINITY, to = 0.0, low = INFINITY, high = -INFINITY, depth = 0.0;
      Real fall() const { return high - low; }
    } now;
    std::vector<Stretch> stretches;
    Real left = INFINITY, right = -INFINITY;  // the ends of the section
    for (Index c = 0; c <= columns.n; ++c) {
      const Real x = columns.left + (static_cast<Real>(c) + 0.5) * columns.width, y = elevation_at(of.phreatic_line, x);
      const std::optional<Real> ground = c < columns.n ? overburden.ground(x) : std::nullopt;
      if (ground) left = std::min(left, x), right = x;
      if (ground && y - *ground > 1e-6 * columns.width) {  // more than round-off of two lines that coincide
        now = {std::min(now.from, x), x, std::min(now.low, y), std::max(now.high, y), std::max(now.depth, y - *ground)};
        continue;
      }
      if (now.from < now.to) stretches.push_back(now);
      now = {};
    }
    std::erase_if(stretches, [&](const Stretch& s) {
      const Real middle = 0.5 * (s.from + s.to), end = s.to == right ? s.to : s.from;
      const bool is_wide = s.to - s.from > few_columns * columns.width && (s.from == left || s.to == right);
      const Real outer_fall = std::abs(elevation_at(of.phreatic_line, end) - elevation_at(of.phreatic_line, middle));
      return s.fall() <= columns.width && !(is_wide && outer_fall > little_fall * columns.width);
    });
    if (stretches.empty()) continue;
    const Stretch most = *std::ranges::max_element(stretches, {}, &Stretch::fall);
    warnings.push_back({number == 0 ? "water.phreatic_line" : phreatic_key(number),
        fmt::format("free water slopes{}", of.name.empty() ? "" : fmt::format(" in the water `{}`", of.name)),
        fmt::format(
            "From x = {:.4g} to {:.4g} m the line lies up to {:.3g} m above the ground, and falls by {:.3g} m.\n"
            "There it is the level of free water, which would run off. Draw it along the ground, or see\n"
            "whether ground, as a berm, was left out, or a level lacks its minus sign.",
            most.from, most.to, most.depth, most.fall()),
        "water.phreatic_line", false, {"water"}});
  }
}

void find_drowned_loads(const Model& model, std::vector<Problem>& warnings)
{
  constexpr Real little = 0.1;  // [m]
  const Case& whole = model.whole();
  const Overburden overburden(model);
  if (!overburden.is_known()) return;
  for (std::size_t k = 0; k < whole.loads.size(); ++k) {
    const LoadCase& load = whole.loads[k];
    const Real x = 0.5 * (load.from + load.to);
    const std::optional<Real> ground = overburden.ground(x);
    if (!ground) continue;
    Real deepest = little;
    const WaterSituation* where = nullptr;
    for (const std::size_t number : situations_on_drawn_ground(whole)) {
      const WaterSituation& of = situation_of(whole.water, number);
      if (of.phreatic_line.empty()) continue;
      const Real depth = elevation_at(of.phreatic_line, x) - *ground;
      if (depth > deepest) deepest = depth, where = &of;
    }
    if (where == nullptr) continue;
    warnings.push_back(
        {fmt::format("load[{}].from", k), fmt::format("the load `{}` stands under free water", load.name),
            fmt::format("At x = {:.4g} m the ground is at {:.4g} m, {:.3g} m below the water{}.", x, *ground, deepest,
                where->name.empty() ? "" : fmt::format(" of `{}`", where->name)),
            "load.from", false, {fmt::format("load[{}]", k)}});
  }
}

/// Free water at the river and, lower, on the land, all the way to the dike: a level of the land without its minus
/// sign, if that level lies in the soil.
void find_flooded_land(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  const Overburden overburden(model);
  if (!overburden.is_known()) return;
  const auto ends = ends_of_soil(state);
  Real lowest = INFINITY;
  for_each_point(state.points,
      [&](const PointBlock<2>& block, Index lane) { lowest = std::min(lowest, block.row(Rows::x + 1)[lane]); });
  for (const std::size_t number : situations_on_drawn_ground(whole)) {
    const auto& line = situation_of(whole.water, number).phreatic_line;
    if (line.empty() || (number > 0 && line == whole.water.start.phreatic_line)) continue;
    const std::size_t land = elevation_at(line, ends[0]) < elevation_at(line, ends[1]) ? 0 : 1;
    const auto depth = [&](Real x) { return elevation_at(line, x) - overburden.ground(x).value_or(INFINITY); };
    const Real level = elevation_at(line, ends[land]), ground = overburden.ground(ends[land]).value_or(INFINITY);
    const bool sign_counts = level > ground && -level < ground && -level > lowest;
    if (!sign_counts || !(elevation_at(line, ends[1 - land]) > level) || !(depth(ends[1 - land]) > 0.0)) continue;
    constexpr int n = 20;  // places over the outer quarter of the section, the ditch of a polder among them
    int n_free = 0;
    for (int k = 0; k < n; ++k) n_free += depth(std::lerp(ends[land], ends[1 - land], 0.25 * k / n)) > 0.0;
    if (n_free < n) continue;
    warnings.push_back({number == 0 ? "water.phreatic_line" : phreatic_key(number), "free water stands on the land",
        fmt::format(
            "On the {} it stands at {:.4g} m, {:.3g} m above the ground. Does the level lack its minus sign? At "
            "{:.4g} m it lies in\nthe soil.",
            land == 0 ? "left" : "right", level, level - ground, -level),
        "water.phreatic_line", false, {"water"}});
  }
}

/// The table rises from the river to the land, and the head of a layer falls: the level of the river with a minus sign
/// that it has not, if without it the table falls, too.
void find_negative_river(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  const Case& whole = model.whole();
  const auto ends = ends_of_soil(state);
  if (!model.flood_level.river) return;
  const std::size_t river = model.flood_level.river == Facing::right ? 1 : 0;
  for (const std::size_t number : situations_on_drawn_ground(whole)) {
    const WaterSituation& of = situation_of(whole.water, number);
    if (of.phreatic_line.empty() || (number > 0 && of.phreatic_line == whole.water.start.phreatic_line)) continue;
    const auto at = [&](const std::vector<Vec<2>>& line, std::size_t end) { return elevation_at(line, ends[end]); };
    const Real level = at(of.phreatic_line, river), land = at(of.phreatic_line, 1 - river);
    const auto falls = [&](const HeadLine& line) {
      return at(line.places, river) > std::max(at(line.places, 1 - river), level);
    };
    if (!(level < land && level < 0.0 && -level > land) || std::ranges::none_of(of.head_lines, falls)) continue;
    warnings.push_back({number == 0 ? "water.phreatic_line" : phreatic_key(number),
        "the phreatic line falls to the river, and a head falls from it",
        fmt::format("The line has {:.4g} m at the river and {:.4g} m on land. Is the level of the river {:.4g} m?",
            level, land, -level),
        "water.phreatic_line", false, {"water"}});
  }
}

}  // namespace

void find_odd_free_water(const Model& model, const State& state, std::vector<Problem>& warnings)
{
  find_swapped_river(model, state, warnings);
  find_sloping_free_water(model, warnings);
  find_flooded_land(model, state, warnings);
  find_negative_river(model, state, warnings);
  find_drowned_loads(model, warnings);
}

}  // namespace terp
