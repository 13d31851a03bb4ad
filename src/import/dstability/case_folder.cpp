// What is taken over is decided before anything is written: river, part of the section, size of cells, clean regions.
// Then water comes first, as the phreatic line cuts layers into pieces; pieces give bodies and soils. A trigger names
// another water for soils that are there. Doubts look at all of it, last.

#include "import/dstability/case_folder.hpp"

#include "math/errors.hpp"
#include "import/dstability/earlier_ground.hpp"
#include "import/dstability/film.hpp"
#include "import/dstability/folder_report.hpp"
#include "import/dstability/folder_water.hpp"
#include "import/dstability/import_doubts.hpp"
#include "import/dstability/load_text.hpp"
#include "import/dstability/preload.hpp"
#include "import/dstability/reference_text.hpp"
#include "import/dstability/river_level.hpp"
#include "import/dstability/river_side.hpp"
#include "import/dstability/section_layout.hpp"
#include "import/dstability/section_part.hpp"
#include "import/dstability/section_pieces.hpp"
#include "import/dstability/soil_text.hpp"
#include "import/dstability/stage_text.hpp"
#include "import/dstability/study_text.hpp"
#include "import/dstability/reported_texts.hpp"
#include "io/case/printable.hpp"
#include "model/bodies/body_outline.hpp"
#include "model/water/water_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace terp {
namespace {

constexpr const char *raised_water = "raised_water", *record = "imported.toml";

class FolderMaker {
 public:
  /// moved: the same project with its river at another level; null: it is that of the file.
  FolderMaker(const StixProject& project, const FolderOptions& options, const RiverLevel* moved)
      : project_(project),
        options_(options),
        section_(project, options.scenario, options.stage, options.basis),
        first_(project, options.scenario, 0, options.basis),
        stage_(section_.stage())
  {
    if (stage_.layers.empty())
      throw InputError({stage_.label, "this stage has no layers", "There is nothing to make a case of.", ""});
    for (const StixLayer& layer : stage_.layers) drawn_.push_back({name_of_layer(project, layer), layer.outline});
    check_outlines(drawn_);
    for (const StixLine& pit : stage_.excavations)
      pits_.push_back({fmt::format("excavation {}", pits_.size() + 1), pit});
    const BoundingBox box = box_around(drawn_);
    river_ = moved != nullptr ? moved->river : find_river(section_, {box.low[0], box.high[0]});
    if (moved != nullptr) assumed_.push_back(moved->sentence), notes_.push_back(moved->sentence);
    take_part();
    layout_ = layout_of(drawn_, pits_, wishes_for(options.cell));
    check_cell(layout_, options.cell);
    find_films();
    cleaning_ = cleaning_for(layout_.cell);
    clean_ = clean_regions(drawn_, pits_, cleaning_);
    is_staged_ = options.stage > 0;
    is_of_file_ = has_distributions(project, options.scenario, options.stage);
    if (options.has_study) pops_.emplace(section_, options.scenario, options.stage, is_of_file_);
  }

  CaseFolder make()
  {
    make_water();
    make_pieces();
    make_bodies();
    make_trigger();
    make_flood();
    make_loads();
    find_doubts();
    text_.title = scenario().label.empty() ? stage_.label : fmt::format("{}: {}", scenario().label, stage_.label);
    text_.head = origin_comments(project_, options_.scenario, options_.stage, options_.basis);
    text_.before.push_back(mesh_table(layout_));
    if (!part_.empty()) text_.before.back().comment += "\n" + part_;
    make_time();
    for (CaseTableText& table : common_tables(layout_)) text_.after.push_back(std::move(table));
    text_.after.push_back(doubts_table(doubts_, assumed_, record));
    for (CaseTableText& table : reference_texts(project_, options_.scenario, options_.stage, options_.basis))
      text_.after.push_back(std::move(table));
    CaseFolder folder;
    const std::string written = text_of(text_);
    folder.files = {{"case.toml", written}, {record, written}};
    for (auto& file : files_) folder.files.push_back(std::move(file));
    folder.files.push_back({"report.md", printable(report())});
    folder.notes = notes_;
    folder.notes.insert(folder.notes.end(), doubts_.begin(), doubts_.end());
    return folder;
  }

 private:
  const StixScenario& scenario() const { return project_.scenarios[options_.scenario]; }

  LayoutWishes wishes_for(Real cell) const
  {
    LayoutWishes wishes{.cell = cell};
    if (!river_.side.empty()) wishes.land = river_.side == "left" ? LandEnd::right : LandEnd::left;
    const auto [one, other] = std::minmax(stage_.embankment.top_water, stage_.embankment.top_land);
    if (std::isfinite(one + other)) wishes.crest = Vec<2>{one, other};
    return wishes;
  }

  /// Without other wishes the part that matters; an end at which the river stands stays if the river would be lost.
  void take_part()
  {
    std::vector<bool> is_undrained;
    for (const StixLayer& layer : stage_.layers) is_undrained.push_back(has_su(project_.soils[*layer.soil]));
    const SectionLayout all = layout_of(drawn_, pits_, wishes_for(1e3));
    SectionPart part = part_that_matters(drawn_, pits_, all.crest, is_undrained);
    toe_ =
        inner_toe(part, river_.side, section_.column(stage_.embankment.toe_land).ground(), all.crest[1] - all.height);
    const BoundingBox box = box_around(drawn_);
    if (river_.side == "left" && !water_stands_at(section_, part.between[0])) part.between[0] = box.low[0];
    if (river_.side == "right" && !water_stands_at(section_, part.between[1])) part.between[1] = box.high[0];
    if (options_.has_films) part.between = with_uplift(section_, river_.side, part.between);
    if (options_.between || options_.base) part.why.clear();
    part.between = options_.between.value_or(part.between);
    part.base = options_.base.value_or(part.base);
    part_ = describe(part, drawn_);
    if (!part_.empty()) geometry_.push_back(part_);
    layers_.resize(drawn_.size());
    std::iota(layers_.begin(), layers_.end(), std::size_t{0});
    take(part_of(drawn_, part));
  }

  /// A row of cells lies on the border of the weakest film, so that it is a whole one.
  void find_films()
  {
    if (!options_.has_films) return;
    films_ = films_of(section_, first_, {layout_.low[0], layout_.high[0]}, layout_.cell);
    const std::optional<Real> base =
        options_.base || films_.empty() ? std::nullopt : base_with_row_at(films_, layout_.low[1], layout_.cell);
    if (!base) return cut_at(films_, layout_.low[1]);
    take(part_of(drawn_, {.between = {layout_.low[0], layout_.high[0]}, .base = *base}));
    layout_ = layout_of(drawn_, pits_, wishes_for(layout_.cell));
    geometry_.push_back(fmt::format("The base is z = {:.3f} m, so that a row of cells begins at the film.", *base));
    cut_at(films_, layout_.low[1]);
  }

  /// Regions of which nothing is left have no corners.
  void take(const std::vector<DrawnRegion>& regions)
  {
    const std::vector<std::size_t> numbers = std::exchange(layers_, {});
    drawn_.clear();
    for (std::size_t k = 0; k < regions.size(); ++k)
      if (!regions[k].polygon.empty()) drawn_.push_back(regions[k]), layers_.push_back(numbers[k]);
  }

  const StixLayer& layer_of(int drawn) const { return stage_.layers[layers_[drawn]]; }

  void make_water() { take(water_of_stages(section_, first_, layout_, is_staged_, raised_water)); }

  void take(FolderWater water)
  {
    std::ranges::move(water.tables, std::back_inserter(text_.after));
    std::ranges::move(water.files, std::back_inserter(files_));
    std::ranges::move(water.notes, std::back_inserter(water_notes_));
    std::ranges::move(water.assumed, std::back_inserter(assumed_));
    if (!water.situation.empty()) situation_ = water.situation;
    if (!water.phreatic.empty()) phreatic_ = water.phreatic;
  }

  Real level_at_end(bool left) const
  {
    return section_.column(left ? layout_.low[0] : layout_.high[0]).now().water().phreatic();
  }

  void make_pieces()
  {
    SectionPieces made =
        pieces_of({section_, first_, scenario(), layout_, clean_, phreatic_, layers_, toe_, options_.face_cohesion});
    pieces_ = std::move(made.of_file), base_ = std::move(made.below_base);
    std::ranges::move(made.geometry, std::back_inserter(geometry_));
  }

  LayerPiece layer_piece(const SectionPiece& piece) const { return {&piece.region, layers_[piece.region.drawn]}; }

  void make_bodies()
  {
    BodyOrder order;
    for (const SectionPiece& piece : pieces_) {
      const StixSoil& soil = project_.soils[piece.soil];
      order.bodies.push_back(body_of(piece));
      order.regions.push_back(piece.region);
      const Real weight = piece.zone == 2 ? soil.weight_above : soil.weight_below;
      const Real area = terp::area(BodyOutline{piece.region.polygon, {1, 1}, piece.region.holes});
      weights_[order.bodies.back().material] += SoilSum{area, area * weight};
    }
    put_on_top(order);
    for (const SectionPiece& piece : base_) {
      text_.bodies.push_back(body_of(piece));
      text_.bodies.back().comment = "Not in the file, fills what is below its base. " + text_.bodies.back().comment;
      text_.bodies.back().name += below_the_base;
      text_.bodies.back().polygon = piece.region.polygon;
      text_.bodies.back().holes = piece.region.holes;
    }
    std::ranges::move(order.bodies, std::back_inserter(text_.bodies));
    std::vector<Problem> problems;
    for (const auto& [key, use] : uses_) try {
        SoilText soil = soil_text(use, options_.basis, options_.kinds);
        text_.materials.push_back(std::move(soil.material));
        assumed_.insert(assumed_.end(), soil.assumed.begin(), soil.assumed.end());
      } catch (const InputError& error) {
        problems.insert(problems.end(), error.problems().begin(), error.problems().end());
      }
    if (!problems.empty()) throw InputError(problems);
    for (const Film& film : films_) add_film(film);
    name_bodies(text_.bodies);
  }

  void add_film(const Film& film)
  {
    const StixLayer& layer = stage_.layers[film.layer];
    const StixSoil& soil = project_.soils[*layer.soil];
    std::string name = "film_" + key_of_name(soil.name);
    for (int k = 2; !names_.insert(name).second; ++k) name = fmt::format("film_{}_{}", key_of_name(soil.name), k);
    const SoilUse use{&soil, false, key_of_name(soil.name), "", stage_.label, "", {}, 0.0};
    const std::string csv = name + ".csv";
    text_.materials.push_back(film_text(soil_text(use, options_.basis, options_.kinds), name, csv).material);
    files_.push_back({csv, film_csv(film)});
    text_.bodies.push_back({"film at the top of " + name_of_layer(project_, layer), name,
        "Not in the file: the strength of the border above it.", film.outline, {}});
    assumed_.push_back(film_sentence(film, name_of_layer(project_, layer), layout_.cell));
  }

  CaseBodyText body_of(const SectionPiece& piece)
  {
    const StixLayer& layer = layer_of(piece.region.drawn);
    const std::string zone = piece.zone == 0 ? "" : piece.zone == 1 ? ", below the phreatic line" : ", above it";
    const std::string name = name_of_layer(project_, layer);
    return {name + (piece.zone == 0      ? ""
                       : piece.zone == 1 ? ", below water"
                                         : ", above water"),
        material_of(piece),
        fmt::format("Layer {} (id {}), soil {}{}", in_quotes(layer.label), layer.id,
            in_quotes(project_.soils[piece.soil].name), zone),
        {}, {}};
  }

  /// The material of a piece; pieces of one soil and one preload share it.
  std::string material_of(const SectionPiece& piece)
  {
    const StixSoil& soil = project_.soils[piece.soil];
    const std::string preload = piece.pop ? fmt::format("{:g} kPa", *piece.pop / 1e3) : "grid " + piece.history;
    const std::string key = fmt::format("{}/{}/{}/{}", piece.soil, piece.zone, preload, piece.is_face);
    if (const auto known = uses_.find(key); known != uses_.end()) return known->second.name;
    std::string name = key_of_name(soil.name) +
                       (piece.zone == 1      ? "_below"
                           : piece.zone == 2 ? "_above"
                                             : "") +
                       (piece.is_face ? "_face" : "");
    if (names_.contains(name)) name += "_" + key_of_name(layer_of(piece.region.drawn).label, "layer");
    for (int k = 2; names_.contains(name); ++k) name = key_of_name(soil.name) + fmt::format("_{}", k);
    names_.insert(name);
    const std::string where = piece.zone == 0 ? ""
                                              : fmt::format("{} the phreatic line of the analysed stage",
                                                    piece.zone == 1 ? "below" : "above");
    SoilUse use{&soil, piece.zone == 2, name, where, stage_.label,
        strength_follows() ? std::string(name_of_start) : situation_, {},
        largest_stress(section_, pieces_, piece, 2.0 * layout_.cell), piece.is_face ? options_.face_cohesion : 0.0};
    if (pops_ && is_shansep(soil, piece.zone)) use.pop = pops_->at(places_in(piece.region, 2.0 * layout_.cell));
    if (use.pop && piece.pop) use.pop->rest = *piece.pop - use.pop->mean;
    if (piece.pop)
      use.preload = {fmt::format("pop = \"{}\"", preload),
          fmt::format("POP of the file's states, over sigma'_v of {}", is_staged_ ? "the first stage" : "this stage")};
    else if (is_shansep(soil, piece.zone))
      use.preload = yield_grid_of(piece, name, use.pop ? use.pop->mean : 0.0);
    uses_.emplace(key, use);
    return name;
  }

  /// Of the first stage: the analysed one sets its own. Soil that is held at first has the strength that it is to have.
  bool strength_follows() const { return is_staged_ && !options_.is_held; }

  /// pop: a part of it that a study draws [Pa].
  PreloadText yield_grid_of(const SectionPiece& piece, const std::string& name, Real pop)
  {
    std::vector<LayerPiece> alike;
    for (const std::vector<SectionPiece>* pieces : {&pieces_, &base_})
      for (const SectionPiece& other : *pieces)
        if (other.soil == piece.soil && other.zone == piece.zone && !other.pop && other.history == piece.history)
          alike.push_back(layer_piece(other));
    YieldGrid grid = yield_grid(section_, alike, layout_.cell, pop);
    files_.push_back({fmt::format("yield_stress_{}.csv", name), std::move(grid.csv)});
    assumed_.push_back(sentence_on(grid, name));
    return grid_preload(files_.back().first, is_staged_, pop);
  }

  /// x of the river's end of the part that is taken over; where the river may be at both, of the left one.
  Real river_end() const { return river_.side == "right" ? layout_.high[0] - 1e-6 : layout_.low[0] + 1e-6; }

  void make_flood()
  {
    if (!river_.doubt.empty()) doubts_.push_back(river_.doubt);
    const Sentence no_verdict =
        river_level_ ? Sentence{} : no_flood_because(section_, river_, river_end(), layout_.cell);
    if (!no_verdict.empty()) {
      assumed_.push_back(no_verdict);
      if (options_.river) notes_.push_back(no_verdict);
      if (water_stands_at(section_, river_end())) doubts_.push_back(no_verdict);  // finer cells would have one
      return;
    }
    const Real level = river_level_.value_or(level_at_end(river_.side != "right"));
    std::vector<CaseLine> lines;
    if (!river_.side.empty()) lines.push_back({"river", in_quotes(river_.side), river_.origin});
    lines.push_back(
        {"water_level", number_text(level), river_level_ ? "m: that of the trigger" : "m: phreatic line at that end"});
    if (level >= layout_.crest[1]) {
      assumed_.push_back(river_above_crest(level, layout_.crest[1]));
      lines.back().comment = assumed_.back().en;
      notes_.push_back(assumed_.back());
    }
    text_.after.push_back({"[flood]", "Does the ground hold the river back? (docs/flood.md)", lines});
  }

  void make_loads()
  {
    LoadTexts loads = load_texts(stage_, is_staged_ ? &first_.stage() : nullptr, layout_);
    std::ranges::move(loads.tables, std::back_inserter(text_.after));
    std::ranges::move(loads.sets, std::back_inserter(stage_sets_));
    std::ranges::move(loads.assumed, std::back_inserter(assumed_));
    std::ranges::move(loads.left_out, std::back_inserter(left_out_));
  }

  void make_time()
  {
    const std::vector<std::string> sets_when_held = stage_sets_;
    if (strength_follows()) set_water_of_strength(situation_, stage_sets_);
    StagePlan plan{.first = is_staged_ ? scenario().stages.front().label : "",
        .analysed = stage_.label,
        .water = situation_,
        .sets = stage_sets_,
        .is_held = options_.is_held,
        .has_flood = std::ranges::find(text_.after, "[flood]", &CaseTableText::header) != text_.after.end(),
        .trigger = trigger_};
    if (plan.is_held) doubts_.push_back(held_sentence());
    const auto stages = stage_tables(plan);
    text_.before.push_back(time_table(stages.empty() ? last_end(plan.has_flood) : ""));
    text_.after.insert(text_.after.end(), stages.begin(), stages.end());
    if (const auto before = earlier_ground(
            project_, options_.scenario, options_.stage, {layout_.low[0], layout_.high[0]}, 0.25 * layout_.cell)) {
      assumed_.insert(assumed_.begin(), before->sentence);
      if (before->is_other) notes_.push_back(before->sentence);
    }
    plan.sets = sets_when_held;
    if (options_.has_study) make_study(plan);
  }

  void make_study(const StagePlan& stages)
  {
    StudyPlan study{.title = text_.title,
        .stages = stages,
        .kinds = &options_.kinds,
        .model_factor = model_factor_of(scenario(), options_.stage),
        .is_of_file = is_of_file_,
        .has_films = !films_.empty(),
        .slide = std::max(1.0, std::round(layout_.height * layout_.height / 20.0))};
    for (const auto& [key, use] : uses_) study.uses.push_back(&use);
    if (strength_follows()) set_water_of_strength(situation_, study.held_sets);
    StudyText made = study_text(study);
    files_.push_back({"study.toml", std::move(made.file)});
    study_report_ = std::move(made.report);
    if (!is_of_file_) notes_.push_back(made.source);
  }

  void find_doubts()
  {
    const auto add = [&](std::vector<Sentence> more) { std::ranges::move(more, std::back_inserter(doubts_)); };
    std::vector<LayerPiece> shansep;
    for (const SectionPiece& piece : pieces_)
      if (is_shansep(project_.soils[piece.soil], piece.zone)) shansep.push_back(layer_piece(piece));
    add(doubts_of_reading(project_, options_.scenario, options_.stage));
    add(doubts_of_water(scenario(), options_.stage, !shansep.empty()));
    add(doubts_of_datum(section_, !shansep.empty(), layout_.height));
    add(doubts_of_numbers(section_));
    add(section_.state_doubts());
    add(doubts_of_preload(section_, shansep, layout_.cell));
    if (river_.doubt.empty()) add(doubts_of_embankment(section_, river_.side, layout_));
    add(doubts_of_outlines(clean_, drawn_, base_fill(layout_, clean_.regions), layout_.cell));
    add(left_out_);
  }

  void make_trigger()
  {
    if (options_.trigger.kind == TriggerKind::strength) weaken();
    if (options_.trigger.kind == TriggerKind::water) bring_river_to_the_crest();
    if (options_.trigger.kind == TriggerKind::none && !options_.trigger.origin.empty())
      trigger_notes_.push_back(options_.trigger.origin);
    if (!trigger_.comment.empty()) trigger_notes_.push_back(trigger_.comment);
  }
  void weaken()
  {
    const std::string factor = number_text(options_.trigger.value);
    trigger_ = {"weaker_soil",
        fmt::format("Trigger: all strengths are divided by {}. {}", factor, options_.trigger.origin), "",
        {"at_strength = " + factor}};
  }

  void bring_river_to_the_crest()
  {
    check_river_to_move(section_, river_, river_end());
    const bool at_left = river_.side == "left";
    const RaisedRiver raised = raise_river(section_,
        {.at_left = at_left,
            .ends = {layout_.low[0], layout_.high[0]},
            .level = level_at_end(at_left),
            .inland = level_at_end(!at_left),
            .crest = layout_.crest[1],
            .height = layout_.height},
        options_.trigger.value);
    const StixProject project = with_stage(project_, options_.scenario, options_.stage, raised.stage);
    const StixSection section(project, options_.scenario, options_.stage + 1, options_.basis);
    FolderWater water;
    water.add(water_text(section, layout_, "water_raised", true), "[[water.situation]]",
        "The river at the level of the trigger", {{"name", in_quotes(raised_water), ""}}, layout_.cell);
    take(std::move(water));
    river_level_ = raised.level;
    trigger_ = {"raised_river", raised.comment, raised_water, {}};
    set_water_of_strength(raised_water, trigger_.sets);
  }

  void set_water_of_strength(const std::string& water, std::vector<std::string>& sets) const
  {
    for (const auto& [key, use] : uses_)
      if (const std::string path = strength_water_key(use); !path.empty())
        sets.push_back(fmt::format("\"{}\" = {}", path, in_quotes(water)));
  }

  std::string report() const
  {
    std::vector<std::string> geometry = describe(clean_, drawn_, cleaning_);
    geometry.insert(geometry.end(), geometry_.begin(), geometry_.end());
    std::vector<std::string> left = in_english(left_out_);
    for (const StixRemark& remark : project_.remarks) left.push_back(fmt::format("{}: {}", remark.where, remark.what));
    FolderReport report{.title = text_.title,
        .head = text_.head,
        .weights = weights_,
        .sections = {{"In doubt", in_english(doubts_)}, {"Geometry: what moved", geometry}, {"Water", water_notes_},
            {"Trigger: what makes the section fail", trigger_notes_},
            {"Stored slices beside what the file gives", slices_in_words(project_, options_.scenario, options_.stage)},
            {"Assumed", in_english(assumed_)}, {"Left out, or not understood", left}}};
    if (options_.has_study) report.sections.push_back({"Study: what is random", study_report_});
    return text_of(report);
  }

  const StixProject& project_;
  const FolderOptions& options_;
  StixSection section_, first_;
  const StixStage& stage_;
  std::vector<DrawnRegion> drawn_;
  std::vector<std::size_t> layers_;  ///< of the stage, by drawn region
  std::vector<DrawnExcavation> pits_;
  SectionLayout layout_;
  CleaningOptions cleaning_;
  CleanSection clean_;
  bool is_staged_ = false;
  std::string situation_, part_;
  StixRiver river_;
  TriggerStage trigger_;
  std::optional<Real> river_level_;  ///< of the trigger [m]
  bool is_of_file_ = true;           ///< distributions of a study
  std::optional<RandomPops> pops_;   ///< of a study
  std::vector<std::string> study_report_;
  std::vector<Vec<2>> phreatic_;
  std::optional<Real> toe_;  ///< level of the inner toe [m]; none: the ground is level
  std::vector<Film> films_;
  std::vector<SectionPiece> pieces_, base_;  ///< of the file; below its base
  std::map<std::string, SoilUse> uses_;
  std::set<std::string> names_;
  std::map<std::string, SoilSum> weights_;
  SectionText text_;
  std::vector<std::pair<std::string, std::string>> files_;
  std::vector<Sentence> doubts_;  ///< what speaks against the case
  std::vector<Sentence> notes_, assumed_, left_out_;
  std::vector<std::string> geometry_, water_notes_, stage_sets_, trigger_notes_;
};

}  // namespace

CaseFolder case_folder_of(const StixProject& project, const FolderOptions& options)
{
  if (!options.river) return FolderMaker(project, options, nullptr).make();
  const RiverLevel moved = with_river_level(project, options.scenario, options.stage, options.basis, *options.river);
  FolderOptions there = options;
  there.stage = moved.stage;
  return FolderMaker(moved.project, there, &moved).make();
}

}  // namespace terp
