// A DXF text is a list of pairs: a line with a group code, a line with a value. Code 0 begins an entity or section.

#include "import/drawing/dxf_file.hpp"

#include "math/errors.hpp"
#include "math/utf8.hpp"
#include "model/bodies/polygon.hpp"
#include "math/number_from.hpp"
#include "import/drawing/dxf_hatch.hpp"
#include "import/drawing/dxf_letters.hpp"
#include "import/drawing/dxf_shapes.hpp"
#include "import/drawing/dxf_units.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>

namespace terp {
namespace {

constexpr std::size_t most_problems = 10;
constexpr int comment = 999;
constexpr Real missing = std::numeric_limits<Real>::quiet_NaN();
constexpr Real flat = 0.005;       // [m]: distance of chords from a bent line
constexpr int most_depth = 16;     // of blocks in blocks
constexpr Real most_copies = 1e4;  // of a block by one INSERT
constexpr std::size_t most_inserted = 1'000'000;
constexpr DxfPlacement seen_from_behind{-1.0, 0.0, 0.0, 1.0, {0.0, 0.0}};
constexpr Real most_metres = 1e7;  // a coordinate beyond the Earth's grids is a fault of the file

struct Pair {
  int code;
  std::string_view value;
  std::size_t line;  ///< of the value
};

class DxfReader {
 public:
  DxfReader(const std::string& path, std::string_view text, Real unit, const std::vector<std::string>& layers)
      : path_(path), rest_(text), unit_(unit), layers_(layers)
  {
  }

  DxfDrawing read()
  {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // a byte order mark
    if (!next()) refuse("is no DXF file", "It is empty.");
    for (bool more = true; more;) more = read_section();
    if (!has_entities_) refuse("has no entities", "A DXF drawing has a section ENTITIES. Save it once more as DXF.");
    finish();
    return std::move(drawing_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& detail)
  {
    throw InputError({path_, what, detail, ""});
  }

  std::string_view line()
  {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view text = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    return text;
  }

  /// The next pair that is no comment.
  bool next()
  {
    while (next_of_any_kind())
      if (pair_.code != comment) return true;
    return false;
  }

  bool next_of_any_kind()
  {
    if (rest_.empty() || trimmed(rest_) == "\n") return false;
    const std::string_view code = line();
    if (code.empty() && rest_.empty()) return false;
    const auto number = number_from<int>(code);
    if (!number)
      refuse("is no DXF file", fmt::format("Line {} should be a group code, a whole number; got `{}`.", line_,
                                   std::string(code.substr(0, 40))));
    if (rest_.empty()) refuse("ends in the middle of a pair", fmt::format("Line {} is the last one.", line_));
    pair_.code = *number;
    pair_.value = line();
    pair_.line = line_;
    return true;
  }

  bool begins(std::string_view word) const { return pair_.code == 0 && pair_.value == word; }

  /// From one "0 SECTION" to behind its ENDSEC; false at the end.
  bool read_section()
  {
    if (begins("EOF")) return false;
    if (!begins("SECTION"))
      refuse("is no DXF file", fmt::format("Line {} should begin a section; got code {} with `{}`.", pair_.line,
                                   pair_.code, std::string(pair_.value.substr(0, 40))));
    if (!next()) refuse("ends in the middle of a section", "Its last section has no name.");
    const std::string name(pair_.code == 2 ? pair_.value : "");
    bool more = next();
    if (name == "HEADER") {
      more = read_header(more);
    } else if (name == "TABLES") {
      more = read_tables(more);
    } else if (name == "BLOCKS") {
      more = read_blocks(more);
    } else if (name == "ENTITIES") {
      has_entities_ = true;
      more = read_entities(more);
    }
    while (more && !begins("ENDSEC")) more = next();
    if (!more) refuse("ends in the middle of a section", fmt::format("The section {} has no ENDSEC.", name));
    return next();
  }

  bool read_header(bool more)
  {
    std::string_view variable;
    for (; more && !begins("ENDSEC"); more = next()) {
      if (pair_.code == 9) variable = pair_.value;
      if (variable == "$INSUNITS" && pair_.code == 70) header_unit_ = static_cast<int>(number());
      if (variable == "$DWGCODEPAGE" && pair_.code == 3) code_page_ = pair_.value;
    }
    return more;
  }

  Real number()
  {
    std::string_view text = pair_.value;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto value = number_from<Real>(text);
    if (!value || !(std::abs(*value) < 2e9))
      refuse("has a value that is no number", fmt::format("Line {}: group code {} needs a number, got `{}`.",
                                                  pair_.line, pair_.code, std::string(pair_.value.substr(0, 40))));
    return *value;
  }

  using Entity = DxfEntity;

  struct Block {
    Vec<2> base{0.0, 0.0};
    std::vector<Entity> entities = {};
  };

  /// One entity with its groups; stops at the next code 0. Of a kind that bounds nothing only what all have.
  bool read_groups(Entity& entity)
  {
    const bool has_shape = entity.is_line() || entity.is({"VERTEX", "INSERT", "BLOCK"});
    const bool is_hatch = entity.kind == "HATCH";
    bool has_paths = false, more = next();
    for (; more && pair_.code != 0; more = next()) switch (pair_.code) {
        case 2: entity.block = pair_.value; break;
        case 5: entity.handle = pair_.value; break;
        case 8: entity.layer = pair_.value; break;
        case 60: entity.hidden = number() != 0.0; break;
        case 67: entity.on_paper = number() != 0.0; break;
        default:
          if (has_shape && is_number_of_shape(pair_.code)) take_group(entity, pair_.code, number());
          if (!is_hatch) break;
          if (pair_.code == 91 || pair_.code == 75) has_paths = pair_.code == 91;
          if (has_paths && pair_.code < 100)
            entity.hatch.emplace_back(pair_.code, number_from<Real>(pair_.value).value_or(missing));
          if (pair_.code == 230) take_group(entity, pair_.code, number());
      }
    return more;
  }

  /// With the vertices of a POLYLINE.
  bool read_entity(Entity& entity)
  {
    entity.kind = pair_.value;
    if (entity.kind == "ELLIPSE") entity.scale = {0.0, 2.0 * std::numbers::pi};  // from and to, where not given
    bool more = read_groups(entity);
    if (entity.kind != "POLYLINE") return more;
    entity.places.clear(), entity.bulges.clear(), entity.z.clear();  // of a POLYLINE itself: no place
    while (more && begins("VERTEX")) {
      Entity vertex{"VERTEX"};
      more = read_groups(vertex);
      if (vertex.flags & 16) continue;  // a control point of a curve; the curve's own places come as well
      entity.z.insert(entity.z.end(), vertex.z.begin(), vertex.z.end());
      entity.places.push_back(vertex.places.empty() ? Vec<2>{missing, missing} : vertex.places[0]);
      entity.bulges.push_back(vertex.bulges.empty() ? 0.0 : vertex.bulges[0]);
    }
    if (more && begins("SEQEND")) {
      Entity end{"SEQEND"};
      more = read_groups(end);
    }
    return more;
  }

  bool read_entities(bool more)
  {
    while (more && !begins("ENDSEC")) {
      Entity entity{""};
      more = read_entity(entity);
      take(entity, {}, "", 0);
    }
    return more;
  }

  bool read_blocks(bool more)
  {
    while (more && !begins("ENDSEC")) {
      Entity head{std::string(pair_.value)};
      more = read_groups(head);
      if (head.kind != "BLOCK") continue;
      Block& block = blocks_[head.block];
      if (!head.places.empty() && !std::isnan(head.places[0][1])) block.base = head.places[0];
      while (more && !begins("ENDBLK") && !begins("ENDSEC"))
        more = read_entity(block.entities.emplace_back(Entity{""}));
    }
    return more;
  }

  /// Which layers are off, frozen or not plotted.
  bool read_tables(bool more)
  {
    while (more && !begins("ENDSEC")) {
      const bool is_layer = begins("LAYER");
      std::string name, state;
      for (more = next(); more && pair_.code != 0; more = next()) {
        if (!is_layer) continue;
        if (pair_.code == 2) name = pair_.value;
        if (pair_.code == 62 && number() < 0.0) state = "off";
        if (pair_.code == 70 && (static_cast<int>(number()) & 1)) state = "frozen";
        if (pair_.code == 290 && number() == 0.0) state = "not plotted";
      }
      if (!state.empty()) layer_states_[name] = state;
    }
    return more;
  }

  void problem(const Entity& entity, const std::string& what, const std::string& detail)
  {
    if (++n_problems_ > most_problems) return;
    problems_.push_back({fmt::format("{}: {} {}", path_, entity.kind,
                             entity.handle.empty() ? "without a handle" : "with handle " + entity.handle),
        what, fmt::format("It is on layer {}. {}", entity.layer, detail), ""});
  }

  bool is_chosen(const std::string& layer) const { return std::ranges::find(layers_, layer) != layers_.end(); }

  /// Left out by the drawing, by --layers, or as what bounds nothing; counted with its reason.
  bool is_left_out(const Entity& entity, const std::string& raw_layer, const std::string& layer)
  {
    if (entity.on_paper) return ++n_on_paper_, true;
    if (entity.hidden) return ++n_hidden_, true;
    const bool is_insert = entity.kind == "INSERT";
    const auto state = layer_states_.find(raw_layer);
    const bool is_shown = state == layer_states_.end() || (is_insert && state->second != "frozen");
    if (layers_.empty() && !is_shown) return left_layers_.insert(fmt::format("{} ({})", layer, state->second)), true;
    if (is_insert) return false;  // entities of its block have layers of their own
    all_layers_.insert(layer);
    if (!layers_.empty() && !is_chosen(layer)) return left_layers_.insert(layer), true;
    if (entity.is_line() || entity.kind == "HATCH") return false;
    if (!entity.is({"SEQEND", "ATTRIB", "VERTEX"})) ++others_[{layer, entity.kind}];
    return true;
  }

  /// outer_layer: that of the INSERT, which holds for layer 0 of its block.
  void take(const Entity& given, const DxfPlacement& outer, const std::string& outer_layer, int depth)
  {
    Entity entity = given;
    if (depth > 0 && entity.layer == "0") entity.layer = outer_layer;
    const std::string layer = dxf_letters(entity.layer, code_page_);
    if (is_left_out(entity, entity.layer, layer)) return;
    if (entity.kind == "INSERT") return take_block(entity, outer, depth);
    if (entity.kind == "HATCH") return take_hatch(entity, layer, outer);
    const bool is_line = entity.kind == "LINE";
    if (entity.kind == "POLYLINE" && (entity.flags & (16 | 64)))
      return problem(entity, "is a mesh", "Terp reads polylines only. Delete it, or draw its outline.");
    // Places of other kinds are those of the world, whatever their normal says.
    const bool has_own_plane = entity.is({"LWPOLYLINE", "ARC"}) || (entity.kind == "POLYLINE" && !(entity.flags & 8));
    if (entity.turned && (has_own_plane || entity.kind == "ELLIPSE"))
      return problem(entity, "does not lie in the plane of the drawing",
          "Its normal (code 210 to 230) is not 0, 0, 1 or 0, 0, -1. Draw the section in the plane of x and y.");
    if (std::ranges::any_of(entity.z, [&](Real z) { return std::abs(z - entity.z[0]) > 1e-9; }))
      return problem(entity, "does not lie in one plane",
          fmt::format("Its z goes from {:g} to {:g}. The elevation is y in a section: draw it in the plane of x and y.",
              std::ranges::min(entity.z), std::ranges::max(entity.z)));
    if (is_line) entity.places.push_back(entity.end), entity.bulges.push_back(0.0);
    for (const auto* places : {&entity.places, &entity.spline.fit})
      if (std::ranges::any_of(*places, [](const Vec<2>& x) { return std::isnan(x[0] + x[1]); }))
        return problem(entity, "has a place without x or y",
            "Codes 10 and 20 give x and y of a place, 11 and 21 of the end of a LINE. Save the drawing once more.");
    bool closed = entity.is({"LWPOLYLINE", "POLYLINE"}) && (entity.flags & 1);
    n_bent_ += is_bent(entity) ? 1 : 0;
    n_of_fit_places_ += entity.kind == "SPLINE" && entity.places.empty() ? 1 : 0;
    const DxfPlacement placement = has_own_plane && entity.mirrored ? joined(outer, seen_from_behind) : outer;
    entity.places = chords_of(entity, closed, flat / (metres_of_unit() * placement.largest()));
    if (entity.places.size() < 2) {
      ++others_[{layer, entity.kind}];
      return;
    }
    if (!is_line && !closed && entity.places.size() > 3 && entity.places.front() == entity.places.back()) closed = true;
    if (closed && entity.places.front() == entity.places.back()) entity.places.pop_back();
    for (Vec<2>& x : entity.places) x = placement(x);
    has_lost_letters_ = has_lost_letters_ || layer.find("\xEF\xBF\xBD") != std::string::npos;
    drawing_.lines.push_back({layer, std::move(entity.places), closed, entity.handle});
  }

  void take_hatch(const Entity& hatch, const std::string& layer, const DxfPlacement& outer)
  {
    const DxfPlacement placement = hatch.mirrored ? joined(outer, seen_from_behind) : outer;
    auto outlines = hatch_outlines(hatch.hatch, flat / (metres_of_unit() * placement.largest()), n_holes_of_hatches_);
    if (hatch.turned) outlines.clear();
    if (outlines.empty()) ++others_[{layer, hatch.kind}];
    for (auto& places : outlines) {
      for (Vec<2>& x : places) x = placement(x);
      drawing_.hatches.push_back({layer, std::move(places), true, hatch.handle});
    }
  }

  void take_block(const Entity& insert, const DxfPlacement& outer, int depth)
  {
    const auto block = blocks_.find(insert.block);
    if (block == blocks_.end() || insert.places.empty() || std::isnan(insert.places[0][1])) {
      lost_blocks_.insert(fmt::format("{} on {}", insert.block, insert.layer));
      return;
    }
    if (depth == most_depth || static_cast<Real>(insert.columns) * insert.rows > most_copies || insert.turned)
      return problem(insert, "is not read", "Its block is nested too deep, repeated too often or turned. Explode it.");
    for (int i = 0; i < insert.columns; ++i)
      for (int j = 0; j < insert.rows; ++j) {
        const DxfPlacement grid = placement_of(insert.places[0], {0.0, 0.0}, {1.0, 1.0}, insert.rotation);
        const Vec<2> at = grid({i * insert.spacing[0], j * insert.spacing[1]});
        DxfPlacement placement = placement_of(at, block->second.base, insert.scale, insert.rotation);
        if (insert.mirrored) placement = joined(seen_from_behind, placement);
        for (const Entity& entity : block->second.entities) {
          if (++n_inserted_ > most_inserted)
            refuse("inserts its blocks too often", "Explode them, or leave out their layer.");
          take(entity, joined(outer, placement), insert.layer, depth + 1);
        }
      }
  }

  void finish()
  {
    if (n_problems_ > most_problems)
      problems_.push_back({path_, fmt::format("has {} more such entities", n_problems_ - most_problems), "", ""});
    if (!problems_.empty()) throw InputError(std::move(problems_));
    check_chosen_layers();
    if (drawing_.lines.empty() && drawing_.hatches.empty())
      refuse("has no lines",
          fmt::format(
              "No LINE, LWPOLYLINE, POLYLINE, ARC, ELLIPSE, SPLINE or HATCH bounds a region.{}{} Draw outlines.",
              others_.empty() ? "" : " It has " + others_text() + ".",
              left_layers_.empty() ? "" : fmt::format(" Layers left out: {}.", fmt::join(left_layers_, ", "))));
    if (!others_.empty()) drawing_.notes.push_back(fmt::format("Bounds no region: {}.", others_text()));
    if (!left_layers_.empty())
      drawing_.notes.push_back(fmt::format("Layers left out: {}.", fmt::join(left_layers_, ", ")));
    if (n_bent_ > 0)
      drawing_.notes.push_back(fmt::format("{} bent lines were made of chords within {:g} m.", n_bent_, flat));
    if (!lost_blocks_.empty())
      drawing_.doubts.push_back(
          fmt::format("Blocks that are not in the drawing were left out: {}. Bind external references.",
              fmt::join(lost_blocks_, ", ")));
    if (n_of_fit_places_ > 0)
      drawing_.doubts.push_back(fmt::format(
          "{} splines have fit points alone: straight lines were drawn between them. Convert them to polylines.",
          n_of_fit_places_));
    if (n_on_paper_ > 0)
      drawing_.notes.push_back(fmt::format("{} entities of layouts (paper space) were left out.", n_on_paper_));
    if (n_hidden_ > 0)
      drawing_.notes.push_back(fmt::format("{} entities that the drawing hides (code 60) were left out.", n_hidden_));
    if (has_lost_letters_)
      drawing_.doubts.push_back(fmt::format(
          "Letters of layer names were lost: they are not of the code page of the drawing, {}. Known are ANSI_1250 to "
          "ANSI_1254, ANSI_1257, DOS437 and DOS850.",
          code_page_.empty() ? "ANSI_1252" : code_page_));
    const Real scale = unit_ > 0.0 ? unit_ : unit_of_header();
    const auto is_on_earth = [](const Vec<2>& x) {
      return std::abs(x[0]) < most_metres && std::abs(x[1]) < most_metres;
    };
    for (auto* lines : {&drawing_.lines, &drawing_.hatches})
      for (DxfLine& line : *lines)
        for (Vec<2>& x : line.places) x = {scale * x[0], scale * x[1]};
    for (const DxfLine& line : drawing_.lines)
      for (const Vec<2>& x : line.places)
        if (!is_on_earth(x))
          refuse("has a place beyond all maps",
              fmt::format("{:g}, {:g} m on layer {}. Check the unit of the drawing.", x[0], x[1], line.layer));
    std::erase_if(
        drawing_.hatches, [&](const DxfLine& hatch) { return !std::ranges::all_of(hatch.places, is_on_earth); });
    if (n_holes_of_hatches_ > 0)
      drawing_.notes.push_back(
          fmt::format("{} paths within a hatch were left out: what is drawn there counts.", n_holes_of_hatches_));
    drawing_.layers_are_chosen = !layers_.empty();
    doubt_width();
  }

  /// "2 TEXT on notes, 1 CIRCLE on marks".
  std::string others_text() const
  {
    std::string text;
    for (const auto& [what, n] : others_)
      text += fmt::format("{}{} {} on {}", text.empty() ? "" : ", ", n, what.second, what.first);
    return text;
  }

  void check_chosen_layers()
  {
    for (const std::string& layer : layers_)
      if (!all_layers_.contains(layer))
        refuse(fmt::format("has nothing on a layer `{}`", layer),
            fmt::format("Layers of it: {}.", fmt::join(all_layers_, ", ")));
  }

  /// Of the header or the option; 1 where it is not known yet.
  Real metres_of_unit() const
  {
    if (unit_ > 0.0) return unit_;
    for (const DxfUnit& known : dxf_units)
      if (header_unit_ && known.number == *header_unit_) return known.metres;
    return 1.0;
  }

  /// Many drawings are in metres, with a header that says millimetres, as that of an empty drawing does.
  void doubt_width()
  {
    std::vector<Vec<2>> places;
    for (const auto* lines : {&drawing_.lines, &drawing_.hatches})
      for (const DxfLine& line : *lines) places.insert(places.end(), line.places.begin(), line.places.end());
    const BoundingBox box = box_around(places);
    const Real width = box.high[0] - box.low[0], height = box.high[1] - box.low[1];
    if (width >= narrowest_section && width <= widest_section && height <= highest_section) return;
    drawing_.doubts.push_back(
        fmt::format("The section is {:.3g} m wide and {:.3g} m high: is that the unit of the drawing? --unit takes "
                    "another one.",
            width, height));
  }

  Real unit_of_header()
  {
    if (!header_unit_ || *header_unit_ == 0) {
      drawing_.notes.push_back("The drawing has no unit ($INSUNITS): one unit was taken as 1 m.");
      return 1.0;
    }
    for (const DxfUnit& known : dxf_units)
      if (known.number == *header_unit_) {
        drawing_.notes.push_back(fmt::format("The unit of the drawing is {}.", known.name));
        return known.metres;
      }
    refuse("has a unit that Terp does not know",
        fmt::format("$INSUNITS is {}; known are 1 in, 2 ft, 4 mm, 5 cm, 6 m, 14 dm. Set it in the drawing, or give "
                    "--unit.",
            *header_unit_));
  }

  const std::string& path_;
  std::string_view rest_;
  Real unit_;
  const std::vector<std::string>& layers_;  ///< empty: all that the drawing shows
  std::size_t line_ = 0, n_problems_ = 0, n_on_paper_ = 0, n_hidden_ = 0, n_bent_ = 0, n_inserted_ = 0,
              n_of_fit_places_ = 0, n_holes_of_hatches_ = 0;
  std::map<std::string, Block, std::less<>> blocks_;
  std::map<std::string, std::string> layer_states_;                    ///< of those that are not shown
  std::map<std::pair<std::string, std::string>, std::size_t> others_;  ///< by layer and kind: what bounds nothing
  std::set<std::string> left_layers_, all_layers_, lost_blocks_;
  std::string code_page_;  ///< of releases before 2007
  Pair pair_{};
  bool has_entities_ = false, has_lost_letters_ = false;
  std::optional<int> header_unit_;
  std::vector<Problem> problems_;
  DxfDrawing drawing_;
};

}  // namespace

Real dxf_unit(std::string_view name)
{
  for (const DxfUnit& unit : dxf_units)
    if (unit.name == name) return unit.metres;
  return 0.0;
}

DxfDrawing read_dxf_text(
    const std::string& path, std::string_view text, Real unit, const std::vector<std::string>& layers)
{
  return DxfReader(path, text, unit, layers).read();
}

DxfDrawing read_dxf(const std::string& path, Real unit, const std::vector<std::string>& layers)
{
  return read_dxf_text(path, read_file(path), unit, layers);
}

}  // namespace terp
