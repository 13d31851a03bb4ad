// Whether the ground still holds the water between river and land, at each ledger row and at the end. Definitions:
// docs/flood.md. Not for: how the ground is measured (model/ground/barrier), nor for water that flows over it.

#include "run/measure/crest.hpp"
#include "run/measure/followers.hpp"
#include "run/measure/moved_depth.hpp"
#include "run/measure/settled_ground.hpp"
#include "model/water/free_water.hpp"
#include "model/ground/ground_section.hpp"
#include "run/loop/stages.hpp"
#include "run/report/ledger_context.hpp"
#include "run/report/mesh_frame.hpp"
#include "mpm/features/rest.hpp"
#include "mpm/step/node_passes.hpp"
#include "mpm/step/state_arrays.hpp"
#include "run/report/summary.hpp"

#include <cmath>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr Real never = std::numeric_limits<Real>::quiet_NaN();
constexpr Real round_off = 1e-9;   // of heights and widths [m]
constexpr Real slid_share = 0.05;  // of the square of the relief: a small slide of a toe or a berm
constexpr Real flood_time = 2.0;   // for which ground must stay below the level; a dip is shorter [s]

std::optional<Real> known(Real value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

/// The end of the section at which the river is: as the case or the water says, or where the ground lies below the
/// level if that at the other end does not.
std::optional<Facing> river_side(const FloodLevel& level, const StandingGround& ground)
{
  if (level.river) return level.river;
  const auto stands = [](Real height) { return std::isfinite(height); };
  const auto left = std::ranges::find_if(ground.heights, stands);
  const auto right = std::find_if(ground.heights.rbegin(), ground.heights.rend(), stands);
  if (left == ground.heights.end() || (*left >= ground.level) == (*right >= ground.level)) return std::nullopt;
  return *left < ground.level ? Facing::left : Facing::right;
}

std::string criterion_text(const FloodCase& flood, Real level, const RiverBeforeTrigger& river)
{
  std::string text = fmt::format(
      "it floods where no ground between river and land stands at {:g} m or higher", level + flood.smallest_freeboard);
  if (river.n_stages > 0 && std::isfinite(river.level))
    text += fmt::format(" (before the trigger: {:g} m)", river.level + flood.smallest_freeboard);
  if (flood.smallest_freeboard > 0.0)
    text += fmt::format(", {:g} m over the water at {:g} m", flood.smallest_freeboard, level);
  if (flood.smallest_width > 0.0)
    text += fmt::format(", or where the ground is less than {:g} m wide at {:g} m", flood.smallest_width, level);
  return text;
}

/// Whether two models judge the same ground against the same water by the same criterion.
bool is_judged_alike(const Model& a, const Model& b)
{
  const FloodCase &of_a = a.description.flood, &of_b = b.description.flood;
  return a.flood_level.is_known() && a.flood_level.value == b.flood_level.value &&
         a.flood_level.river == b.flood_level.river && of_a.smallest_freeboard == of_b.smallest_freeboard &&
         of_a.smallest_width == of_b.smallest_width && of_a.intact_below == of_b.intact_below &&
         of_a.least_depth == of_b.least_depth;
}

/// Level of the river in the water of a stage [m]; none: the stage has no water of its own, or none of lines.
std::optional<Real> river_of(const Case& c, const StageCase& stage, std::optional<Facing> river)
{
  const auto is_named = [&](const WaterSituation& water) { return water.name == stage.water; };
  const auto found = std::ranges::find_if(c.water.situations, is_named);
  if (stage.water.empty() || found == c.water.situations.end() || found->phreatic_line.empty()) return std::nullopt;
  return river == Facing::right ? found->phreatic_line.back()[1] : found->phreatic_line.front()[1];
}

/// The first stage so far that is there to make the section fail, or from which on strengths are divided. A stage that
/// holds the soil for those after it is none.
std::optional<std::size_t> trigger_stage(const Case& c, std::size_t now)
{
  std::optional<std::size_t> first;
  bool is_weaker = true;  // from here to the present stage
  for (std::size_t k = now + 1; k-- > 0;) {
    const Real divided_by = c.stages[k].changed->at_strength;
    is_weaker = is_weaker && (divided_by > 1.0 || (divided_by < 1.0 && now + 1 == c.stages.size()));
    if (is_weaker || c.stages[k].trigger) first = k;
  }
  return first;
}

/// at_strength at a time, if that lies in a stage over whose ramp it changes.
std::optional<Real> at_strength_at(
    const Case& c, const std::vector<StageSummary>& stages, const std::optional<Real>& time)
{
  const std::string name = stage_at(stages, time);
  const auto stage = std::ranges::find(c.stages, name, &StageCase::name);
  const auto summary = std::ranges::find(stages, name, &StageSummary::name);
  if (name.empty() || stage == c.stages.end() || stage == c.stages.begin() || !(stage->ramp > 0.0)) return std::nullopt;
  const Real before = (stage - 1)->changed->at_strength, now = stage->changed->at_strength;
  if (before == now) return std::nullopt;
  const Real share = Ramp{summary->record.start, stage->ramp}.share_at(*time);
  return 1.0 / ((1.0 - share) / before + share / now);
}

/// The ground below the level, so far or for the last time.
struct TimeBelow {
  bool lasts = false;               ///< in the last row, too
  Real since = never, until = 0.0;  ///< [s]
  Real by = 0.0;                    ///< at most [m]
  bool narrow = false;              ///< in the last row it was too narrow, whatever its height

  void enter(const Barrier& barrier, const FloodCase& flood, Real river, Real time)
  {
    const Real depth = river + flood.smallest_freeboard - barrier.height;
    narrow = barrier.width < flood.smallest_width - round_off;
    const bool is_below = narrow || depth > round_off;
    if (is_below && !lasts) since = time, by = 0.0;
    if (is_below) until = time, by = std::max(by, depth);
    lasts = is_below;
  }
  /// As long as the time alone decides whether it is a dip.
  bool is_short() const { return lasts && until - since < flood_time - round_off; }
  bool floods(Real tolerance) const { return lasts && !is_short() && (narrow || by >= tolerance); }
};

/// Where soil moves fastest.
struct FastSoil {
  Index stage = -1;                          ///< at the end of which that was; -1: of none
  Real speed = never, x = never, y = never;  ///< [m/s], [m]
  Index material = 0;
};

/// What makes the section fail so far. times: from which on it is damaged and below the level; NaN: it is not [s].
/// flooded: by stage that has ended, whether it flooded then. moving: a stage at the end of which soil moved; -1: none.
std::optional<FloodTrigger> trigger_of(const Case& c, const State& state, std::optional<Facing> river,
    const std::array<Real, 2>& times, const std::vector<std::int64_t>& flooded, Index moving)
{
  FloodTrigger trigger{.at_strength = c.at_strength};
  if (c.stages.empty()) return c.at_strength != 1.0 ? std::optional(trigger) : std::nullopt;
  const auto now = static_cast<std::size_t>(state.stage);
  const std::optional<std::size_t> first = trigger_stage(c, now);
  if (!first) return std::nullopt;
  trigger.stage = c.stages[*first].name;
  for (std::size_t k = *first; k <= now; ++k)
    if (const auto level = river_of(c, c.stages[k], river); c.stages[k].trigger && level) trigger.river = level;
  if (*first == 0) return trigger;
  const StageRecord& before = state.stages_done[*first - 1];
  if (times[1] <= before.end)
    trigger.before = *first <= flooded.size() && flooded[*first - 1] == 0 ? FloodVerdict::near : FloodVerdict::floods;
  else if (before.at_rest && (moving < 0 || moving >= static_cast<Index>(*first)))
    trigger.before = times[0] <= before.end ? FloodVerdict::damaged : FloodVerdict::stands;
  return trigger;
}

bool is_of(const Model& model, const FastSoil& soil)
{
  return soil.stage >= 0 && soil.stage < std::ssize(model.description.stages) && soil.material >= 0 &&
         soil.material < std::ssize(model.materials);
}

/// Speed and stage are known.
void find_place(const Model& model, const State& state, FastSoil& soil)
{
  const NodeMotion motion = map_motion(model, state);
  Real most = -1.0, nearest = std::numeric_limits<Real>::infinity();
  for (Index i = 0; i < std::ssize(motion.mass); ++i) {
    const Real speed = std::hypot(motion.velocity[2 * i], motion.velocity[2 * i + 1]);
    if (!(motion.mass[i] >= part_of_full_mass(model, i, part_that_rests)) || !(speed > most)) continue;
    most = speed;
    soil.x = model.mesh->nodes[i][0], soil.y = model.mesh->nodes[i][1];
  }
  for_each_point(state.points, [&](const PointBlock<2>& block, Index lane) {
    const Real away = std::hypot(block.row(Rows::x)[lane] - soil.x, block.row(Rows::x + 1)[lane] - soil.y);
    if (away < nearest) nearest = away, soil.material = block.material;
  });
}

/// A verdict is one of all stages: it stays where displacement is counted anew.
class Flood : public Follower {
  ColumnRange range_;          ///< of the ground that counts
  Real first_height_ = never;  ///< of the barrier at t = 0 [m]
  Real settles_ = 0.0;         ///< fall of the barrier from which on the ground is damaged [m]
  Real slides_ = 0.0;          ///< volume of ground that moved, from which on it is [m^2]
  std::optional<Facing> river_;
  std::optional<RiverBeforeTrigger> before_;        ///< follows from the model: looked for once
  Real time_damaged_ = never, time_below_ = never;  ///< the first ones; but for slides [s]
  Real fastest_node_ = never;                       ///< in the last row [m/s]
  Real moved_from_ = never;                         ///< displacement from which on ground counts as moved [m]
  Section first_;                                   ///< from which depths count; of cases with flood.least_depth
  SettledGround settled_;                           ///< at the last looks of a stage that ends with the verdict
  TimeBelow below_;
  std::vector<std::int64_t> flooded_;  ///< by stage that has ended: 1, it flooded then
  FastSoil moving_;                    ///< at the end of the first stage but the last in which soil still moved

  void start(const Model& model, const State& state) override
  {
    const StandingGround ground = standing_ground(model, state.points);
    range_ = columns_of_barrier(ground, model.flood_level.river);
    first_height_ = find_barrier(ground, range_).height;
    const Section section = first_section(model, state.points, ground_of(model));
    const Real height = relief(section);
    moved_from_ = moved_distance(section);
    keep_first_ground(model, section);
    settled_.forget();
    settles_ = standing_tolerance(height);
    slides_ = slid_share * height * height;
    river_ = river_side(model.flood_level, ground);
    time_damaged_ = time_below_ = never;
    below_ = {};
    flooded_.clear();
    moving_ = {};
    before_.reset();
  }

  void keep_first_ground(const Model& model, const Section& section)
  {
    first_ = model.description.flood.least_depth > 0.0 ? section : Section{};
  }

  MovedByDepth look_deep(const Model& model, const State& state) const
  {
    return moved_by_depth(
        state.points, state.x_initial, moved_from_, first_, ground_of(model), model.description.flood.least_depth);
  }

  /// Volume that moved, of a case with a least depth from deeper [m^2].
  Real moved_of(const LedgerContext& context) const
  {
    const bool asks_depth = context.model.description.flood.least_depth > 0.0;
    return (asks_depth ? look_deep(context.model, context.state).deep() : context.totals.moved.volume) +
           volume_that_left(context.state);
  }

  Barrier look(const Model& model, const State& state, Real level) const
  {
    return find_barrier(standing_ground(model, state.points, level), range_);
  }

  void row(const LedgerContext& context, std::span<Real> values) override
  {
    const FloodCase& flood = context.model.description.flood;
    const FloodLevel& level = context.model.flood_level;
    if (!level.is_known()) return;
    if (!before_) before_ = river_before_trigger(context.model);
    const Barrier barrier = look(context.model, context.state, level.value);
    const bool is_before = static_cast<std::size_t>(context.state.stage) < before_->n_stages;
    const Real river = is_before ? before_->level : level.value;
    const Barrier judged = is_before ? look(context.model, context.state, river) : barrier;
    values[0] = barrier.height, values[1] = barrier.width, values[2] = barrier.intact_width;
    fastest_node_ = context.fastest_node;
    const auto keep_first = [&](bool so, Real& time) {
      if (so && std::isnan(time)) time = context.state.time;
    };
    below_.enter(judged, flood, river, context.state.time);
    keep_first(below_.lasts, time_below_);
    const Real moved = moved_of(context);
    const bool is_deep = !(flood.least_depth > 0.0) || moved > least_deep_volume(first_);
    const bool is_held = holds_soil(context.model.description, context.model.stage.number);
    keep_first(!is_held && ((is_deep && judged.height < first_height_ - settles_) ||
                               judged.intact_width < flood.smallest_width - round_off || moved > slides_),
        time_damaged_);
    end_stage(context.model, context.state);
  }

  /// The model is that of the stage that begins; soil that was held is judged from here on.
  void count_displacement_anew(const Model& model, const State& state) override
  {
    if (holds_soil(model.description, model.stage.number - 1))
      first_height_ = look(model, state, model.flood_level.value).height;
    const Section section = first_section(model, state.points, ground_of(model));
    moved_from_ = moved_distance(section);
    keep_first_ground(model, section);
  }

  /// The ground floods since this stage or run began, and what is left of it has settled. Else it is to come to rest.
  bool is_answered(const Model& model, const State& state, bool is_first) override
  {
    if (is_first || !below_.lasts) settled_.forget();
    if (!model.flood_level.is_known() || !below_.lasts || !(below_.since > model.time_of(state.stage_start)))
      return false;
    const Barrier barrier = look(model, state, model.flood_level.value);
    const GroundLeft left{barrier.height, barrier.width,
        find_moved(state.points, state.x_initial, moved_from_, ground_of(model)).volume + volume_that_left(state)};
    return settled_.enter(left, resolution_of(left, columns_of_section(*model.mesh).width));
  }

  bool waits(const State&) const override { return below_.is_short(); }

  /// What soil that moves at the end of a stage would have done there, a later stage does not show.
  void end_stage(const Model& model, const State& state)
  {
    const Stage& stage = model.stage;
    if (!stage.name.empty() && std::ssize(state.stages_done) > state.stage) {
      flooded_.resize(stage.number, 1);
      flooded_.push_back(below_.floods(settles_));
    }
    const bool ends = !stage.name.empty() && !stage.is_last() && std::ssize(state.stages_done) > state.stage;
    if (!ends || moving_.stage >= 0 || is_decided_later(model.description, stage.number)) return;
    const bool is_slow = stage.rest.steps > 0 && !stage.rest.by_mean && fastest_node_ < stage.rest.speed;
    if (is_slow || !moves(model, state)) return;
    moving_.stage = static_cast<Index>(stage.number), moving_.speed = fastest_node_;
    find_place(model, state, moving_);
  }

  /// At the end of a stage, or of the run.
  bool moves(const Model& model, const State& state) const
  {
    const StageRecord* last = state.stages_done.empty() ? nullptr : &state.stages_done.back();
    const bool was_to_rest = last != nullptr && std::isfinite(last->fastest);
    return !(last != nullptr && (last->at_rest || last->known_for > 0.0)) && std::isfinite(fastest_node_) &&
           (was_to_rest || fastest_node_ * time_to_look_ahead(model, state) > settles_);
  }

  /// Which soil still moves at the end or, where that is not known to be damaged, moved at the end of a stage.
  void say_what_moves(const Model& model, const State& state, FloodSummary& f) const
  {
    const bool at_end = moves(model, state);
    f.still_moves = at_end || (is_of(model, moving_) && !f.first_time_damaged);
    if (!f.still_moves) return;
    FastSoil soil = moving_;
    if (at_end) {
      soil.speed = fastest_node_;
      find_place(model, state, soil);
    }
    f.stage_moving = at_end ? f.stage : model.description.stages[static_cast<std::size_t>(soil.stage)].name;
    f.fastest_node = soil.speed, f.fastest_x = soil.x, f.fastest_y = soil.y;
    f.fastest_soil = model.materials[soil.material].name;
  }

  void summarise(const Model& model, const State& state, Summary& s) const override
  {
    const FloodLevel& level = model.flood_level;
    const Barrier barrier = look(model, state, level.value);
    s.residual_height = known(barrier.height);
    if (!level.is_known() || state.has_no_start) return;
    FloodSummary& f = s.flood.emplace();
    f.water_level = level.value;
    f.water_level_origin = level.origin;
    f.river = river_;
    f.residual_height = barrier.height;
    f.freeboard = barrier.height - f.water_level;
    f.width_at_level = barrier.width;
    f.intact_width = barrier.intact_width;
    f.first_time_below = known(time_below_);
    if (f.first_time_below) f.below_for = below_.until - below_.since, f.below_by = known(below_.by);
    f.first_time_damaged =  // the slopes are asked before
        known(std::fmin(time_damaged_, s.first_slide_time.value_or(never)));
    f.stage_damaged = stage_at(s.stages, f.first_time_damaged);
    f.stage_below = stage_at(s.stages, f.first_time_below);
    f.at_strength_damaged = at_strength_at(model.description, s.stages, f.first_time_damaged);
    f.at_strength_below = at_strength_at(model.description, s.stages, f.first_time_below);
    f.stage = s.stages.empty() ? "" : s.stages.back().name;
    f.fastest_node = known(fastest_node_);
    say_what_moves(model, state, f);
    f.verdict = below_.floods(settles_) ? FloodVerdict::floods
                : f.first_time_below    ? FloodVerdict::near
                : f.still_moves         ? FloodVerdict::moving
                : f.first_time_damaged  ? FloodVerdict::damaged
                                        : FloodVerdict::stands;
    if (model.description.flood.least_depth > 0.0) {
      const MovedByDepth moved = look_deep(model, state);
      f.ravelled_volume = moved.ravelled, f.ravelled_depth = moved.ravelled_depth;
    }
    if (const FloodCase& flood = model.description.flood; flood.asks_profile())
      f.profile = {flood.profile_width, flood.profile_slope,
          place_of_profile(
              standing_ground(model, state.points, level.value), range_, flood.profile_width, flood.profile_slope)};
    const Real margin = f.freeboard - model.description.flood.smallest_freeboard;
    if (f.verdict == FloodVerdict::damaged && margin < settles_) f.margin = margin;
    f.trigger = trigger_of(
        model.description, state, river_, {f.first_time_damaged.value_or(never), time_below_}, flooded_, moving_.stage);
    f.criterion = criterion_text(model.description.flood, level.value, before_.value_or(river_before_trigger(model)));
  }

  /// As long again as the run took; after a short one the time of a free fall through the relief [s].
  Real time_to_look_ahead(const Model& model, const State& state) const
  {
    const Real g = std::hypot(model.gravity[0], model.gravity[1]), height = std::sqrt(slides_ / slid_share);
    return g > 0.0 ? std::max(state.time, std::sqrt(2.0 * height / g)) : state.time;
  }

  void save(ArrayWriter& arrays) const override
  {
    arrays.copy("columns", std::vector<std::int64_t>{range_.first, range_.last});
    arrays.copy("ground", std::vector<Real>{first_height_, settles_, slides_});
    arrays.copy("river", std::vector<std::int64_t>{!river_ ? 0 : static_cast<std::int64_t>(outwards(*river_))});
    arrays.copy("times", std::vector<Real>{time_damaged_, time_below_});
    arrays.copy("below", std::vector<Real>{below_.since, below_.until, below_.by});
    arrays.copy("below_now", std::vector<std::int64_t>{below_.lasts, below_.narrow});
    if (!flooded_.empty()) arrays.copy("flooded", flooded_);
    arrays.copy("speed", std::vector<Real>{fastest_node_});
    arrays.copy("moved_from", std::vector<Real>{moved_from_});
    if (const std::vector<Real> looks = settled_.values(); !looks.empty()) arrays.copy("looks", looks);
    if (!first_.heights.empty()) {
      arrays.refer("first_heights", first_.heights);
      arrays.copy("first_columns", std::vector<Real>{first_.columns.left, first_.columns.width});
    }
    if (moving_.stage < 0) return;
    arrays.copy("moving", std::vector<Real>{moving_.speed, moving_.x, moving_.y});
    arrays.copy("moving_in", std::vector<std::int64_t>{moving_.stage, moving_.material});
  }
  void load(const Model&, const State&, const ArrayReader& arrays) override
  {
    const auto &ground = arrays.reals("ground", 3), &times = arrays.reals("times", 2);
    const auto& columns = arrays.wholes("columns", 2);
    range_ = {static_cast<Index>(columns[0]), static_cast<Index>(columns[1])};
    first_height_ = ground[0], settles_ = ground[1], slides_ = ground[2];
    const std::int64_t river = arrays.wholes("river", 1)[0];
    river_ = river == 0 ? std::nullopt : std::optional(river > 0 ? Facing::right : Facing::left);
    time_damaged_ = times[0], time_below_ = times[1];
    const std::vector<Real>& below = arrays.reals("below", 3);
    const std::vector<std::int64_t>& below_now = arrays.wholes("below_now", 2);
    below_ = {below_now[0] != 0, below[0], below[1], below[2], below_now[1] != 0};
    flooded_ = arrays.has("flooded") ? arrays.wholes("flooded") : std::vector<std::int64_t>{};
    fastest_node_ = arrays.reals("speed", 1)[0];
    moved_from_ = arrays.reals("moved_from", 1)[0];
    settled_.set_values(arrays.has("looks") ? arrays.reals("looks") : std::vector<Real>{});
    first_ = {};
    if (arrays.has("first_heights")) {
      first_.heights = arrays.reals("first_heights");
      const std::vector<Real>& columns = arrays.reals("first_columns", 2);
      first_.columns = {columns[0], columns[1], static_cast<Index>(first_.heights.size())};
    }
    moving_ = {};
    if (!arrays.has("moving")) return;
    const std::vector<Real>& at = arrays.reals("moving", 3);
    const std::vector<std::int64_t>& in = arrays.wholes("moving_in", 2);
    moving_ = {static_cast<Index>(in[0]), at[0], at[1], at[2], static_cast<Index>(in[1])};
  }

  /// What the other run counted holds if it was judged against the same. Else only the ground of t = 0 is looked at,
  /// and times begin here.
  void begin_from(const Model& before, const Model& model, const State& first) override
  {
    const Real damaged = time_damaged_, below = time_below_;
    const FastSoil moving = moving_;
    const TimeBelow time_below = below_;
    start(model, first);
    if (!is_judged_alike(before, model)) return;
    time_damaged_ = damaged, time_below_ = below, below_ = time_below;
    moving_ = moving_in(before, model, moving);
  }

  /// The same stage and soil by the numbers of another model; of none where that has no such names.
  static FastSoil moving_in(const Model& before, const Model& model, FastSoil soil)
  {
    if (!is_of(before, soil)) return {};
    const auto &stages = model.description.stages, &stages_before = before.description.stages;
    const auto stage =
        std::ranges::find(stages, stages_before[static_cast<std::size_t>(soil.stage)].name, &StageCase::name);
    const std::string& name = before.materials[soil.material].name;
    const auto same =
        std::ranges::find_if(model.materials, [&](const auto& material) { return material.name == name; });
    soil.stage = static_cast<Index>(stage - stages.begin());
    soil.material = static_cast<Index>(same - model.materials.begin());
    return is_of(model, soil) ? soil : FastSoil{};
  }
};

}  // namespace

const FollowerType flood_follower{.name = "flood",
    .columns = {{"residual_height", "m", "highest ground",
                    "height of the highest ground between river and land; of cases with `[flood]` (docs/flood.md)"},
        {"width_at_level", "m", "width at the water level", "width of the ground at the water level of `[flood]`"},
        {"intact_width", "m", "intact width at the water level", "of that, with eps_eq_p below `flood.intact_below`"}},
    .make = make_follower<Flood>};

}  // namespace terp
