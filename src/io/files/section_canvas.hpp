// The page of a drawing of the section: where a place of the mesh lies on it, what is put there, axes.
// Not for: what is drawn (section_svg.cpp).
#pragma once

#include "mpm/mesh/mesh.hpp"
#include "io/files/svg.hpp"
#include "model/bodies/body_outline.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <vector>

namespace terp {

inline constexpr Real width = 1200.0, left = 92.0, right = 92.0, top = 96.0;  // of the page and its margins [px]
inline constexpr Real highest = 640.0;                                        // of the section [px]
inline constexpr const char* ink = "#1f2933";
/// Of words that lie on lines.
inline constexpr const char* white_edge = "stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"";

class SectionCanvas {
 public:
  explicit SectionCanvas(const Mesh<2>& mesh)
  {
    for (const Vec<2>& x : mesh.nodes)
      for (int d = 0; d < 2; ++d) low_[d] = std::min(low_[d], x[d]), high_[d] = std::max(high_[d], x[d]);
    scale_ = std::min((width - left - right) / (high_[0] - low_[0]), highest / (high_[1] - low_[1]));
    offset_ = 0.5 * (width - scale_ * (high_[0] - low_[0]));
  }

 protected:
  Real px(Real x) const { return offset_ + scale_ * (x - low_[0]); }
  Real py(Real y) const { return top + scale_ * (high_[1] - y); }
  Real floor_px() const { return py(low_[1]); }

  template <class... Args>
  void put(fmt::format_string<Args...> text, Args&&... args)
  {
    fmt::format_to(std::back_inserter(out_), text, std::forward<Args>(args)...);
    out_ += '\n';
  }

  void text(Real x, Real y, std::string_view words, const char* anchor = "start", const std::string& style = "")
  {
    put("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>", x, y, anchor, style,
        escaped_for_markup(words));
  }

  std::string open_path(const std::vector<Vec<2>>& places) const
  {
    std::string path;
    for (const Vec<2>& x : places) path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", px(x[0]), py(x[1]));
    return path;
  }

  std::string ring(const std::vector<Vec<2>>& corners) const { return open_path(corners) + "Z"; }

  std::string line(const Side& s) const
  {
    return fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", px(s.a[0]), py(s.a[1]), px(s.b[0]), py(s.b[1]));
  }

  void arrow(Real x, Real y, Vec<2> direction, Real size, const char* colour)
  {
    const Real n = std::hypot(direction[0], direction[1]), dx = direction[0] / n, dy = -direction[1] / n;
    const Real ex = x + size * dx, ey = y + size * dy;
    put("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}\" fill=\"none\" "
        "stroke=\"{}\" "
        "stroke-width=\"2.4\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/>",
        x, y, ex, ey, ex - 9 * dx + 5 * dy, ey - 9 * dy - 5 * dx, ex, ey, ex - 9 * dx - 5 * dy, ey - 9 * dy + 5 * dx,
        colour);
  }

  /// Returns where the room below the axes begins [px].
  Real axes()
  {
    const Real bottom = floor_px() + 44.0, side = px(low_[0]) - 44.0;
    put("<path d=\"M{0:.1f} {2:.1f}H{1:.1f}M{3:.1f} {4:.1f}V{5:.1f}\" stroke=\"#5c6670\" fill=\"none\"/>", px(low_[0]),
        px(high_[0]), bottom, side, py(low_[1]), py(high_[1]));
    const auto each = [&](int d, auto&& f) {
      const Real between_ticks = d == 0 ? 55.0 : 28.0;  // at least [px]
      const Real range = high_[d] - low_[d], step = nice_step(range, std::max(1.0, scale_ * range / between_ticks));
      for (Real k = std::ceil(low_[d] / step - 1e-9); k * step <= high_[d] + 1e-9 * step; ++k) f(k * step + 0.0);
    };
    each(0, [&](Real x) {
      put("<path d=\"M{:.1f} {:.1f}v5\" stroke=\"#5c6670\"/>", px(x), bottom);
      text(px(x), bottom + 18.0, fmt::format("{:.6g}", x), "middle", "font-size=\"12\" fill=\"#5c6670\"");
    });
    each(1, [&](Real y) {
      put("<path d=\"M{:.1f} {:.1f}h-5\" stroke=\"#5c6670\"/>", side, py(y));
      text(side - 8.0, py(y) + 4.0, fmt::format("{:.6g}", y), "end", "font-size=\"12\" fill=\"#5c6670\"");
    });
    text(px(high_[0]) + 26.0, bottom + 18.0, "m", "start", "font-size=\"12\" fill=\"#5c6670\"");
    return bottom + 40.0;
  }

  Vec<2> low_{INFINITY, INFINITY}, high_{-INFINITY, -INFINITY};  ///< of the mesh [m]
  Real scale_ = 1.0, offset_ = left;                             ///< [px/m], [px]
  std::string out_;
};

}  // namespace terp
