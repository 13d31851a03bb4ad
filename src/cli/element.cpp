// Element tests of the materials of a case, one after the other: a table of each, and a page of all. What stops one
// leaves the others, and what it had.

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "io/case/printable.hpp"
#include "io/case/units.hpp"
#include "io/element/element_case.hpp"
#include "io/element/element_csv.hpp"
#include "io/files/files.hpp"
#include "io/files/run_folder.hpp"
#include "math/number_from.hpp"
#include "model/parts/setup.hpp"
#include "os/say.hpp"
#include "page/element_page.hpp"
#include "page/page.hpp"
#include "run/element/element_tests.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace terp {
namespace {

[[noreturn]] void refuse_element(const std::string& what, const std::string& cure)
{
  throw CaseError(printable(fmt::format("error: {}\n  {}\n", what, cure)));
}

/// "100 kPa", or a number in Pa.
Real stress_of(const char* option, const std::string& text)
{
  Node node;
  node.kind = NodeKind::text, node.text = text;
  const std::optional<Real> value = number_from<Real>(text);
  const std::optional<Real> found = value ? value : number_of(node, "Pa");
  if (!found || !std::isfinite(*found))
    refuse_element(
        fmt::format("{}: `{}` is no stress", option, text), "Give a number in Pa, or one with its unit: \"100 kPa\".");
  return *found;
}

const ElementTestInfo& test_of(const std::string& name)
{
  return *std::ranges::find(element_tests(), name, &ElementTestInfo::name);
}

/// The soil with the stress that it begins with: of its place, of its body, or as the command has it.
ElementAtPlace start_of(const ElementCommand& command, const Case& c, const MaterialCase& material)
{
  ElementAtPlace found = command.place.empty()
                             ? ElementAtPlace{element_soil(c, material), start_of_element(c, material)}
                             : element_at(build_model(c, 1), material, {command.place[0], command.place[1]});
  if (!command.pressure.empty()) {
    const Real vertical = -stress_of("--pressure", command.pressure);
    found.stress = {vertical, vertical, vertical, 0.0};
  }
  found.stress[0] *= command.k0, found.stress[2] *= command.k0;
  return found;
}

ElementPath path_of(const ElementCommand& command, const std::array<Real, 4>& stress)
{
  if (!command.path.empty()) try {
      return read_path_csv(command.path, {.stress = stress,
                                             .undrained = command.undrained,
                                             .increments = command.increments,
                                             .duration = command.duration});
    } catch (const FileError& error) {
      throw CaseError(printable(fmt::format("error: {}\n", error.what())));
    }
  ElementTestOptions options{.test = &test_of(command.test),
      .stress = stress,
      .undrained = command.undrained,
      .strain = command.strain,
      .duration = command.duration};
  if (command.increments > 0) options.increments = command.increments;
  for (const std::string& load : command.load) options.load.push_back(stress_of("--load", load));
  if (options.strain.empty() && options.load.empty())
    refuse_element("the element is not driven",
        "Give the turning points of its strain or of its stress: --strain 0.1, or --load \"200 kPa\".");
  return path_of_test(options);
}

std::string title_of(const ElementCommand& command)
{
  const std::string what = command.path.empty() ? command.test + " test" : "path of " + command.path;
  return fmt::format("{}, {}", what, command.undrained ? "undrained" : "drained");
}

/// "clay below" -> "clay_below.csv"
std::string file_of(const std::string& material)
{
  std::string name = material;
  std::ranges::replace_if(
      name, [](unsigned char c) { return !(std::isalnum(c) || c == '_' || c == '-' || c == '.' || c >= 0x80); }, '_');
  return name + ".csv";
}

/// Numbers in another unit than Pa and 1, told by what the soil does and by its stiffness.
void doubt_path(const ElementCommand& command, const ElementAtPlace& start, const ElementOnPage& element)
{
  constexpr Real none = 1e-6, all = 1.0, least = 3e-5, most = 1.0, little = 0.1;
  const auto largest = [&](const char* prefix) {
    Real found = 0.0;
    for (const ElementColumn& column : element.result.columns)
      if (column.name.starts_with(prefix))
        for (const Real value : column.values) found = std::max(found, std::abs(value));
    return found;
  };
  const Real strain = largest("strain_"), pressure = -start.stress[1],
             share = pressure / start.soil.law->shear_modulus();
  const auto is_far_less = [&](const std::string& load) {
    return std::abs(stress_of("--load", load)) < little * pressure;
  };
  const auto doubt = [&](bool is_odd, const std::string& what, const char* cure) {
    if (is_odd) say(stderr, "{}", printable(fmt::format("warning: {}: {}\n  {}\n", element.material, what, cure)));
  };
  doubt(strain > all, fmt::format("a strain of {:.3g}", strain), "Strains are parts: 10 % is 0.1.");
  doubt(element.result.fault.empty() && strain < none, fmt::format("a largest strain of {:.2g}", strain),
      "Strains are parts, and stresses in Pa: 10 % is 0.1, 100 kPa is 100e3.");
  doubt(pressure > 0.0 && (share < least || share > most),
      fmt::format("a pressure of {:.4g} Pa at the start is {:.2g} times G", pressure, share),
      "Stresses are in Pa: 100 kPa is 100e3, or \"100 kPa\". Usual: 0.001 to 0.1 times.");
  doubt(!command.load.empty() && std::ranges::all_of(command.load, is_far_less),
      fmt::format("all loads are far below the {:.4g} Pa of the start", pressure),
      "Stresses are in Pa: 100 kPa is 100e3, or \"100 kPa\".");
  doubt(std::ranges::adjacent_find(command.strain) != command.strain.end(), "two turning points are the same",
      "Between them nothing happens: --strain 0.1,0,0.2 goes there and back.");
}

void print_table(const std::vector<ElementOnPage>& elements)
{
  say("  {:<20} {:>12} {:>12} {:>12} {:>12} {:>12} {:>12}\n", "material", "largest q", "at strain", "p at end",
      "q at end", "u at end", "vol. strain");
  say("  {:<20} {:>12} {:>12} {:>12} {:>12} {:>12} {:>12}\n", "", "kPa", "-", "kPa", "kPa", "kPa", "-");
  for (const ElementOnPage& element : elements) {
    const auto& q = element.result.at("deviator");
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(q) - q.begin());
    const auto last = [&](const char* name) { return element.result.at(name).back(); };
    const Real u = last("pore_pressure");
    say("  {:<20} {:>12.5g} {:>12.4g} {:>12.5g} {:>12.5g} {:>12} {:>12.4g}\n", element.material, q[peak] / 1e3,
        element.result.at("deviator_strain")[peak], last("mean_pressure") / 1e3, q.back() / 1e3,
        std::isnan(u) ? "-" : fmt::format("{:.5g}", u / 1e3), std::round(1e6 * last("volume_strain")) / 1e6 + 0.0);
  }
}

}  // namespace

int test_elements(const ElementCommand& command)
{
  const CaseFile file = read_element_case(command.case_path, command.changes);
  const std::string folder =
      command.output.empty() ? default_run_folder(command.case_path) + "_element" : command.output;
  std::vector<ElementOnPage> elements;
  try {
    for (const MaterialCase* material : materials_of_element(file.values, command.materials)) {
      const ElementAtPlace start = start_of(command, file.values, *material);
      elements.push_back({material->name, material->model,
          follow_path(start.soil, path_of(command, start.stress), command.void_ratio.value_or(std::nan("")))});
      doubt_path(command, start, elements.back());
    }
  } catch (const InputError& error) {
    throw CaseError(render(error.problems(), file));
  }
  make_folder(folder);
  const std::string title = title_of(command);
  std::string files;
  for (const ElementOnPage& element : elements) {
    write_file_atomically(path_in(folder, file_of(element.material)), element_csv(element.result));
    files += ", " + file_of(element.material);
  }
  write_file_atomically(
      path_in(folder, "element.html"), make_page(page_template(), element_payload(title, elements, now_in_utc())));
  if (!command.quiet) {
    say("{}\n", title);
    print_table(elements);
    say("in {}: element.html{}\n", folder, files);
  }
  bool all_solved = true;
  for (const ElementOnPage& element : elements) {
    if (element.result.fault.empty()) continue;
    all_solved = false;
    say(stderr, "error: the soil `{}` does not follow the path to its end\n  {}\n", element.material,
        element.result.fault);
  }
  return all_solved ? solved : stopped_itself;
}

}  // namespace terp
