// Values are written in three layers: what no point of this id has, the points that are there, the points that left. A
// frame may be a part of the ids; those outside of it turn into `nowhere`.

#include "run/report/frame.hpp"

#include "run/report/frame_fields.hpp"

#include <algorithm>

namespace terp {
namespace {

std::size_t id_of(const PointBlock<2>& block, Index lane)
{
  return static_cast<std::size_t>(block.row(Rows::id)[lane]);
}

bool wanted(const Model& model, const FrameField& field)
{
  const auto& names = model.description.output.field_names;
  return names.empty() ? field.by_default : std::ranges::find(names, field.name) != names.end();
}

/// Points of bodies that are not there, or no longer: at their first place, with volume 0, material -1 and cell -1.
void mark_absent(const State& state, Frame& frame)
{
  if (state.points.n_points() + std::ssize(state.left) == state.n_ids()) return;
  const auto first = state.x_initial.begin() + static_cast<std::ptrdiff_t>(2 * frame.first);
  std::copy_n(first, frame.x.size(), frame.x.begin());
  for (PointField& field : frame.fields)
    if (field.name == "material" || field.name == "cell") std::ranges::fill(field.values, -1.0);
}

/// Points that left the mesh stay in the frames where they left, with volume 0, material -1 and cell -1.
void mark_left(const State& state, Frame& frame)
{
  for (const LeftPoint& point : state.left) {
    if (point.id < frame.first || point.id >= frame.first + frame.n_points()) continue;
    const auto k = static_cast<std::size_t>(point.id - frame.first);
    for (int d = 0; d < 2; ++d) frame.x[2 * k + d] = point.x[d];
    for (PointField& field : frame.fields)
      if (field.name == "material" || field.name == "cell") field.values[k] = -1.0;
  }
}

Frame gather_frame(const State& state, const std::vector<FrameField>& fields, std::int64_t first, std::int64_t n)
{
  const auto size = static_cast<std::size_t>(n);
  Frame frame{.time = state.time,
      .step = state.step,
      .x = std::vector<Real>(2 * size),
      .fields = {},
      .first = first,
      .n_all = state.n_ids()};
  for (const FrameField& field : fields)
    frame.fields.push_back(
        {field.name, field.unit, field.n_components, std::vector<Real>(size * field.n_components, 0.0)});
  mark_absent(state, frame);
  std::vector<std::size_t> places;
  for_each_block(state.points, [&](const PointBlock<2>& block) {
    places.clear();
    for (Index lane = 0; lane < block.n; ++lane) {
      const std::size_t place = id_of(block, lane) - static_cast<std::size_t>(first);  // wraps below `first`
      places.push_back(place < size ? place : FrameField::nowhere);
    }
    for_each_place(block, places, 2, frame.x.data(), [&](Index lane, Real* out) {
      for (int d = 0; d < 2; ++d) out[d] = block.row(Rows::x + d)[lane];
    });
    for (std::size_t k = 0; k < fields.size(); ++k) fields[k].read(block, places, frame.fields[k].values.data());
  });
  mark_left(state, frame);
  return frame;
}

}  // namespace

std::optional<PointField> make_field(
    const Model& model, const State& state, const std::string& name, std::vector<std::string>& names)
{
  std::vector<FrameField> fields = frame_fields(model, state);
  names = {"position"};
  for (const FrameField& field : fields) names.push_back(field.name);
  std::erase_if(fields, [&](const FrameField& field) { return field.name != name; });
  if (fields.empty() && name != "position") return {};
  Frame frame = gather_frame(state, fields, 0, state.n_ids());
  if (fields.empty()) return PointField{"position", "m", 2, std::move(frame.x)};
  return std::move(frame.fields[0]);
}

Frame make_frame(const Model& model, const State& state) { return make_frame(model, state, 0, state.n_ids()); }

Frame make_frame(const Model& model, const State& state, std::int64_t first, std::int64_t n)
{
  std::vector<FrameField> fields = frame_fields(model, state);
  std::erase_if(fields, [&](const FrameField& field) { return !wanted(model, field); });
  return gather_frame(state, fields, first, n);
}

}  // namespace terp
