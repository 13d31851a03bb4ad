// Values are codes from the start, so that fit() can halve their steps in place: the scale of a field, and of those
// that share its codes, must be doubled with them. Points are chosen by their numbers alone, so that each run of the
// command shows the same. Halving them looks at one bit of a scrambled number after another. Ends of colour scales come
// from quantiles: a few points that shear most would take all of the colours.

#include "page/shown.hpp"

#include "page/thin.hpp"
#include "run/report/frame_fields.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace terp {
namespace {

// Steps of a place at first: a fiftieth of the distance of two neighbouring points, or what a reader of centimetres
// sees if that is more, but never more than a tenth of the distance.
constexpr Real finest_per_spacing = 50.0, coarsest_per_spacing = 10.0, fine_enough = 0.002;  // m
constexpr std::size_t light_bytes = 2'000'000;  // of codes: with them a page still goes by mail
constexpr Real on_log_scale = 400.0;            // colours: more of them than of a field that is drawn on a linear scale
constexpr Real strained = 0.06;  // strain of soil by which a range of colours ends: a matter of the picture alone

constexpr Real softened_to = 0.9, few_softened = 0.01;  // of the first strength; share of the points: of colours alone

using Values = std::vector<std::vector<float>>;  // by frame and point

/// How a shown field comes from those in the file. label: "" is that of the source.
struct Recipe {
  std::string name, source, symbol, label, unit, kind;
  Real factor = 1.0;  ///< shown over stored
  enum class Take { value, size, mean_stress } take = Recipe::Take::value;
  Real colours = 200.0;  ///< that the scale is made of, at least; noisy fields, which cost most, have fewer
};

std::string label_of_field(const std::string& name)
{
  const auto fields = all_frame_fields();
  const auto known = std::ranges::find(fields, name, &FrameField::name);
  return known == fields.end() ? name : known->label;  // of a run of another version of Terp
}

std::vector<Recipe> all_recipes(const Frames& frames)
{
  using Take = Recipe::Take;
  std::vector<Recipe> recipes = {
      {"eps_eq_p", "eps_eq_p", "ε_eq,p", "equivalent plastic strain", "-", "sequential", 1.0, Take::value,
          on_log_scale},
      {"eps_deviatoric", "eps_deviatoric", "ε_dev", "", "-", "sequential", 1.0, Take::value, on_log_scale},
      {"su", "su", "S_u", "undrained shear strength", "kPa", "sequential", 1e-3},
      {"pressure", "stress", "p", "mean stress, tension positive", "kPa", "diverging", 1e-3, Take::mean_stress, 100.0},
      {"pore_pressure", "pore_pressure", "p_w", "", "kPa", "sequential", 1e-3},
      {"head", "head", "h", "", "m", "sequential"},
      {"excess_pressure", "excess_pressure", "u_e", "", "kPa", "diverging", 1e-3, Take::value, 100.0},
      {"velocity", "velocity", "|v|", "speed", "m/s", "sequential", 1.0, Take::size, 100.0},
      {"displacement", "displacement", "|u|", "", "m", "sequential", 1.0, Take::size},
      {"material", "material", "", "", "-", "category"},
  };
  const auto known = [&](const std::string& name) {
    return name == "volume" || name == "cell" ||
           std::ranges::any_of(recipes, [&](const Recipe& r) { return r.source == name; });
  };
  for (const ResultField& field : frames.fields())  // state and derived fields of other laws
    if (field.n_components == 1 && !known(field.name))
      recipes.insert(recipes.end() - 1, field.unit == "Pa"
                                            ? Recipe{field.name, field.name, field.name, "", "kPa", "sequential", 1e-3}
                                            : Recipe{field.name, field.name, field.name, "", field.unit, "sequential"});
  std::erase_if(recipes, [&](const Recipe& r) {
    return !frames.has(r.source) || (r.take == Take::mean_stress && frames.field(r.source).n_components < 3);
  });
  for (Recipe& recipe : recipes)
    if (recipe.label.empty()) recipe.label = label_of_field(recipe.source);
  return recipes;
}

std::vector<float> read_values(
    const Frames& frames, const Recipe& recipe, std::size_t k, const std::vector<std::uint32_t>& ids)
{
  std::vector<Real> stored = frames.read(recipe.source, k);
  const int n = frames.field(recipe.source).n_components;
  if (recipe.take == Recipe::Take::size) stored = magnitudes(stored, n);
  std::vector<float> values(ids.size());
  for (std::size_t p = 0; p < ids.size(); ++p) {
    const Real* at = &stored[recipe.take == Recipe::Take::mean_stress ? static_cast<std::size_t>(n) * ids[p] : ids[p]];
    const Real value = recipe.take == Recipe::Take::mean_stress ? (at[0] + at[1] + at[2]) / 3.0 : at[0];
    values[p] = static_cast<float>(recipe.factor * value);
  }
  return values;
}

/// Finite values of every frame, about a million of them.
std::vector<float> sample_of(const Values& values)
{
  const std::size_t total = values.size() * values[0].size(), stride = total / 1'000'000 + 1;
  std::vector<float> sample;
  std::size_t k = 0;
  for (const auto& frame : values)
    for (const float v : frame)
      if (k++ % stride == 0 && std::isfinite(v)) sample.push_back(v);
  return sample;
}

/// Brings values into another order.
Real quantile(std::vector<float>& values, Real part)
{
  if (values.empty()) return 0.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<Real>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

/// The next number of the kind a colour scale ends well with.
Real round_up(Real value)
{
  if (!(value > 0.0)) return 1.0;
  const Real power = std::pow(10.0, std::floor(std::log10(value)));
  for (const Real step : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (value <= step * power * (1.0 + 1e-9)) return step * power;
  return 10.0 * power;
}

/// The upper quartile of the strain of the points that have sheared in the end: the thin basal layer shears ten times
/// as much as the slip surfaces and would leave those dark.
Real end_of_strain_scale(const Values& values)
{
  std::vector<float> sheared;
  for (const float v : values.back())
    if (v > strained) sheared.push_back(v);
  return round_up(sheared.empty() ? strained : quantile(sheared, 0.75));
}

void set_colour_range(ShownField& field, const Values& values)
{
  std::vector<float> sample = sample_of(values);
  const Real low = quantile(sample, 0.01), high = quantile(sample, 0.99);
  if (field.name.starts_with("eps_")) {
    field.high = end_of_strain_scale(values);
  } else if (field.kind == "diverging") {
    field.high = round_up(std::max(std::abs(low), std::abs(high)));
    field.low = -field.high;
  } else if (field.kind == "category") {
    field.high = sample.empty() ? 0.0 : *std::ranges::max_element(sample);
  } else {
    field.high = round_up(high);
    field.low = low < 0.0 ? -round_up(-low) : 0.0;
  }
}

/// The longest of the steps 1, 2 and 5 times a power of ten that is not longer than `most`.
Real round_step(Real most)
{
  const Real power = std::pow(10.0, std::floor(std::log10(most)));
  const Real lead = most / power * (1.0 + 1e-9);
  return (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0) * power;
}

/// high: end of the colour scale; none: of what the values are.
ShownField make_field(const Recipe& recipe, const Values& values, std::optional<Real> high = std::nullopt)
{
  ShownField field{
      .name = recipe.name, .symbol = recipe.symbol, .label = recipe.label, .unit = recipe.unit, .kind = recipe.kind};
  set_colour_range(field, values);
  if (high) field.high = *high;
  Real lo = std::numeric_limits<Real>::infinity(), hi = -lo;
  for (const auto& frame : values)
    for (const float v : frame)
      if (std::isfinite(v)) lo = std::min(lo, Real{v}), hi = std::max(hi, Real{v});
  if (lo > hi) lo = hi = 0.0;
  const Real end = std::max(std::abs(field.low), std::abs(field.high));
  const Real step = recipe.kind == "category" ? 1.0 : round_step(end / recipe.colours);
  field.scale = make_scale(step * std::floor(lo / step), hi, step);  // from a round number: a hover shows whole steps
  for (const auto& frame : values) {
    const std::vector<Real> wide(frame.begin(), frame.end());
    field.frames.push_back(quantise(wide, field.scale));
  }
  return field;
}

/// The value with which each point began, also one of a body that a stage places; NaN: it has none.
std::vector<float> first_of(const Values& values)
{
  std::vector<float> first = values[0];
  for (const auto& frame : values)
    for (std::size_t p = 0; p < first.size(); ++p)
      if (std::isnan(first[p])) first[p] = frame[p];
  return first;
}

/// The strength with which soil began that has softened by a tenth or more: a strong layer below it, which nothing
/// shears, would take most of the colours. None if hardly any has softened.
std::optional<Real> end_of_strength_scale(const Values& values)
{
  const std::vector<float> first = first_of(values);
  std::vector<float> softened;
  for (std::size_t p = 0; p < first.size(); ++p)
    if (values.back()[p] < softened_to * first[p]) softened.push_back(first[p]);
  if (static_cast<Real>(softened.size()) < few_softened * static_cast<Real>(first.size())) return std::nullopt;
  return round_up(quantile(softened, 0.99));
}

/// Ratios run to 1, and down to the tenth that the smallest of them reaches; to a half where little softens.
Real begin_of_ratio_scale(const std::vector<float>& first, const std::vector<float>& last)
{
  Real least = 0.5;
  for (std::size_t p = 0; p < first.size(); ++p)
    if (first[p] > 0.0f && std::isfinite(last[p])) least = std::min<Real>(least, last[p] / first[p]);
  return std::max(0.0, std::floor(10.0 * least) / 10.0);
}

/// S_u over its first value. Where all points began with one strength, it has the codes of S_u.
ShownField strength_ratio(const ShownField& su, int index, const Values& values)
{
  const std::vector<float> first = first_of(values);
  ShownField ratio{.name = "su_ratio",
      .symbol = "S_u/S_u,0",
      .label = "strength left of the first",
      .unit = "-",
      .kind = "sequential",
      .low = begin_of_ratio_scale(first, values.back()),
      .shares = index};
  if (std::ranges::all_of(first, [&](float v) { return v == first[0]; }) && first[0] > 0.0f) {
    ratio.scale = {su.scale.lo / first[0], su.scale.step / first[0]};
    return ratio;
  }
  Values ratios = values;
  for (auto& frame : ratios)
    for (std::size_t p = 0; p < frame.size(); ++p) frame[p] /= first[p];
  const Recipe recipe{ratio.name, "su", ratio.symbol, ratio.label, ratio.unit, ratio.kind};
  ShownField own = make_field(recipe, ratios);
  own.low = ratio.low, own.high = 1.0;
  return own;
}

/// A whole number that looks like chance, from an id (multiplicative hashing: Knuth, TAOCP 3, 6.4).
std::uint32_t scramble(std::int64_t id) { return static_cast<std::uint32_t>(id) * 2654435761u; }

std::vector<std::uint32_t> choose_points(std::int64_t n, std::int64_t n_most)
{
  const double share = n > n_most ? static_cast<double>(n_most) / static_cast<double>(n) : 1.0;
  std::vector<std::uint32_t> ids;
  for (std::int64_t id = 0; id < n; ++id)
    if (share >= 1.0 || scramble(id) < share * 4294967296.0) ids.push_back(static_cast<std::uint32_t>(id));
  return ids;
}

/// Typical distance of the points shown, which fill the soil of the first frame [m].
Real spacing_of(const Frames& frames, const std::vector<std::uint32_t>& ids)
{
  const auto x = frames.places(0);
  const auto n = std::ranges::count_if(ids, [&](std::uint32_t id) { return is_soil(x, id); });
  Real area = 0.0;
  if (frames.has("volume")) {
    for (const Real v : frames.read("volume", 0))
      if (v > 0.0) area += v;
  } else {
    constexpr Real inf = std::numeric_limits<Real>::infinity();
    Real low[2] = {inf, inf}, high[2] = {-inf, -inf};
    for (std::size_t k = 0; k < x.size(); ++k)
      if (is_soil(x, k / 2)) low[k % 2] = std::min(low[k % 2], x[k]), high[k % 2] = std::max(high[k % 2], x[k]);
    area = (high[0] - low[0]) * (high[1] - low[1]);
  }
  return std::sqrt(area / static_cast<Real>(std::max<std::ptrdiff_t>(1, n)));
}

void read_places(const Frames& frames, ShownRun& shown, const LookAtPlaces& look)
{
  std::vector<std::vector<Real>> x, y;
  Real inf = std::numeric_limits<Real>::infinity();
  shown.bounds = {inf, inf, -inf, -inf};
  for (const std::size_t k : shown.frames) {
    const auto places = frames.places(k);
    look(shown, places);
    x.emplace_back();
    y.emplace_back();
    for (const std::size_t id : shown.ids) {
      const Real px = places[2 * id], py = places[2 * id + 1];
      x.back().push_back(px);
      y.back().push_back(py);
      auto& b = shown.bounds;
      if (!is_soil(places, id)) continue;
      b = {std::min(b[0], px), std::min(b[1], py), std::max(b[2], px), std::max(b[3], py)};
    }
  }
  const Real step =
      std::max(shown.point_size / finest_per_spacing, std::min(fine_enough, shown.point_size / coarsest_per_spacing));
  shown.x = make_scale(shown.bounds[0], shown.bounds[2], step);
  shown.y = make_scale(shown.bounds[1], shown.bounds[3], step);
  for (std::size_t f = 0; f < x.size(); ++f) {
    shown.x_codes.push_back(quantise(x[f], shown.x));
    shown.y_codes.push_back(quantise(y[f], shown.y));
  }
}

/// How far the points are from where the first frame has them [m]; NaN where one of both has no soil.
std::vector<float> distances(const ShownRun& shown, std::size_t f)
{
  std::vector<float> gone(shown.ids.size(), std::numeric_limits<float>::quiet_NaN());
  const Codes &x = shown.x_codes[f], &y = shown.y_codes[f], &x0 = shown.x_codes[0], &y0 = shown.y_codes[0];
  for (std::size_t p = 0; p < gone.size(); ++p)
    if (x[p] != no_value && x0[p] != no_value)
      gone[p] = static_cast<float>(std::hypot(shown.x.step * (x[p] - x0[p]), shown.y.step * (y[p] - y0[p])));
  return gone;
}

/// Whether displacements are these distances, to the rounding of places: in a few frames, as bodies are all that there
/// is from the start.
bool follow_from_places(const Frames& frames, const Recipe& recipe, const ShownRun& shown)
{
  for (const Codes& x : shown.x_codes)
    for (std::size_t p = 0; p < x.size(); ++p)
      if (x[p] != no_value && shown.x_codes[0][p] == no_value) return false;
  const Real most = 1.5 * std::max(shown.x.step, shown.y.step);
  const std::size_t last = shown.frames.size() - 1;
  for (const std::size_t f : {last, last / 2}) {
    const std::vector<float> stored = read_values(frames, recipe, shown.frames[f], shown.ids),
                             gone = distances(shown, f);
    for (std::size_t p = 0; p < gone.size(); ++p)
      if (!std::isnan(gone[p]) && !(std::abs(gone[p] - stored[p]) <= most)) return false;
  }
  return true;
}

void read_fields(const Frames& frames, ShownRun& shown)
{
  for (const Recipe& recipe : all_recipes(frames)) {
    Values values;
    const bool of_places = recipe.name == "displacement" && follow_from_places(frames, recipe, shown);
    for (std::size_t f = 0; f < shown.frames.size(); ++f)
      values.push_back(of_places ? distances(shown, f) : read_values(frames, recipe, shown.frames[f], shown.ids));
    const auto high = recipe.name == "su" ? end_of_strength_scale(values) : std::nullopt;
    ShownField& field = shown.fields.emplace_back(make_field(recipe, values, high));
    const bool never_changes = std::ranges::all_of(field.frames, [&](const Codes& c) { return c == field.frames[0]; });
    if (recipe.kind == "category" && never_changes) field.frames.resize(1);
    if (of_places) {
      field.of_places = true;
      field.frames.clear();
      const auto& b = shown.bounds;
      field.scale = make_scale(0.0, std::hypot(b[2] - b[0], b[3] - b[1]), std::max(shown.x.step, shown.y.step));
    }
    if (recipe.name == "su")
      shown.fields.push_back(strength_ratio(field, static_cast<int>(shown.fields.size()) - 1, values));
  }
}

void for_each_array(
    std::vector<ShownRun>& runs, const std::function<void(ShownRun&, std::vector<Codes>&, Scale*, bool is_place)>& f)
{
  for (ShownRun& run : runs) {
    f(run, run.x_codes, &run.x, true);
    f(run, run.y_codes, &run.y, true);
    for (ShownField& field : run.fields)
      if (!field.frames.empty()) f(run, field.frames, field.kind == "category" ? nullptr : &field.scale, false);
  }
}

void coarsen_arrays(std::vector<ShownRun>& runs, bool places)
{
  for_each_array(runs, [&](ShownRun& run, std::vector<Codes>& frames, Scale* scale, bool is_place) {
    if (is_place != places || scale == nullptr) return;
    if (places && 2.0 * coarsest_per_spacing * scale->step > run.point_size) return;
    for (Codes& codes : frames) coarsen(codes, 2);
    scale->step *= 2.0;
  });
  for (ShownRun& run : runs)
    for (ShownField& field : run.fields)
      if (!places && field.shares >= 0) field.scale.step *= 2.0;
}

template <class T>
void keep(std::vector<T>& values, const std::vector<std::size_t>& kept)
{
  std::vector<T> some;
  for (const std::size_t k : kept) some.push_back(std::move(values[k]));
  values = std::move(some);
}

void leave_out_frames(std::vector<ShownRun>& runs)
{
  for (ShownRun& run : runs) {
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < run.frames.size(); ++k)
      if (k % 2 == 0 || k + 1 == run.frames.size()) kept.push_back(k);
    keep_frames(run, kept);
  }
}

/// halving: how often that was done before.
void leave_out_points(std::vector<ShownRun>& runs, int halving)
{
  const auto goes = [bit = 0x10000u << halving](std::uint32_t id) { return (scramble(id) & bit) != 0u; };
  for_each_array(runs, [&](ShownRun& run, std::vector<Codes>& frames, Scale*, bool) {
    for (Codes& codes : frames) {
      std::size_t n = 0;
      for (std::size_t p = 0; p < codes.size(); ++p)
        if (!goes(run.ids[p])) codes[n++] = codes[p];
      codes.resize(n);
    }
  });
  for (ShownRun& run : runs) {
    std::erase_if(run.ids, goes);
    run.point_size *= std::sqrt(2.0);
  }
}

std::size_t fewest_frames(const std::vector<ShownRun>& runs)
{
  std::size_t n = SIZE_MAX;
  for (const ShownRun& run : runs) n = std::min(n, run.frames.size());
  return n;
}

}  // namespace

ShownRun read_shown(const Frames& frames, std::int64_t n_most, const LookAtPlaces& look)
{
  ShownRun shown{.n_points = frames.n_points(),
      .ids = choose_points(frames.n_points(), n_most),
      .n_frames_in_run = frames.times().size(),
      .times = frames.times()};
  for (std::size_t k = 0; k < shown.n_frames_in_run; ++k) shown.frames.push_back(k);
  shown.point_size = spacing_of(frames, shown.ids);
  read_places(frames, shown, look);
  read_fields(frames, shown);
  return shown;
}

void keep_frames(ShownRun& run, const std::vector<std::size_t>& kept)
{
  keep(run.frames, kept);
  keep(run.times, kept);
  keep(run.x_codes, kept);
  keep(run.y_codes, kept);
  for (ShownField& field : run.fields)
    if (field.frames.size() > 1) keep(field.frames, kept);
}

std::size_t estimate_bytes(const std::vector<ShownRun>& runs)
{
  std::size_t bytes = 0;
  for (const ShownRun& run : runs) {
    bytes += best_packing(run.x_codes).bytes + best_packing(run.y_codes).bytes;
    for (const ShownField& field : run.fields)
      if (!field.frames.empty()) bytes += best_packing(field.frames).bytes;
  }
  return bytes;
}

void fit(std::vector<ShownRun>& runs, std::size_t most_bytes)
{
  std::size_t bytes = estimate_bytes(runs);
  if (bytes > light_bytes) {
    leave_out_unmissed_frames(runs);
    bytes = estimate_bytes(runs);
  }
  int halvings = 0;
  for (int round = 0; round < 16 && bytes > most_bytes; ++round) {
    const std::size_t n_frames = fewest_frames(runs);
    if (round < 1)
      coarsen_arrays(runs, false);  // to 100 colours, of noisy fields 50
    else if (round < 3)
      coarsen_arrays(runs, true);
    else if (n_frames > 60)
      leave_out_frames(runs);
    else if (round < 5)
      coarsen_arrays(runs, false);
    else if (n_frames > 20)
      leave_out_frames(runs);
    else
      leave_out_points(runs, halvings++);
    bytes = estimate_bytes(runs);
  }
}

}  // namespace terp
