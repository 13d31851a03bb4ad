#include "report/payload.hpp"

#include "base/errors.hpp"
#include "input/case_file.hpp"
#include "output/compress.hpp"
#include "output/json_text.hpp"
#include "report/backdrop.hpp"
#include "report/failure_json.hpp"
#include "report/shown.hpp"
#include "results/compare.hpp"
#include "simulation/setup_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr double codes_share =
    0.75 * 0.88;  // base64 makes 4 bytes of 3; tables and texts take a little, and the size is an estimate
constexpr std::size_t most_edges = 100'000;  // of a mesh that is drawn

/// Collects chunks; each gets a number.
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
    return add(bytes_of(std::span<const T>(values)));
  }
  std::vector<std::string> take() { return std::move(chunks_); }

 private:
  std::vector<std::string> chunks_;
};

/// A run with all that its part of the page needs.
struct Source {
  RunResults run;
  Frames frames;
  std::string name;
  std::optional<CaseFile> case_read;  ///< none if the case can no longer be read
  std::optional<Mesh<2>> mesh;
  std::vector<std::string> warnings;
};

Source open_source(const std::string& folder, const std::string& name)
{
  RunResults run = read_run(folder);
  Frames frames = run.frames();
  Source source{
      .run = std::move(run), .frames = std::move(frames), .name = name, .case_read = {}, .mesh = {}, .warnings = {}};
  try {
    source.case_read = read_case(path_in(folder, case_file));
    source.mesh = build_mesh(source.case_read->values);
  } catch (const CaseError&) {
    source.warnings.push_back(
        "The case file of this run can no longer be read: the page shows no mesh and no outline.");
  } catch (const std::exception& error) {
    source.warnings.push_back(
        fmt::format("The background mesh cannot be built again and is not shown: {}", error.what()));
  }
  return source;
}

/// What the page shows of the points. Frames that turn out to be damaged while they are read are left out.
ShownRun read_points(Source& source, std::int64_t most_points)
{
  const auto read = [&] {
    try {
      return read_shown(source.frames, most_points);
    } catch (const FileError&) {
      const std::size_t n = source.frames.times().size();
      source.frames.leave_out_damaged();
      if (source.frames.times().size() == n) throw;
      return read_shown(source.frames, most_points);
    }
  };
  ShownRun shown = read();
  const auto& left_out = source.frames.warnings();
  source.warnings.insert(source.warnings.end(), left_out.begin(), left_out.end());
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

/// Columns as float32, one after the other.
std::int64_t add_table(Chunks& chunks, const Table& table)
{
  std::vector<float> values;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const Real factor = readable(describe_column(table.names[c]).unit).factor;
    for (const Real v : table.columns[c]) values.push_back(static_cast<float>(factor * v));
  }
  return chunks.add(values);
}

void put_columns(JsonText& json, const Table& table)
{
  json.key("columns").begin_array();
  for (const auto& name : table.names) {
    const QuantityInfo info = describe_column(name);
    json.begin_object()
        .entry("name", name)
        .entry("label", info.label)
        .entry("unit", readable(info.unit).name)
        .end_object();
  }
  json.end_array();
}

void put_table(JsonText& json, Chunks& chunks, const Table& table)
{
  put_columns(json, table);
  json.entry("chunk", add_table(chunks, table)).entry("rows", table.n_rows());
}

void put_array(JsonText& json, std::int64_t chunk, const std::vector<Codes>& frames, const Scale& scale)
{
  json.begin_object().entry("chunk", chunk).entry("lo", scale.lo).entry("hi", scale.hi()).entry("log", false);
  json.entry("frames", frames.size())
      .entry("points", frames[0].size())
      .entry("bits", 16)
      .entry("static", frames.size() == 1)
      .end_object();
}

void put_places(JsonText& json, Chunks& chunks, const ShownRun& shown)
{
  json.key("positions").begin_object().key("x");
  put_array(json, chunks.add(encode_frames(shown.x_codes)), shown.x_codes, shown.x);
  json.key("y");
  put_array(json, chunks.add(encode_frames(shown.y_codes)), shown.y_codes, shown.y);
  json.end_object();
}

void put_fields(JsonText& json, Chunks& chunks, const ShownRun& shown)
{
  std::vector<std::int64_t> chunk_of;
  json.key("fields").begin_array();
  for (const ShownField& field : shown.fields) {
    const bool own = field.shares < 0;
    const auto& frames = own ? field.frames : shown.fields[static_cast<std::size_t>(field.shares)].frames;
    chunk_of.push_back(own ? chunks.add(encode_frames(frames)) : chunk_of[static_cast<std::size_t>(field.shares)]);
    json.begin_object()
        .entry("name", field.name)
        .entry("symbol", field.symbol)
        .entry("label", field.label)
        .entry("unit", field.unit);
    json.entry("kind", field.kind).entry("log", field.name.starts_with("eps_"));
    json.key("range").begin_array().value(field.low).value(field.high).end_array();
    json.entry("precision", field.scale.step).key("data");
    put_array(json, chunk_of.back(), frames, field.scale);
    json.end_object();
  }
  json.end_array();
}

void put_materials(JsonText& json, const Source& source)
{
  json.key("materials").begin_array();
  if (source.case_read) {
    const auto& materials = source.case_read->values.materials;
    for (std::size_t k = 0; k < materials.size(); ++k)
      json.begin_object().entry("id", k).entry("name", materials[k].name).end_object();
  }
  json.end_array();
}

void put_backdrop(JsonText& json, Chunks& chunks, const Source& source)
{
  std::vector<float> edges, outline;
  if (source.mesh) {
    edges = mesh_edges(*source.mesh);
    if (edges.size() > 4 * most_edges) edges.clear();
    outline = first_outline(source.case_read->values, *source.mesh);
  }
  json.key("mesh").begin_object().key("edges").begin_object();
  json.entry("chunk", chunks.add(edges)).entry("count", edges.size() / 4).end_object().end_object();
  json.key("outline")
      .begin_object()
      .entry("chunk", chunks.add(outline))
      .entry("count", outline.size() / 2)
      .end_object();
}

/// The free surface in each frame that is shown.
void put_surfaces(JsonText& json, Chunks& chunks, const Source& source, const ShownRun& shown)
{
  const Frames& frames = source.frames;
  const Real width = source.mesh ? typical_cell_size(*source.mesh) : 4.0 * shown.point_size;
  std::vector<float> lines;
  std::vector<std::size_t> offsets{0};
  for (const std::size_t k : shown.frames) {
    const auto material = frames.has("material") ? frames.read("material", k)
                                                 : std::vector<Real>(static_cast<std::size_t>(shown.n_points), 0.0);
    const auto line = surface_line(frames.places(k), material, width);
    lines.insert(lines.end(), line.begin(), line.end());
    offsets.push_back(lines.size() / 2);
  }
  json.key("surfaces").begin_object().entry("chunk", chunks.add(lines)).key("offsets").begin_array();
  for (const std::size_t offset : offsets) json.value(offset);
  json.end_array().end_object();
}

void put_histories(JsonText& json, Chunks& chunks, const RunResults& run)
{
  json.key("histories").begin_array();
  for (const PointTable& point : run.history) {
    const auto first = [&](std::string_view column) {
      const auto* values = point.table.find(column);
      return values != nullptr && !values->empty() ? values->front() : std::nan("");
    };
    json.begin_object().entry("name", point.point).entry("x", first("x")).entry("y", first("y"));
    put_table(json, chunks, point.table);
    json.end_object();
  }
  json.end_array();
}

void put_bounds(JsonText& json, const Source& source, const ShownRun& shown)
{
  auto b = shown.bounds;
  if (source.mesh)
    for (const Vec<2> x : source.mesh->nodes)
      b = {std::min(b[0], x[0]), std::min(b[1], x[1]), std::max(b[2], x[0]), std::max(b[3], x[1])};
  json.key("bounds").begin_array();
  for (const Real v : b) json.value(v);
  json.end_array();
}

void put_head(JsonText& json, const Source& source, const ShownRun& shown)
{
  const Summary& s = source.run.summary.values;
  const std::string title = source.case_read ? source.case_read->values.title : "";
  json.entry("name", source.name)
      .entry("title", title)
      .entry("scheme", s.scheme)
      .entry("case_toml", source.run.case_toml);
  json.entry("machine", fmt::format("{} ({})", s.processor.empty() ? "unknown processor" : s.processor, s.instructions))
      .entry("threads", s.threads)
      .entry("wall_seconds", s.wall_s)
      .entry("finished", source.run.summary.finished);
  json.entry("n_points", shown.n_points)
      .entry("n_shown", shown.ids.size())
      .entry("n_frames_in_run", shown.n_frames_in_run);
  json.key("times").begin_array();
  for (const Real t : shown.times) json.value(t);
  json.end_array();
  json.entry("position_precision", std::max(shown.x.step, shown.y.step)).entry("point_size", shown.point_size);
}

void put_run(JsonText& json, Chunks& chunks, const Source& source, const ShownRun& shown)
{
  json.begin_object();
  put_head(json, source, shown);
  put_bounds(json, source, shown);
  put_materials(json, source);
  json.key("ids").begin_object().entry("chunk", chunks.add(shown.ids)).end_object();
  put_places(json, chunks, shown);
  put_fields(json, chunks, shown);
  put_backdrop(json, chunks, source);
  put_surfaces(json, chunks, source, shown);
  json.key("velocity_vectors").null();
  put_histories(json, chunks, source.run);
  json.key("series").begin_object();
  put_table(json, chunks, source.run.ledger);
  json.end_object();
  put_failure(json, source.run, source.warnings);
  json.key("summary").raw(source.run.summary.text);
  json.end_object();
}

void put_comparison(JsonText& json, const std::vector<Source>& sources)
{
  if (sources.size() < 2) return void(json.null());
  std::vector<RunResults> runs;
  std::vector<std::string> names;
  for (const Source& source : sources) {
    runs.push_back(source.run);
    names.push_back(source.name);
  }
  json.raw(comparison_json(compare_runs(runs, names)));
}

std::string note_on(const std::string& name, const ShownRun& shown)
{
  std::string note = fmt::format("{}: {} frames", name, shown.frames.size());
  if (shown.frames.size() < shown.n_frames_in_run) note += fmt::format(" of {}", shown.n_frames_in_run);
  note += fmt::format(", {} points", shown.ids.size());
  if (std::ssize(shown.ids) < shown.n_points) note += fmt::format(" of {}", shown.n_points);
  return note + fmt::format(", places to {:.2g} m", std::max(shown.x.step, shown.y.step));
}

}  // namespace

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
  JsonText json;
  json.begin_object()
      .entry("format", 1)
      .entry("terp", TERP_VERSION)
      .entry("written", options.written)
      .key("runs")
      .begin_array();
  for (std::size_t k = 0; k < sources.size(); ++k) {
    put_run(json, chunks, sources[k], shown[k]);
    payload.notes.push_back(note_on(names[k], shown[k]));
    const auto& left_out = sources[k].frames.warnings();
    payload.warnings.insert(payload.warnings.end(), left_out.begin(), left_out.end());
  }
  json.end_array().key("comparison");
  put_comparison(json, sources);
  json.end_object();
  payload.json = json.text();
  payload.chunks = chunks.take();
  return payload;
}

}  // namespace terp
