#include "meshing/mesh_cache.hpp"

#include "system/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace terp {
namespace {

namespace fs = std::filesystem;

/// Written beside its place under a name of this process, then renamed: nobody sees half a file.
bool write_whole(const fs::path& path, const std::string& bytes)
{
  std::error_code problem;
  fs::create_directories(path.parent_path(), problem);
  const fs::path unfinished = path.string() + fmt::format(".{}", process_number());
  std::ofstream file(unfinished, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) fs::rename(unfinished, path, problem);
  if (file && !problem) return true;
  fs::remove(unfinished, problem);
  return false;
}

}  // namespace

std::string cached_mesh_path(const std::string& key)
{
  const fs::path folder = cache_folder();
  return folder.empty() ? "" : (folder / "terp" / "meshes" / (key + ".msh")).string();
}

std::vector<std::string> cached_meshes(const std::string& start_of_key)
{
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::path(cached_mesh_path(start_of_key)).parent_path(), ignored))
    if (entry.path().extension() == ".msh" && entry.path().filename().string().starts_with(start_of_key))
      found.emplace_back(entry.last_write_time(ignored), entry.path().string());
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> paths;
  for (const auto& [time, path] : found) paths.push_back(path);
  return paths;
}

std::string bytes_of(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool keep_mesh(const std::string& key, const std::string& bytes)
{
  const std::string path = cached_mesh_path(key);
  return !path.empty() && write_whole(path, bytes);
}

}  // namespace terp
