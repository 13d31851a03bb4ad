// Each reader asks a member for the keys that it knows, and the rest of its keys is reported as unknown. Only the
// waternet creator has a rest that does not matter. A fault does not end the reading; the tenth does. Ids of other
// members stay ids, which read_stix.cpp resolves; only head lines are resolved here, as they stand in the same member.
// Pressures and unit weights become Pa and N/m^3 here.

#include "import/dstability/ground_column.hpp"
#include "import/dstability/stix_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace terp {
namespace {

void end(JsonCursor& file)
{
  file.pass_over({"Id", "ContentVersion"});
  file.tell_unknown();
}

void end_entry(JsonCursor& entry)
{
  entry.pass_over({"Label", "Notes", "Id"});
  entry.tell_unknown();
}

StixConsolidation read_consolidation(JsonCursor& from)
{
  StixConsolidation degrees;
  for (JsonCursor& entry : from.list("Consolidations")) {
    const Real degree = entry.required("Degree");
    if (degree < 0.0 || degree > 100.0)
      entry.fault("Degree", "is out of range", fmt::format("Got {} %, allowed are 0 to 100 %.", degree));
    degrees[entry.id("LayerId")] = degree;
    entry.tell_unknown();
  }
  return degrees;
}

std::vector<StixDrawnLine> read_drawn_lines(JsonCursor& from, const char* key)
{
  std::vector<StixDrawnLine> lines;
  for (JsonCursor& entry : from.list(key)) {
    lines.push_back({entry.text("Label"), entry.place_if_given("Start"), entry.place_if_given("End")});
    entry.pass_over({"ReductionArea", "TensileStrength"});  // of geotextiles
    end_entry(entry);
  }
  return lines;
}

StixPreload read_preload(JsonCursor from)
{
  StixPreload preload;
  const std::string kind = from.text("StateType");
  if (kind.empty()) {
    from.remark(filled<reported_texts::no_state_type>());
    preload.pop.value = 0.0;
    return preload;
  }
  if (kind == "Ocr")
    preload.kind = StixPreload::Kind::ocr;
  else if (kind == "YieldStress")
    preload.kind = StixPreload::Kind::yield_stress;
  else if (kind != "Pop")
    from.fault("StateType", "is none that Terp knows", fmt::format("Got \"{}\"; Pop, Ocr or YieldStress.", kind));
  preload.pop = read_parameter(from, "Pop", pa_per_kpa);
  preload.ocr = from.number("Ocr");
  preload.yield_stress = pa_per_kpa * from.number("YieldStress");
  const Real needed = preload.kind == StixPreload::Kind::pop   ? preload.pop.value
                      : preload.kind == StixPreload::Kind::ocr ? preload.ocr
                                                               : preload.yield_stress;
  if (std::isnan(needed))
    from.fault(kind.c_str(), "needs a number", fmt::format("It is the state that holds, as StateType is {}.", kind));
  from.pass_over({"OcrStochasticParameter", "YieldStressStochasticParameter"});
  from.tell_unknown();
  return preload;
}

void read_state_line(JsonCursor& from, std::vector<StixStateLine>& lines)
{
  StixStateLine state{.line = from.line_to_the_right("Points"), .values = {}};
  for (JsonCursor& entry : from.list("Values")) {
    state.values.push_back({.id = entry.text("Id"),
        .label = entry.text("Label"),
        .x = entry.required("X"),
        .above = read_preload(entry.object("Above")),
        .below = read_preload(entry.object("Below"))});
    entry.pass_over({"IsProbabilistic", "IsAboveAndBelowCorrelated"});
    end_entry(entry);
  }
  std::ranges::stable_sort(state.values, {}, &StixStateLine::Value::x);
  end_entry(from);
  if (state.line.empty() || state.values.empty()) return from.remark(filled<reported_texts::empty_state_line>());
  lines.push_back(std::move(state));
}

std::optional<std::size_t> number_of(const StixWater& water, JsonCursor& from, const char* key)
{
  const std::string id = from.text(key);
  if (id.empty()) return std::nullopt;
  const auto found = std::ranges::find(water.head_lines, id, &StixHeadLine::id);
  if (found == water.head_lines.end())
    from.fault(key, "names a head line that is not there", fmt::format("Got {}.", id));
  else if (found->line.empty())
    from.fault(key, "names a head line without places", fmt::format("The head line `{}`.", found->label));
  else
    return static_cast<std::size_t>(found - water.head_lines.begin());
  return std::nullopt;
}

/// A line without a head says nothing of the water.
void read_reference_line(StixWater& water, JsonCursor& from)
{
  StixReferenceLine line{.label = from.text("Label"), .line = from.line_to_the_right("Points")};
  const auto top = number_of(water, from, "TopHeadLineId"), bottom = number_of(water, from, "BottomHeadLineId");
  if ((top || bottom) && !line.line.empty()) {
    line.top_head = top ? *top : *bottom;
    line.bottom_head = bottom ? *bottom : *top;
    water.reference_lines.push_back(std::move(line));
  } else if (line.line.empty() || (!from.has("TopHeadLineId") && !from.has("BottomHeadLineId")))
    from.remark(line.line.empty() ? filled<reported_texts::no_reference_places>(line.label)
                                  : filled<reported_texts::no_reference_head>(line.label));
  end_entry(from);
}

/// The ends of a section are upright: corners next to them are moved onto them. Else it would end in a sliver in which
/// most layers are missing. Tells how many moved, and by how much.
void straighten_ends(const JsonCursor& file, std::vector<StixLayer>& layers)
{
  constexpr Real near_end = 0.01;  // [m]: coordinates of drawings are in cm
  const BoundingBox box = box_around(layers);
  const Real low = box.low[0], high = box.high[0];
  Real most = 0.0;
  std::size_t moved = 0;
  for (StixLayer& layer : layers)
    for (Vec<2>& x : layer.outline)
      if (const Real end = x[0] < low + near_end ? low : high; x[0] != end && std::abs(x[0] - end) < near_end) {
        most = std::max(most, std::abs(x[0] - end));
        x[0] = end;
        ++moved;
      }
  if (moved > 0)
    file.remark_on_format(
        fmt::format("The ends of this section are not upright: {} corners were moved onto them, by up to {:.1f} mm.",
            moved, 1e3 * most));
}

}  // namespace

void read_geometry(JsonCursor& file, StixParts& parts)
{
  std::vector<StixLayer> layers;
  for (JsonCursor& entry : file.list("Layers")) {
    StixLayer layer{.id = entry.id("Id"), .label = entry.text("Label"), .outline = entry.line("Points", 3), .soil = {}};
    if (std::ranges::find(layers, layer.id, &StixLayer::id) != layers.end())
      entry.fault("Id", "is there twice", fmt::format("Got {}, which another layer has.", layer.id));
    layers.push_back(std::move(layer));
    end_entry(entry);
  }
  straighten_ends(file, layers);
  parts.geometries.add(file.id("Id"), file, std::move(layers));
  end(file);
}

void read_soil_layers(JsonCursor& file, StixParts& parts)
{
  std::map<std::string, std::string> soils;
  for (JsonCursor& entry : file.list("SoilLayers")) {
    const std::string layer = entry.id("LayerId");
    if (!soils.emplace(layer, entry.text("SoilId")).second)
      entry.fault("LayerId", "is there twice", fmt::format("The layer {} has two soils.", layer));
    entry.tell_unknown();
  }
  parts.soil_layers.add(file.id("Id"), file, std::move(soils));
  end(file);
}

void read_decorations(JsonCursor& file, StixParts& parts)
{
  StixDecorations decorations;
  for (JsonCursor& entry : file.list("Excavations")) {
    StixLine line = entry.line("Points", 0);
    if (line.size() < 2)
      entry.remark(filled<reported_texts::no_excavation_line>());
    else
      decorations.excavations.push_back(std::move(line));
    end_entry(entry);
  }
  for (const char* key : {"Elevations", "Berms"})  // Berms: data model 1
    for (JsonCursor& entry : file.list(key)) {
      decorations.added_layers.push_back(entry.text("AddedLayerId"));
      entry.pass_over({"Points"});
      end_entry(entry);
    }
  parts.decorations.add(file.id("Id"), file, std::move(decorations));
  end(file);
}

void read_waternet(JsonCursor& file, StixParts& parts)
{
  StixWater water{.unit_weight = file.required("UnitWeightWater", pa_per_kpa)};
  for (JsonCursor& entry : file.list("HeadLines")) {
    const std::string id = entry.id("Id");
    if (std::ranges::find(water.head_lines, id, &StixHeadLine::id) != water.head_lines.end())
      entry.fault("Id", "is there twice", fmt::format("Got {}, which another head line has.", id));
    water.head_lines.push_back({id, entry.text("Label"), entry.line_to_the_right("Points")});
    end_entry(entry);
  }
  for (JsonCursor& entry : file.list("ReferenceLines")) read_reference_line(water, entry);
  water.phreatic = number_of(water, file, "PhreaticLineId");
  parts.waternets.add(file.id("Id"), file, std::move(water));
  end(file);
}

void read_water_mesh(JsonCursor& file, StixParts& parts)
{
  StixWater water{.unit_weight = pa_per_kpa * file.number("UnitWeightWater"), .is_mesh = true};
  for (JsonCursor& entry : file.list("Elements")) {
    std::vector<JsonCursor> nodes = entry.list("WaterMeshNodes");
    if (nodes.size() != 3) {
      entry.fault("WaterMeshNodes", "has not three corners", fmt::format("Got {}.", nodes.size()));
      continue;
    }
    StixWaterTriangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.corners[k] = nodes[k].place("Point");
      triangle.pressure[k] = nodes[k].required("TotalPorePressure", pa_per_kpa);
      nodes[k].tell_unknown();
    }
    water.mesh.push_back(triangle);
    entry.tell_unknown();
  }
  parts.water_meshes.add(file.id("Id"), file, std::move(water));
  file.pass_over({"WaterMeshProperties"});
  end(file);
}

void read_waternet_creator(JsonCursor& file, StixParts& parts)
{
  JsonCursor at = file.object("EmbankmentCharacteristics");
  const StixEmbankment embankment{.toe_water = at.number("EmbankmentToeWaterSide"),
      .top_water = at.number("EmbankmentTopWaterSide"),
      .top_land = at.number("EmbankmentTopLandSide"),
      .shoulder_land = at.number("ShoulderBaseLandSide"),
      .toe_land = at.number("EmbankmentToeLandSide")};
  at.tell_unknown();
  parts.embankments.add(file.id("Id"), file, embankment);
  // What else stands here made the lines of the waternet, which are in the file.
}

void read_states(JsonCursor& file, StixParts& parts)
{
  StixStates states;
  for (JsonCursor& entry : file.list("StatePoints")) {
    StixStatePoint point{.id = entry.text("Id"),
        .label = entry.text("Label"),
        .layer = entry.text("LayerId"),
        .place = entry.place("Point"),
        .preload = read_preload(entry.object("Stress"))};
    states.state_points.push_back(std::move(point));
    entry.pass_over({"IsProbabilistic"});
    end_entry(entry);
  }
  for (JsonCursor& entry : file.list("StateLines")) read_state_line(entry, states.state_lines);
  parts.states.add(file.id("Id"), file, std::move(states));
  end(file);
}

void read_state_correlations(JsonCursor& file, StixParts& parts)
{
  parts.state_correlations.add(file.id("Id"), file, true);
  file.pass_over({"StateCorrelations"});
  end(file);
}

void read_loads(JsonCursor& file, StixParts& parts)
{
  StixLoads loads;
  for (JsonCursor& entry : file.list("UniformLoads")) {
    StixUniformLoad load{.label = entry.text("Label"),
        .start = entry.required("Start"),
        .end = entry.required("End"),
        .magnitude = entry.required("Magnitude", pa_per_kpa),
        .spread = entry.number("Spread"),
        .consolidation = {}};
    if (std::isnan(load.spread)) {
      if (entry.has("Spread")) entry.remark(filled<reported_texts::no_spread>(load.label));
      load.spread = 0.0;
    }
    if (!(load.spread >= 0.0 && load.spread < 90.0))
      entry.fault(
          "Spread", "is out of range", fmt::format("Got {} degrees, allowed are 0 to less than 90.", load.spread));
    if (load.end < load.start) std::swap(load.start, load.end);
    load.consolidation = read_consolidation(entry);
    loads.loads.push_back(std::move(load));
    end_entry(entry);
  }
  for (JsonCursor& entry : file.list("LayerLoads")) {
    loads.layer_loads.push_back({entry.id("LayerId"), read_consolidation(entry)});
    end_entry(entry);
  }
  loads.line_loads = file.list("LineLoads").size();
  loads.trees = file.list("Trees").size();
  loads.has_earthquake = file.object("Earthquake").flag("IsEnabled");
  parts.loads.add(file.id("Id"), file, std::move(loads));
  end(file);
}

void read_reinforcements(JsonCursor& file, StixParts& parts)
{
  StixReinforcements all{read_drawn_lines(file, "ForbiddenLines"), read_drawn_lines(file, "Geotextiles"), {}};
  for (JsonCursor& entry : file.list("Nails")) {
    const Vec<2> place = entry.place_if_given("Location");
    all.nails.push_back({entry.text("Label"), place, place});
  }
  parts.reinforcements.add(file.id("Id"), file, std::move(all));
  end(file);
}

void read_colours(JsonCursor& file, StixParts& parts)
{
  for (JsonCursor& entry : file.list("SoilVisualizations")) {
    parts.colours[entry.text("SoilId")] = entry.text("Color");
    entry.pass_over({"PersistableShadingType"});
    entry.tell_unknown();
  }
  end(file);
}

}  // namespace terp
