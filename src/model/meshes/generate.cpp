// A recipe of gmsh may leave triangles or cells that are not convex, so recipes are tried until one leaves none. The
// key of the cache has the scripts of all recipes, the version of gmsh, and the number `improvement`. Whatever else
// decides the mesh must enter the key, or an old mesh is taken for a new one.

#include "model/meshes/generate.hpp"

#include "math/checksum.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/meshes/geo_text.hpp"
#include "model/meshes/gmsh_file.hpp"
#include "model/meshes/gmsh_program.hpp"
#include "model/meshes/improve.hpp"
#include "model/meshes/msh_content.hpp"
#include "os/files.hpp"
#include "os/read_file.hpp"
#include "os/say.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <unordered_map>

namespace terp {
namespace {

namespace fs = std::filesystem;

constexpr Real merged_share =
    0.2;  // of a cell: followed places closer than this are one, lest a sliver sets the time step
constexpr Real many_cells = 2e5;          // from which on the user is told that gmsh is at work
constexpr const char* improvement = "1";  // part of the key: raise it when improve.cpp gives other meshes

/// In the order in which they are tried. Size factors: measured on a rectangle, a curved domain and a dike section.
/// Packed parallelograms (algorithm 9) gave the largest smallest altitude everywhere, and squares where squares fit;
/// Frontal-Delaunay (6) with Blossom pairs gives meshes without a grain.
std::vector<Recipe> recipes(int variant)
{
  if (variant == 0) return {{9, 0, 0, 1.0}, {6, 1, 0, 1.08}, {5, 1, 0, 1.13}};
  return {{6, 1, variant, 1.08}, {5, 1, variant, 1.13}, {9, 0, variant, 1.0}};
}

[[noreturn]] void refuse_without_gmsh()
{
  throw MeshError(
      "gmsh is not installed; Terp needs it to make a mesh from a polygon\n  Install it: " + how_to_install_gmsh() +
      "\n  or bring a mesh that you have made elsewhere: [mesh] file = \"section.msh\"");
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// How the nodes may move: along the lines of the map, and freely inside its faces. Those of turned squares stay.
std::vector<Freedom> freedom_of(const MshContent& file, const PlanarMap& map)
{
  std::vector<Freedom> freedom(file.places.size());
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    const auto [dimension, number] = file.node_entities[i];
    const std::size_t n_of_map = dimension == 1 ? map.lines.size() : map.faces.size();
    if (static_cast<std::size_t>(number) > n_of_map) continue;
    freedom[i].n = dimension;
    if (dimension != 1) continue;
    const CutLine& line = map.lines.at(number - 1);
    const Vec<2>&a = map.places[line.a], &b = map.places[line.b];
    const Real length = std::hypot(b[0] - a[0], b[1] - a[1]);
    freedom[i].along = {(b[0] - a[0]) / length, (b[1] - a[1]) / length};
  }
  return freedom;
}

std::vector<std::array<Index, 4>> cells_of(const MshContent& file)
{
  std::unordered_map<std::int64_t, Index> place;
  for (std::size_t i = 0; i < file.node_numbers.size(); ++i) place[file.node_numbers[i]] = static_cast<Index>(i);
  std::vector<std::array<Index, 4>> cells(file.quads.size());
  for (std::size_t e = 0; e < cells.size(); ++e)
    for (int k = 0; k < 4; ++k) cells[e][k] = place.at(file.quads[e].nodes[k]);
  return cells;
}

std::vector<Real> targets_of(
    const std::vector<std::array<Index, 4>>& cells, const std::vector<Vec<2>>& nodes, const PolygonMesh& mesh)
{
  std::vector<Real> target;
  for (const auto& cell : cells) {
    Vec<2> centre{0.0, 0.0};
    for (const Index i : cell)
      for (int d = 0; d < 2; ++d) centre[d] += 0.25 * nodes[i][d];
    target.push_back(target_size(mesh, centre));
  }
  return target;
}

/// Moves the nodes in the bytes of gmsh's file until the worst cells are better. False if a cell is still not convex.
bool improve_file(const PolygonMesh& mesh, const PlanarMap& map, const MshContent& file, std::string& bytes)
{
  const auto cells = cells_of(file);
  std::vector<Vec<2>> nodes;
  for (const auto& place : file.places) nodes.push_back({place[0], place[1]});
  enlarge_altitudes(cells, freedom_of(file, map), targets_of(cells, nodes, mesh), nodes);
  for (const auto& cell : cells)
    if (!(smallest_altitude(cell, nodes) > 0.0)) return false;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    std::memcpy(bytes.data() + file.node_bytes[i], nodes[i].data(), sizeof(Vec<2>));
  return true;
}

/// Says on the terminal which recipe gmsh is at, and how long: after `first` seconds, then now and then.
class Waiting {
 public:
  Waiting(std::string what, double longest, double first) : what_(std::move(what)), longest_(longest), next_(first) {}
  void operator()(double seconds)
  {
    if (seconds < next_) return;
    say(stderr, "{}: {:.0f} s of at most {:.0f} s\n", what_, seconds, longest_);
    next_ = std::max(2.0 * next_, next_ + 10.0);
  }
  double longest() const { return longest_; }

 private:
  std::string what_;
  double longest_, next_;
};

/// What gmsh writes for one recipe, with better cells; empty, and why, if they are not all convex quadrilaterals.
struct Attempt {
  std::string bytes, why;
};

Attempt try_recipe(
    const PolygonMesh& mesh, const PlanarMap& map, const Recipe& recipe, const std::string& folder, Waiting waiting)
{
  const std::string script = folder + "/section.geo", result = folder + "/section.msh";
  std::ofstream(script) << geo_text(mesh, map, recipe);
  fs::remove(result);
  const ProcessResult run =
      run_gmsh({"-2", script, "-o", result, "-nt", "1", "-v", "2"}, folder, waiting.longest(), std::ref(waiting));
  const std::string why = run.timed_out        ? fmt::format("gmsh did not finish in {:.3g} s", waiting.longest())
                          : run.signal != 0    ? fmt::format("gmsh crashed (signal {})", run.signal)
                          : run.output.empty() ? fmt::format("gmsh ended with status {}", run.status)
                                               : run.output;
  if (!run.succeeded() || !fs::exists(result)) return {"", why};
  std::string bytes = read_file(result);
  if (bytes.empty()) return {"", why};
  const MshContent file = read_msh(result, bytes);
  if (file.quads.empty() || file.n_others > 0) return {"", why};
  if (!improve_file(mesh, map, file, bytes)) return {"", "some of its cells are not convex"};
  return {bytes, ""};
}

void tell_of_work(const PolygonMesh& mesh)
{
  Real n = estimate_cells(mesh);
  for (const Refinement& refine : mesh.refine) n += estimate_more_cells(mesh, refine);
  if (n > many_cells)
    say(stderr, "gmsh is at work on about {:.2g} million cells; it may take minutes, once\n", n / 1e6);
}

std::string make_mesh(const PolygonMesh& mesh, const PlanarMap& map, const GmshTimes& times, const std::string& folder)
{
  tell_of_work(mesh);
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Recipe> all = recipes(mesh.variant);
  std::string why;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double seconds = std::min(times.recipe, times.all - passed);
    if (seconds <= 0.0) break;
    const std::string what = fmt::format("gmsh, recipe {} of {}", k + 1, all.size());
    Attempt attempt = try_recipe(mesh, map, all[k], folder, Waiting(what, seconds, times.first_word));
    if (!attempt.bytes.empty()) return attempt.bytes;
    why = attempt.why;
    if (k + 1 < all.size()) say(stderr, "{} gave no mesh ({}); trying the next\n", what, first_line(why));
  }
  throw MeshError(
      fmt::format("gmsh made no mesh of quadrilaterals from the polygon: {}\n"
                  "  Make the cells smaller than the shortest edge, follow fewer outlines, or bring a mesh: [mesh] "
                  "file = \"section.msh\"",
          why));
}

/// Where the mesh of the key is kept, whether it is there or not; empty if no variable says where a cache lies.
std::string kept_path(const std::string& key)
{
  const fs::path folder = cache_folder();
  return folder.empty() ? "" : (folder / "terp" / "meshes" / (key + ".msh")).string();
}

std::optional<GeneratedMesh> read_kept(const std::string& path)
{
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    return GeneratedMesh{path, read_gmsh(path)};
  } catch (const MeshError&) {
    return std::nullopt;
  }
}

/// Of any version of gmsh, the newest first.
std::optional<GeneratedMesh> read_any_kept(const std::string& start_of_key)
{
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::path(kept_path(start_of_key)).parent_path(), ignored))
    if (entry.path().extension() == ".msh" && entry.path().filename().string().starts_with(start_of_key))
      found.emplace_back(entry.last_write_time(ignored), entry.path().string());
  std::sort(found.rbegin(), found.rend());
  for (const auto& [time, path] : found)
    if (auto kept = read_kept(path)) return kept;
  return std::nullopt;
}

/// Written beside its place under a name of this process, then renamed: nobody sees half a file. Path of the kept file;
/// empty if it cannot be written.
std::string keep_mesh(const std::string& key, const std::string& bytes)
{
  const std::string path = kept_path(key), unfinished = fmt::format("{}.{}", path, process_number());
  if (path.empty()) return "";
  std::error_code problem;
  fs::create_directories(fs::path(path).parent_path(), problem);
  std::ofstream file(unfinished, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) fs::rename(unfinished, path, problem);
  if (file && !problem) return path;
  fs::remove(unfinished, problem);
  return "";
}

}  // namespace

GeneratedMesh generate_mesh(const PolygonMesh& mesh, const GmshTimes& times)
{
  const PlanarMap map = cut_polygon(mesh.polygon, mesh.follow, merged_share * mesh.cell);
  const SignalsHeld until_the_folder_is_gone;
  const WorkFolder folder;
  std::string content = std::string(improvement) + "\n";
  for (const Recipe& recipe : recipes(mesh.variant)) content += geo_text(mesh, map, recipe);
  const std::string start = digits_of(content) + "-", version = gmsh_version(folder.path()),
                    key = start + digits_of(version);
  auto kept = version.empty() ? read_any_kept(start) : read_kept(kept_path(key));
  if (kept) return std::move(*kept);
  if (version.empty()) refuse_without_gmsh();
  std::string bytes = make_mesh(mesh, map, times, folder.path());
  const std::string path = keep_mesh(key, bytes);
  return {path, read_gmsh_text("the mesh of gmsh", std::move(bytes))};
}

}  // namespace terp
