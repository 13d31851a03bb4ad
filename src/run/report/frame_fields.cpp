// Of several laws with a field of the same name there is one field; each point reads it from its own law, or has NaN.
// `all_frame_fields` lists names for the help without a model: a new source must be added there as well.

#include "run/report/frame_fields.hpp"

#include "math/nan.hpp"
#include "math/quantity.hpp"
#include "run/report/ledger.hpp"
#include "model/water/nodal_water.hpp"

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

/// A point of a run.
struct PointOfRun {
  const Model& model;
  const State& state;
  const PointBlock<2>& block;
  Index lane;
};
using P = const PointOfRun&;

/// A field that follows from the rows of any point. read: its n_components values.
struct CommonField {
  QuantityInfo info;
  int n_components;
  void (*read)(P point, Real* out);
};

const CommonField common_fields[] = {
    {{"displacement", "m", "displacement", "displacement since t = 0"}, 3,
        [](P p, Real* out) {
          const auto id = static_cast<std::size_t>(p.block.row(Rows::id)[p.lane]);
          for (int d = 0; d < 2; ++d) out[d] = p.block.row(Rows::x + d)[p.lane] - p.state.x_initial[2 * id + d];
        }},
    {{"material", "-", "material", "number of the material, from 0 in the order of the case file"}, 1,
        [](P p, Real* out) { *out = p.block.material; }},
    {{"cell", "-", "cell", "number of the cell that holds the point"}, 1, [](P p, Real* out) { *out = p.block.cell; }},
    {{"eps_deviatoric", "-", "total deviatoric strain", "total deviatoric strain, sqrt(1/2 e:e)"}, 1,
        [](P p, Real* out) { *out = deviatoric_strain(p.block, p.lane); }},
};

constexpr QuantityInfo pore_pressure{"pore_pressure", "Pa", "pore pressure",
    "pressure of the water at the point, in the soil or around it; suction is negative"};

constexpr QuantityInfo head{
    "head", "m", "head", "head of computed water, y + pore_pressure/unit_weight; NaN where the soil is dry"};

/// "current cohesion" of "current cohesion, Eq. (5)".
std::string label_of(std::string_view meaning) { return std::string(meaning.substr(0, meaning.find(','))); }

FrameField field_of(const RowInfo& row)
{
  return {.name = row.name,
      .unit = row.unit,
      .label = label_of(row.meaning),
      .meaning = row.meaning,
      .n_components = row.n == 2 ? 3 : row.n,  // vectors have three components, as viewers expect
      .by_default = row.name != "strain"};     // four numbers per point, which eps_deviatoric sums up
}

FrameField field_of(const CommonField& common)
{
  const QuantityInfo& info = common.info;
  return {.name = std::string(info.name),
      .unit = std::string(info.unit),
      .label = std::string(info.label),
      .meaning = std::string(info.meaning),
      .n_components = common.n_components};
}

FrameField field_of(const auto& info)
{
  return {.name = std::string(info.name),
      .unit = std::string(info.unit),
      .label = label_of(info.meaning),
      .meaning = std::string(info.meaning)};
}

bool has(const std::vector<FrameField>& fields, std::string_view name)
{
  return std::ranges::find(fields, name, &FrameField::name) != fields.end();
}

/// read(block, lane, out): the values of one point.
template <class F>
void add(FrameField field, F read, std::vector<FrameField>& fields)
{
  field.read = [read, n = field.n_components](const PointBlock<2>& block, FrameField::Places places, Real* values) {
    for_each_place(block, places, n, values, [&](Index lane, Real* out) { read(block, lane, out); });
  };
  fields.push_back(std::move(field));
}

/// As the forces of the present step have it.
void add_water(const Model& model, const State& state, std::vector<FrameField>& fields)
{
  const auto pore = std::make_shared<PorePressure>(water_at(model, state));
  const auto read = [&model, pore](const PointBlock<2>& block, Index lane, Real* out) {
    *out = pore_pressure_at(model, *pore, block, lane);
  };
  add(field_of(CommonField{pore_pressure, 1, nullptr}), read, fields);
  if (model.description.water.kind != WaterKind::seepage) return;
  const auto read_head = [&model, pore](const PointBlock<2>& block, Index lane, Real* out) {
    const Real pressure = pore_pressure_at(model, *pore, block, lane);
    *out = pressure > 0.0 ? block.row(Rows::x + 1)[lane] + pressure / model.description.water.unit_weight : nan;
  };
  add(field_of(CommonField{head, 1, nullptr}), read_head, fields);
}

/// NaN at points whose material does not have the row.
void add_row(const RowInfo& row, std::vector<FrameField>& fields)
{
  const auto read = [&row](const PointBlock<2>& block, Index lane, Real* out) {
    const bool there = row.is_of(block.material);
    for (int k = 0; k < row.n; ++k) out[k] = there ? block.row(row.first + k)[lane] : nan;
  };
  add(field_of(row), read, fields);
}

/// NaN at points whose law has no such field.
void add_derived(const Model& model, const DerivedInfo& info, std::vector<FrameField>& fields)
{
  const auto read = [&model, name = info.name](const PointBlock<2>& block, Index lane, Real* out) {
    const SoilMaterial& material = model.materials[block.material];
    const int k = find_name(material.type->derived, name);
    *out = k < 0 ? nan : material.law->derived(k, material.view(block, lane));
  };
  add(field_of(info), read, fields);
}

}  // namespace

std::vector<FrameField> frame_fields(const Model& model, const State& state)
{
  std::vector<FrameField> fields;
  for (const RowInfo& row : model.rows.entries())
    if (row.shown) add_row(row, fields);
  for (const CommonField& common : common_fields) {
    const auto read = [&model, &state, &common](const PointBlock<2>& block, Index lane, Real* out) {
      common.read({model, state, block, lane}, out);
    };
    add(field_of(common), read, fields);
  }
  if (model.with.water) add_water(model, state, fields);
  for (const SoilMaterial& of : model.materials)
    for (const DerivedInfo& info : of.type->derived)
      if (!has(fields, info.name)) add_derived(model, info, fields);
  return fields;
}

std::vector<FrameField> frame_fields_of(const MaterialType& law)
{
  std::vector<FrameField> fields;
  for (const StateInfo& state : law.nonlocal != nullptr ? law.nonlocal->state : law.state)
    if (state.shown && !state.scratch) fields.push_back(field_of(state));
  for (const DerivedInfo& derived : law.derived) fields.push_back(field_of(derived));
  for (const ParameterInfo& parameter : law.parameters)
    if (parameter.may_vary) fields.push_back(field_of(row_of_parameter(parameter)));
  return fields;
}

std::vector<FrameField> all_frame_fields()
{
  std::vector<FrameField> fields;
  const RowTable any_point;
  for (const RowInfo& row : any_point.entries())
    if (row.shown) fields.push_back(field_of(row));
  for (const CommonField& common : common_fields) fields.push_back(field_of(common));
  for (const QuantityInfo& info : {pore_pressure, head}) fields.push_back(field_of(CommonField{info, 1, nullptr}));
  fields.push_back(field_of(row_of_excess_pressure()));
  for (const MaterialType* law : all_materials())
    for (FrameField& field : frame_fields_of(*law))
      if (!has(fields, field.name)) fields.push_back(std::move(field));
  return fields;
}

Real deviatoric_strain(const PointBlock<2>& block, Index lane)
{
  std::array<Real, 4> strain;
  for (int k = 0; k < n_sym<2>; ++k) strain[k] = block.row(Rows::strain + k)[lane];
  return deviatoric_strain(strain);
}

Real deviatoric_strain(const std::array<Real, 4>& strain)
{
  const Real mean = (strain[0] + strain[1] + strain[2]) / 3.0;
  Real square = 2.0 * strain[3] * strain[3];
  for (int k = 0; k < 3; ++k) square += (strain[k] - mean) * (strain[k] - mean);
  return std::sqrt(square * 0.5);
}

}  // namespace terp
