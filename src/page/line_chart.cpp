// The ranges of the axes come first, then the margins that their numbers need; only then do px() and py() hold. The
// height of the legend is known last, so the <svg> tag is written around the finished drawing. Widths of texts are
// estimated from the number of letters, as no font is at hand.

#include "page/line_chart.hpp"

#include "io/files/svg.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real width = 460.0, height = 270.0, top = 30.0, bottom = 44.0;  // [px]
constexpr Real least_left = 66.0, least_right = 14.0;                     // of the margins [px]
constexpr Real wide_digit = 6.6, beside_numbers = 27.0;                   // a digit; the label along y and gaps [px]
constexpr const char* colours[] = {"#0067a5", "#c14f00", "#007a58", "#a8467f", "#6b5b00"};  // of runs, as in web/
constexpr const char* dash_patterns[] = {"", "9 4", "5 4", "2 4", "9 4 2 4", "1 5"};
constexpr const char* ink = "#18212b";
constexpr const char* muted = "#566270";

struct Range {
  Real low = INFINITY, high = -INFINITY;

  void take(Real value)
  {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  bool is_empty() const { return !(low <= high); }
  /// A line that is level lies in the middle.
  void widen(Real share)
  {
    const Real size = high - low;
    const Real more = size > 1e-9 * std::max(std::abs(low), std::abs(high)) ? share * size
                      : high != 0.0                                         ? 0.1 * std::abs(high)
                                                                            : 1.0;
    low -= more, high += more;
  }
};

class Drawing {
 public:
  explicit Drawing(const LineChart& chart) : chart_(chart)
  {
    for (const ChartLine& line : chart.lines)
      for (const Vec<2>& at : line.points)
        if (std::isfinite(at[0]) && std::isfinite(at[1])) x_.take(at[0]), y_.take(at[1]);
    for (const ChartBar& bar : chart.bars) x_.take(bar.at[0]), y_.take(bar.at[1]);
    if (chart.x_from_zero) x_.take(0.0);
  }

  std::string draw()
  {
    if (x_.is_empty() || y_.is_empty()) return "";
    x_.widen(0.03);
    y_.widen(0.08);
    make_room();
    axes();
    for (const ChartBar& bar : chart_.bars) draw_bar(bar);
    for (const ChartLine& line : chart_.lines) draw_line(line);
    legend();
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" role=\"img\" aria-label=\"{2}\" "
        "font-size=\"11.5\" fill=\"{3}\">\n{4}</svg>\n",
        width, height + legend_height_, escaped_for_markup(chart_.title), ink, out_);
  }

 private:
  Real px(Real x) const { return left_ + (width - left_ - right_) * (x - x_.low) / (x_.high - x_.low); }
  Real py(Real y) const { return height - bottom - (height - top - bottom) * (y - y_.low) / (y_.high - y_.low); }

  /// Margins that hold the numbers of both axes.
  void make_room()
  {
    each_tick(y_, n_ticks_y,
        [&](Real y) { left_ = std::max(left_, beside_numbers + wide_digit * static_cast<Real>(tick_text(y).size())); });
    each_tick(x_, n_ticks_x,
        [&](Real x) { right_ = std::max(right_, 0.5 * wide_digit * static_cast<Real>(tick_text(x).size())); });
  }

  template <class... Args>
  void put(fmt::format_string<Args...> text, Args&&... args)
  {
    fmt::format_to(std::back_inserter(out_), text, std::forward<Args>(args)...);
    out_ += '\n';
  }

  void text(Real x, Real y, const std::string& words, const char* anchor, const char* style = "")
  {
    put("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>", x, y, anchor, style,
        escaped_for_markup(words));
  }

  static constexpr Real n_ticks_x = 6.0, n_ticks_y = 5.0;  // about as many
  static std::string tick_text(Real value) { return fmt::format("{:.5g}", value); }

  static void each_tick(const Range& range, Real n, auto&& f)
  {
    const Real step = nice_step(range.high - range.low, n);
    for (Real k = std::ceil(range.low / step - 1e-9); k * step <= range.high + 1e-9 * step; ++k) f(k * step + 0.0);
  }

  void axes()
  {
    const Real floor = height - bottom;
    each_tick(y_, n_ticks_y, [&](Real y) {
      put("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#e2e7ec\"/>", left_, py(y), width - right_);
      text(left_ - 6.0, py(y) + 4.0, tick_text(y), "end");
    });
    each_tick(x_, n_ticks_x, [&](Real x) {
      put("<path d=\"M{:.1f} {:.1f}v5\" stroke=\"{}\"/>", px(x), floor, muted);
      text(px(x), floor + 17.0, tick_text(x), "middle");
    });
    put("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}\" stroke=\"{4}\" fill=\"none\"/>", left_, top, floor,
        width - right_, muted);
    text(left_, 16.0, chart_.title, "start", "font-weight=\"650\" font-size=\"12.5\"");
    text(0.5 * (left_ + width - right_), height - 10.0, chart_.x_label, "middle", "fill=\"#566270\"");
    put("<text transform=\"translate(13 {:.1f}) rotate(-90)\" text-anchor=\"middle\" fill=\"{}\">{}</text>",
        0.5 * (top + floor), muted, escaped_for_markup(chart_.y_label));
  }

  static const char* colour_of(std::size_t style) { return colours[style % std::size(colours)]; }

  static std::string dashes_of(const ChartLine& line)
  {
    const auto k = static_cast<std::size_t>(line.dashes) % std::size(dash_patterns);
    return k == 0 ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash_patterns[k]);
  }

  void mark(Real x, Real y, std::size_t style)
  {
    constexpr const char* shapes[] = {"m-3.6 0a3.6 3.6 0 1 0 7.2 0a3.6 3.6 0 1 0 -7.2 0", "m-3.3 -3.3h6.6v6.6h-6.6z",
        "m0 -4.2l4 7.2h-8z", "m0 -4.6l4.4 4.6l-4.4 4.6l-4.4 -4.6z"};
    put("<path d=\"M{:.1f} {:.1f}{}\" fill=\"{}\"/>", x, y, shapes[style % std::size(shapes)], colour_of(style));
  }

  void draw_line(const ChartLine& line)
  {
    std::string path;
    bool open = false;
    for (const Vec<2>& at : line.points) {
      const bool is_there = std::isfinite(at[0]) && std::isfinite(at[1]);
      if (is_there) path += fmt::format("{}{:.1f} {:.1f}", open ? "L" : "M", px(at[0]), py(at[1]));
      if (is_there && line.marks) mark(px(at[0]), py(at[1]), line.style);
      open = is_there;
    }
    put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.7\" stroke-linejoin=\"round\"{}/>", path,
        colour_of(line.style), dashes_of(line));
  }

  void draw_bar(const ChartBar& bar)
  {
    const Real x = px(bar.at[0]), low = std::max(bar.at[1] - bar.half, y_.low),
               high = std::min(bar.at[1] + bar.half, y_.high);
    put("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {1:.1f}h8M{3:.1f} {2:.1f}h8\" stroke=\"{4}\" "
        "stroke-width=\"1.4\"/>",
        x, py(low), py(high), x - 4.0, colour_of(bar.style));
    put("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.6\"/>", x,
        py(bar.at[1]), colour_of(bar.style));
  }

  void legend()
  {
    Real x = left_, y = height + 4.0;
    for (const ChartLine& line : chart_.lines) {
      if (line.name.empty()) continue;
      const Real wide = 44.0 + 6.3 * static_cast<Real>(line.name.size());
      if (x > left_ && x + wide > width - right_) x = left_, y += 17.0;
      put("<path d=\"M{:.1f} {:.1f}h24\" stroke=\"{}\" stroke-width=\"1.7\"{}/>", x, y, colour_of(line.style),
          dashes_of(line));
      if (line.marks) mark(x + 12.0, y, line.style);
      text(x + 30.0, y + 4.0, line.name, "start");
      x += wide;
      legend_height_ = y + 12.0 - height;
    }
  }

  const LineChart& chart_;
  Range x_, y_;
  Real left_ = least_left, right_ = least_right;  // margins [px]
  Real legend_height_ = 0.0;
  std::string out_;
};

}  // namespace

std::string draw_chart(const LineChart& chart) { return Drawing(chart).draw(); }

}  // namespace terp
