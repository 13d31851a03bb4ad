// The keys of water that is computed, and of the soil that it flows through. Rivers, ponds and heads at sides are
// tables of a few values each; one list of what a table may hold reads all three.

#include "io/case/document.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/units.hpp"
#include "io/case/values.hpp"
#include "math/closest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace terp {
namespace {

constexpr std::array seepage_sides{"left", "right", "bottom"};

/// A value of a small table.
struct Member {
  std::string name;
  std::string type;  ///< in words
  std::function<bool(const Node&)> take;
  bool is_needed = false;
};

Member number_member(const char* name, Real& value, bool is_needed)
{
  return {name, "a number in m, or text with a unit, \"4.5 m\"",
      [&value](const Node& node) {
        const std::optional<Real> number = number_of(node, "m");
        if (number) value = *number;
        return number && std::isfinite(*number);
      },
      is_needed};
}

Member text_member(const char* name, std::string& value)
{
  return {name, "text", [&value](const Node& node) {
            value = node.text;
            return node.kind == NodeKind::text && !node.text.empty();
          }};
}

Member side_member(SectionSide& side, std::size_t n)
{
  std::vector<std::string> words(seepage_sides.begin(), seepage_sides.begin() + static_cast<std::ptrdiff_t>(n));
  return {"side", "one of " + quoted_list(words),
      [&side, words](const Node& node) {
        const auto found = std::ranges::find(words, node.text);
        if (node.kind != NodeKind::text || found == words.end()) return false;
        side = static_cast<SectionSide>(found - words.begin());
        return true;
      },
      true};
}

/// A level, or a line over x.
Member head_member(std::vector<Vec<2>>& head)
{
  return {"head", "a number in m, or places [[x, head], ...] from left to right",
      [&head](const Node& node) {
        if (const std::optional<Real> level = number_of(node, "m"); level && std::isfinite(*level)) {
          head = {{0.0, *level}};
          return true;
        }
        if (node.kind != NodeKind::list || node.items.empty()) return false;
        head.clear();
        for (const Node& place : node.items) {
          if (place.kind != NodeKind::list || place.items.size() != 2) return false;
          const std::optional<Real> x = number_of(place.items[0], "m"), h = number_of(place.items[1], "m");
          if (!x || !h || (!head.empty() && *x < head.back()[0])) return false;
          head.push_back({*x, *h});
        }
        return true;
      },
      true};
}

bool read_members(
    const Entry& entry, const Node& table, const std::string& path, const std::vector<Member>& members, Findings& f)
{
  std::vector<std::string> names;
  for (const Member& member : members) names.push_back(member.name);
  if (table.kind != NodeKind::table)
    return refuse(entry, path, fmt::format("`{}` must be a table", last_part(path)),
        fmt::format("Got {}. Keys of it: {}", describe_value(table), plain_list(names)), f);
  bool good = true;
  for (const Node& item : table.items) {
    const auto member = std::ranges::find(members, item.name, &Member::name);
    const std::string here = join_path(path, item.name);
    if (member == members.end())
      good = refuse(entry, here, fmt::format("unknown key `{}`", item.name),
          did_you_mean(item.name, names) + fmt::format("Keys of it: {}", plain_list(names)), f);
    else if (!member->take(item))
      good = refuse(entry, here, fmt::format("`{}` must be {}", item.name, member->type),
          fmt::format("Got {}.", describe_value(item)), f);
  }
  for (const Member& member : members)
    if (member.is_needed && find_item(table, member.name) == nullptr)
      good = refuse(entry, path, fmt::format("`{}` has no `{}`", last_part(path), member.name),
          fmt::format("Give {} = {}.", member.name, member.type), f);
  return good;
}

bool check_stretch(const Entry& entry, const std::string& path, Real from, Real to, Findings& findings)
{
  return from < to || refuse(entry, path, "a stretch goes from a smaller to a larger number",
                          fmt::format("Got from {:g} m to {:g} m.", from, to), findings);
}

/// The members of one entry of a list, and what must hold of it when they are read.
template <class T>
struct EntryForm {
  std::vector<Member> (*members)(T&);
  bool (*check)(const Entry&, const std::string&, const T&, Findings&);
};

template <class T>
bool read_entries(const Entry& entry, Findings& findings, std::vector<T>& all, const EntryForm<T>& form)
{
  if (entry.node.kind != NodeKind::list)
    return refuse(entry, entry.path, fmt::format("`{}` must be a list of tables", last_part(entry.path)),
        fmt::format("Got {}.", describe_value(entry.node)), findings);
  bool good = true;
  all.clear();
  for (std::size_t k = 0; k < entry.node.items.size(); ++k) {
    const std::string path = fmt::format("{}[{}]", entry.path, k);
    T& item = all.emplace_back();
    good = read_members(entry, entry.node.items[k], path, form.members(item), findings) &&
           form.check(entry, path, item, findings) && good;
  }
  return good;
}

std::vector<Member> members_of_pond(PondCase& pond)
{
  return {text_member("name", pond.name), number_member("from", pond.from, true), number_member("to", pond.to, true),
      number_member("level", pond.level, true)};
}

bool check_pond(const Entry& entry, const std::string& path, const PondCase& pond, Findings& findings)
{
  return check_stretch(entry, path, pond.from, pond.to, findings);
}

std::vector<Member> members_of_side(SideHead& side)
{
  return {text_member("name", side.name), side_member(side.side, 3), number_member("from", side.from, false),
      number_member("to", side.to, false), head_member(side.head),
      number_member("leakage_length", side.leakage_length, false)};
}

bool check_side(const Entry& entry, const std::string& path, const SideHead& side, Findings& findings)
{
  if (!check_stretch(entry, path, side.from, side.to, findings)) return false;
  if (side.leakage_length < 0.0)
    return refuse(entry, path + ".leakage_length", "a leakage length is more than 0 m",
        fmt::format("Got {:g} m. Without it the head is right at the side.", side.leakage_length), findings);
  if (side.side != SectionSide::bottom && side.head.size() > 1)
    return refuse(entry, path + ".head", "a line of heads over x is for the bottom",
        "At the left and the right side give one number in m.", findings);
  return true;
}

/// Two places or more.
Member line_member(std::vector<Vec<2>>& line)
{
  return {"line", "places [[x, y], ...] in m, at least two, each apart from the one before",
      [&line](const Node& node) {
        if (node.kind != NodeKind::list || node.items.size() < 2) return false;
        line.clear();
        for (const Node& place : node.items) {
          if (place.kind != NodeKind::list || place.items.size() != 2) return false;
          const std::optional<Real> x = number_of(place.items[0], "m"), y = number_of(place.items[1], "m");
          if (!x || !y || (!line.empty() && line.back() == Vec<2>{*x, *y})) return false;
          line.push_back({*x, *y});
        }
        return true;
      },
      true};
}

std::vector<Member> members_of_wall(WallCase& wall) { return {text_member("name", wall.name), line_member(wall.line)}; }

std::string text_of(const WallCase& wall)
{
  std::string places;
  for (const Vec<2>& place : wall.line) places += fmt::format(" [{}, {}]", place[0], place[1]);
  return fmt::format("{}{}", wall.name, places);
}

std::string text_of(const PondCase& pond)
{
  return fmt::format("{} {} to {} at {}", pond.name, pond.from, pond.to, pond.level);
}

std::string text_of(const SideHead& side)
{
  std::string heads;
  for (const Vec<2>& place : side.head) heads += fmt::format(" [{}, {}]", place[0], place[1]);
  return fmt::format("{} {} {} to {} at{} over {}", side.name, seepage_sides[static_cast<std::size_t>(side.side)],
      side.from, side.to, heads, side.leakage_length);
}

template <class T>
std::string text_of_all(const std::vector<T>& all)
{
  std::string text;
  for (const T& item : all) text += fmt::format("{}{}", text.empty() ? "" : "; ", text_of(item));
  return text;
}

OwnForm river_field(std::optional<RiverCase>& river)
{
  return {"a table { side = \"left\", level = 4.5 }",
      [&river](const Entry& entry, Findings& findings) {
        RiverCase read;
        if (!read_members(entry, entry.node, entry.path,
                {side_member(read.side, 2), number_member("level", read.level, true)}, findings))
          return false;
        river = read;
        return true;
      },
      [&river] {
        return river ? fmt::format("{} at {}", seepage_sides[static_cast<std::size_t>(river->side)], river->level)
                     : std::string();
      }};
}

OwnForm ponds_field(std::vector<PondCase>& ponds)
{
  return {"a list of tables { name = \"ditch\", from = 54.0, to = 60.0, level = -0.3 }",
      [&ponds](const Entry& entry, Findings& findings) {
        return read_entries<PondCase>(entry, findings, ponds, {members_of_pond, check_pond});
      },
      [&ponds] { return text_of_all(ponds); }};
}

OwnForm boundary_field(std::vector<SideHead>& boundary)
{
  return {"a list of tables { name = \"aquifer\", side = \"right\", from = -8.5, to = -6.5, head = 0.4 }",
      [&boundary](const Entry& entry, Findings& findings) {
        return read_entries<SideHead>(entry, findings, boundary, {members_of_side, check_side});
      },
      [&boundary] { return text_of_all(boundary); }};
}

OwnForm walls_field(std::vector<WallCase>& walls)
{
  return {"a list of tables { name = \"sheet pile\", line = [[25.0, 5.0], [25.0, -4.0]] }",
      [&walls](const Entry& entry, Findings& findings) {
        return read_entries<WallCase>(entry, findings, walls,
            {members_of_wall, [](const Entry&, const std::string&, const WallCase&, Findings&) { return true; }});
      },
      [&walls] { return text_of_all(walls); }};
}

constexpr Real least_k = 1e-12, most_k = 1.0;  // [m/s]

/// A number, or { horizontal = , vertical = }.
OwnForm permeability_field(Permeability& k)
{
  return {"a number in m/s or text with a unit, or { horizontal = \"1 m/d\", vertical = \"0.1 m/d\" }",
      [&k](const Entry& entry, Findings& findings) {
        const auto take = [&](Real& value, const Node& node, const std::string& path) {
          const std::optional<Real> number = number_of(node, "m/s");
          if (!number)
            return refuse(entry, path,
                fmt::format("`{}` must be a number in m/s, or text with a unit", last_part(path)),
                fmt::format("Got {}.", describe_value(node)), findings);
          if (!(*number >= least_k && *number <= most_k))
            return refuse(entry, path, "no soil has such a permeability",
                fmt::format("Got {:.3g} m/s, which is {:.3g} m/d; allowed: {:g} to {:g} m/s. Clay has 1e-10 to 1e-8 "
                            "m/s, sand 1e-5 to 1e-3 m/s\n(1 to 100 m/d). Give values in m/d with their unit, as "
                            "\"8.6 m/d\".",
                    *number, *number * 86400.0, least_k, most_k),
                findings);
          value = *number;
          return true;
        };
        if (entry.node.kind != NodeKind::table) {
          if (!take(k.horizontal, entry.node, entry.path)) return false;
          k.vertical = k.horizontal;
          return true;
        }
        const Node *horizontal = find_item(entry.node, "horizontal"), *vertical = find_item(entry.node, "vertical");
        if (horizontal == nullptr || vertical == nullptr || entry.node.items.size() != 2)
          return refuse(entry, entry.path, "the table of a permeability holds `horizontal` and `vertical`",
              "Give both, or one number for all directions.", findings);
        return take(k.horizontal, *horizontal, entry.path + ".horizontal") &&
               take(k.vertical, *vertical, entry.path + ".vertical");
      },
      [&k] {
        return !k.is_given()                ? std::string()
               : k.horizontal == k.vertical ? fmt::format("{}", k.horizontal)
                                            : fmt::format("horizontal {}, vertical {}", k.horizontal, k.vertical);
      }};
}

std::vector<std::string> water_kinds() { return {"lines", "seepage"}; }

using SituationOf = WaterSituation& (*)(Case&, std::size_t);

}  // namespace

std::vector<KeyInfo> seepage_keys()
{
  return {
      {.path = "water.model",
          .field = [](Case& c, std::size_t) { return word_field(c.water.kind); },
          .words = water_kinds,
          .meaning = "where the water comes from: the lines that are drawn, or computed seepage from permeabilities, "
                     "river, ponds and heads at the sides (docs/seepage.md)",
          .equation = "seepage: div(k_r k grad h) = 0, p_w = unit_weight (h - y)"},
      {.path = "water.suction_band",
          .field = [](Case& c, std::size_t) { return &c.water.suction_band; },
          .unit = "m",
          .range = not_negative,
          .usual = between(0.01, 5.0),
          .meaning =
              "height over which soil dries about the table of computed water; a wider band converges more easily",
          .default_text = "half the height of a cell"},
      {.path = "water.walls",
          .field = [](Case& c, std::size_t) { return walls_field(c.water.walls); },
          .unit = "m",
          .meaning = "of computed water: lines that let no water through, along sides of cells. They hold back water "
                     "alone, not soil"},
  };
}

std::vector<KeyInfo> seepage_keys_of_situation(const std::string& section, SituationOf of)
{
  return {
      {.path = section + ".river",
          .field = [of](Case& c, std::size_t i) { return river_field(of(c, i).seepage.river); },
          .meaning = "of computed water: free water at the left or the right end, from there as far as the ground lies "
                     "below its level"},
      {.path = section + ".ponds",
          .field = [of](Case& c, std::size_t i) { return ponds_field(of(c, i).seepage.ponds); },
          .unit = "m",
          .meaning =
              "of computed water: free water on stretches of the ground, as ditches and polders. Other ground is a "
              "seepage face: water comes out where its pressure would be more than zero"},
      {.path = section + ".boundary",
          .field = [of](Case& c, std::size_t i) { return boundary_field(of(c, i).seepage.boundary); },
          .unit = "m",
          .meaning =
              "of computed water: heads of the soil at the sides left and right between two elevations, or at the "
              "bottom between two x. leakage_length: the layer goes on beyond the section and has the head that "
              "far away. What has no head has no flow"},
  };
}

std::vector<KeyInfo> flow_keys_of_material()
{
  return {
      {.path = "material.NAME.permeability",
          .field = [](Case& c, std::size_t i) { return permeability_field(c.materials[i].permeability); },
          .unit = "m/s",
          .meaning = "of saturated soil, for water.model = \"seepage\""},
      {.path = "material.NAME.specific_yield",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].storage.yield; },
          .range = between_open(0.0, 1.0),
          .usual = between(0.005, 0.4),
          .meaning =
              "volume of water per volume of soil that drains where the table falls, for `terp seepage` in time"},
      {.path = "material.NAME.specific_storage",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].storage.elastic; },
          .unit = "1/m",
          .range = positive,
          .usual = between(1e-6, 0.1),
          .meaning =
              "volume of water that soil of one cubic metre gives per metre of head, for `terp seepage` in time"},
  };
}

}  // namespace terp
