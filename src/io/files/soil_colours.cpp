// A colour belongs to a soil, not to a material: the two parts of a soil that the phreatic line divides have shades of
// one. The first word of the table that the name holds decides, so special words stand before general ones. A second
// soil of the same colour becomes darker. All follows from the order of the materials, so pictures of one case agree.

#include "io/files/soil_colours.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>

#include <fmt/format.h>

namespace terp {
namespace {

struct Named {
  std::string_view word;  ///< in the name of the soil, small letters
  std::string_view colour;
};

// The first word that a name holds decides. English and Dutch.
constexpr Named named[] = {{"organic", "#8f9e63"}, {"humeus", "#8f9e63"}, {"venig", "#8f9e63"}, {"peat", "#9a6d47"},
    {"veen", "#9a6d47"}, {"gyttja", "#7d7452"}, {"dike", "#c9a97d"}, {"dijk", "#c9a97d"}, {"levee", "#c9a97d"},
    {"embankment", "#c9a97d"}, {"fill", "#c9a97d"}, {"ophoog", "#c9a97d"}, {"clay", "#a3c293"}, {"klei", "#a3c293"},
    {"silt", "#cdbb8a"}, {"loam", "#cdbb8a"}, {"leem", "#cdbb8a"}, {"sand", "#ead592"}, {"zand", "#ead592"},
    {"gravel", "#c2b09a"}, {"grind", "#c2b09a"}, {"rock", "#aeb4ba"}, {"water", "#9cc3dd"}};

// Colours that stay apart in grey and for most colour-blind eyes (Okabe and Ito, made lighter).
constexpr std::array<std::string_view, 8> others = {
    "#d9b98a", "#9cc3dd", "#a8cfa0", "#e8a98f", "#c9b3d9", "#e6d784", "#9fb5b0", "#c7c7c7"};

constexpr double shade_step = 0.86;  // of a second soil with the same word: darker each time
constexpr int most_shades = 4;
constexpr double dry = 0.3;  // share of white in the colour of soil above the phreatic line

std::string_view colour_of_name(std::string_view name, std::size_t number)
{
  std::string small(name);
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Named& entry : named)
    if (small.find(entry.word) != std::string::npos) return entry.colour;
  return others[number % others.size()];
}

/// Each of the three parts of a colour by change(part), 0 to 255.
template <class Change>
std::string changed(std::string_view colour, Change change)
{
  std::string text = "#";
  for (std::size_t at = 1; at < 7; at += 2)
    text += fmt::format("{:02x}", static_cast<int>(change(std::stoi(std::string(colour.substr(at, 2)), nullptr, 16))));
  return text;
}

std::string darkened(std::string_view colour, int times)
{
  double factor = 1.0;
  for (int k = 0; k < times % most_shades; ++k) factor *= shade_step;
  return changed(colour, [factor](int part) { return factor * part; });
}

}  // namespace

std::vector<std::string> soil_colours(const std::vector<MaterialCase>& materials)
{
  std::vector<std::string> colours;
  std::map<std::string, std::string> of_soil;
  std::map<std::string_view, int> used;
  for (const MaterialCase& material : materials) {
    const auto [entry, is_new] = of_soil.try_emplace(material.called(), material.color);
    if (is_new && material.color.empty()) {
      const std::string_view colour = colour_of_name(material.called(), of_soil.size() - 1);
      entry->second = darkened(colour, used[colour]++);
    }
    colours.push_back(material.zone != Zone::above ? entry->second : changed(entry->second, [](int part) {
      return (1.0 - dry) * part + dry * 255.0;
    }));
  }
  return colours;
}

}  // namespace terp
