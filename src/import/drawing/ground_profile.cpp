// Cells are apart by semicolons, tabs, commas or spaces, whichever stands in the table first in this order; with
// semicolons and tabs a comma is that of a decimal. A column is known by its head, else the first two are distance and
// level. A place may stand twice for a step, so only what lies before its neighbour turns a table round.

#include "import/drawing/ground_profile.hpp"

#include "import/drawing/dxf_file.hpp"
#include "math/errors.hpp"
#include "math/nan.hpp"
#include "math/number_from.hpp"
#include "math/plane.hpp"
#include "math/utf8.hpp"
#include "model/bodies/polygon.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>

namespace terp {
namespace {

using Cells = std::vector<std::string>;

std::string_view without_quotes(std::string_view text)
{
  text = trimmed(text);
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : text;
}

char separator_of(std::string_view text)
{
  for (const char c : {';', '\t', ','})
    if (text.find(c) != std::string_view::npos) return c;
  return ' ';
}

Cells cells_of(std::string_view line, char separator)
{
  Cells cells;
  while (true) {
    if (separator == ' ') line = trimmed(line);
    const std::size_t end =
        std::min(line.find_first_of(separator == ' ' ? " \t" : std::string(1, separator)), line.size());
    cells.emplace_back(without_quotes(line.substr(0, end)));
    if (end == line.size()) return cells;
    line.remove_prefix(end + 1);
  }
}

/// Without empty ones at the end.
std::size_t n_filled(const Cells& cells)
{
  std::size_t n = cells.size();
  while (n > 0 && cells[n - 1].empty()) --n;
  return n;
}

/// NaN where it is none.
Real number_of(std::string text, char separator)
{
  if (separator != ',') std::ranges::replace(text, ',', '.');
  for (const char* minus : {"\xE2\x88\x92", "\xE2\x80\x93"})  // a minus sign, a dash
    if (text.starts_with(minus)) text.replace(0, 3, "-");
  if (text.starts_with('+')) text.erase(0, 1);
  return number_from<Real>(text).value_or(nan);
}

/// What stands in brackets in the head of a column, or behind its last underscore, up to a blank: "m" of "z [m NAP]".
std::string_view unit_name(std::string_view head)
{
  const std::size_t bracket = head.find_first_of("[("), line = head.rfind('_');
  if (bracket == std::string_view::npos && line == std::string_view::npos) return "";
  std::string_view name = head.substr((bracket != std::string_view::npos ? bracket : line) + 1);
  return name.substr(0, name.find_first_of(" +])"));
}

/// [m]; 0: the head names none.
Real unit_of(std::string_view head)
{
  const std::string_view name = unit_name(head);
  for (const auto& [word, metres] : {std::pair{"feet", 0.3048}, std::pair{"km", 1e3}})
    if (name == word) return metres;
  return dxf_unit(name);
}

/// Letters of the head of a column, without its unit.
std::string word_of(std::string_view head)
{
  std::string_view name = head.substr(0, head.find_first_of("[("));
  if (name.size() == head.size() && unit_of(head) > 0.0) name = name.substr(0, name.rfind('_'));
  std::string word;
  for (const char c : name)
    if (c != '_' && c != ' ') word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

const std::vector<std::string> distance_words{"l", "s", "d", "distance", "dist", "chainage", "station", "offset",
    "afstand", "abstand", "distanz", "afst", "lengte", "length", "abscisse", "distancia", "distanza", "metrering"};
const std::vector<std::string> level_words{"z", "level", "elevation", "elev", "height", "hoogte", "peil", "h", "nap",
    "mnap", "hoehe", "h\xC3\xB6he", "kote", "niveau", "altitude", "cota", "quota", "zcoord", "maaiveld"};
const std::vector<std::string> x_words{"x", "rdx", "xrd", "xcoord", "easting", "oost"};
const std::vector<std::string> y_words{"y", "rdy", "yrd", "ycoord", "northing", "noord"};
const std::vector<std::string> depth_words{"depth", "diepte", "tiefe", "profondeur", "profundidad"};
const std::vector<std::string> name_words{"name", "naam", "profile", "profiel", "id", "locationid", "section", "profil",
    "nom", "dwp", "dwarsprofiel", "profielnaam"};
const std::vector<std::string> soil_profile_words{"soilprofileid", "soilprofilename", "profile", "profiel", "id"};
const std::vector<std::string> top_words{"toplevel", "top", "bovenkant", "level", "z"};
const std::vector<std::string> soil_words{"soilname", "soil", "grondsoort", "grond", "material", "name", "naam"};

struct TableColumns {
  int distance = 0, level = 1, y = -1, name = -1;
  Real unit_x = 1.0, unit_z = 1.0;
  std::string unknown_unit = {};         ///< the head that has it
  std::vector<std::string> rivals = {};  ///< heads of which each could be the one
  bool are_known = true;                 ///< by their heads
  bool has_depths = false;               ///< instead of levels
};

/// The column whose head is one of the words, the first of them first; -1: none.
int find_column(const Cells& heads, const std::vector<std::string>& words)
{
  for (const std::string& word : words)
    for (std::size_t k = 0; k < heads.size(); ++k)
      if (word_of(heads[k]) == word) return static_cast<int>(k);
  return -1;
}

/// Heads that all name distances, or all levels: one of the words, alone or before a number, as in z_2023.
std::vector<std::string> rivals_in(const Cells& heads, const std::vector<std::string>& words)
{
  std::vector<std::string> rivals;
  for (const std::string& head : heads) {
    std::string word = word_of(head);
    while (!word.empty() && std::isdigit(static_cast<unsigned char>(word.back()))) word.pop_back();
    if (std::ranges::find(words, word) != words.end()) rivals.push_back(head);
  }
  return rivals.size() > 1 ? rivals : std::vector<std::string>();
}

TableColumns columns_of(const Cells& heads)
{
  const auto find = [&](const std::vector<std::string>& words) { return find_column(heads, words); };
  const int x = find(x_words), y = find(y_words), l = find(distance_words), z = find(level_words);
  TableColumns c{l >= 0 ? l : std::max(0, x), z >= 0 ? z : y >= 0 ? y : 1, -1, find(name_words)};
  if (l < 0 && x >= 0 && y >= 0 && z >= 0) c.y = y;
  c.are_known = (l >= 0 || x >= 0) && (z >= 0 || y >= 0);
  c.has_depths = z < 0 && find(depth_words) >= 0;
  c.rivals = rivals_in(heads, level_words);
  if (c.rivals.empty()) c.rivals = rivals_in(heads, distance_words);
  const auto unit = [&](int column, Real& metres) {
    if (column >= std::ssize(heads)) return;
    const std::string_view head = heads[column];
    metres = unit_of(head);
    if (metres == 0.0 && head.find_first_of("[(") != std::string_view::npos && !unit_name(head).starts_with('m'))
      c.unknown_unit = head;
    if (metres == 0.0) metres = 1.0;
  };
  unit(c.distance, c.unit_x);
  unit(c.level, c.unit_z);
  return c;
}

/// Calls take(cells, number of the line) for each line that is neither empty nor a comment.
template <class Take>
void for_each_row(std::string_view text, char separator, Take take)
{
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);  // with its blanks: with tabs a first cell may be empty
    if (const auto words = trimmed(line); !words.empty() && !words.starts_with('#'))
      take(cells_of(line, separator), number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// "A, B, C and 12 more".
std::string some_of(const Cells& names)
{
  constexpr std::size_t most = 20;
  const std::span first = std::span(names).first(std::min(names.size(), most));
  return fmt::format(
      "{}{}", fmt::join(first, ", "), names.size() > most ? fmt::format(" and {} more", names.size() - most) : "");
}

class ProfileReader {
 public:
  ProfileReader(const std::string& path, std::string_view text, const ProfileOptions& options)
      : path_(path), options_(options), separator_(separator_of(text))
  {
    for_each_row(text, separator_, [&](const Cells& cells, int) { take(cells); });
  }

  DxfRegions regions()
  {
    if (profiles_.size() > 1)
      refuse(fmt::format("holds {} profiles", profiles_.size()),
          fmt::format("Name the one to read: --layers NAME. There are: {}.", some_of(profiles_)));
    if (!options_.name.empty() && ground_.empty())
      refuse(fmt::format("has no profile `{}`", options_.name), "--layers names a profile of a table of several.");
    put_in_order();
    if (ground_.size() < 2)
      refuse("is no ground profile", "It needs two rows with a distance and a level, as l,z and 0,-1.0 below it.");
    const BoundingBox box = box_around(ground_);
    const Real lowest = box.low[1], width = box.high[0] - box.low[0], height = box.high[1] - lowest;
    const Real base = options_.base.value_or(lowest - (options_.depth > 0.0 ? options_.depth : usual_depth));
    if (!(base < lowest))
      refuse("has ground below the base",
          fmt::format("The base is at {:g} m, the lowest ground at {:g} m.", base, lowest));
    DxfRegions found;
    if (width < narrowest_section || width > widest_section || height > highest_section)
      found.doubts.push_back(fmt::format(
          "The profile is {:.6g} m wide and {:.6g} m high: are its numbers in metres? --unit takes another unit.",
          width, height));
    Polygon outline = ground_;
    std::ranges::reverse(outline);  // the ground runs from right to left, then along the base
    outline.push_back({ground_.front()[0], base});
    outline.push_back({ground_.back()[0], base});
    found.regions.push_back({"ground", outline});
    found.notes.push_back(
        fmt::format("The base was drawn at {:g} m, {:g} m below the lowest ground: --depth takes another "
                    "one.",
            base, lowest - base));
    if (n_without_ > 0)
      (has_text_ ? found.doubts : found.notes)
          .push_back(fmt::format("{} rows without numbers were left out.", n_without_));
    if (is_turned_) found.notes.push_back("The distances fall: the profile was read from its last row.");
    return found;
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& cure) const
  {
    throw InputError({path_, what, cure, ""});
  }

  Real number_at(const Cells& cells, int column) const
  {
    return column < std::ssize(cells) ? number_of(cells[column], separator_) : nan;
  }

  void take(const Cells& cells)
  {
    if (!has_heads_) {
      has_heads_ = true;
      int n_numbers = 0;
      for (const std::string& cell : cells) n_numbers += !std::isnan(number_of(cell, separator_));
      columns_.are_known = false;
      if (n_numbers < 2) {
        columns_ = columns_of(cells);
        n_cells_ = n_filled(cells);
        if (!columns_.unknown_unit.empty() && options_.unit == 0.0)
          refuse(fmt::format("has a unit that Terp does not know, `{}`", columns_.unknown_unit),
              "Known are m, dm, cm, mm, ft, in: name one there, or give --unit.");
        if (!columns_.rivals.empty())
          refuse(fmt::format("has several columns that could be the one of levels or distances: {}",
                     fmt::join(columns_.rivals, ", ")),
              "Leave one of them, as l;z.");
        if (columns_.has_depths)
          refuse("has depths, and no levels", "Give the level of the ground in each row, as l,z.");
        is_wide_ = cells.size() >= 4 && word_of(cells[0]) == "locationid" && word_of(cells[1]) == "x1";
        return;
      }
    }
    if (is_wide_) return take_line(cells);
    n_cells_ = n_cells_ > 0 ? n_cells_ : n_filled(cells);
    if (n_filled(cells) > n_cells_)
      refuse("has rows of more cells than others",
          "Is a comma both that of a decimal and between cells? Put semicolons between cells.");
    if (!columns_.are_known && n_cells_ > 2)
      refuse("does not say which columns are distance and level", "Name them in the first line, as l;z.");
    const Real z = number_at(cells, columns_.level), at = number_at(cells, columns_.distance);
    const std::string name = columns_.name >= 0 && columns_.name < std::ssize(cells) ? cells[columns_.name] : "";
    if (!options_.name.empty() && name != options_.name) return;
    if (!std::isfinite(at) || !std::isfinite(z)) {
      ++n_without_;
      const auto is_text = [&](int column) {
        return column < std::ssize(cells) && cells[column].find_first_of("0123456789") != std::string::npos &&
               std::isnan(number_of(cells[column], separator_));
      };
      has_text_ = has_text_ || is_text(columns_.level) || is_text(columns_.distance);
      return;
    }
    if (columns_.name >= 0 && std::ranges::find(profiles_, name) == profiles_.end()) profiles_.push_back(name);
    if (columns_.y >= 0) return add_place({at, number_at(cells, columns_.y)}, z);
    ground_.push_back({at * (options_.unit > 0.0 ? options_.unit : columns_.unit_x),
        z * (options_.unit > 0.0 ? options_.unit : columns_.unit_z)});
  }

  /// A profile on one line: its name, then x, y, z of each place.
  void take_line(const Cells& cells)
  {
    if (!options_.name.empty() && cells[0] != options_.name) return;
    profiles_.push_back(cells[0]);
    std::vector<Vec<2>> places;
    int k = 1;
    for (; !std::isnan(number_at(cells, k) + number_at(cells, k + 1) + number_at(cells, k + 2)); k += 3) {
      places.push_back({number_at(cells, k), number_at(cells, k + 1)});
      add_place(places.back(), number_at(cells, k + 2));
    }
    if (!std::isnan(number_at(cells, k)))
      refuse(fmt::format("has a place without x, y or z in `{}`", cells[0]), "Each place has three numbers.");
    for (std::size_t p = 1; p < places.size(); ++p)
      if (dot(between(places[p - 1], places[p]), between(places.front(), places.back())) < 0.0)
        refuse(fmt::format("goes back in `{}`", cells[0]),
            fmt::format("After {:g}, {:g} comes {:g}, {:g}: give the places from one end to the other.",
                places[p - 1][0], places[p - 1][1], places[p][0], places[p][1]));
  }

  /// Of a map: at its distance along the line.
  void add_place(Vec<2> place, Real z)
  {
    const Real unit = options_.unit > 0.0 ? options_.unit : columns_.unit_x;
    place = {unit * place[0], unit * place[1]};
    ground_.push_back({ground_.empty() ? 0.0 : ground_.back()[0] + distance(before_, place),
        z * (options_.unit > 0.0 ? options_.unit : columns_.unit_z)});
    before_ = place;
  }

  void put_in_order()
  {
    ground_.erase(std::unique(ground_.begin(), ground_.end()), ground_.end());
    const auto falls = [](const Vec<2>& a, const Vec<2>& b) { return b[0] < a[0]; };
    if (ground_.size() > 1 && ground_.back()[0] < ground_.front()[0]) {
      std::ranges::reverse(ground_);
      is_turned_ = true;
    }
    const auto back = std::adjacent_find(ground_.begin(), ground_.end(), falls);
    if (back != ground_.end())
      refuse("goes back",
          fmt::format("After x = {:g} m comes {:g} m: give the rows from one end to the other. If it holds several "
                      "profiles, name them in a column `profile`.",
              (*back)[0], (*(back + 1))[0]));
    refuse_two_in_turn();
  }

  /// Profiles that were sorted by their distance into one: at many places the level goes up and down.
  void refuse_two_in_turn() const
  {
    int n_steps = 0;
    Real sum = 0.0;
    for (std::size_t k = 1; k < ground_.size(); ++k)
      if (ground_[k][0] == ground_[k - 1][0]) ++n_steps, sum += std::abs(ground_[k][1] - ground_[k - 1][1]);
    if (n_steps < 4) return;
    const BoundingBox box = box_around(ground_);
    if (sum > 2.0 * (box.high[1] - box.low[1]))
      refuse(fmt::format("has two levels at {} places", n_steps),
          "Does it hold several profiles? Name them in a column `profile`, and one of them with --layers.");
  }

  const std::string& path_;
  const ProfileOptions& options_;
  char separator_;
  TableColumns columns_;
  bool has_heads_ = false, is_turned_ = false, is_wide_ = false, has_text_ = false;
  int n_without_ = 0;
  std::size_t n_cells_ = 0;  // of the heads, or of the first row
  Vec<2> before_{};
  Cells profiles_;
  Polygon ground_;
};

struct SoilTop {
  std::string soil;
  Real level;  ///< [m]
};

/// From the highest to the lowest.
std::vector<SoilTop> read_soil_tops(const std::string& path, std::string_view text, const std::string& name)
{
  const auto refuse = [&](const std::string& what, const std::string& cure) {
    throw InputError({path, what, cure, ""});
  };
  const char separator = separator_of(text);
  int profile = -1, top = -1, soil = -1;
  Real unit = 1.0;
  Cells profiles;
  std::vector<SoilTop> tops;
  for_each_row(text, separator, [&](const Cells& cells, int line) {
    if (top < 0) {
      profile = find_column(cells, soil_profile_words);
      top = find_column(cells, top_words), soil = find_column(cells, soil_words);
      if (top < 0 || soil < 0)
        refuse("is no table of soils", "Its first line names the columns: soilprofile_id;top_level;soil_name.");
      if (const Real metres = unit_of(cells[top]); metres > 0.0) unit = metres;
      return;
    }
    const auto at = [&](int column) { return column >= 0 && column < std::ssize(cells) ? cells[column] : ""; };
    if (!name.empty() && at(profile) != name) return;
    if (std::ranges::find(profiles, at(profile)) == profiles.end()) profiles.push_back(at(profile));
    const Real level = unit * number_of(at(top), separator);
    if (!std::isfinite(level) || at(soil).empty())
      refuse(fmt::format("has no level or no soil in line {}", line), "Each line has the level of a top, and a soil.");
    tops.push_back({at(soil), level});
  });
  if (profiles.size() > 1)
    refuse(fmt::format("holds {} profiles of soils", profiles.size()),
        fmt::format("Name the one to take: --soils FILE,NAME. There are: {}.", some_of(profiles)));
  if (tops.empty())
    refuse(name.empty() ? "has no soil" : fmt::format("has no profile `{}`", name), "Each line has a top and a soil.");
  std::ranges::stable_sort(tops, std::ranges::greater{}, &SoilTop::level);
  if (const auto same = std::ranges::adjacent_find(tops, {}, &SoilTop::level); same != tops.end())
    refuse(fmt::format("has two soils with the top at {:g} m", same->level), "Each soil lies below the one before it.");
  return tops;
}

/// The part of an outline below a level. The outline runs along the base, then along the ground from right to left.
Polygon below(const Polygon& outline, Real level)
{
  Polygon part;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec<2> a = outline[k], b = outline[(k + 1) % outline.size()];
    part.push_back({a[0], std::min(a[1], level)});
    if ((a[1] > level) != (b[1] > level))
      part.push_back({std::lerp(a[0], b[0], (level - a[1]) / (b[1] - a[1])), level});
  }
  part.erase(std::unique(part.begin(), part.end()), part.end());
  return part;
}

}  // namespace

DxfRegions with_soils(
    const DxfRegions& profile, const std::string& path, std::string_view text, const std::string& name)
{
  const std::vector<SoilTop> tops = read_soil_tops(path, text, name);
  const Polygon& ground = profile.regions.front().polygon;
  const BoundingBox box = box_around(ground);
  DxfRegions found{{}, profile.notes, profile.doubts};
  for (std::size_t k = 0; k < tops.size(); ++k) {
    const bool reaches_up = k + 1 < tops.size() && tops[k + 1].level >= box.high[1];
    if (reaches_up || tops[k].level <= box.low[1]) {
      found.notes.push_back(fmt::format("`{}` from {:g} m down lies {} the section.", tops[k].soil, tops[k].level,
          reaches_up ? "above" : "below the base of"));
      continue;
    }
    // Each soil lies on all below it, whose outlines are smaller and so count.
    found.regions.push_back({tops[k].soil, found.regions.empty() ? ground : below(ground, tops[k].level)});
  }
  if (found.regions.empty()) throw InputError({path, "has no soil in the section", "Are its levels in m?", ""});
  if (tops.front().level < box.high[1])
    found.notes.push_back(
        fmt::format("The ground reaches {:g} m above the highest soil, `{}`, which was taken up to it.",
            box.high[1] - tops.front().level, tops.front().soil));
  return found;
}

DxfRegions read_profile(const std::string& path, std::string_view text, const ProfileOptions& options)
{
  return ProfileReader(path, text, options).regions();
}

}  // namespace terp
