// The keys of the case file, but for those of materials (material_keys.cpp). A new key is one entry here and one member
// in model/case/case.hpp.

#include "io/case/key_table.hpp"

#include "io/case/key_text.hpp"
#include "io/case/units.hpp"
#include "io/case/values.hpp"
#include "mpm/features/side_table.hpp"
#include "io/case/side_kinds.hpp"
#include "mpm/schemes/scheme.hpp"

#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

using Words = std::vector<std::string>;

Words scheme_words()
{
  Words words;
  for (const Scheme* scheme : all_schemes()) words.emplace_back(scheme->name);
  return words;
}
// In the order of the enums in case.hpp.
Words footing_words() { return {"rough", "smooth"}; }

Words side_words() { return side_kind_words(""); }
Words contact_words() { return side_kind_words("contact"); }

/// Four numbers xx yy zz xy.
OwnForm stress_field(std::optional<std::array<Real, 4>>& stress)
{
  static constexpr const char* form = "a list of four numbers: xx, yy, zz, xy";
  const auto read = [&stress](const Entry& entry, Findings& findings) {
    const auto refuse = [&](const std::string& what) {
      findings.problems.push_back(
          {entry.path, what, fmt::format("Allowed: {} in Pa, or with their unit.", form), topic_of(entry.key.path)});
      return false;
    };
    if (entry.node.kind != NodeKind::list || entry.node.items.size() != 4)
      return refuse(fmt::format("`stress` cannot be {}", describe_value(entry.node)));
    std::array<Real, 4> values{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::optional<Real> value = number_of(entry.node.items[k], "Pa");
      if (!value || !std::isfinite(*value))
        return refuse(fmt::format("`stress` cannot have {}", describe_value(entry.node.items[k])));
      values[k] = *value;
    }
    stress = values;
    return true;
  };
  const auto text = [&stress] {
    return stress ? fmt::format("[{}, {}, {}, {}]", (*stress)[0], (*stress)[1], (*stress)[2], (*stress)[3]) : "";
  };
  return {form, read, text};
}

std::vector<KeyInfo> frame_keys()
{
  return {
      {.path = "title", .field = [](Case& c, std::size_t) { return &c.title; }, .meaning = "one line for reports"},
      {.path = "scheme",
          .field = [](Case& c, std::size_t) { return &c.scheme; },
          .words = scheme_words,
          .meaning = "how the soil is integrated; see `terp list`"},
      {.path = "at_strength",
          .field = [](Case& c, std::size_t) { return &c.at_strength; },
          .range = positive,
          .usual = {0.1, 10.0},
          .in_stage = true,
          .meaning = "all strengths of soil and contact planes are divided by this (docs/stability.md); `terp run "
                     "--at-strength` sets it"},
  };
}

constexpr Range cell_sizes = between(1e-3, 1e2);  // usual ones [m]

std::vector<KeyInfo> rectangle_keys()
{
  return {
      {.path = "mesh.origin",
          .field = [](Case& c, std::size_t) { return &c.mesh.origin; },
          .unit = "m",
          .meaning = "lower left corner of a rectangle"},
      {.path = "mesh.size",
          .field = [](Case& c, std::size_t) { return &c.mesh.size; },
          .unit = "m",
          .range = positive,
          .usual = {1e-2, 1e4},
          .required_for = "a rectangle, graded or not",
          .meaning = "width and height of a rectangle"},
      {.path = "mesh.cell",
          .field = [](Case& c, std::size_t) { return NumberOrPair{&c.mesh.cell}; },
          .unit = "m",
          .range = positive,
          .usual = cell_sizes,
          .required_for = "a rectangle of equal cells or a polygon",
          .meaning = "width and height of a cell, one number for both; with polygon: the size to aim at, one number"},
      {.path = "mesh.cells",
          .field = [](Case& c, std::size_t) { return CountOrPair{&c.mesh.cells}; },
          .range = between(1, 100000),
          .required_for = "a graded rectangle or a grid between four sides",
          .meaning = "number of cells along x and along y, or along bottom and along left; one number for both"},
      {.path = "mesh.grading",
          .field = [](Case& c, std::size_t) { return &c.mesh.grading; },
          .range = positive,
          .usual = {0.01, 100.0},
          .meaning = "size of the last cell over the size of the first, along x and along y; 1: all equal",
          .equation = "h_k = h_1 grading^((k - 1) / (n - 1)), k = 1 to n"},
  };
}

std::vector<KeyInfo> mesh_shape_keys()
{
  return {
      {.path = "mesh.file",
          .field = [](Case& c, std::size_t) { return &c.mesh.file; },
          .required_for = "a mesh from a file",
          .meaning = "mesh of quadrilaterals (MSH 4.1, or what gmsh converts to it), relative to the case file; its "
                     "physical groups name "
                     "sides and regions"},
      {.path = "mesh.polygon",
          .field =
              [](Case& c, std::size_t) {
                return PolygonField{&c.mesh.polygon, true};
              },
          .unit = "m",
          .required_for = "a mesh from a polygon",
          .meaning = "corners of the domain in order, without repeating the first; gmsh fills it with quadrilaterals"},
      {.path = "mesh.edges",
          .field = [](Case& c, std::size_t) { return EdgesList{&c.mesh.edges}; },
          .range = not_negative,
          .meaning = "names of parts of the boundary and their edges; edge k of the polygon runs from its corner k to "
                     "corner k + 1, counted from 0"},
      {.path = "mesh.follow_bodies",
          .field = [](Case& c, std::size_t) { return &c.mesh.follow_bodies; },
          .meaning = "whether the cells of a polygon follow the outlines of the bodies"},
      {.path = "mesh.variant",
          .field = [](Case& c, std::size_t) { return &c.mesh.variant; },
          .range = not_negative,
          .meaning =
              "another mesh of the same size and shape: to see how much a result depends on the mesh; for a polygon, "
              "0 is the best mesh, 1, 2, ... are others"},
  };
}

KeyInfo side_line_key(const std::string& side, std::size_t number, const std::string& course)
{
  return {.path = "mesh.sides." + side,
      .field = [number](Case& c, std::size_t) { return Polyline{&c.mesh.sides[number]}; },
      .unit = "m",
      .required = true,
      .meaning = "line from the " + course + " corner of the grid"};
}

std::vector<KeyInfo> side_line_keys()
{
  return {side_line_key("bottom", 0, "lower left to the lower right"),
      side_line_key("right", 1, "lower right to the upper right"),
      side_line_key("top", 2, "upper left to the upper right"),
      side_line_key("left", 3, "lower left to the upper left")};
}

std::vector<KeyInfo> refine_keys()
{
  return {
      {.path = "mesh.refine[].line",
          .field = [](Case& c, std::size_t i) { return Polyline{&c.mesh.refine[i].line}; },
          .unit = "m",
          .meaning = "line along which the cells are smaller; either this or box"},
      {.path = "mesh.refine[].box",
          .field =
              [](Case& c, std::size_t i) {
                return BoxCorners{&c.mesh.refine[i].low, &c.mesh.refine[i].high};
              },
          .unit = "m",
          .meaning = "lower left and upper right corner of the place with smaller cells; either this or line"},
      {.path = "mesh.refine[].cell",
          .field = [](Case& c, std::size_t i) { return &c.mesh.refine[i].cell; },
          .unit = "m",
          .range = positive,
          .usual = cell_sizes,
          .required = true,
          .meaning = "size of the cells there"},
      {.path = "mesh.refine[].distance",
          .field = [](Case& c, std::size_t i) { return &c.mesh.refine[i].distance; },
          .unit = "m",
          .range = not_negative,
          .required_for = "a line",
          .meaning = "distance from the line or box over which the cells grow back to mesh.cell"},
  };
}

std::vector<KeyInfo> body_keys()
{
  return {
      {.path = "body[].name",
          .field = [](Case& c, std::size_t i) { return &c.bodies[i].name; },
          .meaning = "its name in messages, tables and pictures, and in `set`, `place` and `remove` of a stage; each "
                     "body needs its own"},
      {.path = "body[].material",
          .field = [](Case& c, std::size_t i) { return &c.bodies[i].material; },
          .required_for = "a body with box, polygon or region",
          .in_stage = true,
          .meaning = "NAME of the [material.NAME] that the body is made of; the file of points names its own"},
      {.path = "body[].box",
          .field = [](Case& c, std::size_t i) { return Box{&c.bodies[i].polygon}; },
          .unit = "m",
          .meaning = "lower left and upper right corner of the body; one of box, polygon, region, points"},
      {.path = "body[].polygon",
          .field = [](Case& c, std::size_t i) { return PolygonField{&c.bodies[i].polygon}; },
          .unit = "m",
          .meaning = "corners of the body in order, without repeating the first; one of box, polygon, region, points"},
      {.path = "body[].holes",
          .field = [](Case& c, std::size_t i) { return PolygonList{&c.bodies[i].holes}; },
          .unit = "m",
          .meaning = "polygons that are cut out of the box or polygon"},
      {.path = "body[].region",
          .field = [](Case& c, std::size_t i) { return &c.bodies[i].region; },
          .meaning = "physical group of mesh.file whose cells the body fills; one of box, polygon, region, points"},
      {.path = "body[].points",
          .field = [](Case& c, std::size_t i) { return &c.bodies[i].points_file; },
          .meaning = "CSV file with the head x,y,volume,material (m, m, m^2: volume per metre of thickness, NAME), one "
                     "material point per line, "
                     "relative to the case file; one of box, polygon, region, points"},
      {.path = "body[].points_per_cell",
          .field = [](Case& c, std::size_t i) { return CountOrPair{&c.bodies[i].points_per_cell}; },
          .range = between(1, 100),
          .meaning = "material points along x and y in each cell; one number for both"},
      {.path = "body[].stress",
          .field = [](Case& c, std::size_t i) { return stress_field(c.bodies[i].stress); },
          .unit = "Pa",
          .meaning = "stress of the body at t = 0, tension positive: xx, yy, zz, xy, effective where its soil stores "
                     "that. It counts with initial.stress = \"none\"",
          .default_text = "none"},
      {.path = "body[].velocity",
          .field =
              [](Case& c, std::size_t i) {
                return VelocityPair{&c.bodies[i].velocity, &c.bodies[i].velocity_at};
              },
          .unit = "m/s",
          .usual = {1e-6, 1e3},
          .meaning =
              "velocity of the body at t = 0; a text is a formula of the place x, y [m]: [\"0.1*sin(pi*x/4)\", 0.0]"},
  };
}

std::vector<KeyInfo> side_keys()
{
  std::vector<KeyInfo> keys = {
      {.path = "boundary.SIDE",
          .field = [](Case& c, std::size_t i) { return side_kind_field(c.sides[i].kind, ""); },
          .words = side_words,
          .in_stage = true,
          .meaning = "boundary condition of a side of the mesh: left, right, bottom or top, or a name of mesh.edges or "
                     "of a physical group of mesh.file. " +
                     side_kind_meanings("") + "; or a table with " + side_key_names() + ", as below"},
      {.path = "boundary.SIDE.contact",
          .field = [](Case& c, std::size_t i) { return side_kind_field(c.sides[i].kind, "contact"); },
          .words = contact_words,
          .in_stage = true,
          .meaning = "contact plane (reading R15). " + side_kind_meanings("contact"),
          .equation = "|tangential impulse of a node| <= (a L_i + mu N_i) dt"},
      {.path = "boundary.SIDE.velocity",
          .field =
              [](Case& c, std::size_t i) {
                return VelocityPair{&c.sides[i].velocity, &c.sides[i].velocity_at};
              },
          .unit = "m/s",
          .usual = {1e-6, 1e3},
          .in_stage = true,
          .meaning = "prescribed velocity of the side, two numbers or formulas of the place x, y [m]; the mesh, and so "
                     "the side, stays in place: it pushes soil only within the "
                     "cells next to it"},
      {.path = "boundary.SIDE.slip",
          .field = [](Case& c, std::size_t i) { return &c.sides[i].slip; },
          .in_stage = true,
          .meaning = "with velocity: true: a smooth wall; only the component across the side is prescribed, soil "
                     "slides along it freely"},
  };
  std::vector<KeyInfo> numbers;
  for (const SideNumber& number : side_numbers())
    numbers.push_back({.path = "boundary.SIDE." + std::string(number.name),
        .field = [at = number.at](Case& c, std::size_t i) { return &(c.sides[i].*at); },
        .unit = std::string(number.unit),
        .range = number.range,
        .usual = number.usual,
        .in_stage = true,
        .meaning = std::string(number.meaning)});
  keys.insert(keys.begin() + 2, numbers.begin(), numbers.end());  // beside the contact
  return keys;
}

std::vector<KeyInfo> footing_keys()
{
  return {
      {.path = "footing[].name",
          .field = [](Case& c, std::size_t i) { return &c.footings[i].name; },
          .meaning = "its name in footings.csv and summary.json; each footing needs its own"},
      {.path = "footing[].box",
          .field =
              [](Case& c, std::size_t i) {
                return BoxCorners{&c.footings[i].low, &c.footings[i].high};
              },
          .unit = "m",
          .required = true,
          .meaning = "lower left and upper right corner of the rigid block at t = 0; it holds the nodes inside it and "
                     "on its outline, and "
                     "moves on with its velocity. Its lower side lies on a row of nodes at the surface of the soil"},
      {.path = "footing[].velocity",
          .field = [](Case& c, std::size_t i) { return &c.footings[i].velocity; },
          .unit = "m/s",
          .usual = {1e-6, 1e2},
          .required = true,
          .meaning = "velocity of the block after the ramp; small against the shear wave speed, or the reaction holds "
                     "inertia"},
      {.path = "footing[].ramp",
          .field = [](Case& c, std::size_t i) { return &c.footings[i].ramp; },
          .unit = "s",
          .range = not_negative,
          .meaning = "time over which the velocity grows from zero",
          .equation = "v(t) = V (1 - cos(pi t / ramp)) / 2 for t < ramp, then V"},
      {.path = "footing[].contact",
          .field = [](Case& c, std::size_t i) { return word_field(c.footings[i].contact); },
          .words = footing_words,
          .meaning = "rough: the nodes take both components of the velocity; smooth: that along the velocity only, "
                     "free to slide across "
                     "it. Both hold in tension"},
  };
}

std::vector<KeyInfo> output_keys()
{
  return {
      {.path = "output.fields.every",
          .field = [](Case& c, std::size_t) { return &c.output.fields_every; },
          .unit = "s",
          .range = not_negative,
          .meaning = "interval of the fields of all points; 0: only first and last"},
      {.path = "output.fields.names",
          .field = [](Case& c, std::size_t) { return NameList{&c.output.field_names}; },
          .words = output_field_names,
          .more_words = true,
          .meaning = "fields to write besides position and id; left out or empty: all"},
      {.path = "output.history.every",
          .field = [](Case& c, std::size_t) { return &c.output.history_every; },
          .unit = "s",
          .range = positive,
          .meaning = "interval of the rows of history.csv"},
      {.path = "output.history.points",
          .field = [](Case& c, std::size_t) { return NamedPlaces{&c.output.history_points}; },
          .unit = "m",
          .meaning = "names and initial places; the nearest material point is followed (reading R21)"},
      {.path = "output.ledger.every",
          .field = [](Case& c, std::size_t) { return &c.output.ledger_every; },
          .unit = "s",
          .range = positive,
          .meaning = "interval of the rows of ledger.csv: mass, momentum, energy"},
      {.path = "output.mesh",
          .field = [](Case& c, std::size_t) { return &c.output.mesh; },
          .meaning =
              "whether mesh.vtkhdf also holds mass and velocity of the nodes and pressure of the cells, whenever "
              "the fields of all points are written"},
      {.path = "output.checkpoint.every",
          .field = [](Case& c, std::size_t) { return &c.output.checkpoint_every; },
          .unit = "s",
          .range = not_negative,
          .meaning = "interval of the files to resume from; 0: only at the end and when stopped"},
      {.path = "output.checkpoint.keep",
          .field = [](Case& c, std::size_t) { return &c.output.checkpoint_keep; },
          .range = not_negative,
          .meaning = "how many of the newest checkpoints are kept; 0: all"},
  };
}

}  // namespace

std::vector<KeyInfo> key_table()
{
  std::vector<KeyInfo> list;
  for (auto part : {frame_keys, time_keys, stage_keys, rectangle_keys, mesh_shape_keys, side_line_keys, refine_keys,
           body_keys, material_keys, softening_keys, force_keys, water_keys, flood_keys, side_keys, footing_keys,
           surface_load_keys, method_keys, motion_keys, output_keys, reference_keys})
    for (KeyInfo& key : part()) list.push_back(std::move(key));
  return list;
}

std::optional<std::size_t> count_entries(Case& c, std::string_view section, bool one_more)
{
  const auto count = [&](auto& list) {
    if (one_more) list.emplace_back();
    return list.size();
  };
  if (section == "body[]") return count(c.bodies);
  if (section == "stage[]") return count(c.stages);
  if (section == "load[]") return count(c.loads);
  if (section == "footing[]") return count(c.footings);
  if (section == "mesh.refine[]") return count(c.mesh.refine);
  if (section == "water.situation[]") return count(c.water.situations);
  return std::nullopt;
}

}  // namespace terp
