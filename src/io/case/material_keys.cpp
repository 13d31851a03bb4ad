// These are the keys that a material may have whatever its law is; the parameters of a law come from its own table.
// Help shows the default of a key from the structs of the case, unless default_text stands here. A colour is read by a
// function of its own, since a plain text would accept any word.

#include "io/case/document.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/values.hpp"

#include <fmt/format.h>

namespace terp {
namespace {

// In the order of the enum.
std::vector<std::string> drainage_words() { return {"by_law", "drained", "undrained", "undrained_effective"}; }

/// "#rrggbb".
OwnForm color_field(std::string& color)
{
  constexpr std::string_view form = "text: a colour \"#rrggbb\"";
  return {std::string(form),
      [&color, form](const Entry& entry, Findings& findings) {
        const std::string& text = entry.node.text;
        const bool good = entry.node.kind == NodeKind::text && text.size() == 7 && text[0] == '#' &&
                          text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
        if (good)
          color = text;
        else
          findings.problems.push_back({entry.path, fmt::format("`{}` is no colour", last_part(entry.path)),
              fmt::format("Got {}; allowed: {}, as \"#d9b98a\".", describe_value(entry.node), form),
              topic_of(entry.key.path)});
        return good;
      },
      [&color] { return color.empty() ? std::string() : quoted_list({color}); }};
}

}  // namespace

std::vector<KeyInfo> material_keys()
{
  std::vector<KeyInfo> keys{
      {.path = "material.NAME.model",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].model; },
          .words = material_model_names,
          .required = true,
          .meaning = "constitutive law; see `terp list`"},
      {.path = "material.NAME.density",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].density; },
          .unit = "kg/m^3",
          .range = positive,
          .usual = {500.0, 5000.0},
          .required = true,
          .meaning = "mass per volume of the soil with its water (reading R16); a unit weight, as \"19.5 kN/m3\", is "
                     "divided by 9.81 m/s^2, whatever the gravity of the case. A table { below = N, above = N }: below "
                     "the phreatic line at t = 0, and above it"},
      {.path = "material.NAME.drainage",
          .field = [](Case& c, std::size_t i) { return word_field(c.materials[i].drainage); },
          .words = drainage_words,
          .in_stage = true,
          .meaning =
              "what the soil stores where there is water: drained soil effective stress, undrained soil total stress. "
              "undrained_effective: effective stress, while the pore water cannot leave. by_law: undrained for "
              "tresca_softening, ngi_adp and newtonian_fluid, drained for all others",
          .equation = "undrained_effective: d sigma = D' d eps + (K_w/n) tr(d eps) I"},
      {.path = "material.NAME.undrained_poisson_ratio",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].undrained_poisson_ratio; },
          .range = between_open(0.0, 0.5),
          .usual = between(0.45, 0.499),
          .in_stage = true,
          .meaning = "Poisson's ratio nu_u of undrained_effective soil with its water, above that of the soil alone. "
                     "The nearer to 0.5, the shorter the time step",
          .equation = "K_w/n = 2 G (1 + nu_u) / (3 (1 - 2 nu_u)) - K', with the largest G of the soil"},
      {.path = "material.NAME.water_stiffness",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].water_stiffness; },
          .unit = "Pa",
          .range = positive,
          .usual = between(1e5, 2.2e10),
          .in_stage = true,
          .meaning = "K_w/n of undrained_effective soil, bulk modulus of the pore water over the porosity; instead of "
                     "undrained_poisson_ratio",
          .default_text = "from undrained_poisson_ratio"},
      {.path = "material.NAME.k0",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].k0; },
          .range = between(0.0, 10.0),
          .usual = {0.2, 4.0},
          .meaning = "horizontal over vertical effective stress of this material, for initial.stress = \"k0\" or "
                     "\"equilibrium\"",
          .default_text = "the value of initial.k0"},
      {.path = "material.NAME.ground",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].ground; },
          .meaning = "whether slopes and dikes are made of it; false of a load that lies on the soil. A fluid is never "
                     "ground. Front, crest, slides, moved soil and [flood] look at ground alone"},
      {.path = "material.NAME.color",
          .field = [](Case& c, std::size_t i) { return color_field(c.materials[i].color); },
          .meaning = "of the soil in pictures, red, green and blue in hexadecimal digits: \"#d9b98a\"",
          .default_text = "by the name of the soil: sand, clay, peat, loam, gravel, dike; else one of eight"},
  };
  for (KeyInfo& key : flow_keys_of_material()) keys.push_back(std::move(key));
  return keys;
}

std::vector<KeyInfo> softening_keys()
{
  return {
      {.path = "material.NAME.softening.length",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].softening.length; },
          .unit = "m",
          .range = {0.0, 1e6},
          .usual = {1e-3, 10.0},
          .meaning = "distance l over which softening spreads: at least the size of a cell, better twice that or more, "
                     "and at most a twentieth of the height of the section; 0: each point softens by itself",
          .equation = "weights exp(-r^2 / l^2)"},
      {.path = "material.NAME.softening.reference_width",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].softening.reference_width; },
          .unit = "m",
          .range = not_negative,
          .usual = {1e-3, 10.0},
          .meaning =
              "width t_ref of the band for which the shape factors hold: a slip surface takes the energy of a band "
              "of this width, if it is one cell wide, or with a length as wide as that makes it; 0: of any width",
          .equation =
              "k += (h/t_ref) d(eps_eq_p), h = sqrt(area of the cell); with a length 3.07 l (m = 1.5) or 1.77 l "
              "(m = 1) for h"},
      {.path = "material.NAME.softening.m",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].softening.over_nonlocal; },
          .range = between(1.0, 2.0),
          .meaning = "weight of the nonlocal strain; above 1 the width of a band converges too, not only its energy",
          .equation = "k = max(k, m mean(eps_eq_p) + (1 - m) eps_eq_p)"},
      {.path = "material.NAME.softening.halo",
          .field = [](Case& c, std::size_t i) { return &c.materials[i].softening.halo; },
          .meaning = "whether soil beside a band, within about 2 l, softens too; false, with m = 1: only by what it "
                     "sheared itself, which keeps blocks whole but depends on the mesh",
          .equation = "false: k = max(k, min(mean(eps_eq_p), eps_eq_p))"},
  };
}

}  // namespace terp
