// A fault becomes text as soon as it is added; after the tenth only the number grows. Advice is kept apart, since many
// faults share one. Numbers of the mesh file are named where they exist: by them a user finds the place in the mesh
// generator.

#include "model/meshes/mesh_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr std::int64_t most_shown = 10, most_counted = 1000;

std::int64_t node_number(const Mesh<2>& mesh, Index node)
{
  return mesh.node_numbers.empty() ? node : mesh.node_numbers[node];
}

}  // namespace

std::string coordinate_text(Real x)
{
  if (!std::isfinite(x) || std::abs(x) >= 1e12 || std::abs(x) < 1e-4) return fmt::format("{:.6g}", x);
  std::string text = fmt::format("{:.{}f}", x, std::max(3, 5 - static_cast<int>(std::floor(std::log10(std::abs(x))))));
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string place_text(Vec<2> x) { return fmt::format("({}, {})", coordinate_text(x[0]), coordinate_text(x[1])); }

std::string cell_name(const Mesh<2>& mesh, Index cell)
{
  if (mesh.cell_numbers.empty()) return fmt::format("cell {}", cell);
  return fmt::format("cell {} (element {} of the file)", cell, mesh.cell_numbers[cell]);
}

std::string node_name(const Mesh<2>& mesh, Index node)
{
  return fmt::format("node {} at {} m", node_number(mesh, node), place_text(mesh.nodes[node]));
}

std::string corner_names(const Mesh<2>& mesh, Index cell)
{
  std::string text = "nodes";
  for (const Index i : mesh.cells[cell])
    text += fmt::format(" {} at {},", node_number(mesh, i), place_text(mesh.nodes[i]));
  text.back() = ' ';
  return text + "m";
}

void MeshFaults::add(const std::string& what, const std::string& places, const std::string& advice)
{
  if (++n_ >= most_counted) stop_if_any();
  if (n_shown_ == most_shown) return;
  ++n_shown_;
  text_ += "\n  " + what;
  if (!places.empty()) text_ += "\n    " + places;
  if (!advice.empty() && std::find(advice_.begin(), advice_.end(), advice) == advice_.end()) advice_.push_back(advice);
}

void MeshFaults::stop_if_any() const
{
  if (empty()) return;
  std::string text = fmt::format("{} has {} fault{}:{}", title_, n_,
      n_ == 1              ? ""
      : n_ == most_counted ? "s or more"
                           : "s",
      text_);
  if (n_ > n_shown_) text += fmt::format("\n  and {} more", n_ - n_shown_);
  for (const auto& advice : advice_) text += "\n  " + advice;
  throw MeshError(text);
}

}  // namespace terp
