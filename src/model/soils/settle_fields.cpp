// Every field is asked at every point to be, before the run: where it leaves its range, and its mean. The mean becomes
// the value of the parameter in the description, so that whatever takes one number of a soil finds one. A parameter
// that follows from a wrong one is not reported as well.

#include "model/soils/settle_fields.hpp"

#include "math/errors.hpp"
#include "model/meshes/mesh_error.hpp"
#include "model/soils/overburden.hpp"
#include "model/soils/point_parameters.hpp"
#include "model/bodies/setup_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

struct FieldRange {
  Real sum = 0.0;
  Index n = 0, n_outside = 0;  // points; those where the value is outside its range
  Real worst = 0.0;            // the value farthest outside, or none at all
  Vec<2> where{0.0, 0.0};

  void add(Real value, const Range& range, Vec<2> x)
  {
    ++n;
    sum += value;
    if (std::isfinite(value) && range.contains(value)) return;
    const auto beyond = [&](Real v) { return std::isnan(v) ? INFINITY : std::max(range.low - v, v - range.high); };
    if (++n_outside == 1 || beyond(value) > beyond(worst)) worst = value, where = x;
  }
};

Problem outside_its_range(const MaterialCase& material, const ParameterInfo& info, const FieldRange& found)
{
  const bool is_number = !std::isnan(found.worst);
  const std::string got =
      is_number
          ? fmt::format("It is {:.6g} {} at {} m, where it is worst,", found.worst, info.unit, place_text(found.where))
          : fmt::format("There is no value at {} m, or what it is made of is out of range there. It is wrong",
                place_text(found.where));
  return {parameter_key(material, info.name),
      fmt::format("`{}` {} in part of the soil", info.name, is_number ? "is out of range" : "has no value"),
      fmt::format("{} at {} of {} points of `{}`; allowed: {} {}{}{}.{}", got, found.n_outside, found.n, material.name,
          info.range.low_open ? "more than" : "at least", info.range.low,
          info.unit == "-" ? "" : fmt::format(" {}", info.unit),
          std::isfinite(info.range.high) ? fmt::format(", up to {}", info.range.high) : "",
          found.worst <= info.range.low ? "\nGive it a least value: max(..., ...) in a formula, `minimum` in shansep."
                                        : ""),
      "material." + std::string(info.name), false, {"water", parameter_key(material, "model")}};
}

bool is_in(const FieldCover& cover, Vec<2> x)
{
  constexpr Real round_off = 1e-9;  // [m]
  return x[0] >= cover.low[0] - round_off && x[0] <= cover.high[0] + round_off && x[1] >= cover.low[1] - round_off &&
         x[1] <= cover.high[1] + round_off;
}

std::string cover_text(const FieldCover& cover)
{
  const auto along = [&](int axis) {
    return std::isinf(cover.low[axis]) ? std::string()
                                       : fmt::format("{} = {} to {} m", axis == 0 ? "x" : "y",
                                             coordinate_text(cover.low[axis]), coordinate_text(cover.high[axis]));
  };
  const std::string x = along(0), y = along(1);
  return fmt::format("Its places lie in {}{}{}", x, x.empty() || y.empty() ? "" : ", ", y);
}

/// Whether the parameter that a field is found from is wrong somewhere: then that is reported, and not what follows.
bool follows_a_wrong_one(
    const MaterialCase& material, const ParameterField& field, const std::vector<FieldRange>& found)
{
  for (std::size_t f = 0; field.follows && f < found.size(); ++f)
    if (material.fields[f].parameter == *field.follows) return found[f].n_outside > 0;
  return false;
}

/// soil: the box around its points. A table may lie in it and between points, as one of a short boring does.
void check_covers(const MaterialCase& material, const ParameterField& field, const BoundingBox& soil)
{
  for (std::size_t c = 0; c < field.needs.covers.size(); ++c)
    if (!overlap({field.needs.covers[c].low, field.needs.covers[c].high}, soil))
      throw InputError(Problem{parameter_key(material, material.type()->parameters[field.parameter].name),
          fmt::format("the table `{}` covers none of the soil", field.needs.covers[c].file),
          fmt::format(
              "{}; `{}` lies in x = {:.4g} to {:.4g} m, y = {:.4g} to {:.4g} m. Are x and y in m, and in the axes of "
              "the case?",
              cover_text(field.needs.covers[c]), material.name, soil.low[0], soil.high[0], soil.low[1], soil.high[1]),
          "material"});
}

}  // namespace

FieldsOfPoints fields_of_points(const StageSoil& soil)
{
  const std::vector<MaterialCase>& materials = soil.description.materials;
  FieldsOfPoints fields;
  if (std::ranges::all_of(materials, [](const MaterialCase& m) { return m.fields.empty(); })) return fields;
  TERP_ASSERT(soil.grounds.first != nullptr);
  for (const auto& batch : make_points(soil))
    for (const NewPoint& point : batch) {
      const Index m = point.key.material;
      const BodyCase& body = soil.description.bodies[static_cast<std::size_t>(point.body)];
      if (materials[m].fields.empty() || !body.is_there) continue;
      fields.points.push_back({m, point.x, fields.values.size()});
      const PlaceInSoil place{point.x, soil.grounds.of(body)};
      for (const ParameterField& field : materials[m].fields) fields.values.push_back(field.value_at(place));
    }
  return fields;
}

FieldsOfPoints settle_fields(const Parts& parts, Soils& soils)
{
  std::vector<MaterialCase>& materials = soils.description.materials;
  FieldsOfPoints fields = fields_of_points({parts, soils});
  std::vector<std::vector<FieldRange>> found(materials.size());
  std::vector<BoundingBox> boxes(materials.size(), {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}});
  for (std::size_t m = 0; m < materials.size(); ++m) found[m].resize(materials[m].fields.size());
  for (const auto& [m, x, first] : fields.points) {
    for (int d = 0; d < 2; ++d)
      boxes[m].low[d] = std::min(boxes[m].low[d], x[d]), boxes[m].high[d] = std::max(boxes[m].high[d], x[d]);
    for (std::size_t f = 0; f < materials[m].fields.size(); ++f) {
      const ParameterField& field = materials[m].fields[f];
      found[m][f].add(fields.values[first + f], soils.materials[m].type->parameters[field.parameter].range, x);
    }
  }
  std::vector<Problem> problems;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    for (std::size_t f = 0; f < found[m].size(); ++f) {
      const ParameterField& field = materials[m].fields[f];
      const FieldRange& values = found[m][f];
      if (values.n == 0) continue;
      check_covers(materials[m], field, boxes[m]);
      const ParameterInfo& info = soils.materials[m].type->parameters[field.parameter];
      if (values.n_outside > 0 && !follows_a_wrong_one(materials[m], field, found[m]))
        problems.push_back(outside_its_range(materials[m], info, values));
      materials[m].parameters[field.parameter] = values.sum / static_cast<Real>(values.n);
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  for (std::size_t m = 0; m < materials.size(); ++m)
    if (!materials[m].fields.empty()) {
      const MaterialType& type = *soils.materials[m].type;
      soils.materials[m].law = type.make_varying(materials[m].parameters, varying_parameters(materials[m], type));
    }
  return fields;
}

void find_uncovered_soil(const Model& model, const StepState& state, std::vector<Problem>& warnings)
{
  for (std::size_t m = 0; m < model.materials.size(); ++m)
    for (const ParameterField& field : model.description.materials[m].fields)
      for (const FieldCover& cover : field.needs.covers) {
        Index n = 0, n_outside = 0;
        Real farthest = 0.0;
        for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
          if (block.material != static_cast<Index>(m)) return;
          ++n;
          const Vec<2> x{block.row(Rows::x)[lane], block.row(Rows::x + 1)[lane]};
          if (is_in(cover, x)) return;
          ++n_outside;
          const auto beyond = [&](int d) { return std::max({cover.low[d] - x[d], x[d] - cover.high[d], 0.0}); };
          farthest = std::max(farthest, std::hypot(beyond(0), beyond(1)));
        });
        if (n_outside == 0) continue;
        const MaterialCase& material = model.description.materials[m];
        warnings.push_back({parameter_key(material, model.materials[m].type->parameters[field.parameter].name),
            fmt::format("the table `{}` does not cover all of the soil", cover.file),
            fmt::format("{}; {} of {} points of `{}` lie outside, by up to {:.3g} m. They take the value of the "
                        "nearest places.",
                cover_text(cover), n_outside, n, material.name, farthest),
            "material"});
      }
}

}  // namespace terp
