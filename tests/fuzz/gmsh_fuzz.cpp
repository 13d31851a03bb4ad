// Meshes of gmsh: any bytes give a mesh that passes the checks, or a MeshError.
#include "model/meshes/check_mesh.hpp"
#include "model/meshes/gmsh_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  try {
    terp::check_mesh(terp::read_gmsh_text("m.msh", {reinterpret_cast<const char*>(data), size}));
  } catch (const terp::MeshError&) {
  }
  return 0;
}
