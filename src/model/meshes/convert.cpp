// gmsh works in a folder of its own, on a link to the file and not beside it. Signals wait until that folder is gone.
// The result is read into memory as any MSH 4.1 file. All elements are saved, not only those of groups. Those that the
// conversion made several times are then dropped, by their entity and nodes.

#include "model/meshes/msh_content.hpp"

#include "model/meshes/mesh_error.hpp"
#include "model/meshes/gmsh_program.hpp"
#include "os/files.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

namespace terp {
namespace {

constexpr double longest_conversion = 300.0;  // [s] that gmsh may take

[[noreturn]] void refuse_to_convert(const std::string& path, const std::string& why)
{
  throw MeshError(
      fmt::format("{}: this is not MSH 4.1, and {}\n"
                  "  Save the mesh as MSH 4.1; in gmsh: `gmsh FILE -save -format msh41 -o NEW.msh`",
          path, why));
}

}  // namespace

bool needs_conversion(const std::string& path, const std::string& text)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".unv" || ending == ".bdf" || ending == ".nas" || ending == ".vtk") return true;
  const std::string head = "$MeshFormat\n";
  return text.starts_with("$NOD") || (text.starts_with(head) && text.compare(head.size(), 4, "4.1 ") != 0);
}

MshContent convert_by_gmsh(const std::string& path)
{
  const SignalsHeld until_the_folder_is_gone;
  const WorkFolder folder;
  // Under a name of our own: gmsh also reads options from a file that lies beside its input.
  const std::string input = folder.path() + "/mesh" + std::filesystem::path(path).extension().string(),
                    output = folder.path() + "/converted.msh";
  link_or_copy(path, input);
  const ProcessResult run =
      run_gmsh({input, "-save", "-save_all", "-format", "msh41", "-bin", "-o", output, "-nt", "1", "-v", "2"},
          folder.path(), longest_conversion);
  if (!run.found) refuse_to_convert(path, "gmsh, which would convert it, is not installed: " + how_to_install_gmsh());
  if (run.timed_out) refuse_to_convert(path, fmt::format("gmsh did not convert it in {:g} s", longest_conversion));
  if (!run.succeeded() || !std::filesystem::exists(output)) {
    std::string why = run.output.substr(0, run.output.find('\n'));
    if (const auto at = why.find(input); at != std::string::npos) why.replace(at, input.size(), path);
    refuse_to_convert(path, "gmsh cannot convert it: " + why);
  }
  std::string bytes = read_file(output);
  if (bytes.find("$Nodes\n") == std::string::npos) refuse_to_convert(path, "gmsh finds no mesh in it");
  MshContent content = read_msh(path + " (converted by gmsh)", std::move(bytes));
  // gmsh gives an element of MSH 2.2 that is there once for each of its groups a number for each.
  std::set<std::pair<int, std::array<std::int64_t, 4>>> known;
  std::erase_if(content.quads, [&](const MshElement& quad) { return !known.emplace(quad.entity, quad.nodes).second; });
  return content;
}

}  // namespace terp
