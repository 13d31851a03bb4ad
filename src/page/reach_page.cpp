// Every section has a row; one without a result shows its state and its fault instead of a verdict. Verdicts and hints
// come from the summary and io/results/reach. Words stand here in pairs, English and Dutch, chosen by one flag. A
// fault, and why there is no trigger, are in English alone, and are marked so on a Dutch page.

#include "page/reach_page.hpp"

#include "io/files/run_folder.hpp"
#include "io/files/svg.hpp"
#include "page/plain_page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace terp {
namespace {

constexpr const char* reach_style = R"(
th, td { padding: 6px 12px; vertical-align: top; white-space: normal; } thead th { vertical-align: bottom; }
td:last-child, thead th:last-child { text-align: right; white-space: nowrap; }
th.text, td.words { text-align: left; } td.words { max-width: 26em; }
td p + p { color: #566270; font-size: 0.87rem; }
.verdict { font-weight: 650; } .stands .verdict { color: #00694b; }
.damaged .verdict, .still_moving .verdict { color: #8a5a00; }
.floods .verdict, .fault .verdict { color: #b3261e; } .fault p { white-space: pre-line; }
td .mark { color: #8a5a00; }
a { color: #0b5f9e; } td svg { width: 210px; }
@media print { @page { size: A4 landscape; } td svg { width: 40mm; } }
)";

struct Words {
  const char *en, *nl;
  const char* in(bool dutch) const { return dutch ? nl : en; }
};

constexpr Words title{"Sections of a reach", "Doorsneden van een traject"},
    counts{
        "Solved: {} of {} sections. Stands: {}; damaged, holds the water: {}; still moving: {}; floods: {}; no verdict "
        "on the water: {}; no result: {}.",
        "Berekend: {} van {} doorsneden. Blijft staan: {}; beschadigd, keert het water: {}; beweegt nog: {}; "
        "overstroming: {}; geen oordeel over het water: {}; zonder resultaat: {}."},
    section{"Section", "Doorsnede"}, picture{"Ground before and after", "Maaiveld voor en na"},
    verdict{"Verdict", "Oordeel"}, height_left{"Height that remains", "Resthoogte"},
    freeboard{"Freeboard", "Waakhoogte"}, factor{"Factor of safety", "Stabiliteitsfactor"},
    stored{"stored", "opgeslagen"}, time{"Time", "Rekentijd"}, stands{"stands", "blijft staan"},
    damaged{"damaged, holds the water", "beschadigd, keert het water"},
    undecided{"still moving, not decided", "beweegt nog, niet beslist"}, floods{"floods", "overstroming"},
    no_flood{"no verdict on the water", "geen oordeel over het water"}, refused{"refused", "geweigerd"},
    failed{"failed", "mislukt"}, open{"not finished", "niet afgerond"},
    divided{"after strengths were divided by {}", "nadat de sterktes door {} zijn gedeeld"},
    raised{"after the river was brought to {} m", "nadat de rivier op {} m is gebracht"},
    after_stage{"after the stage {}", "na fase {}"}, before{"As it is: {}.", "Zoals zij is: {}."},
    moved_before{"no verdict, as it had not come to rest", "geen oordeel, want niet tot rust gekomen"},
    at_rest{"not at rest", "niet in rust"}, moving{" Not at rest at the end: {}.", " Aan het eind niet in rust: {}."},
    report{"report page", "rapport"}, assumed{"what was assumed", "aannamen"},
    caution{
        "Water that would flow over is not simulated. A verdict after a trigger is not that of the section as it is.",
        "Water dat zou overstromen is niet berekend. Een oordeel na een ingreep is niet dat van de doorsnede zoals zij "
        "is."},
    made{"Written {} by terp {}. The same as tables: reach.csv, reach.json.",
        "Geschreven {} door terp {}. Hetzelfde als tabel: reach.csv, reach.json."};

const Words& words_of(FloodVerdict verdict)
{
  switch (verdict) {
    case FloodVerdict::stands: return stands;
    case FloodVerdict::damaged: return damaged;
    case FloodVerdict::moving: return undecided;
    case FloodVerdict::floods: break;
  }
  return floods;
}

template <class... Args>
std::string filled(const Words& words, bool dutch, const Args&... args)
{
  return fmt::format(fmt::runtime(words.in(dutch)), args...);
}

std::string paragraph(const std::string& text, const char* attributes = "")
{
  return text.empty() ? "" : fmt::format("<p{}>{}</p>", attributes, escaped_for_markup(text));
}

/// Words of the record, which has them in English alone.
std::string english(const std::string& text, bool dutch) { return paragraph(text, dutch ? " lang=\"en\"" : ""); }

std::string trigger_in(const FloodTrigger& trigger, bool dutch)
{
  std::string text = trigger.at_strength != 1.0
                         ? filled(divided, dutch, decimal_sign(fmt::format("{:g}", trigger.at_strength), dutch))
                         : "";
  if (trigger.river)
    text += (text.empty() ? ""
                : dutch   ? " en "
                          : " and ") +
            filled(raised, dutch, decimal_sign(fmt::format("{:.2f}", *trigger.river), dutch));
  return text.empty() ? filled(after_stage, dutch, trigger.stage) : text;
}

std::string metres(std::optional<Real> value, bool dutch)
{
  return value && std::isfinite(*value) ? decimal_sign(fmt::format("{:.2f}", *value), dutch) + "&nbsp;m" : "&ndash;";
}

std::string class_of(const ReachSection& s)
{
  if (!s.is_solved) return "fault";
  const auto& flood = s.summary.flood;
  return flood && flood->verdict ? std::string(info_of(*flood->verdict).name) : "";
}

bool is_moving(const ReachSection& s) { return std::ranges::count(hints_on(s), Hint::moves) > 0; }

/// The verdict with what triggered it, or why there is none.
std::string verdict_cell(const ReachSection& s, bool dutch)
{
  std::string text;
  const auto& flood = s.summary.flood;
  if (!s.is_solved) {
    const std::string state = state_of(s);
    text = paragraph((state == "refused"     ? refused
                         : state == "failed" ? failed
                                             : open)
                         .in(dutch),
               " class=\"verdict\"") +
           english(s.record.fault, dutch);
  } else if (!flood || !flood->verdict) {
    text = paragraph(no_flood.in(dutch), " class=\"verdict\"");
  } else {
    const auto& trigger = flood->trigger;
    text = fmt::format("<p class=\"verdict\">{}{}</p>",
        escaped_for_markup(words_of(*flood->verdict).in(dutch) + (trigger ? ", " + trigger_in(*trigger, dutch) : "")),
        is_moving(s) ? fmt::format(" <span class=\"mark\">&#9888; {}</span>", at_rest.in(dutch)) : "");
    if (trigger && (trigger->before || moved_before_trigger(s)))
      text += paragraph(filled(before, dutch, (trigger->before ? words_of(*trigger->before) : moved_before).in(dutch)));
  }
  for (const Hint hint : hints_on(s)) text += paragraph(words_of(hint, s, dutch), " class=\"mark\"");
  if (s.is_solved) text += english(s.record.trigger, dutch);
  return "<td class=\"words\">" + text + "</td>";
}

std::string name_cell(const ReachSection& s, bool dutch)
{
  const std::string folder = escaped_for_markup(s.record.name);
  std::string text = s.is_solved ? fmt::format("<p><a href=\"{0}/{1}/{2}\" title=\"{3}\">{0}</a></p>", folder,
                                       run_of_section, report_file, report.in(dutch))
                                 : paragraph(s.record.name);
  text += paragraph(s.record.title);
  if (s.record.has_report) text += fmt::format("<p><a href=\"{}/report.md\">{}</a></p>", folder, assumed.in(dutch));
  return "<th class=\"text\" scope=\"row\">" + text + "</th>";
}

std::string factor_cell(const ReachSection& s, bool dutch)
{
  std::string text;
  if (s.record.factor)
    text = paragraph(
        decimal_sign(fmt::format("{:.3f} ± {:.3f}", *s.record.factor, s.record.uncertainty.value_or(0.0)), dutch));
  if (!s.record.stored.empty())
    text += paragraph(fmt::format("{}: {}", stored.in(dutch), stored_text(s.record, dutch)), " class=\"muted\"");
  return "<td class=\"words\">" + text + "</td>";
}

std::string row_of(const ReachSection& s, bool dutch)
{
  const auto& flood = s.summary.flood;
  const auto of_flood = [&](Real FloodSummary::*member) {
    return s.is_solved && flood ? std::optional((*flood).*member) : std::nullopt;
  };
  return fmt::format("<tr class=\"{}\">{}<td>{}</td>{}<td>{}</td><td>{}</td>{}<td>{:.0f}&nbsp;s</td></tr>\n",
      class_of(s), name_cell(s, dutch), reach_picture(s), verdict_cell(s, dutch),
      metres(s.is_solved ? s.summary.residual_height : std::nullopt, dutch),
      metres(of_flood(&FloodSummary::freeboard), dutch), factor_cell(s, dutch), s.record.seconds);
}

std::string counts_in(const std::vector<ReachSection>& sections, bool dutch)
{
  std::array<int, flood_verdicts.size()> n{};
  int n_solved = 0, n_moving = 0;
  for (const ReachSection& s : sections) {
    n_solved += s.is_solved ? 1 : 0, n_moving += is_moving(s) ? 1 : 0;
    if (const auto& flood = s.summary.flood; s.is_solved && flood && flood->verdict)
      ++n[static_cast<std::size_t>(*flood->verdict)];
  }
  const auto n_all = static_cast<int>(sections.size());
  return filled(counts, dutch, n_solved, n_all, n[0], n[1], n[2], n[3], n_solved - n[0] - n[1] - n[2] - n[3],
             n_all - n_solved) +
         (n_moving > 0 ? filled(moving, dutch, n_moving) : "");
}

std::string polyline(const std::vector<std::array<Real, 2>>& places, const char* style_of)
{
  std::string text = fmt::format("<polyline fill=\"none\" {} points=\"", style_of);
  for (const auto& [x, y] : places) text += fmt::format("{:.1f},{:.1f} ", x, y);
  return text + "\"/>";
}

}  // namespace

std::string reach_picture(const ReachSection& section)
{
  constexpr Real wide = 240.0, high = 80.0, edge = 4.0;
  std::array<Real, 2> low{1e30, 1e30}, top{-1e30, -1e30};
  const auto reach = [&](int d, Real value) {
    if (std::isfinite(value)) low[d] = std::min(low[d], value), top[d] = std::max(top[d], value);
  };
  for (const auto& [x, start, end] : section.profile) reach(0, x), reach(1, start), reach(1, end);
  if (section.water_level) reach(1, *section.water_level);
  if (!(low[0] < top[0] && low[1] < top[1])) return "";
  const auto px = [&](Real x) { return edge + (x - low[0]) / (top[0] - low[0]) * (wide - 2.0 * edge); };
  const auto py = [&](Real y) { return high - edge - (y - low[1]) / (top[1] - low[1]) * (high - 2.0 * edge); };
  const auto line = [&](std::size_t column) {
    std::vector<std::array<Real, 2>> places;
    for (const auto& row : section.profile)
      if (std::isfinite(row[column])) places.push_back({px(row[0]), py(row[column])});
    return places;
  };
  std::string text = fmt::format("<svg viewBox=\"0 0 {:g} {:g}\" role=\"img\">", wide, high);
  if (section.water_level)
    text += polyline({{edge, py(*section.water_level)}, {wide - edge, py(*section.water_level)}},
        "stroke=\"#3a86c8\" stroke-dasharray=\"3 3\"");
  text += polyline(line(1), "stroke=\"#98a3ae\" stroke-width=\"1.5\"");
  return text + polyline(line(2), "stroke=\"#18212b\" stroke-width=\"1.5\"") + "</svg>";
}

std::string reach_page(
    const std::vector<ReachSection>& sections, const std::string& language, const std::string& written)
{
  const bool dutch = language == "nl";
  std::string head;
  for (const auto& [words, is_text] : {std::pair{&section, true}, {&picture, true}, {&verdict, true},
           {&height_left, false}, {&freeboard, false}, {&factor, true}, {&time, false}})
    head += fmt::format("<th scope=\"col\"{}>{}</th>", is_text ? " class=\"text\"" : "", words->in(dutch));
  std::string rows;
  for (const ReachSection& s : sections) rows += row_of(s, dutch);
  return plain_page({.title = title.in(dutch),
      .name = title.in(dutch),
      .subtitle = counts_in(sections, dutch),
      .body = paragraph(caution.in(dutch), " class=\"notice\"") + "<div class=\"scroll\"><table>\n<thead><tr>" + head +
              "</tr></thead>\n<tbody>\n" + rows + "</tbody></table></div>",
      .footer = filled(made, dutch, written, TERP_VERSION),
      .language = dutch ? "nl" : "en",
      .style = reach_style});
}

}  // namespace terp
