// All runs are read first, since fit() shares the bytes of the page among them; only then chunks are made. A run whose
// case or mesh cannot be read again is shown without what depends on them, with a warning.

#include "page/payload.hpp"

#include "math/checksum.hpp"
#include "math/errors.hpp"
#include "io/case/case_file.hpp"
#include "io/case/document.hpp"
#include "io/files/compress.hpp"
#include "io/files/soil_colours.hpp"
#include "page/backdrop.hpp"
#include "page/beside.hpp"
#include "page/failure_json.hpp"
#include "page/layers.hpp"
#include "page/shown.hpp"
#include "page/thin.hpp"
#include "io/results/compare.hpp"
#include "io/results/import_changes.hpp"
#include "model/meshes/setup_mesh.hpp"
#include "os/read_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace terp {
namespace {

using Json = nlohmann::ordered_json;

constexpr double codes_share =
    0.75 * 0.88;  // base64 makes 4 bytes of 3; tables and texts take a little, and the size is an estimate
constexpr std::size_t most_edges = 100'000;  // of a mesh that is drawn

class Chunks {
 public:
  std::int64_t add(std::string_view bytes)
  {
    chunks_.push_back(base64(gzip(bytes)));
    return std::ssize(chunks_) - 1;
  }
  template <class T>
  std::int64_t add(const std::vector<T>& values)
  {
    return add(pack_words(bytes_of(std::span<const T>(values))));
  }
  std::vector<std::string> take() { return std::move(chunks_); }

 private:
  std::vector<std::string> chunks_;
};

struct Source {
  RunResults run;
  Frames frames;
  std::string name;
  std::optional<CaseFile> case_read;  ///< none if the case can no longer be read
  std::optional<Mesh<2>> mesh;
  std::vector<Sentence> warnings;
  std::vector<std::vector<float>> surfaces;  ///< by frame of the run
};

constexpr SentenceForm no_case{
    "The case file of this run can no longer be read: the page shows no mesh and no outline.",
    "Het invoerbestand van deze berekening is niet meer te lezen: de pagina toont geen rekennet en geen omtrek."};
constexpr SentenceForm no_mesh{"The background mesh cannot be built again and is not shown: {}",
    "Het rekennet kan niet opnieuw worden gemaakt en is niet getekend: {}"};

Json sentences_json(const std::vector<Sentence>& sentences)
{
  Json json{{"en", Json::array()}, {"nl", Json::array()}};
  for (const Sentence& sentence : sentences) json["en"].push_back(sentence.en), json["nl"].push_back(sentence.nl);
  return json;
}

/// Texts of [reference] by language: `doubts`, what speaks against an imported section, or `assumed`. Doubts that a
/// user took out in one language alone are those in English.
Json texts_json(const std::string& case_toml, const std::string& key)
{
  Json json{{"en", Json::array()}, {"nl", Json::array()}};
  const Node document = parse_toml(case_toml);
  for (const auto& [language, end] : {std::pair{"en", ""}, {"nl", "_nl"}})
    if (const Node* const texts = find_node(document, "reference." + key + end))
      for (const Node& item : texts->items) json[language].push_back(item.text);
  if (json["nl"].size() != json["en"].size()) json["nl"] = json["en"];
  return json;
}

std::vector<Sentence> changes_of(const RunResults& run)
{
  try {
    return changes_since_import(parse_toml(run.case_toml), run.folder);
  } catch (const SyntaxError&) {
    return {};  // a warning says that the case cannot be read
  }
}

Source open_source(const std::string& folder, const std::string& name)
{
  RunResults run = read_run(folder);
  Frames frames = run.frames();
  Source source{.run = std::move(run),
      .frames = std::move(frames),
      .name = name,
      .case_read = {},
      .mesh = {},
      .warnings = {},
      .surfaces = {}};
  try {
    source.case_read = read_case(path_in(folder, case_file));
    source.mesh = build_mesh(source.case_read->values);
  } catch (const CaseError&) {
    source.warnings.push_back(filled<no_case>());
  } catch (const std::exception& error) {
    source.warnings.push_back(filled<no_mesh>(std::string(error.what())));
  }
  return source;
}

SurfaceColumns columns_of(const Source& source, const ShownRun& shown)
{
  const Real share = static_cast<Real>(shown.ids.size()) / static_cast<Real>(std::max<std::int64_t>(1, shown.n_points));
  return {source.mesh ? typical_cell_size(*source.mesh) : 4.0 * shown.point_size,
      0.5 * shown.point_size * std::sqrt(share)};
}

/// What the page shows of the points. Frames that turn out to be damaged while they are read are left out.
ShownRun read_points(Source& source, std::int64_t most_points)
{
  const auto look = [&](const ShownRun& shown, const std::vector<Real>& places) {
    source.surfaces.push_back(surface_line(places, columns_of(source, shown)));
  };
  const auto read = [&] {
    try {
      return read_shown(source.frames, most_points, look);
    } catch (const FileError&) {
      const std::size_t n = source.frames.times().size();
      source.frames.leave_out_damaged();
      if (source.frames.times().size() == n) throw;
      source.surfaces.clear();
      return read_shown(source.frames, most_points, look);
    }
  };
  ShownRun shown = read();
  const auto& left_out = source.frames.warnings();
  source.warnings.insert(source.warnings.end(), left_out.begin(), left_out.end());
  shown.moments = moments_of(source.run.summary.values);
  return shown;
}

/// Pa becomes kPa, J becomes kJ: what a person reads.
struct Unit {
  std::string name;
  Real factor;
};

Unit readable(std::string_view unit)
{
  if (unit == "Pa" || unit.starts_with("J/")) return {"k" + std::string(unit), 1e-3};
  return {std::string(unit), 1.0};
}

std::int64_t add_table(Chunks& chunks, const Table& table)
{
  std::vector<float> values;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const Real factor = readable(describe_column(table.names[c]).unit).factor;
    for (const Real v : table.columns[c]) values.push_back(static_cast<float>(factor * v));
  }
  return chunks.add(values);
}

Json table_json(Chunks& chunks, const Table& table)
{
  Json columns = Json::array();
  for (const auto& name : table.names) {
    const QuantityInfo info = describe_column(name);
    columns.push_back({{"name", name}, {"label", info.label}, {"unit", readable(info.unit).name}});
  }
  return {{"columns", std::move(columns)}, {"chunk", add_table(chunks, table)}, {"rows", table.n_rows()}};
}

Json array_json(Chunks& chunks, const std::vector<Codes>& frames, const Scale& scale)
{
  const Layout layout = best_packing(frames).layout;
  return {{"chunk", chunks.add(encode_frames(frames, layout))},
      {"layout", layout == Layout::by_frame ? "frame" : "point"}, {"lo", scale.lo}, {"hi", scale.hi()}, {"log", false},
      {"frames", frames.size()}, {"points", frames[0].size()}, {"static", frames.size() == 1}};
}

Json places_json(Chunks& chunks, const ShownRun& shown)
{
  return {{"x", array_json(chunks, shown.x_codes, shown.x)}, {"y", array_json(chunks, shown.y_codes, shown.y)}};
}

Json data_json(Chunks& chunks, const ShownRun& shown, const ShownField& field)
{
  if (!field.of_places) return array_json(chunks, field.frames, field.scale);
  return {{"chunk", nullptr}, {"lo", field.scale.lo}, {"hi", field.scale.hi()}, {"log", false},
      {"frames", shown.frames.size()}, {"points", shown.ids.size()}, {"static", false}};
}

Json fields_json(Chunks& chunks, const ShownRun& shown)
{
  Json fields = Json::array();
  for (const ShownField& field : shown.fields) {
    Json data = field.shares < 0 ? data_json(chunks, shown, field) : fields[field.shares]["data"];
    if (field.shares >= 0) data["lo"] = field.scale.lo, data["hi"] = field.scale.hi();
    fields.push_back({{"name", field.name}, {"symbol", field.symbol}, {"label", field.label}, {"unit", field.unit},
        {"kind", field.kind}, {"log", field.name.starts_with("eps_")}, {"range", {field.low, field.high}},
        {"precision", field.of_places ? std::max(shown.x.step, shown.y.step) : field.scale.step},
        {"data", std::move(data)}});
  }
  return fields;
}

Json materials_json(const Source& source)
{
  Json materials = Json::array();
  if (!source.case_read) return materials;
  const std::vector<std::string> colours = soil_colours(source.case_read->values.materials);
  for (const auto& material : source.case_read->values.materials) {
    const std::size_t id = materials.size();
    materials.push_back({{"id", id}, {"name", material.name}, {"soil", material.called()}, {"color", colours[id]}});
  }
  return materials;
}

/// Edges of the mesh, 4 numbers each; points of the first outline, 2 numbers each.
std::pair<std::vector<float>, std::vector<float>> backdrop(const Source& source)
{
  if (!source.mesh) return {};
  std::vector<float> edges = mesh_edges(*source.mesh);
  if (edges.size() > 4 * most_edges) edges.clear();
  return {std::move(edges), first_outline(source.case_read->values, *source.mesh)};
}

/// Lines, frame after frame; frame f has the places offsets[f] to offsets[f + 1] - 1.
struct LinesOfFrames {
  std::vector<float> places = {};  ///< x, y [m], shape [n, 2]
  std::vector<std::size_t> offsets{0};

  void add(const std::vector<float>& line)
  {
    places.insert(places.end(), line.begin(), line.end());
    offsets.push_back(places.size() / 2);
  }
  std::span<const float> line(std::size_t frame) const
  {
    return std::span(places).subspan(2 * offsets[frame], 2 * (offsets[frame + 1] - offsets[frame]));
  }
  std::span<const float> first() const { return line(0); }
  std::span<const float> last() const { return line(offsets.size() - 2); }
  Json json(Chunks& chunks) const { return {{"chunk", chunks.add(places)}, {"offsets", offsets}}; }
};

LinesOfFrames surfaces_of(const Source& source, const ShownRun& shown)
{
  const Real step = std::exp2(std::floor(std::log2(shown.x.step)));  // bits of nothing but rounding cost much
  LinesOfFrames surfaces;
  for (const std::size_t k : shown.frames) {
    std::vector<float> line = source.surfaces[k];
    for (float& v : line) v = static_cast<float>(std::round(v / step) * step);
    surfaces.add(line);
  }
  return surfaces;
}

std::optional<LinesOfFrames> water_of(const Source& source, const ShownRun& shown)
{
  if (!source.mesh || !source.case_read->values.water.is_given()) return std::nullopt;
  const Case& values = source.case_read->values;
  const std::vector<Real> first = source.frames.places(shown.frames.front());
  LinesOfFrames lines;
  for (std::size_t k = 0; k < shown.times.size(); ++k) {
    const std::vector<float> drawn =
        phreatic_line(values, source.run.summary.values.stages, *source.mesh, shown.times.front(), shown.times[k]);
    lines.add(values.water.follow_soil
                  ? water_in_moved_soil(first, source.frames.places(shown.frames[k]), drawn, columns_of(source, shown))
                  : drawn);
  }
  return lines;
}

Json attached_json(Chunks& chunks, const AttachedLines& lines)
{
  if (lines.is_empty()) return nullptr;
  return {{"points", chunks.add(lines.points)}, {"offsets", chunks.add(lines.offsets)}, {"count", lines.points.size()}};
}

struct ShownPoints {
  std::vector<Real> places, materials;

  ShownPoints(const Frames& frames, const ShownRun& shown, std::size_t k)
  {
    const std::vector<Real> all = frames.places(k);
    const std::vector<Real> material =
        frames.has("material") ? frames.read("material", k) : std::vector<Real>(all.size());
    for (const std::uint32_t id : shown.ids) {
      places.insert(places.end(), {all[2 * id], all[2 * id + 1]});
      materials.push_back(material[id]);
    }
  }
  PointsAtStart with_spacing(Real spacing) const { return {places, materials, spacing}; }
};

Json layers_json(Chunks& chunks, const Source& source, const ShownRun& shown)
{
  Json layers = Json::array();
  if (!source.mesh) return layers;
  const ShownPoints points(source.frames, shown, shown.frames.front());
  for (const SoilLayer& layer :
      attach_layers(source.case_read->values, *source.mesh, points.with_spacing(shown.point_size)))
    layers.push_back({{"soil", layer.soil}, {"lines", attached_json(chunks, layer.lines)},
        {"middle", attached_json(chunks, layer.middle)}});
  return layers;
}

/// Each load where it was put on, and its rows of loads.csv.
Json loads_json(Chunks& chunks, const Source& source, const ShownRun& shown)
{
  Json loads = Json::array();
  const std::string path = path_in(source.run.folder, "loads.csv");
  if (!source.case_read || source.case_read->values.loads.empty() || !std::filesystem::exists(path)) return loads;
  const std::vector<PointTable> tables = read_history(path, "load");
  for (const LoadCase& load : source.case_read->values.loads) {
    const auto table = std::ranges::find(tables, load.name, &PointTable::point);
    if (table == tables.end()) continue;
    const auto begins = std::ranges::lower_bound(shown.times, load.start);
    const std::size_t f = std::min(static_cast<std::size_t>(begins - shown.times.begin()), shown.times.size() - 1);
    const ShownPoints points(source.frames, shown, shown.frames[f]);
    Json json{{"name", load.name}, {"frame", f},
        {"lines", attached_json(chunks, attach_surface(points.with_spacing(shown.point_size), load.from, load.to))}};
    json.update(table_json(chunks, table->table));
    loads.push_back(std::move(json));
  }
  return loads;
}

Json slip_planes_json(const Source& source)
{
  Json planes = Json::array();
  if (!source.case_read) return planes;
  for (const SlipPlaneCase& plane : source.case_read->values.slip_planes) {
    Json line = Json::array();
    for (const Vec<2> x : plane.line) line.push_back({x[0], x[1]});
    planes.push_back({{"name", plane.name}, {"method", plane.method},
        {"factor_of_safety", std::isnan(plane.factor_of_safety) ? Json() : Json(plane.factor_of_safety)},
        {"points", std::move(line)}});
  }
  return planes;
}

Json histories_json(Chunks& chunks, const RunResults& run)
{
  Json histories = Json::array();
  for (const PointTable& point : run.history) {
    const auto first = [&](std::string_view column) {
      const auto* values = point.table.find(column);
      return values != nullptr && !values->empty() ? values->front() : std::nan("");
    };
    Json history{{"name", point.point}, {"x", first("x")}, {"y", first("y")}};
    history.update(table_json(chunks, point.table));
    histories.push_back(std::move(history));
  }
  return histories;
}

/// Low x, low y, high x, high y of all that is drawn.
std::array<Real, 4> bounds_of(const Source& source, const ShownRun& shown)
{
  auto b = shown.bounds;
  if (source.mesh)
    for (const Vec<2> x : source.mesh->nodes)
      b = {std::min(b[0], x[0]), std::min(b[1], x[1]), std::max(b[2], x[0]), std::max(b[3], x[1])};
  return b;
}

Json head_json(const Source& source, const ShownRun& shown)
{
  const Summary& s = source.run.summary.values;
  return {{"name", source.name}, {"title", source.case_read ? source.case_read->values.title : ""},
      {"scheme", s.scheme}, {"case_toml", source.run.case_toml}, {"case_path", path_in(source.run.folder, case_file)},
      {"case_digits", digits_of(source.run.case_toml)},
      {"machine", fmt::format("{} ({})", s.processor.empty() ? "unknown processor" : s.processor, s.instructions)},
      {"threads", s.threads}, {"wall_seconds", s.wall_s}, {"finished", source.run.summary.finished},
      {"n_points", shown.n_points}, {"n_shown", shown.ids.size()}, {"n_frames_in_run", shown.n_frames_in_run},
      {"times", shown.times}, {"position_precision", std::max(shown.x.step, shown.y.step)},
      {"point_size", shown.point_size}, {"cell", source.mesh ? Json(typical_cell_size(*source.mesh)) : Json()}};
}

Json run_json(Chunks& chunks, const Source& source, const ShownRun& shown)
{
  const auto [edges, outline] = backdrop(source);
  Json json = head_json(source, shown);
  json["bounds"] = bounds_of(source, shown);
  json["materials"] = materials_json(source);
  json["ids"] = {{"chunk", chunks.add(shown.ids)}};
  json["positions"] = places_json(chunks, shown);
  json["fields"] = fields_json(chunks, shown);
  json["mesh"]["edges"] = {{"chunk", chunks.add(edges)}, {"count", edges.size() / 4}};
  json["outline"] = {{"chunk", chunks.add(outline)}, {"count", outline.size() / 2}};
  const LinesOfFrames surfaces = surfaces_of(source, shown);
  json["surfaces"] = surfaces.json(chunks);
  const std::optional<LinesOfFrames> water = water_of(source, shown);
  json["water"] = water ? water->json(chunks) : Json();
  json["layers"] = layers_json(chunks, source, shown);
  json["loads"] = loads_json(chunks, source, shown);
  json["slip_planes"] = slip_planes_json(source);
  if (source.case_read)
    for (const char* const key : {"assumed", "doubts"}) json[key] = texts_json(source.run.case_toml, key);
  json["changed"] = sentences_json(changes_of(source.run));
  json["depends"] = depends_json(source.run);
  json["stability"] = stability_beside(source.run);
  json["histories"] = histories_json(chunks, source.run);
  json["series"] = table_json(chunks, source.run.ledger);
  const Real column = source.mesh ? typical_cell_size(*source.mesh) : 0.0;
  json.update(failure_json(source.run, {surfaces.first(), outline, column}));
  json["warnings"] = sentences_json(source.warnings);
  json["summary"] = Json::parse(source.run.summary.text);
  return json;
}

Json comparison_of(const std::vector<Source>& sources)
{
  if (sources.size() < 2) return nullptr;
  std::vector<RunResults> runs;
  std::vector<std::string> names;
  for (const Source& source : sources) {
    runs.push_back(source.run);
    names.push_back(source.name);
  }
  return Json::parse(comparison_json(compare_runs(runs, names)));
}

std::string note_on(const std::string& name, const ShownRun& shown)
{
  std::string note = fmt::format("{}: {} frame{}", name, shown.frames.size(), shown.frames.size() == 1 ? "" : "s");
  if (shown.frames.size() < shown.n_frames_in_run) note += fmt::format(" of {}", shown.n_frames_in_run);
  note += fmt::format(", {} points", shown.ids.size());
  if (std::ssize(shown.ids) < shown.n_points) note += fmt::format(" of {}", shown.n_points);
  return note + fmt::format(", places to {:.2g} m", std::max(shown.x.step, shown.y.step));
}

}  // namespace

std::string text_for_a_page(std::string json)
{
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
  return json;
}

Payload make_payload(const std::vector<std::string>& folders, const ReportOptions& options)
{
  const auto names = distinct_names(folders);
  std::vector<Source> sources;
  std::vector<ShownRun> shown;
  for (std::size_t k = 0; k < folders.size(); ++k) {
    sources.push_back(open_source(folders[k], names[k]));
    shown.push_back(read_points(sources.back(), options.most_points));
  }
  fit(shown, static_cast<std::size_t>(static_cast<double>(options.most_bytes) * codes_share));

  Payload payload;
  Chunks chunks;
  Json document{{"format", report_format}, {"kind", "run"}, {"terp", TERP_VERSION}, {"written", options.written},
      {"language", options.language}, {"runs", Json::array()}};
  for (std::size_t k = 0; k < sources.size(); ++k) {
    document["runs"].push_back(run_json(chunks, sources[k], shown[k]));
    payload.notes.push_back(note_on(names[k], shown[k]));
    const auto left_out = in_english(sources[k].frames.warnings());
    payload.warnings.insert(payload.warnings.end(), left_out.begin(), left_out.end());
  }
  document["comparison"] = comparison_of(sources);
  payload.json = text_for_a_page(document.dump(-1, ' ', false, Json::error_handler_t::replace));
  payload.chunks = chunks.take();
  return payload;
}

}  // namespace terp
