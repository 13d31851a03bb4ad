// Lines that touch make a group. The section is the group with most outlines; a group with an outline around all of it
// is a frame.

#include "import/drawing/tidy_lines.hpp"

#include "import/drawing/drawn_sections.hpp"
#include "import/drawing/line_gaps.hpp"

#include "math/errors.hpp"
#include "math/plane.hpp"
#include "model/bodies/polygon.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <set>

namespace terp {
namespace {

constexpr std::size_t most_sides = 20'000;  // of all lines, up to which groups are looked for
constexpr int outline_weight = 1000;        // of an outline beside open lines, to find the section

const char* const water_words[] = {"water", "phrea", "frea", "wasser", "nappe", "gws", "gwl", "piezo", "stijghoogte"};
const char* const ground_words[] = {"waterkering", "watergang", "bodem", "watercourse", "klei", "clay", "zand", "sand",
    "veen", "peat", "leem", "silt", "grind", "pakket", "watervoerend", "waterremmend", "talud",
    "slope"};  // of ground, in spite of it
const char* const words_of_levels[] = {"mhw", "mlw", "ghw", "glw", "hw", "lw", "ws", "peil", "hwl", "mhws"};  // alone
const char* const frame_words[] = {"frame", "kader", "rahmen", "cadre", "title", "titel", "legend", "stempel"};
const char* const words_of_sheets[] = {"border", "sheet", "blad"};  // of frames, but also of soil borders and piles

template <std::size_t n>
bool has_word(const std::string& layer, const char* const (&words)[n])
{
  std::string lower;
  for (const char c : layer) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::ranges::any_of(words, [&](const char* word) { return lower.find(word) != std::string::npos; });
}

/// "MHW", "peil 1", "NAP_HW": a word of its own.
bool is_of_water_level(const std::string& layer)
{
  std::string word;
  for (const char c : layer + ' ')
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else {
      if (std::ranges::any_of(words_of_levels, [&](const char* level) { return word == level; })) return true;
      word.clear();
    }
  return false;
}

/// Width of a line within a box, 0 where a place of it lies outside [m].
Real width_within(const DxfLine& line, const BoundingBox& box)
{
  const BoundingBox of = box_around(line.places);
  for (int d = 0; d < 2; ++d)
    if (of.low[d] < box.low[d] || of.high[d] > box.high[d]) return 0.0;
  return of.high[0] - of.low[0];
}

bool meet(const DxfLine& a, const DxfLine& b, Real snap)
{
  for (const Vec<2>& x : a.places)
    if (gap_to(b, x) <= snap) return true;
  for (const Vec<2>& x : b.places)
    if (gap_to(a, x) <= snap) return true;
  Vec<2> x;
  for (std::size_t i = 0; i < n_sides(a); ++i)
    for (std::size_t j = 0; j < n_sides(b); ++j)
      if (lines_cross(
              a.places[i], a.places[(i + 1) % a.places.size()], b.places[j], b.places[(j + 1) % b.places.size()], x))
        return true;
  return false;
}

class Tidier {
 public:
  Tidier(const DxfDrawing& drawing, Real snap)
      : tidy_{drawing.lines}, snap_(snap), layers_are_chosen_(drawing.layers_are_chosen)
  {
  }

  TidyLines tidy(bool is_one_section)
  {
    close_outlines();
    leave_out_ground_of_export();
    leave_out_water();
    std::size_t n_places = 0;
    for (const DxfLine& line : tidy_.lines) n_places += line.places.size();
    const bool is_small = n_places <= most_sides;
    if (is_small && !layers_are_chosen_) leave_out_named_frames(), refuse_doubtful_frames();
    if (is_small) leave_out_copies();
    if (is_small && !is_one_section) leave_out_tables();
    const bool is_layered = has_boundaries(tidy_.lines, snap_);
    if (is_layered) close_ends();
    if (is_small)
      if (const std::string doubt = doubt_of_gaps(tidy_.lines, snap_); !doubt.empty()) tidy_.doubts.push_back(doubt);
    if (is_small) leave_out_frames(is_layered), leave_out_walls();
    if (!is_layered) close_ends();
    return std::move(tidy_);
  }

 private:
  template <class... A>
  void note(fmt::format_string<A...> text, A&&... arguments)
  {
    tidy_.notes.push_back(fmt::format(text, std::forward<A>(arguments)...));
  }

  template <class... A>
  void doubt(fmt::format_string<A...> text, A&&... arguments)
  {
    tidy_.doubts.push_back(fmt::format(text, std::forward<A>(arguments)...));
  }

  template <class F>
  void drop(F&& is_meant)
  {
    std::erase_if(tidy_.lines, is_meant);
  }

  void close_outlines()
  {
    int n_closed = 0;
    Real widest = 0.0;
    for (DxfLine& line : tidy_.lines) {
      auto& x = line.places;
      x.erase(std::unique(x.begin(), x.end()), x.end());
      const Real gap = distance(x.front(), x.back());
      if (line.closed || x.size() < 4 || gap > snap_) continue;
      while (x.size() > 3 && distance(x.front(), x.back()) <= snap_) x.pop_back();
      line.closed = true;
      if (gap == 0.0) continue;
      ++n_closed;
      widest = std::max(widest, gap);
    }
    drop([](const DxfLine& line) { return line.places.size() < 2; });
    if (n_closed > 0) note("{} outlines were closed, by at most {:.3g} mm.", n_closed, 1e3 * widest);
  }

  void leave_out_ground_of_export()
  {
    const std::size_t n = tidy_.lines.size();
    if (std::ranges::none_of(tidy_.lines, &DxfLine::closed)) return;
    drop([](const DxfLine& line) {
      return !line.closed && (line.layer == "ground_start" || line.layer == "ground_end");
    });
    if (tidy_.lines.size() < n) note("The ground lines of an exported section bound no soil.");
  }

  void leave_out_water()
  {
    std::set<std::string> water, bodies_of_water;
    drop([&](const DxfLine& line) {
      if (is_of_water(line.layer)) (line.closed ? bodies_of_water : water).insert(line.layer);
      return is_of_water(line.layer) && !line.closed;
    });
    if (!water.empty()) note("Open lines of water bound no soil: {}.", fmt::join(water, ", "));
    if (!bodies_of_water.empty())
      doubt("Outlines on layers of water were taken as soil: {}. --layers leaves them out.",
          fmt::join(bodies_of_water, ", "));
  }

  /// Borders, title blocks and legends by their names, whatever they touch.
  void leave_out_named_frames()
  {
    const auto is_frame = [](const DxfLine& line) { return has_word(line.layer, frame_words); };
    std::set<std::string> names;
    if (std::ranges::all_of(tidy_.lines, is_frame)) return;
    drop([&](const DxfLine& line) { return is_frame(line) && (names.insert(line.layer), true); });
    if (!names.empty())
      doubt("Lines of a frame bound no soil: {}. Name all layers of soil in --layers if they do.",
          fmt::join(names, ", "));
  }

  /// A rectangle that holds all other outlines and touches them: a frame, or soil that they lie in.
  void refuse_doubtful_frames()
  {
    if (tidy_.lines.size() < 3 || !std::ranges::all_of(tidy_.lines, &DxfLine::closed)) return;
    std::set<std::string> layers;
    for (const DxfLine& line : tidy_.lines) layers.insert(line.layer);
    for (const DxfLine& line : tidy_.lines) {
      if (!is_rectangle(line) || has_word(line.layer, ground_words)) continue;
      const BoundingBox box = box_around(line.places);
      const auto touches = [&](const DxfLine& other) {  // but for title blocks on its own layer
        return &other != &line && other.layer != line.layer && meet(line, other, snap_);
      };
      const bool holds_all = std::ranges::all_of(
          tidy_.lines, [&](const DxfLine& other) { return width_within(other, wider(box, snap_)) > 0.0; });
      const bool is_of_no_layer = line.layer == "0" && layers.size() >= 3;
      if ((!holds_all && !is_of_no_layer) || std::ranges::none_of(tidy_.lines, touches)) continue;
      std::set<std::string> others = layers;
      others.erase(line.layer);
      throw InputError({"", fmt::format("the rectangle on layer {} may be a frame or soil", line.layer),
          fmt::format("It lies from {:.2f}, {:.2f} to {:.2f}, {:.2f} m and {}. A frame: --layers '{}'. Soil: --layers "
                      "'{}'.",
              box.low[0], box.low[1], box.high[0], box.high[1],
              holds_all ? "holds all other outlines" : "others have layers of their own", fmt::join(others, ","),
              fmt::join(layers, ",")),
          ""});
    }
  }

  /// Of outlines in one place the last one that was drawn counts.
  void leave_out_copies()
  {
    std::vector<std::string> named;
    std::vector<bool> is_copy(tidy_.lines.size(), false);
    for (std::size_t k = 0; k < tidy_.lines.size(); ++k)
      for (std::size_t later = k + 1; later < tidy_.lines.size() && !is_copy[k]; ++later) {
        const DxfLine &line = tidy_.lines[k], &other = tidy_.lines[later];
        is_copy[k] = line.closed && other.closed && is_same_outline(line, other, snap_);
        if (is_copy[k] && line.layer != other.layer)
          named.push_back(fmt::format("{} and {} at {:.2f}, {:.2f} m: {} counts", line.layer, other.layer,
              line.places[0][0], line.places[0][1], other.layer));
      }
    std::size_t k = 0;
    drop([&](const DxfLine&) { return is_copy[k++]; });
    if (!named.empty())
      doubt(
          "Two layers have the same outline, of which the last one that was drawn counts: {}. --layers leaves one out.",
          fmt::join(named, ", "));
  }

  void leave_out_tables()
  {
    const SectionSearch found = look_for_sections(tidy_.lines, snap_);
    if (!found.doubt.empty()) tidy_.doubts.push_back(found.doubt);
    std::set<std::string> names;
    std::size_t k = 0;
    drop([&](const DxfLine& line) { return found.is_apart[k++] && (names.insert(line.layer), true); });
    if (!names.empty()) note("Lines beside the section bound no soil: {}.", fmt::join(names, ", "));
  }

  /// The number of its group for each line.
  std::vector<std::size_t> groups() const
  {
    const std::size_t n = tidy_.lines.size();
    std::vector<std::size_t> group(n);
    std::iota(group.begin(), group.end(), std::size_t{0});
    std::vector<BoundingBox> boxes;
    for (const DxfLine& line : tidy_.lines) boxes.push_back(wider(box_around(line.places), snap_));
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b)
        if (group[a] != group[b] && overlap(boxes[a], boxes[b]) && meet(tidy_.lines[a], tidy_.lines[b], snap_))
          std::ranges::replace(group, std::size_t{group[b]}, std::size_t{group[a]});  // copies: both stand in it
    return group;
  }

  /// The number of the group that is the section: of layers that which was closed, else that of most outlines.
  static std::size_t section_of(const std::vector<std::size_t>& group, const std::vector<int>& weight, bool has_ends)
  {
    if (has_ends) return group.back();
    return static_cast<std::size_t>(std::ranges::max_element(weight) - weight.begin());
  }

  void leave_out_frames(bool is_layered)
  {
    const std::vector<std::size_t> group = groups();
    const bool has_ends = is_layered && !tidy_.lines.empty() && tidy_.lines.back().layer.empty();
    std::vector<int> weight(group.size(), 0);
    for (std::size_t k = 0; k < group.size(); ++k) weight[group[k]] += tidy_.lines[k].closed ? outline_weight : 1;
    if (group.empty()) return;
    const std::size_t section = section_of(group, weight, has_ends);
    std::vector<Vec<2>> places;
    for (std::size_t k = 0; k < group.size(); ++k)
      if (group[k] == section) places.insert(places.end(), tidy_.lines[k].places.begin(), tidy_.lines[k].places.end());
    const BoundingBox section_box = box_around(places);
    std::set<std::size_t> frames;
    std::set<std::string> names, apart;
    for (std::size_t k = 0; k < group.size(); ++k) {
      const DxfLine& line = tidy_.lines[k];
      if (group[k] == section || !line.closed) continue;
      const bool is_around = std::ranges::all_of(places, [&](const Vec<2>& x) { return contains(line.places, x); });
      const bool is_frame = line.places.size() == 4 && weight[section] >= 2 && !has_word(line.layer, ground_words);
      if (is_around && (is_frame || has_word(line.layer, words_of_sheets)) && !layers_are_chosen_)
        frames.insert(group[k]), names.insert(line.layer);
    }
    for (std::size_t k = 0; k < group.size(); ++k) {
      const DxfLine& line = tidy_.lines[k];
      if (group[k] == section || !line.closed || frames.contains(group[k])) continue;
      if (has_ends && overlap(section_box, box_around(line.places))) continue;
      if (std::ranges::none_of(tidy_.lines, [&](const DxfLine& other) {
            return &other != &line && other.closed && contains(other.places, line.places[0]);
          }))
        apart.insert(line.layer);
    }
    std::set<std::string> loose;
    Real long_within = 0.0;  // [m]: width of what is left out within the section
    std::vector<DxfLine> kept;
    for (std::size_t k = 0; k < group.size(); ++k) {
      const bool touches_nothing =
          group[k] != section && weight[section] >= outline_weight && weight[group[k]] < outline_weight;
      if (touches_nothing) loose.insert(tidy_.lines[k].layer), long_within += width_within(tidy_.lines[k], section_box);
      if (!touches_nothing && !frames.contains(group[k])) kept.push_back(std::move(tidy_.lines[k]));
    }
    tidy_.lines = std::move(kept);
    if (!loose.empty()) {
      const std::string text = fmt::format("Lines that touch no outline bound no soil: {}.", fmt::join(loose, ", "));
      if (long_within > short_piece * (section_box.high[0] - section_box.low[0]))
        tidy_.doubts.push_back(text + " Those within the section may be borders of soil: let them end at its outline.");
      else
        tidy_.notes.push_back(text);
    }
    if (!frames.empty())
      doubt("Outlines that hold all others and touch none were taken as a frame, not as soil: {}.",
          fmt::join(names, ", "));
    std::set<std::string> drawn_frames;
    for (const DxfLine& line : tidy_.lines)
      if (line.closed && has_word(line.layer, words_of_sheets)) drawn_frames.insert(line.layer);
    if (!drawn_frames.empty() && !layers_are_chosen_)
      doubt("Outlines on layers of frames were taken as soil: {}. --layers leaves them out.",
          fmt::join(drawn_frames, ", "));
    if (!apart.empty() && (has_ends || weight[section] >= 2 * outline_weight))
      doubt(
          "Outlines that touch no other were taken as soil: {}. --layers leaves a layer out.", fmt::join(apart, ", "));
  }

  bool is_loose(const DxfLine& line, Vec<2> end) const
  {
    return std::ranges::none_of(
        tidy_.lines, [&](const DxfLine& other) { return &other != &line && gap_to(other, end) <= snap_; });
  }

  /// With outlines on both sides of boundaries, a line that ends within one is a wall, a drain or an anchor.
  void leave_out_walls()
  {
    if (std::ranges::count_if(tidy_.lines, &DxfLine::closed) < 2) return;
    std::set<std::string> names;
    std::vector<DxfLine> kept;
    for (const DxfLine& line : tidy_.lines) {
      const auto ends_within = [&](Vec<2> end) {
        return is_loose(line, end) && std::ranges::any_of(tidy_.lines, [&](const DxfLine& other) {
          return other.closed && contains(other.places, end);
        });
      };
      if (!line.closed && (ends_within(line.places.front()) || ends_within(line.places.back())))
        names.insert(line.layer);
      else
        kept.push_back(line);
    }
    tidy_.lines = std::move(kept);
    if (!names.empty()) note("Lines that end within an outline bound no soil: {}.", fmt::join(names, ", "));
  }

  /// Whether a line lies along a vertical between two heights.
  bool is_closed(Real x, Real low, Real high) const
  {
    return std::ranges::any_of(tidy_.lines, [&](const DxfLine& line) {
      return gap_to(line, {x, 0.5 * (low + high)}) <= snap_;
    });
  }

  /// Ends of open lines at one x, upwards: at the outermost x on a side of the section where they have several heights.
  std::vector<Vec<2>> ends_at_one_x(std::vector<Vec<2>> ends, Real middle, Real outwards) const
  {
    std::erase_if(ends, [&](const Vec<2>& end) { return outwards * (end[0] - middle) <= 0.0; });
    std::ranges::sort(ends, {}, [&](const Vec<2>& end) { return -outwards * end[0]; });
    for (const Vec<2>& end : ends) {
      std::vector<Vec<2>> here;
      std::ranges::copy_if(
          ends, std::back_inserter(here), [&](const Vec<2>& other) { return std::abs(other[0] - end[0]) <= snap_; });
      std::ranges::sort(here, {}, [](const Vec<2>& x) { return x[1]; });
      if (here.back()[1] - here.front()[1] > snap_) return here;
    }
    return {};
  }

  /// Boundaries from end to end of the section, as other programs write them.
  void close_ends()
  {
    std::vector<Vec<2>> all, ends;
    for (const DxfLine& line : tidy_.lines) {
      all.insert(all.end(), line.places.begin(), line.places.end());
      if (!line.closed) ends.push_back(line.places.front()), ends.push_back(line.places.back());
    }
    if (ends.empty()) return;
    const BoundingBox box = box_around(all);
    std::vector<DxfLine> verticals;
    for (const Real outwards : {-1.0, 1.0}) {
      const std::vector<Vec<2>> side = ends_at_one_x(ends, 0.5 * (box.low[0] + box.high[0]), outwards);
      for (std::size_t k = 1; k < side.size(); ++k)
        if (side[k][1] - side[k - 1][1] > snap_ && !is_closed(side[k][0], side[k - 1][1], side[k][1]))
          verticals.push_back({"", {side[k - 1], side[k]}, false, ""});
    }
    if (verticals.empty()) return;
    const auto base_of = [](const DxfLine& line) { return line.closed ? INFINITY : line.places[0][1]; };
    const auto lowest = std::ranges::min_element(tidy_.lines, {}, base_of);
    std::set<std::string> where;
    for (const DxfLine& vertical : verticals) where.insert(fmt::format("{:.2f}", vertical.places[0][0]));
    note("Boundaries without ends were closed by verticals at x = {} m; the lowest line, on layer {}, is the base.",
        fmt::join(where, ", "), lowest->layer);
    std::ranges::move(verticals, std::back_inserter(tidy_.lines));
  }

  TidyLines tidy_;
  Real snap_;
  bool layers_are_chosen_;
};

}  // namespace

bool is_of_water(const std::string& layer)
{
  return (has_word(layer, water_words) || is_of_water_level(layer)) && !has_word(layer, ground_words);
}

TidyLines tidy_lines(const DxfDrawing& drawing, Real snap)
{
  return Tidier(drawing, snap).tidy(drawing.is_one_section);
}

}  // namespace terp
