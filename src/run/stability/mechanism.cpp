// The largest motion of all is that of the judged soil, and no point counts with more. The shape is that of all soil:
// columns in which the largest motion is a tenth of it take part. Above the slip surface points move by
// at least half of the largest in the column, below it by less. The stretch of columns that moves most is the
// mechanism; it ends where the soil moves the other way.
#include "run/stability/mechanism.hpp"

#include "run/report/frame.hpp"
#include "run/stability/border_under_slip.hpp"
#include "run/report/frame_fields.hpp"
#include "model/ground/ground_section.hpp"
#include "model/parts/reduce.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr Real share_of_column = 0.5;  // of the largest motion in a column: above the slip surface
constexpr Real share_of_all = 0.1;     // of the largest motion: columns that take part
constexpr Real fast = 0.99;            // part of the points that move less than "the largest"; single points ravel
constexpr Real of_crest = 0.05;        // of the relief: what lies within this of the highest surface is highest

struct MovingPoint {
  Vec<2> x{0.0, 0.0};   // at rest [m]
  Vec<2> dx{0.0, 0.0};  // in the last window [m]
  Real size = 0.0;      // of dx, at most the largest [m]
  Real volume = 0.0;    // [m^2]
  Index material = 0;
  bool counts = true;  // for the largest motion of all, which judges
};

struct Column {
  std::vector<MovingPoint> points;  // from the highest down
  Real largest = 0.0;               // [m]
  Real slip = 0.0;                  // elevation of the slip surface [m]
  std::size_t n_above = 0;          // points above it
  Real area = 0.0, motion = 0.0;    // of them: volume [m^2], sum of volume times motion along x [m^3]
};

Real largest_motion(const std::vector<MovingPoint>& points)
{
  std::vector<Real> sizes;
  for (const MovingPoint& p : points)
    if (p.counts) sizes.push_back(p.size);
  if (sizes.empty()) return 0.0;
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(fast * static_cast<Real>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

std::vector<MovingPoint> ground_points(
    const Model& model, const State& state, const PointMotion& before, const PointMotion& now, const Judged& judged)
{
  const auto ground = ground_of(model);
  std::vector<MovingPoint> points;
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    if (!is_ground(ground, block)) return;
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    MovingPoint p{.volume = block.row(Rows::volume)[lane],
        .material = block.material,
        .counts = judged.empty() || judged[id] != 0};
    for (std::size_t d = 0; d < 2; ++d) {
      p.x[d] = state.x_initial[2 * id + d];
      p.dx[d] = now.x[2 * id + d] - before.x[2 * id + d];
    }
    p.size = std::hypot(p.dx[0], p.dx[1]);
    points.push_back(p);
  });
  return points;
}

std::vector<Column> sort_into_columns(const std::vector<MovingPoint>& points, const Columns& columns)
{
  std::vector<Column> sorted(static_cast<std::size_t>(columns.n));
  for (const MovingPoint& p : points)
    if (const Real k = (p.x[0] - columns.left) / columns.width; k >= 0.0 && k < columns.n)
      sorted[static_cast<std::size_t>(k)].points.push_back(p);
  for (Column& column : sorted) {
    std::ranges::sort(column.points, std::ranges::greater{}, [](const MovingPoint& p) { return p.x[1]; });
    for (const MovingPoint& p : column.points) column.largest = std::max(column.largest, p.size);
  }
  return sorted;
}

/// At the level at which the fewest points lie on the wrong side.
void find_slip(Column& column)
{
  const auto moves = [half = share_of_column * column.largest](const MovingPoint& p) { return p.size >= half; };
  const auto& points = column.points;
  std::ptrdiff_t wrong = std::ranges::count_if(points, moves), fewest = wrong;  // all below
  std::size_t first = 0, last = 0;  // of the numbers of points above with which it is so
  for (std::size_t k = 0; k < points.size(); ++k) {
    wrong += moves(points[k]) ? -1 : 1;
    if (wrong < fewest) fewest = wrong, first = k + 1;
    if (wrong == fewest) last = k + 1;
  }
  column.n_above = (first + last + 1) / 2;
  if (column.n_above == 0) return;
  const Real above = points[column.n_above - 1].x[1];
  column.slip = column.n_above < points.size() ? 0.5 * (above + points[column.n_above].x[1]) : above;
  for (std::size_t k = 0; k < column.n_above; ++k) {
    column.area += points[k].volume;
    column.motion += points[k].volume * points[k].dx[0];
  }
}

bool takes_part(const Column& column, Real least) { return column.largest >= least && column.area > 0.0; }

/// Columns first ... last - 1.
struct Stretch {
  std::size_t first = 0, last = 0;
};

/// The stretch of neighbouring columns of one sign of motion that moves most.
Stretch largest_stretch(const std::vector<Column>& columns, Real least)
{
  Stretch best;
  Real most = 0.0;
  for (std::size_t k = 0; k < columns.size();) {
    if (!takes_part(columns[k], least)) {
      ++k;
      continue;
    }
    Stretch now{k, k};
    Real motion = 0.0;
    const bool right = columns[k].motion > 0.0;
    for (; k < columns.size() && takes_part(columns[k], least) && (columns[k].motion > 0.0) == right; ++k)
      motion += std::abs(columns[k].motion);
    now.last = k;
    if (motion > most) best = now, most = motion;
  }
  return best;
}

Real middle_of_highest(const Section& section)
{
  const Real top = *std::ranges::max_element(section.heights) - of_crest * relief(section);
  Real sum = 0.0, n = 0.0;
  for (Index k = 0; k < section.columns.n; ++k)
    if (section.heights[k] >= top) sum += section.columns.left + (k + 0.5) * section.columns.width, n += 1.0;
  return sum / n;
}

/// Share of the motion that is not of this sign.
Real share_of_other_way(const std::vector<Column>& columns, Real least, bool right)
{
  Real all = 0.0, other = 0.0;
  for (const Column& column : columns) {
    if (!takes_part(column, least)) continue;
    all += std::abs(column.motion);
    if ((column.motion > 0.0) != right) other += std::abs(column.motion);
  }
  return other / all;
}

/// The name of the soil without cohesion that most of what moves is of; empty: other soil.
std::string sand_of(const Case& c, const std::vector<Column>& columns, Stretch stretch, Real area)
{
  std::vector<Real> areas(c.materials.size(), 0.0);
  for (std::size_t k = stretch.first; k < stretch.last; ++k)
    for (std::size_t i = 0; i < columns[k].n_above; ++i)
      areas[static_cast<std::size_t>(columns[k].points[i].material)] += columns[k].points[i].volume;
  const auto most = static_cast<std::size_t>(std::ranges::max_element(areas) - areas.begin());
  return areas[most] > 0.5 * area && is_sand(c.materials[most]) ? c.materials[most].name : "";
}

MovingSoil describe(const Section& section, const std::vector<Column>& columns, Stretch stretch, Real least)
{
  const Columns& c = section.columns;
  const auto edge = [&](std::size_t k) { return c.left + static_cast<Real>(k) * c.width; };
  const auto ground = [&](std::size_t k) { return section.heights[k]; };
  const auto cut = [&](std::size_t in, std::size_t out) {  // of the ground between two columns; out: it may have none
    const bool has_soil = out < columns.size() && std::isfinite(ground(out));
    return has_soil ? 0.5 * (ground(in) + ground(out)) : columns[in].slip;
  };
  MovingSoil moving;
  Real motion = 0.0;
  moving.line.push_back({edge(stretch.first), cut(stretch.first, stretch.first - 1)});  // -1 is no column
  for (std::size_t k = stretch.first; k < stretch.last; ++k) {
    moving.line.push_back({edge(k) + 0.5 * c.width, columns[k].slip});
    moving.depth = std::max(moving.depth, ground(k) - columns[k].slip);
    moving.area += columns[k].area;
    motion += columns[k].motion;
  }
  moving.line.push_back({edge(stretch.last), cut(stretch.last - 1, stretch.last)});
  const bool right = motion > 0.0;
  moving.way = right ? Facing::right : Facing::left;
  moving.entry = right ? moving.line.front() : moving.line.back();
  moving.exit = right ? moving.line.back() : moving.line.front();
  moving.highest_x = middle_of_highest(section);
  moving.slope = moving.exit[0] >= moving.highest_x ? Facing::right : Facing::left;
  moving.other_way = share_of_other_way(columns, least, right);
  return moving;
}

std::optional<MovingSoil> find_moving(
    const Model& model, const State& state, const PointMotion& before, const PointMotion& now, const Judged& judged)
{
  std::vector<MovingPoint> points = ground_points(model, state, before, now, judged);
  if (points.empty()) return std::nullopt;
  const Real largest = largest_motion(points), least = share_of_all * largest;
  if (!(largest > 0.0)) return std::nullopt;
  for (MovingPoint& p : points) p.size = std::min(p.size, largest);
  const Section section = first_section(model, state.points, ground_of(model));
  std::vector<Column> columns = sort_into_columns(points, section.columns);
  for (Column& column : columns)
    if (column.largest >= least) find_slip(column);
  const Stretch stretch = largest_stretch(columns, least);
  if (stretch.first == stretch.last) return std::nullopt;
  MovingSoil moving = describe(section, columns, stretch, least);
  moving.border = find_border_under(model, state, moving.line);
  moving.sand = sand_of(model.description, columns, stretch, moving.area);
  return moving;
}

/// A field of the frame by its name; nullptr: there is none.
PointField* find_field(Frame& frame, std::string_view name)
{
  const auto found = std::ranges::find(frame.fields, name, &PointField::name);
  return found == frame.fields.end() ? nullptr : &*found;
}

Frame make_mechanism_frame(
    const Model& model, const State& state, const PointMotion& before, const PointMotion& now, Real stiffening)
{
  constexpr std::string_view kept[] = {"displacement", "stress", "material", "cell", "pore_pressure"};
  Frame frame = make_frame(model, state);
  std::erase_if(frame.fields, [&](const PointField& f) { return std::ranges::find(kept, f.name) == std::end(kept); });
  frame.x = state.x_initial;
  const auto n = static_cast<std::size_t>(state.n_ids());
  PointField moved{"displacement_increment", "m", 3, std::vector<Real>(3 * n, 0.0)},
      sheared{"shear_increment", "-", 1, std::vector<Real>(n, 0.0)};
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t d = 0; d < 2; ++d) moved.values[3 * k + d] = stiffening * (now.x[2 * k + d] - before.x[2 * k + d]);
    std::array<Real, 4> strain;
    for (std::size_t c = 0; c < 4; ++c) strain[c] = stiffening * (now.strain[4 * k + c] - before.strain[4 * k + c]);
    sheared.values[k] = deviatoric_strain(strain);
  }
  if (PointField* displacement = find_field(frame, "displacement"))
    for (Real& value : displacement->values) value *= stiffening;
  frame.fields.push_back(std::move(moved));
  frame.fields.push_back(std::move(sheared));
  frame.time *= std::sqrt(stiffening);
  return frame;
}

}  // namespace

PointMotion look_at_points(const State& state)
{
  const auto n = static_cast<std::size_t>(state.n_ids());
  PointMotion motion{std::vector<Real>(2 * n, 0.0), std::vector<Real>(4 * n, 0.0)};
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    for (int d = 0; d < 2; ++d) motion.x[2 * id + static_cast<std::size_t>(d)] = block.row(Rows::x + d)[lane];
    for (int k = 0; k < 4; ++k) motion.strain[4 * id + static_cast<std::size_t>(k)] = block.row(Rows::strain + k)[lane];
  });
  return motion;
}

Mechanism find_mechanism(const Model& model, const State& state, const PointMotion& before, const PointMotion& now,
    const Judged& judged, Real stiffening)
{
  return {.factor = 0.0,
      .stiffening = stiffening,
      .moving = find_moving(model, state, before, now, judged),
      .frame = make_mechanism_frame(model, state, before, now, stiffening)};
}

}  // namespace terp
