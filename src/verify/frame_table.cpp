#include "verify/frame_table.hpp"

namespace terp {
namespace {

using Names = std::vector<std::string>;

Names component_names(const PointField& field)
{
  if (field.name == "velocity") return {"vx", "vy"};
  if (field.name == "displacement") return {"ux", "uy", "x0", "y0"};
  if (field.name == "stress") return {"sxx", "syy", "szz", "sxy", "p"};
  if (field.name == "strain") return {"exx", "eyy", "ezz", "exy"};
  return field.n_components == 1 ? Names{field.name} : Names{};
}

void add_values(const Frame& frame, const PointField& field, std::size_t point, std::vector<Real>& row)
{
  const std::size_t n_names = component_names(field).size();
  const Real* const v = &field.values[point * static_cast<std::size_t>(field.n_components)];
  if (field.name == "displacement") {
    row.insert(row.end(), {v[0], v[1], frame.x[2 * point] - v[0], frame.x[2 * point + 1] - v[1]});
  } else if (field.name == "stress") {
    row.insert(row.end(), {v[0], v[1], v[2], v[3], (v[0] + v[1] + v[2]) / 3.0});
  } else {
    row.insert(row.end(), v, v + n_names);
  }
}

}  // namespace

Names names_of(const Frame& frame)
{
  Names names{"t", "x", "y"};
  for (const PointField& field : frame.fields)
    for (std::string& name : component_names(field)) names.push_back(std::move(name));
  return names;
}

void read_row(const Frame& frame, std::size_t point, std::vector<Real>& row)
{
  row.assign({frame.time, frame.x[2 * point], frame.x[2 * point + 1]});
  for (const PointField& field : frame.fields)
    if (!component_names(field).empty()) add_values(frame, field, point, row);
}

}  // namespace terp
