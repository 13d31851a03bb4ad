#include "meshing/generate.hpp"

#include "meshing/geo_text.hpp"
#include "meshing/gmsh_file.hpp"
#include "meshing/gmsh_nodes.hpp"
#include "meshing/improve.hpp"
#include "meshing/mesh_cache.hpp"
#include "mesh/mesh_error.hpp"
#include "meshing/process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

namespace terp {
namespace {

constexpr double longest_run = 600.0;  // [s] that gmsh may take
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
      "gmsh is not installed; Terp needs it to make a mesh from a polygon\n"
      "  Install it: apt-get install gmsh\n"
      "  or bring a mesh that you have made elsewhere: [mesh] file = \"section.msh\"");
}

ProcessResult run_gmsh(std::vector<std::string> arguments, const std::string& home)
{
  arguments.insert(arguments.begin(), "gmsh");
  // A home of its own: the user's gmsh options must not change the mesh.
  const ProcessResult result =
      run_process(arguments, longest_run, {"GMSH_HOME=" + home, "LC_ALL=C", "OMP_NUM_THREADS=1"});
  if (result.interrupted || result.signal == SIGINT) throw MeshError("gmsh was interrupted");
  return result;
}

/// Empty if it is not installed.
std::string gmsh_version(const std::string& home)
{
  const ProcessResult result = run_gmsh({"--version"}, home);
  if (!result.found) return "";
  if (!result.succeeded()) throw MeshError("`gmsh --version` fails: " + result.output);
  return result.output.substr(0, result.output.find_last_not_of(" \n") + 1);
}

std::string bytes_of(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<Freedom> freedom_of(const GmshNodes& file, const PlanarMap& map)
{
  std::vector<Freedom> freedom(file.nodes.size());
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    freedom[i].n = file.dimension[i];
    if (file.dimension[i] != 1) continue;
    const CutLine& line = map.lines.at(file.number[i] - 1);
    const Vec<2>&a = map.places[line.a], &b = map.places[line.b];
    const Real length = std::hypot(b[0] - a[0], b[1] - a[1]);
    freedom[i].along = {(b[0] - a[0]) / length, (b[1] - a[1]) / length};
  }
  return freedom;
}

std::vector<Real> targets_of(const GmshNodes& file, const PolygonMesh& mesh)
{
  std::vector<Real> target;
  for (const auto& cell : file.cells) {
    Vec<2> centre{0.0, 0.0};
    for (const Index i : cell)
      for (int d = 0; d < 2; ++d) centre[d] += 0.25 * file.nodes[i][d];
    target.push_back(target_size(mesh, centre));
  }
  return target;
}

/// What gmsh writes for one recipe, with better cells; empty, and the reason in `why`, if they are not all convex
/// quadrilaterals.
std::string try_recipe(
    const PolygonMesh& mesh, const PlanarMap& map, const Recipe& recipe, const std::string& folder, std::string& why)
{
  const std::string script = folder + "/section.geo", result = folder + "/section.msh";
  std::ofstream(script) << geo_text(mesh, map, recipe);
  std::filesystem::remove(result);
  const ProcessResult run = run_gmsh({"-2", script, "-o", result, "-nt", "1", "-v", "2"}, folder);
  why = run.timed_out     ? fmt::format("gmsh did not finish in {:g} s", longest_run)
        : run.signal != 0 ? fmt::format("gmsh crashed (signal {})", run.signal)
                          : run.output;
  std::string bytes = bytes_of(result);
  if (!run.succeeded() || bytes.empty()) return "";
  GmshNodes file = find_nodes(bytes);
  if (file.cells.empty() || !file.all_quads) return "";
  enlarge_altitudes(file.cells, freedom_of(file, map), targets_of(file, mesh), file.nodes);
  why = "some of its cells are not convex";
  for (const auto& cell : file.cells)
    if (!(smallest_altitude(cell, file.nodes) > 0.0)) return "";
  put_nodes(file, bytes);
  return bytes;
}

/// For a mesh that takes gmsh minutes.
void tell_of_work(const PolygonMesh& mesh)
{
  Real n = estimate_cells(mesh);
  for (const Refinement& refine : mesh.refine) n += estimate_more_cells(mesh, refine);
  if (n > many_cells)
    fmt::print(stderr, "gmsh is at work on about {:.2g} million cells; it may take minutes, once\n", n / 1e6);
}

std::string make_mesh(const PolygonMesh& mesh, const PlanarMap& map, const std::string& folder)
{
  tell_of_work(mesh);
  std::string why;
  for (const Recipe& recipe : recipes(mesh.variant)) {
    std::string bytes = try_recipe(mesh, map, recipe, folder, why);
    if (!bytes.empty()) return bytes;
  }
  throw MeshError(
      fmt::format("gmsh made no mesh of quadrilaterals from the polygon: {}\n"
                  "  Make the cells smaller than the shortest edge, follow fewer outlines, or bring a mesh: [mesh] "
                  "file = \"section.msh\"",
          why));
}

void check_sizes(const PolygonMesh& mesh)
{
  const auto positive = [](Real size) { return std::isfinite(size) && size > 0.0; };
  if (!positive(mesh.cell)) throw MeshError(fmt::format("the cell size is {:g} m; it must be positive", mesh.cell));
  for (const Refinement& refine : mesh.refine)
    if (!positive(refine.cell))
      throw MeshError(fmt::format("the cell size of a refinement is {:g} m; it must be positive", refine.cell));
  for (const NamedEdges& named : mesh.edges)
    for (const Index edge : named.edges)
      if (edge < 0 || edge >= static_cast<Index>(mesh.polygon.size()))
        throw MeshError(fmt::format(
            "side `{}` has edge {}; the polygon has edges 0 to {}", named.side, edge, mesh.polygon.size() - 1));
}

/// Nothing if the file is not there, is cut off or damaged.
std::optional<GeneratedMesh> read_kept(const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
  try {
    return GeneratedMesh{path, read_gmsh(path)};
  } catch (const MeshError&) {
    return std::nullopt;
  }
}

std::optional<GeneratedMesh> read_any_kept(const std::string& start_of_key)
{
  for (const std::string& path : cached_meshes(start_of_key))
    if (auto kept = read_kept(path)) return kept;
  return std::nullopt;
}

}  // namespace

GeneratedMesh generate_mesh(const PolygonMesh& mesh)
{
  check_sizes(mesh);
  const PlanarMap map = cut_polygon(mesh.polygon, mesh.follow, merged_share * mesh.cell);
  const SignalsHeld until_the_folder_is_gone;
  const WorkFolder folder;
  std::string content = std::string(improvement) + "\n";
  for (const Recipe& recipe : recipes(mesh.variant)) content += geo_text(mesh, map, recipe);
  const std::string start = content_key(content) + "-", version = gmsh_version(folder.path()),
                    key = start + content_key(version);
  auto kept = version.empty() ? read_any_kept(start) : read_kept(cached_mesh_path(key));
  if (kept) return std::move(*kept);
  if (version.empty()) refuse_without_gmsh();
  const std::string path = keep_mesh(key, make_mesh(mesh, map, folder.path()));
  return {path, read_gmsh(path)};
}

}  // namespace terp
