// A number with a unit is rounded once: the power of ten goes into the exponent of its text. So "8 kPa" and 8e3 have
// the same bits. Of units that several kinds of key take, the key decides.

#include "io/case/units.hpp"
#include "math/number_from.hpp"

#include "math/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace terp {
namespace {

constexpr Real minute = 60.0, hour = 3600.0, day = 86400.0;  // [s]
constexpr Real degrees_per_radian = 57.29577951308232;       // 180 / pi

// A new unit is one entry. Of those for one kind of key, the one to propose comes first.
constexpr Unit table[] = {
    {"kPa", "Pa", 3},
    {"Pa", "Pa"},
    {"MPa", "Pa", 6},
    {"GPa", "Pa", 9},
    {"N/m2", "Pa"},
    {"kN/m2", "Pa", 3},
    {"MN/m2", "Pa", 6},
    {"N/mm2", "Pa", 6},
    {"bar", "Pa", 5},
    {"kN/m3", "kg/m^3", 3, 1.0, standard_gravity, true},
    {"N/m3", "kg/m^3", 0, 1.0, standard_gravity, true},
    {"MN/m3", "kg/m^3", 6, 1.0, standard_gravity, true},
    {"kg/m3", "kg/m^3"},
    {"t/m3", "kg/m^3", 3},
    {"g/cm3", "kg/m^3", 3},
    {"m", "m"},
    {"dm", "m", -1},
    {"cm", "m", -2},
    {"mm", "m", -3},
    {"km", "m", 3},
    {"s", "s"},
    {"ms", "s", -3},
    {"min", "s", 0, minute},
    {"h", "s", 0, hour},
    {"d", "s", 0, day},
    {"mm/s", "m/s", -3},
    {"m/s", "m/s"},
    {"cm/s", "m/s", -2},
    {"mm/min", "m/s", -3, 1.0, minute},
    {"mm/h", "m/s", -3, 1.0, hour},
    {"m/h", "m/s", 0, 1.0, hour},
    {"m/d", "m/s", 0, 1.0, day},
    {"km/h", "m/s", 3, 1.0, hour},
    {"m/s2", "m/s^2"},
    {"cm/s2", "m/s^2", -2},
    {"deg", "deg"},
    {"rad", "deg", 0, degrees_per_radian},
    {"%/h", "1/s", -2, 1.0, hour},
    {"%/min", "1/s", -2, 1.0, minute},
    {"%/s", "1/s", -2},
    {"1/s", "1/s"},
    {"1/min", "1/s", 0, 1.0, minute},
    {"1/h", "1/s", 0, 1.0, hour},
    {"1/m", "1/m"},
    {"1/cm", "1/m", 2},
    {"kPa s", "Pa s", 3},
    {"Pa s", "Pa s"},
    {"mPa s", "Pa s", -3},
    {"%", "-", -2},
    {"kN/m3", "N/m^3", 3},  // of water; the same of soil is above
    {"N/m3", "N/m^3"},
};

/// What else people write for the letters of the table.
constexpr std::pair<std::string_view, std::string_view> spellings[] = {
    {"^", ""}, {"²", "2"}, {"³", "3"}, {"°", "deg"}, {"·", " "}, {"*", " "}};

std::string as_in_table(std::string_view name)
{
  std::string text(name);
  for (const auto& [from, to] : spellings)
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  return text;
}

/// of_key: of several kinds of key that take a unit of that name the one that is asked for, or else the first.
const Unit* find_unit(std::string_view name, std::string_view of_key = "")
{
  const std::string known = as_in_table(name);
  const Unit* first = nullptr;
  for (const Unit& unit : table)
    if (unit.name == known && (unit.of_key == of_key || first == nullptr)) first = &unit;
  return first;
}

/// The number at the beginning of a text; empty if there is none. Letters, as of "inf" and "nan", are no number.
std::string_view leading_number(std::string_view text)
{
  const std::size_t sign = text.starts_with('+') || text.starts_with('-');
  if (text.size() == sign || text[sign] < '0' || text[sign] > '9') return {};
  Real ignored = 0.0;
  const char* const begin = text.data() + sign;
  const auto [end, error] = from_chars(begin, text.data() + text.size(), ignored);
  return text.substr(0, static_cast<std::size_t>(end - text.data()));
}

/// The number times 10^power, rounded once: its text with another exponent.
Real shifted(std::string_view number, int power)
{
  if (number.starts_with('+')) number.remove_prefix(1);
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  std::string_view digits = number.substr(std::min(e + 1, number.size()));
  if (digits.starts_with('+')) digits.remove_prefix(1);
  int exponent = 0;
  if (from_chars(digits.data(), digits.data() + digits.size(), exponent).ec == std::errc::result_out_of_range)
    return std::numeric_limits<Real>::quiet_NaN();
  constexpr int beyond_all = 10000;  // no number has such an exponent
  exponent = std::clamp(exponent, -beyond_all, beyond_all) + power;
  const std::string text = fmt::format("{}e{}", number.substr(0, e), exponent);
  Real value = 0.0;
  const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? value : std::numeric_limits<Real>::quiet_NaN();
}

}  // namespace

Real NumberWithUnit::value() const { return shifted(number, unit->power) * unit->times / unit->over; }

std::optional<NumberWithUnit> parse_quantity(std::string_view text)
{
  text = trimmed(text);
  const std::string_view number = leading_number(text), name = trimmed(text.substr(number.size()));
  const auto is_control = [](unsigned char c) { return c < 0x20; };
  if (number.empty() || name.empty() || std::ranges::any_of(name, is_control)) return std::nullopt;
  return NumberWithUnit{std::string(number), std::string(name), find_unit(name)};
}

std::optional<Real> number_of(const Node& node, std::string_view unit_of_key)
{
  if (node.kind == NodeKind::integer) return static_cast<Real>(node.integer);
  if (node.kind == NodeKind::number) return node.number;
  if (node.kind != NodeKind::text) return std::nullopt;
  auto quantity = parse_quantity(node.text);
  if (quantity) quantity->unit = find_unit(quantity->name, unit_of_key);
  if (!quantity || quantity->unit == nullptr || quantity->unit->of_key != unit_of_key) return std::nullopt;
  return quantity->value();
}

std::vector<std::string> units_of_key(std::string_view unit_of_key)
{
  std::vector<std::string> names;
  for (const Unit& unit : table)
    if (unit.of_key == unit_of_key) names.emplace_back(unit.name);
  return names;
}

std::vector<std::string> all_unit_names()
{
  std::vector<std::string> names;
  for (const Unit& unit : table) names.emplace_back(unit.name);
  return names;
}

}  // namespace terp
