// Coordinates of the drawing are pixels, y downward; SectionCanvas turns metres into them.

#include "io/files/section_svg.hpp"

#include "mpm/features/conditions.hpp"
#include "io/files/section_water.hpp"
#include "io/files/soil_colours.hpp"
#include "io/files/svg.hpp"
#include "model/loads/loads.hpp"
#include "model/soils/overburden.hpp"
#include "model/bodies/setup_points.hpp"
#include "model/loads/side_shape.hpp"
#include "run/report/slip_planes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace terp {
namespace {

constexpr Real smallest_cell = 4.0;  // that is drawn [px]
constexpr Index most_cells = 40000, most_points = 20000;

constexpr Real weight_of_a_mass = 9.81e-3;  // [kN/kg], as kN/m3 of a case file is read
constexpr const char *placed_colour = "#1b7f4b", *removed_colour = "#a11d2e";
constexpr const char* load_colour = "#b4371e";
constexpr const char *shade_colour = "#c2185b", *line_colour = "#7a0c3a";
constexpr const char* plane_colours[] = {"#14532d", "#1d4ed8", "#9a3412", "#6d28d9"};  // of other methods, in turn

class SectionDrawing : SectionWater {
 public:
  SectionDrawing(const Model& model, const State& state, const SectionOverlay& overlay)
      : SectionWater(model),
        state_(state),
        overlay_(overlay),
        is_result_(!overlay.subtitle.empty()),
        colours_(soil_colours(model.description.materials))
  {
  }

  std::string draw()
  {
    cells();
    bodies();
    first_water();
    if (!is_result_) heads_and_later_water();
    curves();
    shades();
    if (!is_result_) mesh_lines();
    sides();
    footings();
    loads();
    if (!is_result_) named_points();
    slip_planes();
    slip_line();
    arrows();
    gravity();
    legend_top_ = axes();
    title();
    legend();
    const Real height = legend_top_ + legend_height_ + 24.0;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1:.0f}\" width=\"{0}\" "
        "height=\"{1:.0f}\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"13\" "
        "fill=\"{2}\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{3}</svg>\n",
        width, height, ink, out_);
  }

 private:
  std::string cell_path(Index cell) const
  {
    const auto x = model_.mesh->corners(cell);
    return ring({x.begin(), x.end()});
  }

  const std::string& colour_of(Index material) const { return colours_[static_cast<std::size_t>(material)]; }

  void cells()
  {
    std::string path;
    for_each_edge([&](const Side& edge, bool) { path += line(edge); }, true);
    put("<path d=\"{}\" fill=\"none\" stroke=\"#8a94a0\" stroke-width=\"1\"/>", path);
  }

  template <class F>
  void for_each_edge(F&& f, bool outer) const
  {
    for (Index e = 0; e < model_.mesh->n_cells(); ++e)
      for (int s = 0; s < 4; ++s) {
        const Index other = model_.mesh->neighbours[e][s];
        if (other == outside || (!outer && e < other)) f(edge_of(*model_.mesh, {e, s}), other == outside);
      }
  }

  void bodies()
  {
    const auto outlines = outlines_of(model_);
    for (std::size_t b = 0; b < outlines.size(); ++b) {
      const BodyOutline& outline = outlines[b];
      const BodyCase& body = model_.description.bodies[b];
      if (!body.points_file.empty() || !body.is_there) continue;
      const std::string& colour = colour_of(material_number(model_, body.material, Zone::above));
      const std::string& colour_below = colour_of(material_number(model_, body.material, Zone::below));
      std::string path;
      if (outline.cells.empty()) {
        path = ring(outline.polygon);
        for (const Polygon& hole : outline.holes) path += ring(hole);
        put("<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#5b4a33\" stroke-width=\"1.2\"/>", path, colour);
        if (colour_below != colour)  // cut along the phreatic line
          put("<clipPath id=\"below{0}\"><path d=\"{1}\"/></clipPath><path d=\"{2}\" fill=\"{3}\" "
              "fill-rule=\"evenodd\" "
              "clip-path=\"url(#below{0})\"/>",
              b + 1, below_water(), path, colour_below);
      } else {
        for (const Index cell : outline.cells) path += cell_path(cell);
        put("<path d=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"0.5\"/>", path, colour, colour);
      }
    }
    points_of_files();
    for (std::size_t b = 0; b < outlines.size(); ++b)
      if (model_.description.bodies[b].points_file.empty()) coming_or_going(b, outlines[b]);
  }

  /// The outline of a body that a stage places or removes, with its name and what is done.
  void coming_or_going(std::size_t b, const BodyOutline& outline)
  {
    const BodyCase& body = model_.description.bodies[b];
    if (is_result_ || !comes_or_goes(body) || outline.polygon.empty()) return;
    const char* colour = body.placed > 0 ? placed_colour : removed_colour;
    put("<path d=\"{}\" fill=\"{}\" fill-opacity=\"0.12\" stroke=\"{}\" stroke-width=\"1.6\" stroke-dasharray=\"6 "
        "4\"/>",
        ring(outline.polygon), colour, colour);
    Vec<2> mean{0.0, 0.0};
    for (const Vec<2>& x : outline.polygon)
      for (int d = 0; d < 2; ++d) mean[d] += x[d] / static_cast<Real>(outline.polygon.size());
    const auto& stages = model_.description.stages;
    const auto in = [&](const char* what, StageNumber number) {
      return number == 0 || number > stages.size() ? std::string()
                                                   : fmt::format(", {} in {}", what, stages[number - 1].name);
    };
    text(px(mean[0]), py(mean[1]) + 4.0, body.name + in("placed", body.placed) + in("removed", body.removed), "middle",
        fmt::format(
            "font-size=\"12\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"3\" paint-order=\"stroke\"", colour));
  }

  /// Bodies from files of points have no outline: each point is a disc of its volume.
  void points_of_files()
  {
    const auto& all = model_.description.bodies;
    if (std::ranges::none_of(all, [](const BodyCase& body) { return !body.points_file.empty(); })) return;
    const std::int64_t stride = 1 + state_.points.n_points() / most_points;
    std::int64_t k = 0;
    for_each_point(state_.points, [&](const PointBlock<2>& block, Index lane) {
      if (k++ % stride != 0) return;
      put("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"/>", px(block.row(Rows::x)[lane]),
          py(block.row(Rows::x + 1)[lane]), 0.5 * scale_ * std::sqrt(block.row(Rows::volume)[lane]),
          colour_of(block.material));
    });
  }

  void mesh_lines()
  {
    Real area = 0.0;
    for (Index e = 0; e < model_.mesh->n_cells(); ++e) area += model_.mesh->geometry(e).volume;
    const Real cell = scale_ * std::sqrt(area / model_.mesh->n_cells());
    if (cell < smallest_cell || model_.mesh->n_cells() > most_cells) return;
    std::string path;
    for_each_edge([&](const Side& edge, bool) { path += line(edge); }, false);
    put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-opacity=\"0.22\" stroke-width=\"0.6\"/>", path, ink);
  }

  /// A line along the side, marks outside of it as its kind has them, and its words.
  void sides()
  {
    for (const NamedSide& side : model_.mesh->sides) {
      const SideCondition condition = condition_of(model_.description, side.name);
      const SideKindInfo& kind = info_of(condition.kind);
      const SideShape shape = shape_of_side(*model_.mesh, side);
      if (side.is_inside) continue;
      std::string path, marks;
      for (const CellSide& at : side.edges) {
        const Side edge = edge_of(*model_.mesh, at);
        path += line(edge);
        if (kind.marks != SideMarks::none) hatch(edge, kind.marks == SideMarks::circles, marks);
      }
      put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"/>", path,
          kind.colour, width_of(kind));
      if (!marks.empty()) put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>", marks, kind.colour);
      if (!is_result_) label(side, shape, kind.colour, side.name + ": " + describe(condition));
    }
  }

  static Real width_of(const SideKindInfo& kind) { return kind.kind == SideKind::free ? 1.2 : 3.0; }

  /// Slanting ticks or circles outside of an edge; at even distances from the origin along the edge.
  void hatch(const Side& edge, bool circles, std::string& ticks) const
  {
    constexpr Real spacing = 14.0, depth = 8.0;
    const Real ax = px(edge.a[0]), ay = py(edge.a[1]), dx = px(edge.b[0]) - ax, dy = py(edge.b[1]) - ay;
    const Real l = std::hypot(dx, dy);
    if (l == 0.0) return;
    const Real tx = dx / l, ty = dy / l, nx = -ty, ny = tx;  // outward: the cell lies to the left, y runs down
    const Real start = ax * tx + ay * ty;
    for (Real along = std::ceil(start / spacing) * spacing - start; along < l; along += spacing) {
      const Real x = ax + along * tx, y = ay + along * ty;
      if (circles)
        ticks +=
            fmt::format("M{:.1f} {:.1f}m-2.6 0a2.6 2.6 0 1 0 5.2 0a2.6 2.6 0 1 0 -5.2 0", x + 5.0 * nx, y + 5.0 * ny);
      else
        ticks +=
            fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", x, y, x + depth * (nx - 0.7 * tx), y + depth * (ny - 0.7 * ty));
    }
  }

  void label(const NamedSide& side, const SideShape& shape, std::string_view colour, const std::string& words)
  {
    Vec<2> mean{0.0, 0.0};
    for (const CellSide& at : side.edges) {
      const Side e = edge_of(*model_.mesh, at);
      for (int d = 0; d < 2; ++d) mean[d] += 0.5 * (e.a[d] + e.b[d]) / static_cast<Real>(side.edges.size());
    }
    const auto distance = [&](const CellSide& at) {
      const Side e = edge_of(*model_.mesh, at);
      return std::hypot(0.5 * (e.a[0] + e.b[0]) - mean[0], 0.5 * (e.a[1] + e.b[1]) - mean[1]);
    };
    const auto nearest = std::ranges::min_element(side.edges, {}, distance);
    const Side edge = edge_of(*model_.mesh, *nearest);
    const Real n = std::max(std::hypot(shape.normal[0], shape.normal[1]), 1e-12);
    const Real nx = shape.normal[0] / n, ny = -shape.normal[1] / n;  // of the drawing
    const Real away = ny > 0.5 ? 26.0 : 19.0;
    const Real x = px(0.5 * (edge.a[0] + edge.b[0])) + away * nx, y = py(0.5 * (edge.a[1] + edge.b[1])) + away * ny;
    Real angle = std::atan2(nx, -ny) * 180.0 / 3.14159265358979;  // of the side; never upside down
    if (angle >= 89.9) angle -= 180.0;
    if (angle < -90.1) angle += 180.0;
    put("<text x=\"{0:.1f}\" y=\"{1:.1f}\" text-anchor=\"middle\" dominant-baseline=\"middle\" fill=\"{2}\" "
        "stroke=\"#ffffff\" stroke-width=\"4\" paint-order=\"stroke\" transform=\"rotate({3:.1f} {0:.1f} "
        "{1:.1f})\">{4}</text>",
        x, y, colour, angle, escaped_for_markup(words));
  }

  void footings()
  {
    for (const FootingCase& f : model_.description.footings) {
      put("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#4a5560\" fill-opacity=\"0.85\" "
          "stroke=\"{}\"/>",
          px(f.low[0]), py(f.high[1]), scale_ * (f.high[0] - f.low[0]), scale_ * (f.high[1] - f.low[1]), ink);
      const Real x = px(0.5 * (f.low[0] + f.high[0])), y = py(f.high[1]);
      text(x, y - 8.0, f.name, "middle", "font-weight=\"bold\"");
      if (std::hypot(f.velocity[0], f.velocity[1]) > 0.0)
        arrow(x, 0.5 * (y + py(f.low[1])), f.velocity, 34.0, "#ffffff");
    }
  }

  void loads()
  {
    constexpr Real height = 26.0, apart = 16.0;  // [px]
    const Overburden overburden(model_);
    for (std::size_t l = 0; l < model_.description.loads.size(); ++l) {
      const LoadCase& load = model_.description.loads[l];
      const Real a = px(load.from), b = px(load.to);
      const int n = std::max(1, static_cast<int>((b - a) / apart));
      Real ground = low_[1];
      for (int k = 0; k <= n; ++k)
        ground = std::max(ground, overburden.ground(load.from + (load.to - load.from) * k / n).value_or(low_[1]));
      const Real foot = py(ground) - 2.0;
      std::string path = fmt::format("M{:.2f} {:.2f}H{:.2f}", a, foot - height, b);
      for (int k = 0; k <= n; ++k)
        path += fmt::format("M{0:.2f} {1:.2f}v{2:.2f}m-3 -6l3 6l3 -6", a + (b - a) * k / n, foot - height, height);
      put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"/>", path, load_colour);
      const bool has_room = foot - height > py(high_[1]) + 12.0;  // below the name of the upper side; else beside it
      text(has_room ? 0.5 * (a + b) : a - 8.0, has_room ? foot - height - 6.0 : foot - 4.0,
          load.name + ", " + describe_pressures(model_.whole(), l), has_room ? "middle" : "end",
          fmt::format("font-size=\"12\" fill=\"{}\" {}", load_colour, white_edge));
    }
  }

  void named_points()
  {
    for (const auto& [name, place] : model_.description.output.history_points) {
      put("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.6\"/>",
          px(place[0]), py(place[1]), ink);
      text(px(place[0]) + 6.0, py(place[1]) - 5.0, name, "start", fmt::format("font-size=\"12\" {}", white_edge));
    }
  }

  /// Squares of like strength in one path: there are many.
  void shades()
  {
    constexpr int n_levels = 8;
    std::array<std::string, n_levels> paths;
    for (const SectionOverlay::Shade& shade : overlay_.shades) {
      const int level = std::min(static_cast<int>(shade.value * n_levels), n_levels - 1);
      if (level <= 0) continue;
      const Real side = scale_ * shade.size;
      paths[static_cast<std::size_t>(level)] += fmt::format("M{:.1f} {:.1f}h{:.2f}v{:.2f}h{:.2f}z",
          px(shade.x[0]) - 0.5 * side, py(shade.x[1]) - 0.5 * side, side, side, -side);
    }
    for (int level = 1; level < n_levels; ++level)
      if (const std::string& path = paths[static_cast<std::size_t>(level)]; !path.empty())
        put("<path d=\"{}\" fill=\"{}\" fill-opacity=\"{:.2f}\"/>", path, shade_colour,
            static_cast<Real>(level + 1) / n_levels);
  }

  void curves()
  {
    for (const SectionOverlay::Curves& curve : overlay_.curves) {
      std::string path;
      for (const Side& piece : curve.pieces) path += line(piece);
      put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1\"/>", path, curve.colour);
    }
  }

  void slip_line()
  {
    if (overlay_.line.empty()) return;
    put("<path d=\"{0}\" fill=\"none\" stroke=\"#ffffff\" stroke-width=\"5\" stroke-linejoin=\"round\"/><path "
        "d=\"{0}\" fill=\"none\" stroke=\"{1}\" stroke-width=\"2.4\" stroke-linejoin=\"round\"/>",
        open_path(overlay_.line), line_colour);
  }

  void slip_planes()
  {
    std::size_t k = 0;
    for (const SlipPlaneCase& plane : model_.description.slip_planes)
      put("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2.2\" stroke-dasharray=\"9 5\"/>",
          open_path(plane.line), plane_colours[k++ % std::size(plane_colours)]);
  }

  void arrows()
  {
    for (const SectionOverlay::Arrow& a : overlay_.arrows) {
      const Real x = px(a.from[0]), y = py(a.from[1]), dx = scale_ * a.along[0], dy = -scale_ * a.along[1];
      put("<path d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}m{:.1f} {:.1f}l{:.1f} {:.1f}l{:.1f} {:.1f}\" fill=\"none\" "
          "stroke=\"{}\" stroke-width=\"1.3\" stroke-linejoin=\"round\"/>",
          x, y, dx, dy, -0.3 * dx + 0.18 * dy, -0.3 * dy - 0.18 * dx, 0.3 * dx - 0.18 * dy, 0.3 * dy + 0.18 * dx,
          -0.3 * dx - 0.18 * dy, -0.3 * dy + 0.18 * dx, ink);
    }
  }

  void gravity()
  {
    const Real g = std::hypot(model_.gravity[0], model_.gravity[1]);
    if (g == 0.0) return text(width - 28.0, 40.0, "no gravity", "end");
    arrow(width - 60.0, 24.0, model_.gravity, 36.0, ink);
    text(width - 76.0, 46.0, fmt::format("g = {:.4g} m/s²", g), "end");
  }

  void title()
  {
    const Case& c = model_.description;
    text(28.0, 34.0, c.title.empty() ? c.name : c.title, "start", "font-size=\"18\" font-weight=\"bold\"");
    text(28.0, 56.0,
        is_result_ ? overlay_.subtitle
                   : fmt::format("{}, {} cells, {} material points, before the first step", c.scheme,
                         model_.mesh->n_cells(), state_.points.n_points()),
        "start", "fill=\"#5c6670\"");
  }

  void legend()
  {
    Real x = 28.0, y = legend_top_ + 14.0;
    const auto entry = [&](const std::string& swatch, const std::string& words) {
      const Real wide = 52.0 + 7.9 * static_cast<Real>(words.size());
      if (x > 28.0 && x + wide > width - 28.0) x = 28.0, y += 24.0;
      put("<g transform=\"translate({:.1f} {:.1f})\">{}</g>", x, y, swatch);
      text(x + 32.0, y + 4.5, words);
      x += wide;
    };
    for (std::size_t m = 0; m < model_.materials.size(); ++m) {
      const SoilMaterial& soil = model_.materials[m];
      entry(fmt::format("<rect x=\"0\" y=\"-7\" width=\"24\" height=\"14\" fill=\"{}\" stroke=\"#5b4a33\"/>",
                colour_of(static_cast<Index>(m))),
          fmt::format("{}: {}, {:.4g} kg/m³ = {:.4g} kN/m³", soil.name, soil.type->name, soil.density,
              soil.density * weight_of_a_mass));
    }
    water_legend(!is_result_, entry);
    for (const SectionOverlay::Curves& curve : overlay_.curves)
      entry(fmt::format("<path d=\"M0 0H24\" stroke=\"{}\"/>", curve.colour), curve.words);
    if (!overlay_.line.empty())
      entry(fmt::format("<path d=\"M0 0H24\" stroke=\"{}\" stroke-width=\"2.4\"/>", line_colour), overlay_.of_line);
    std::size_t k = 0;
    for (const SlipPlaneCase& plane : model_.description.slip_planes)
      entry(fmt::format("<path d=\"M0 0H24\" stroke=\"{}\" stroke-width=\"2.2\" stroke-dasharray=\"9 5\"/>",
                plane_colours[k++ % std::size(plane_colours)]),
          words_of(plane));
    if (!overlay_.shades.empty())
      entry(fmt::format("<rect x=\"0\" y=\"-7\" width=\"24\" height=\"14\" fill=\"{}\"/>", shade_colour),
          overlay_.of_shades);
    if (!overlay_.arrows.empty())
      entry(fmt::format("<path d=\"M0 0H24m-7 -4l7 4l-7 4\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.3\"/>", ink),
          overlay_.of_arrows);
    std::vector<std::string_view> shown;
    for (const SideKindInfo& kind : side_kinds()) {
      const auto has_it = [&](const SideCondition& side) { return side.kind == kind.kind; };
      const bool used = kind.kind == SideKind::free || std::ranges::any_of(model_.description.sides, has_it);
      if (!used || std::ranges::find(shown, kind.legend) != shown.end()) continue;
      entry(fmt::format("<path d=\"M0 0H24\" stroke=\"{}\" stroke-width=\"{}\"/>", kind.colour, width_of(kind)),
          std::string(kind.legend));
      shown.push_back(kind.legend);
    }
    legend_height_ = y - legend_top_;
  }

  const State& state_;
  const SectionOverlay& overlay_;
  const bool is_result_;                         // the overlay is of one
  const std::vector<std::string> colours_;       ///< of the materials
  Real legend_top_ = 0.0, legend_height_ = 0.0;  ///< [px]
};

}  // namespace

std::string draw_section(const Model& model, const State& state, const SectionOverlay& overlay)
{
  SectionOverlay::Curves walls{.colour = std::string(ink), .words = "wall that lets no water through"};
  for (const WallCase& wall : model.description.water.walls)
    for (std::size_t k = 0; k + 1 < wall.line.size(); ++k) walls.pieces.push_back({wall.line[k], wall.line[k + 1]});
  if (walls.pieces.empty()) return SectionDrawing(model, state, overlay).draw();
  SectionOverlay with_walls = overlay;
  with_walls.curves.push_back(std::move(walls));
  return SectionDrawing(model, state, with_walls).draw();
}

}  // namespace terp
