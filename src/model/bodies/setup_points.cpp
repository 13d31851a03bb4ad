// The number of a point is its place in what make_points gives: by the stage that places its body, drawn bodies first,
// then files. It is the same in each stage: others make the points again to know whose body a point is of (seeds_of).
// Bodies cut each other out only if one stage places them: what comes later must find room (placed_bodies). Points come
// in batches, which are freed one by one while blocks are filled: a large case never holds all of them twice.

#include "model/bodies/setup_points.hpp"

#include "math/errors.hpp"
#include "mpm/features/overlap.hpp"
#include "mpm/mesh/box_grid.hpp"
#include "mpm/mesh/locate.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/bodies/points_csv.hpp"
#include "model/bodies/points_of_files.hpp"
#include "model/water/water_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace terp {
namespace {

const std::vector<std::string> mesh_extent = {"mesh.origin", "mesh.size", "mesh.sides", "mesh.file", "mesh.polygon"};

const char* const grid_cuts_corners =
    "\nThe grid follows mesh.sides only at its nodes: it cuts off a corner between two of them. Use more cells, so "
    "that a node\n"
    "comes to lie at the corner, or draw the body along the grid.";

/// Number of the material of a soil at a place at t = 0.
Index material_at(const StageSoil& soil, const std::string& name, Vec<2> x)
{
  const auto& phreatic_line = soil.description.water.start.phreatic_line;
  const Zone zone = phreatic_line.empty()                      ? Zone::all
                    : x[1] < elevation_at(phreatic_line, x[0]) ? Zone::below
                                                               : Zone::above;
  return material_number(soil, name, zone);
}

constexpr std::size_t batch_size = 1 << 17;  // points of 10 MB

void add_point(const NewPoint& point, PointBatches& points)
{
  if (points.empty() || points.back().size() == batch_size) points.emplace_back().reserve(batch_size);
  points.back().push_back(point);
}

std::string body_key(std::size_t body, std::string_view key) { return fmt::format("body[{}].{}", body, key); }

const std::vector<Index>& cells_of_region(const Mesh<2>& mesh, const std::string& name, std::size_t body)
{
  std::string known;
  for (const NamedRegion& region : mesh.regions) {
    if (region.name == name) return region.cells;
    known += (known.empty() ? "" : ", ") + region.name;
  }
  throw InputError(Problem{body_key(body, "region"), "the mesh has no region `" + name + "`",
      known.empty() ? "No surface of this mesh has a name. In gmsh: `Physical Surface(\"" + name +
                          "\") = {1};`, then save. "
                          "Files .bdf, .nas and .vtk carry no names of groups: save the mesh as .msh or .unv."
                    : "Regions of this mesh: " + known,
      "body", false, {"mesh.file"}});
}

BodyOutline outline_of(const Case& c, const Mesh<2>& mesh, std::size_t b)
{
  const BodyCase& body = c.bodies[b];
  BodyOutline outline{
      .polygon = body.polygon, .points_per_cell = body.points_per_cell, .holes = body.holes, .cells = {}};
  if (!body.region.empty()) outline.cells = cells_of_region(mesh, body.region, b);
  return outline;
}

void check_outlines(const StageSoil& soil, const std::vector<BodyOutline>& outlines)
{
  for (std::size_t b = 0; b < outlines.size(); ++b) {
    const BodyOutline& outline = outlines[b];
    if (!soil.description.bodies[b].points_file.empty() || !outline.cells.empty()) continue;
    for (const std::string& text : check_outline(outline))
      throw InputError(Problem{
          body_key(b, "polygon"), "the outline of the body is not usable", text, "body", false, keys_of_outline(b)});
    for (const Vec<2>& x : outline.polygon) {
      if (locate(*soil.mesh, x, 0).inside) continue;
      const auto [low, high] = box_around(soil.mesh->nodes);
      throw InputError(Problem{fmt::format("body[{}]", b), "the body lies outside the mesh",
          fmt::format("corner {} m lies in no cell; the mesh spans x = {} to {} m, y = {} to {} m.\nEnlarge the mesh "
                      "or move the body.{}",
              place_text(x), coordinate_text(low[0]), coordinate_text(high[0]), coordinate_text(low[1]),
              coordinate_text(high[1]), soil.description.mesh.kind == MeshKind::mapped ? grid_cuts_corners : ""),
          "mesh", false, keys_of_outline(b)});
    }
  }
}

/// A formula may give no number at some place.
Vec<2> finite_velocity(const BodyCase& body, std::size_t b, Vec<2> x)
{
  const Vec<2> v = velocity_of(body, x);
  if (body.velocity_at && !std::isfinite(v[0] + v[1]))
    throw InputError(Problem{body_key(b, "velocity"), "the velocity is not a finite number everywhere in the body",
        fmt::format("It is [{}, {}] m/s at {} m.", v[0], v[1], place_text(x)), "body.velocity"});
  return v;
}

Index material_of_point(const StageSoil& soil, const std::string& path, const CsvPoint& p)
{
  std::string known;
  for (const MaterialCase& material : soil.description.materials) {
    if (material.called() == p.material) return material_at(soil, p.material, p.x);
    if (material.zone != Zone::above) known += (known.empty() ? "" : ", ") + material.called();
  }
  throw CsvError(fmt::format("{}:{}: no material `{}`. Materials of this case: {}", path, p.line, p.material, known));
}

/// Points of one file, each found in the mesh. Throws CsvError.
void add_points_of_file(const StageSoil& soil, std::size_t b, PointBatches& points)
{
  const BodyCase& body = soil.description.bodies[b];
  Index guess = 0;
  const std::string path = path_of(soil.description.folder, body.points_file);
  for (const CsvPoint& p : read_points_csv(path)) {
    const Location at = locate(*soil.mesh, p.x, guess);
    if (!at.inside)
      throw InputError(Problem{body_key(b, "points"), "a point lies outside the mesh",
          fmt::format("{}:{}: {} m lies in no cell.", path, p.line, place_text(p.x)), "body", false, mesh_extent});
    add_point({p.x, at.local, finite_velocity(body, b, p.x), p.volume, {at.cell, material_of_point(soil, path, p)},
                  static_cast<Index>(b)},
        points);
    guess = at.cell;
  }
}

void try_points_of_file(const StageSoil& soil, std::size_t b, PointBatches& points)
{
  try {
    add_points_of_file(soil, b, points);
  } catch (const FileError& error) {
    throw InputError(Problem{body_key(b, "points"), "the file of points cannot be used", error.what(), "body"});
  }
}

Real fullest_cell(const Mesh<2>& mesh, const PointBatches& points, std::size_t body)
{
  std::vector<Real> volume(mesh.cells.size(), 0.0);
  for (const auto& batch : points)
    for (const NewPoint& p : batch)
      if (static_cast<std::size_t>(p.body) == body) volume[p.key.cell] += p.volume;
  Real fullest = 0.0;
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    fullest = std::max(fullest, volume[cell] / mesh.geometry(cell).volume);
  return fullest;
}

/// Makes blocks of the right size before they are filled: no growth, no waste.
void expect_points(std::vector<BlockKey> keys, StepState& state)
{
  std::ranges::sort(keys);
  for (std::size_t k = 0, end = 0; k < keys.size(); k = end) {
    while (end < keys.size() && keys[end] == keys[k]) ++end;
    state.points.expect(keys[k], static_cast<Index>(end - k));
  }
}

/// values: what all points begin with, shape [n_rows].
void add_to_state(const Model& model, const NewPoint& p, std::size_t id, std::vector<Real>& values, StepState& state)
{
  for (int d = 0; d < 2; ++d) {
    values[Rows::x + d] = p.x[d];
    values[Rows::xi + d] = p.local[d];
    values[Rows::v + d] = p.v[d];
  }
  values[Rows::mass] = p.volume * model.materials[p.key.material].density;
  values[Rows::volume] = p.volume;
  for (const RowInfo& row : model.rows.added())
    if (!row.initials.empty()) values[row.first] = row.initial_in(p.key.material);
  if (model.with.overlap) values[model.with.overlap->inverse_extent] = 1.0 / std::sqrt(p.volume);
  values[Rows::id] = static_cast<Real>(id);
  state.points.add(p.key, values);
}

}  // namespace

std::vector<std::string> keys_of_outline(std::size_t body)
{
  std::vector<std::string> keys{body_key(body, "box"), body_key(body, "polygon"), body_key(body, "holes")};
  keys.insert(keys.end(), mesh_extent.begin(), mesh_extent.end());
  return keys;
}

Index material_number(const StageSoil& soil, const std::string& name, Zone zone)
{
  for (std::size_t k = 0; k < soil.materials.size(); ++k) {
    const MaterialCase& m = soil.description.materials[k];
    if (m.called() == name && (m.zone == zone || m.zone == Zone::all || zone == Zone::all))
      return static_cast<Index>(k);
  }
  throw InputError(Problem{"material", "no material `" + name + "`", "", "body"});
}

Seeds seeds_of(const PointBatches& points)
{
  Seeds seeds;
  for (const auto& batch : points)
    for (const NewPoint& p : batch) {
      seeds.bodies.push_back(p.body);
      seeds.places.insert(seeds.places.end(), p.x.begin(), p.x.end());
    }
  return seeds;
}

std::vector<BodyShare> shares_of_bodies(const Model& model, const PointBatches& points)
{
  std::vector<BodyShare> shares(model.description.bodies.size());
  std::vector<std::vector<bool>> has(shares.size(), std::vector<bool>(model.materials.size(), false));
  const auto enter = [&](const NewPoint& p) {
    BodyShare& share = shares[p.body];
    ++share.n_points;
    share.area += p.volume;
    share.mass += p.volume * model.materials[p.key.material].density;
    has[p.body][p.key.material] = true;
  };
  for (const auto& batch : points) std::ranges::for_each(batch, enter);
  for (std::size_t b = 0; b < shares.size(); ++b) {
    for (std::size_t m = 0; m < model.materials.size(); ++m)
      if (has[b][m]) shares[b].material += (shares[b].material.empty() ? "" : " + ") + model.materials[m].name;
    if (shares[b].n_points == 0) shares[b].material = model.description.bodies[b].material;
    if (!model.description.bodies[b].points_file.empty()) shares[b].fullest_cell = fullest_cell(*model.mesh, points, b);
  }
  return shares;
}

std::vector<BodyOutline> outlines_of(const Case& c, const Mesh<2>& mesh)
{
  std::vector<BodyOutline> outlines;
  for (std::size_t b = 0; b < c.bodies.size(); ++b) outlines.push_back(outline_of(c, mesh, b));
  return outlines;
}

PointBatches make_points(const StageSoil& soil)
{
  const std::vector<BodyCase>& bodies = soil.description.bodies;
  const auto outlines = outlines_of(soil);
  check_outlines(soil, outlines);
  std::set<StageNumber> stages;
  for (const BodyCase& body : bodies) stages.insert(body.placed);

  PointBatches points;
  for (const StageNumber stage : stages) {  // bodies cut each other out where they are drawn together alone
    std::vector<BodyOutline> together(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (bodies[b].placed == stage) together[b] = outlines[b];
    for (const Seed& seed : seed_points(*soil.mesh, together)) {
      const auto b = static_cast<std::size_t>(seed.body);
      add_point({seed.x, seed.local, finite_velocity(bodies[b], b, seed.x), seed.volume,
                    {seed.cell, material_at(soil, bodies[b].material, seed.x)}, seed.body},
          points);
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (!bodies[b].points_file.empty() && bodies[b].placed == stage) try_points_of_file(soil, b, points);
  }
  if (points.empty())
    throw InputError(Problem{"body[0]", "no material points",
        "The bodies hold no point of the seeding lattice. Use a larger body, smaller cells or more points per cell.",
        "body", false, {"body", "mesh"}});
  check_points_of_files(soil, outlines, points);
  return points;
}

void add_points(
    const Model& model, PointBatches points, const std::function<bool(const BodyCase&)>& wanted, StepState& state)
{
  std::vector<Real> values(static_cast<std::size_t>(model.rows.n_rows()));
  for (const RowInfo& row : model.rows.entries()) std::fill_n(values.begin() + row.first, row.n, row.initial);
  std::vector<bool> is_wanted;
  for (const BodyCase& body : model.description.bodies) is_wanted.push_back(wanted(body));
  std::size_t id = 0;
  for (auto& batch : points) {
    std::vector<BlockKey> keys;
    for (const NewPoint& p : batch)
      if (is_wanted[static_cast<std::size_t>(p.body)]) keys.push_back(p.key);
    expect_points(std::move(keys), state);
    for (const NewPoint& p : batch) {
      if (is_wanted[static_cast<std::size_t>(p.body)]) add_to_state(model, p, id, values, state);
      ++id;
    }
    PointBatches::value_type().swap(batch);
  }
}

}  // namespace terp
