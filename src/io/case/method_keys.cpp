// The list comes in two parts, one for the stresses and one for the motion of the points. Every scheme accepts all of
// these keys. Which of them a scheme does not use is said in the file of the scheme (unused_options), and not here.

#include "io/case/key_table.hpp"

namespace terp {
namespace {

template <MethodChoice Choice>
std::vector<std::string> words()
{
  const auto all = words_of(Choice{});
  return {all.begin(), all.end()};
}

}  // namespace

std::vector<KeyInfo> method_keys()
{
  return {
      {.path = "method.as",
          .field = [](Case& c, std::size_t) { return word_field(c.method_form); },
          .words = words<MethodForm>,
          .meaning =
              "what the options of this section are where they are not given: those of Terp, which stand here as "
              "defaults, or those with which Terp repeats the paper (decision 0073): shares = point, strain_shares = "
              "plain, volume_change = centre, pressure = constant, cut_cells = mean, flip = 1. What is given counts"},
      {.path = "method.shares",
          .field = [](Case& c, std::size_t) { return word_field(c.method.shares); },
          .words = words<Shares>,
          .meaning =
              "where a material point counts: in the sub-cell that holds its centre (point), or in every sub-cell "
              "by the part of its extent that lies in it (overlap). by_law: overlap, but point in a case with a fluid "
              "and in schemes that know no other"},
      {.path = "method.weights",
          .field = [](Case& c, std::size_t) { return word_field(c.method.weights); },
          .words = words<Weights>,
          .meaning =
              "weight of a Gauss point (reading R3): the Gauss rule in filled cells and the volume of the points "
              "elsewhere (hybrid), or the volume of the points (summed)"},
      {.path = "method.filled_fraction",
          .field = [](Case& c, std::size_t) { return &c.method.filled_fraction; },
          .range = {0.0, 1.0, true, false},
          .meaning = "a cell is filled when its points fill at least this part of it (reading R3)",
          .equation = "sum_p Omega_p >= filled_fraction V_e"},
      {.path = "method.b_bar",
          .field = [](Case& c, std::size_t) { return &c.method.b_bar; },
          .meaning =
              "volumetric strain of the cell centre at all Gauss points, against locking, and the internal force "
              "that does its work (readings R4, R5)",
          .equation = "d_eps_bar = d_eps + (theta_0 - tr d_eps) I / 3,  theta_0 = tr d_eps(0)"},
      {.path = "method.strain_shares",
          .field = [](Case& c, std::size_t) { return word_field(c.method.strain_shares); },
          .words = words<StrainShares>,
          .meaning = "how the strain of the Gauss points reaches the points: with the shares of Eq. (1) alone (plain), "
                     "or with the weights of the force as well, so that both ways are transposes (transposed)",
          .equation = "transposed: d_eps_p = sum_g s_pg (Omega_g/W_g) d_eps_g / sum_g s_pg (Omega_g/W_g)"},
      {.path = "method.volume_change",
          .field = [](Case& c, std::size_t) { return word_field(c.method.volume_change); },
          .words = words<VolumeChange>,
          .meaning = "where B-bar takes the volume change of a cell that the soil does not fill: in its centre "
                     "(centre), or as the mean over its soil (soil)"},
      {.path = "method.pressure",
          .field = [](Case& c, std::size_t) { return word_field(c.method.pressure); },
          .words = words<Pressure>,
          .meaning =
              "pressure of a soil within a cell: one number, Eqs. (2) and (3) (constant), or with the slope that "
              "its weight and its acceleration ask for (balanced)",
          .equation = "balanced: f_i += sum_g Omega_g grad N_i G.(x_g - mean x),  G = -rho g + grad p_w + rho a"},
      {.path = "method.cut_cells",
          .field = [](Case& c, std::size_t) { return word_field(c.method.cut_cells); },
          .words = words<CutCells>,
          .meaning = "strain of the soils in a cell that their border cuts: all have that of the cell, which then has "
                     "the mean of their strengths (mean), or once one yields they also slip along the border until the "
                     "shear stress on it is the same on both sides (slip; decision 0071)",
          .equation = "d_eps_m = B (du_i - k s_i t) + g_m sym(t n),  tau_m = t.sigma_m.n equal in all soils"},
  };
}

std::vector<KeyInfo> motion_keys()
{
  return {
      {.path = "method.objective_rate",
          .field = [](Case& c, std::size_t) { return word_field(c.method.objective_rate); },
          .words = words<ObjectiveRate>,
          .meaning = "whether the stress turns with the soil (reading R17)",
          .equation = "jaumann: sigma += (d_omega sigma - sigma d_omega)"},
      {.path = "method.remap_contact",
          .field = [](Case& c, std::size_t) { return word_field(c.method.remap_contact); },
          .words = words<RemapContact>,
          .meaning = "what a contact plane does to the remapped velocity: it stops what crosses it and acts along "
                     "itself with the strength that it left unused in pass 2, or it acts across alone, which may do "
                     "work on soil at rest"},
      {.path = "method.relaxation_time",
          .field = [](Case& c, std::size_t) { return &c.method.relaxation_time; },
          .unit = "s",
          .range = not_negative,
          .meaning = "time constant with which points lose the part of their velocity that the mesh does not see; 0: "
                     "they keep it (decision 0048)",
          .equation = "v_p <- v_p + (1 - exp(-t/relaxation_time)) (sum N U_i - v_p), U_i fitted to the points"},
      {.path = "method.flip",
          .field = [](Case& c, std::size_t) { return &c.method.flip; },
          .range = between(0.0, 1.0),
          .meaning = "share of FLIP in the velocity of the points; 0: pure PIC",
          .equation = "v_p <- flip (v_p + dt sum N a_i) + (1 - flip) sum N v*_i",
          .default_text = "1; of fluids 0.95"},
      {.path = "method.small_mass",
          .field = [](Case& c, std::size_t) { return &c.method.small_mass; },
          .range = {0.0, 0.001, false, true},
          .meaning = "nodes lighter than this part of a full cell are not accelerated; they move with their points",
          .equation = "m_i < small_mass rho V_e: a_i = 0"},
  };
}

}  // namespace terp
