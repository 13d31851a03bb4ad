// Dutch names of fields, columns and passes. Their English comes from the program.

import { currentLanguage } from "./texts";

export const DUTCH: Record<string, string> = {
  // Fields
  eps_eq_p: "equivalente plastische rek",
  eps_deviatoric: "totale deviatorische rek",
  su: "ongedraineerde schuifsterkte",
  su_ratio: "resterende sterkte t.o.v. begin",
  pressure: "gemiddelde spanning, trek positief",
  pore_pressure: "waterspanning",
  excess_pressure: "wateroverspanning",
  velocity: "snelheid",
  displacement: "verplaatsing",
  opening: "volumerek waarmee de grond opengaat",
  eps_nonlocal: "niet-lokale plastische rek",
  eps_softening: "rek die de sterkte volgt",
  parameter_shear_modulus: "glijdingsmodulus G",
  parameter_poisson_ratio: "dwarscontractiecoëfficiënt",
  parameter_su_peak: "pieksterkte S_u",
  parameter_su_residual: "reststerkte S_u",
  parameter_su_remoulded: "geroerde sterkte S_u",
  parameter_eta: "vormfactor van de ontsterking",
  parameter_eta_remoulding: "vormfactor van de roering",
  cohesion: "cohesie",
  friction_angle: "hoek van inwendige wrijving",
  dilatancy_angle: "dilatantiehoek",
  parameter_cohesion: "cohesie, piek",
  parameter_friction_angle: "hoek van inwendige wrijving, piek",
  parameter_dilatancy_angle: "dilatantiehoek, piek",
  parameter_tension_cutoff: "grootste trekspanning",
  parameter_cohesion_residual: "restcohesie",
  parameter_friction_angle_residual: "resthoek van inwendige wrijving",
  parameter_dilatancy_angle_residual: "restdilatantiehoek",
  material: "grondsoort",
  // Columns
  time: "tijd",
  kinetic: "kinetische energie van de punten",
  kinetic_nodal: "kinetische energie van de knopen",
  elastic: "elastische energie",
  pore_elastic: "elastische energie van het poriënwater",
  plastic: "plastische arbeid",
  slip_work: "arbeid van het glijden langs grenzen tussen grondsoorten",
  gravity_work: "arbeid van de zwaartekracht",
  damping_work: "arbeid van de demping",
  boundary_work: "arbeid van de randen",
  clamp_work: "arbeid van de begrenzing",
  water_work: "arbeid van het water",
  load_work: "arbeid van de belastingen",
  balance_work: "arbeid van het drukverloop in de cellen",
  relaxation_work: "arbeid van de relaxatie",
  left_energy: "energie van grond die wegging",
  numerical: "numeriek, volgens de balans",
  transfer: "spanningsarbeid verloren tussen knopen en punten",
  pressure_reset: "elastische energie verloren bij het gladstrijken van de druk",
  unexplained: "niet verklaard door de balans",
  x: "x",
  y: "y",
  // Passes of the step
  "points to cells": "punten naar cellen",
  nodes: "knopen",
  "cells to points": "cellen naar punten",
  velocities: "snelheden",
  stress: "spanning",
  move: "verplaatsen",
  relaxation: "relaxatie",
  softening: "ontsterking",
};

/** The label of the program, or its Dutch. */
export function quantityLabel(name: string, label: string): string {
  return currentLanguage() === "nl" ? (DUTCH[name] ?? label) : label;
}
