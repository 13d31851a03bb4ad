// Sections beside each other have an empty strip between them. Sections above each other have one too if they have
// outlines or drawn ends. Of boundaries without ends only names tell: from top to bottom they come twice.

#include "import/drawing/drawn_sections.hpp"

#include "import/drawing/line_gaps.hpp"

#include "math/errors.hpp"
#include "math/plane.hpp"
#include "model/bodies/polygon.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace terp {
namespace {

constexpr Real empty_strip = 0.5;     // [m]: between sections, at least
constexpr Real part_of_widest = 0.2;  // a part that is narrower is a legend
constexpr std::size_t sure = 3;       // boundaries of a section, from which on names that come twice say enough

struct Part {
  BoundingBox box;
  std::vector<const DxfLine*> lines = {};
};

BoundingBox both(const BoundingBox& a, const BoundingBox& b)
{
  return {{std::min(a.low[0], b.low[0]), std::min(a.low[1], b.low[1])},
      {std::max(a.high[0], b.high[0]), std::max(a.high[1], b.high[1])}};
}

Part part_of(std::vector<const DxfLine*> lines)
{
  Part part{box_around(lines.front()->places), std::move(lines)};
  for (const DxfLine* line : part.lines) part.box = both(part.box, box_around(line->places));
  return part;
}

/// Parts with an empty strip between them along an axis.
std::vector<Part> parts_along(int axis, const std::vector<const DxfLine*>& lines)
{
  std::vector<Part> parts, all;
  for (const DxfLine* line : lines) all.push_back({box_around(line->places), {line}});
  std::ranges::stable_sort(all, {}, [&](const Part& part) { return part.box.low[axis]; });
  for (const Part& one : all)
    if (parts.empty() || one.box.low[axis] > parts.back().box.high[axis] + empty_strip) {
      parts.push_back(one);
    } else {
      parts.back().box = both(parts.back().box, one.box);
      parts.back().lines.push_back(one.lines.front());
    }
  return parts;
}

struct Span {
  Vec<2> left, right;
};

std::vector<Span> spans_of(const std::vector<const DxfLine*>& lines, Real snap)
{
  std::vector<Span> spans;
  for (const DxfLine* line : lines) {
    const auto [left, right] = std::minmax(line->places.front(), line->places.back());
    if (!line->closed && right[0] - left[0] > snap) spans.push_back({left, right});
  }
  std::ranges::sort(spans, {}, [](const Span& s) { return s.left[0]; });
  return spans;
}

bool has_boundaries(const std::vector<const DxfLine*>& lines, Real snap)
{
  const std::vector<Span> spans = spans_of(lines, snap);
  for (auto a = spans.begin(); a != spans.end(); ++a)
    for (auto b = a + 1; b != spans.end() && b->left[0] - a->left[0] <= snap; ++b)
      if (std::abs(a->right[0] - b->right[0]) <= snap &&
          (std::abs(a->left[1] - b->left[1]) > snap || std::abs(a->right[1] - b->right[1]) > snap))
        return true;
  return false;
}

bool has_outlines(const Part& part)
{
  std::set<std::string> layers;
  for (const DxfLine* line : part.lines)
    if (line->closed) layers.insert(line->layer);
  return layers.size() >= 2;
}

/// A line stands at both ends of its boundaries.
bool has_ends(const Part& part, Real snap)
{
  const auto stands_at = [&](Real x) {
    return std::ranges::any_of(part.lines, [&](const DxfLine* line) {
      return gap_to(*line, {x, std::lerp(part.box.low[1], part.box.high[1], 0.5)}) <= snap ||
             gap_to(*line, {x, std::lerp(part.box.low[1], part.box.high[1], 0.1)}) <= snap;
    });
  };
  return has_boundaries(part.lines, snap) && stands_at(part.box.low[0]) && stands_at(part.box.high[0]);
}

[[noreturn]] void refuse(const std::vector<Part>& sections)
{
  std::vector<std::string> windows;
  for (const Part& section : sections) {
    const auto down = [](Real x) { return std::floor(10.0 * x - 0.5) / 10.0; };
    const BoundingBox& box = section.box;
    windows.push_back(fmt::format("--window {:.1f},{:.1f},{:.1f},{:.1f}", down(box.low[0]), down(box.low[1]),
        -down(-box.high[0]), -down(-box.high[1])));
  }
  throw InputError({"", fmt::format("the drawing holds {} sections", sections.size()),
      fmt::format("They lie in {}. Give one of these, a window that holds what is one section, or --layers.",
          fmt::join(windows, "; ")),
      ""});
}

/// Frames around several others say nothing of where sections end.
std::vector<const DxfLine*> without_frames(const std::vector<DxfLine>& lines)
{
  std::vector<const DxfLine*> kept;
  for (const DxfLine& line : lines) {
    int n_held = 0;
    if (is_rectangle(line))
      for (const DxfLine& other : lines) {
        const BoundingBox box = wider(box_around(line.places), 1e-6), inner = box_around(other.places);
        n_held += &other != &line && inner.low[0] > box.low[0] && inner.low[1] > box.low[1] &&
                  inner.high[0] < box.high[0] && inner.high[1] < box.high[1];
      }
    if (n_held < 2) kept.push_back(&line);
  }
  return kept;
}

/// Of parts that could be sections. Beside outlines a part of open lines on other layers is a table or a legend, and so
/// is a part that is much narrower: their open lines are put to `apart`.
void refuse_if_several(std::vector<Part> parts, std::set<const DxfLine*>& apart)
{
  Real widest = 0.0;
  std::set<std::string> soils;
  for (const Part& part : parts) {
    widest = std::max(widest, part.box.high[0] - part.box.low[0]);
    if (!has_outlines(part)) continue;
    for (const DxfLine* line : part.lines)
      if (line->closed) soils.insert(line->layer);
  }
  const auto is_beside = [&](const Part& part) {
    const bool is_narrow = part.box.high[0] - part.box.low[0] < part_of_widest * widest;
    const bool has_soil = std::ranges::any_of(
        part.lines, [&](const DxfLine* line) { return line->closed || soils.contains(line->layer); });
    if (!is_narrow && (has_soil || soils.empty())) return false;
    for (const DxfLine* line : part.lines)
      if (!line->closed) apart.insert(line);
    return true;
  };
  std::erase_if(parts, is_beside);
  if (parts.size() > 1) refuse(parts);
}

Real gap_between(const std::vector<Part>& levels, std::size_t k)
{
  return levels[k].box.low[1] - levels[k - 1].box.high[1];
}

/// Boundaries of layers upwards; of sections above each other the layers come twice.
std::string look_at_levels(const Part& part, Real snap)
{
  std::vector<Part> levels;
  for (const DxfLine* line : part.lines)
    if (const BoundingBox box = box_around(line->places);
        !line->closed && box.high[0] - box.low[0] > std::max(snap, 0.5 * (part.box.high[0] - part.box.low[0])))
      levels.push_back({box, {line}});
  const std::size_t n = levels.size();
  if (n < 4) return "";
  std::ranges::stable_sort(levels, {}, [](const Part& level) {
    const auto& x = level.lines[0]->places;
    return x.front()[1] + x.back()[1];
  });
  const auto layer = [&](std::size_t k) { return levels[k].lines[0]->layer; };
  std::size_t widest = 1;
  for (std::size_t k = 2; k < n; ++k)
    if (gap_between(levels, k) > gap_between(levels, widest)) widest = k;
  std::vector<Part> sections;
  bool are_sure = layer(0) != layer(n - 1), is_at_widest = false;
  std::size_t from = 0;
  for (std::size_t k = 1; k <= n; ++k) {
    if (k < n && !(layer(k - 1) == layer(n - 1) && layer(k) == layer(0))) continue;
    std::vector<const DxfLine*> own;
    for (; from < k; ++from) own.push_back(levels[from].lines[0]);
    are_sure = are_sure && own.size() >= 2;
    is_at_widest = is_at_widest || k == widest;
    sections.push_back(part_of(std::move(own)));
  }
  are_sure =
      are_sure && (is_at_widest || std::ranges::all_of(sections, [](const Part& s) { return s.lines.size() >= sure; }));
  if (are_sure && sections.size() > 1) refuse(sections);
  const Real gap = gap_between(levels, widest), low = levels.front().box.low[1], high = levels.back().box.high[1];
  const Real from_y = levels[widest - 1].box.high[1], to_y = levels[widest].box.low[1];
  if (widest < 2 || widest > n - 2 || gap <= std::max(from_y - low, high - to_y)) return "";
  return fmt::format(
      "The layer from {:.2f} to {:.2f} m is thicker than all above and all below it: are these two "
      "sections above each other? --window x0,y0,x1,y1 takes one.",
      from_y, to_y);
}

}  // namespace

void keep_window(DxfDrawing& drawing, const BoundingBox& window)
{
  std::set<std::string> reach_out;
  std::size_t n_outside = 0;
  const auto is_outside = [&](const DxfLine& line) {
    const BoundingBox box = box_around(line.places);
    bool is_inside = true;
    for (int d = 0; d < 2; ++d) is_inside = is_inside && box.low[d] >= window.low[d] && box.high[d] <= window.high[d];
    if (is_inside) return false;
    if (overlap(box, window))
      reach_out.insert(line.layer);
    else
      ++n_outside;
    return true;
  };
  std::erase_if(drawing.lines, is_outside);
  std::erase_if(drawing.hatches, is_outside);
  if (drawing.lines.empty() && drawing.hatches.empty())
    throw InputError({"", "no line lies in the window",
        "--window has the lower left and the upper right corner, in m: x0,y0,x1,y1.", ""});
  if (n_outside > 0) drawing.notes.push_back(fmt::format("{} lines outside the window were left out.", n_outside));
  if (!reach_out.empty())
    drawing.doubts.push_back(
        fmt::format("Lines that reach out of the window were left out: on {}.", fmt::join(reach_out, ", ")));
  drawing.is_one_section = true;
}

bool has_boundaries(const std::vector<DxfLine>& lines, Real snap)
{
  std::vector<const DxfLine*> all;
  for (const DxfLine& line : lines) all.push_back(&line);
  return has_boundaries(all, snap);
}

SectionSearch look_for_sections(const std::vector<DxfLine>& lines, Real snap)
{
  SectionSearch found;
  std::set<const DxfLine*> apart;
  std::vector<Part> columns = parts_along(0, without_frames(lines));
  const auto is_column = [&](const Part& p) { return has_outlines(p) || has_boundaries(p.lines, snap); };
  std::erase_if(columns, std::not_fn(is_column));
  std::vector<Part> sections;
  for (const Part& column : columns) {
    std::vector<Part> rows = parts_along(1, column.lines);
    std::erase_if(rows, [&](const Part& p) { return !has_outlines(p) && !has_ends(p, snap); });
    if (rows.size() < 2) rows = {column};
    std::ranges::move(rows, std::back_inserter(sections));
  }
  refuse_if_several(std::move(sections), apart);
  for (const Part& column : columns)
    if (found.doubt.empty()) found.doubt = look_at_levels(column, snap);
  for (const DxfLine& line : lines) found.is_apart.push_back(apart.contains(&line));
  return found;
}

}  // namespace terp
