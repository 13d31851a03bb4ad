// A DXF text is a list of pairs: a line with a group code, a line with a value. Code 0 begins an entity or section.

#include "import/drawing/dxf_file.hpp"

#include "math/errors.hpp"
#include "math/utf8.hpp"
#include "math/number_from.hpp"
#include "import/drawing/dxf_letters.hpp"
#include "os/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace terp {
namespace {

constexpr std::size_t most_problems = 10;
constexpr int comment = 999;
constexpr Real missing = std::numeric_limits<Real>::quiet_NaN();
constexpr Real narrowest = 1.0, widest = 5e3;  // [m] of a section without doubt
constexpr Real most_metres = 1e7;              // a coordinate beyond the Earth's grids is a fault of the file

struct Unit {
  int number;  ///< of $INSUNITS
  const char* name;
  Real metres;
};
constexpr Unit units[] = {
    {6, "m", 1.0}, {4, "mm", 1e-3}, {5, "cm", 1e-2}, {14, "dm", 0.1}, {2, "ft", 0.3048}, {1, "in", 0.0254}};

struct Pair {
  int code;
  std::string_view value;
  std::size_t line;  ///< of the value
};

class DxfReader {
 public:
  DxfReader(const std::string& path, std::string_view text, Real unit) : path_(path), rest_(text), unit_(unit) {}

  DxfDrawing read()
  {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // a byte order mark
    if (rest_.starts_with("AutoCAD Binary DXF")) refuse("is a binary DXF file", "Save the drawing as ASCII DXF.");
    if (rest_.starts_with("AC10")) refuse("is a DWG file", "Save the drawing as ASCII DXF.");
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
    } else if (name == "ENTITIES") {
      has_entities_ = true;
      while (more && !begins("ENDSEC")) more = read_entity();
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

  struct Entity {
    std::string kind;
    std::string handle = {}, layer = "0";
    std::vector<Vec<2>> places = {};
    Vec<2> end{missing, missing};
    std::vector<Real> z = {};  ///< all that are given
    int flags = 0;
    std::size_t bulges = 0;
    bool on_paper = false, turned = false, hidden = false;
  };

  /// One entity with its groups; stops at the next code 0.
  bool read_groups(Entity& entity)
  {
    bool more = next();
    for (; more && pair_.code != 0; more = next()) switch (pair_.code) {
        case 5: entity.handle = pair_.value; break;
        case 8: entity.layer = pair_.value; break;
        case 10: entity.places.push_back({number(), missing}); break;
        case 20:
          if (!entity.places.empty()) entity.places.back()[1] = number();
          break;
        case 11: entity.end[0] = number(); break;
        case 21: entity.end[1] = number(); break;
        case 30:
        case 31: entity.z.push_back(number()); break;
        case 42: entity.bulges += number() != 0.0 ? 1 : 0; break;
        case 60: entity.hidden = number() != 0.0; break;
        case 67: entity.on_paper = number() != 0.0; break;
        case 70: entity.flags = static_cast<int>(number()); break;
        case 230: entity.turned = std::abs(number() - 1.0) > 1e-9; break;
        default: break;
      }
    return more;
  }

  bool read_entity()
  {
    Entity entity{std::string(pair_.value)};
    bool more = read_groups(entity);
    const bool is_old_polyline = entity.kind == "POLYLINE";
    if (is_old_polyline) {
      entity.places.clear();  // of a POLYLINE itself: no place
      entity.z.clear();
      for (; more && begins("VERTEX");) {
        Entity vertex{"VERTEX"};
        more = read_groups(vertex);
        entity.bulges += vertex.bulges;
        if (vertex.flags & 16) continue;  // a control point of a curve; the curve's own places come as well
        entity.z.insert(entity.z.end(), vertex.z.begin(), vertex.z.end());
        entity.places.push_back(vertex.places.empty() ? Vec<2>{missing, missing} : vertex.places[0]);
      }
      if (more && begins("SEQEND")) {
        Entity end{"SEQEND"};
        more = read_groups(end);
      }
    }
    if (entity.on_paper)
      ++n_on_paper_;
    else if (entity.hidden)
      ++n_hidden_;
    else
      take(entity, is_old_polyline);
    return more;
  }

  void problem(const Entity& entity, const std::string& what, const std::string& detail)
  {
    if (++n_problems_ > most_problems) return;
    problems_.push_back({fmt::format("{}: {} {}", path_, entity.kind,
                             entity.handle.empty() ? "without a handle" : "with handle " + entity.handle),
        what, fmt::format("It is on layer {}. {}", entity.layer, detail), ""});
  }

  void take(Entity& entity, bool is_old_polyline)
  {
    const bool is_line = entity.kind == "LINE";
    if (!is_line && !is_old_polyline && entity.kind != "LWPOLYLINE")
      return problem(entity, "is not read",
          "Terp reads LINE, LWPOLYLINE and POLYLINE with straight sides. Turn it into one of these, or delete it.");
    if (entity.bulges > 0)
      return problem(entity, "has arcs",
          fmt::format("{} of its sides are bent (code 42). Turn them into straight ones.", entity.bulges));
    if (is_old_polyline && (entity.flags & (16 | 64)))
      return problem(entity, "is a mesh", "Terp reads polylines only. Delete it, or draw its outline.");
    if (entity.turned)
      return problem(entity, "does not lie in the plane of the drawing",
          "Its normal (code 210 to 230) is not 0, 0, 1. Draw the section in the plane of x and y.");
    if (std::ranges::any_of(entity.z, [&](Real z) { return std::abs(z - entity.z[0]) > 1e-9; }))
      return problem(entity, "does not lie in one plane",
          fmt::format("Its z goes from {:g} to {:g}. The elevation is y in a section: draw it in the plane of x and y.",
              std::ranges::min(entity.z), std::ranges::max(entity.z)));
    if (is_line) entity.places.push_back(entity.end);
    if (std::ranges::any_of(entity.places, [](const Vec<2>& x) { return std::isnan(x[0] + x[1]); }))
      return problem(entity, "has a place without x or y",
          "Codes 10 and 20 give x and y of a place, 11 and 21 of the end of a LINE. Save the drawing once more.");
    if (entity.places.size() < 2)
      return problem(entity, "has fewer than two places", fmt::format("Got {}. Delete it.", entity.places.size()));
    bool closed = !is_line && (entity.flags & 1);
    if (!is_line && !closed && entity.places.size() > 3 && entity.places.front() == entity.places.back()) closed = true;
    if (closed && entity.places.front() == entity.places.back()) entity.places.pop_back();
    const std::string layer = dxf_letters(entity.layer, code_page_);
    has_lost_letters_ = has_lost_letters_ || layer.find("\xEF\xBF\xBD") != std::string::npos;
    drawing_.lines.push_back({layer, std::move(entity.places), closed, entity.handle});
  }

  void finish()
  {
    if (n_problems_ > most_problems)
      problems_.push_back({path_, fmt::format("has {} more such entities", n_problems_ - most_problems), "", ""});
    if (!problems_.empty()) throw InputError(std::move(problems_));
    if (drawing_.lines.empty()) refuse("has no lines", "Its section ENTITIES has no LINE, LWPOLYLINE or POLYLINE.");
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
    for (DxfLine& line : drawing_.lines)
      for (Vec<2>& x : line.places) {
        x = {scale * x[0], scale * x[1]};
        if (!(std::abs(x[0]) < most_metres && std::abs(x[1]) < most_metres))
          refuse("has a place beyond all maps",
              fmt::format("{:g}, {:g} m on layer {}. Check the unit of the drawing.", x[0], x[1], line.layer));
      }
    doubt_width();
  }

  /// Many drawings are in metres, with a header that says millimetres, as that of an empty drawing does.
  void doubt_width()
  {
    Real low = most_metres, high = -most_metres;
    for (const DxfLine& line : drawing_.lines)
      for (const Vec<2>& x : line.places) low = std::min(low, x[0]), high = std::max(high, x[0]);
    if (high - low >= narrowest && high - low <= widest) return;
    drawing_.doubts.push_back(fmt::format(
        "The section is {:.3g} m wide: is that the unit of the drawing? --unit takes another one.", high - low));
  }

  Real unit_of_header()
  {
    if (!header_unit_ || *header_unit_ == 0) {
      drawing_.notes.push_back("The drawing has no unit ($INSUNITS): one unit was taken as 1 m.");
      return 1.0;
    }
    for (const Unit& known : units)
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
  std::size_t line_ = 0, n_problems_ = 0, n_on_paper_ = 0, n_hidden_ = 0;
  std::string code_page_;  ///< of releases before 2007
  Pair pair_{};
  bool has_entities_ = false, has_lost_letters_ = false;
  std::optional<int> header_unit_;
  std::vector<Problem> problems_;
  DxfDrawing drawing_;
};

/// Release 12 knows letters, digits, $, - and _ in names of layers.
std::string layer_name(const std::string& name)
{
  std::string text;
  for (const char c : name)
    text += std::isalnum(static_cast<unsigned char>(c)) || c == '$' || c == '-' || c == '_' ? c : '_';
  return text.empty() ? "0" : text.substr(0, 31);
}

}  // namespace

Real dxf_unit(std::string_view name)
{
  for (const Unit& unit : units)
    if (unit.name == name) return unit.metres;
  return 0.0;
}

DxfDrawing read_dxf_text(const std::string& path, std::string_view text, Real unit)
{
  return DxfReader(path, text, unit).read();
}

DxfDrawing read_dxf(const std::string& path, Real unit) { return read_dxf_text(path, read_file(path), unit); }

std::string dxf_text(const std::vector<DxfLine>& lines)
{
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n";
  std::set<std::string> layers;
  for (const DxfLine& line : lines) layers.insert(layer_name(line.layer));
  text += fmt::format("0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n{}\n", layers.size());
  int colour = 0;
  for (const std::string& layer : layers)
    text += fmt::format("0\nLAYER\n2\n{}\n70\n0\n62\n{}\n6\nCONTINUOUS\n", layer, 1 + colour++ % 7);
  text += "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (const DxfLine& line : lines) {
    const std::string layer = layer_name(line.layer);
    text += fmt::format("0\nPOLYLINE\n8\n{}\n66\n1\n10\n0.0\n20\n0.0\n30\n0.0\n70\n{}\n", layer, line.closed ? 1 : 0);
    for (const Vec<2>& x : line.places)
      text += fmt::format("0\nVERTEX\n8\n{}\n10\n{:.6f}\n20\n{:.6f}\n30\n0.0\n", layer, x[0], x[1]);
    text += fmt::format("0\nSEQEND\n8\n{}\n", layer);
  }
  return text + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace terp
