// All words of the page with the solver, in English and Dutch. {name} stands for a value.

import { LANGUAGES, type Language } from "../src/logic/texts";

export const TEXTS = {
  title: ["Terp: does the dike hold?", "Terp: houdt de dijk?"],
  intro: ["Drop a section here, and see whether it stands, where it slides, and how far the soil moves. Nothing is installed.",
    "Sleep een doorsnede hierheen en zie of hij blijft staan, waar hij afschuift en hoe ver de grond beweegt. Er wordt niets geïnstalleerd."],
  stays_here: ["Nothing leaves this machine: the policy of this page lets no script open a connection. It works without a network.",
    "Niets verlaat deze computer: de regels van deze pagina laten geen script verbinding maken. De pagina werkt zonder netwerk."],
  drop: ["Drop files here, or choose them", "Sleep bestanden hierheen, of kies ze"],
  kinds: ["A D-Stability file (.stix); a drawing (.dxf); a ground profile (.csv); a case (.toml) with its tables; a zip that was saved here; a report.html.",
    "Een D-Stability-bestand (.stix); een tekening (.dxf); een maaiveldprofiel (.csv); een case (.toml) met zijn tabellen; een zip die hier is bewaard; een report.html."],
  examples: ["Or take an example:", "Of neem een voorbeeld:"],
  example_dike: ["A dike and a flood", "Een dijk en hoogwater"],
  example_stix: ["A D-Stability section", "Een D-Stability-doorsnede"],
  example_slope: ["A slope in sensitive clay", "Een talud in gevoelige klei"],
  limits: ["What is not here", "Wat hier niet kan"],
  limits_text: ["Laws from libraries, meshes that gmsh makes, studies of many runs and more than one thread need Terp on a machine. A run takes up to 3 GB of memory.",
    "Wetten uit bibliotheken, rekennetten van gmsh, studies van veel berekeningen en meer dan één thread vragen Terp op een computer. Een berekening kan tot 3 GB geheugen gebruiken."],
  language: ["Language", "Taal"],

  reading: ["Reading {name} …", "{name} wordt gelezen …"],
  section: ["The section", "De doorsnede"],
  read_from: ["From {name}.", "Uit {name}."],
  read_as: ["What was read as what", "Wat als wat is gelezen"],
  other_file: ["Another file", "Een ander bestand"],
  picture: ["The section: soils, water, sides and loads", "De doorsnede: grondsoorten, water, randen en belastingen"],
  soil: ["Soil", "Grond"],
  area: ["Area", "Oppervlakte"],
  points: ["Material points", "Materiaalpunten"],
  cells: ["Cells", "Cellen"],
  cells_value: ["{n} of {size} m", "{n} van {size} m"],
  judged: ["Floods above", "Overstroming boven"],
  steps: ["Time steps", "Tijdstappen"],
  at_most: ["at most {n}", "hoogstens {n}"],
  memory: ["Memory", "Geheugen"],
  time: ["Time it takes here", "Rekentijd hier"],
  findings: ["Findings ({n})", "Bevindingen ({n})"],
  no_findings: ["No findings.", "Geen bevindingen."],
  findings_language: ["", "De bevindingen over de case zelf zijn in het Engels, zoals in de handleiding."],
  too_large: ["This takes {memory} of memory, and a page has 3 GB. Take cells of {cell} m or more, or Terp on a machine.",
    "Dit vraagt {memory} geheugen, en een pagina heeft 3 GB. Neem cellen van {cell} m of groter, of Terp op een computer."],
  too_long: ["This takes {time} here. Cells of {cell} m take about {other}.", "Dit duurt hier {time}. Cellen van {cell} m vragen ongeveer {other}."],

  choices: ["Choices", "Keuzes"],
  scenario: ["Scenario", "Scenario"],
  stage: ["Stage", "Fase"],
  cell: ["Size of the cells [m]", "Celgrootte [m]"],
  from_section: ["from the section", "uit de doorsnede"],
  strength: ["Strengths", "Sterktes"],
  strength_deterministic: ["as calculated with", "waarmee is gerekend"],
  strength_mean: ["mean", "gemiddelde"],
  strength_design: ["design", "rekenwaarde"],
  trigger: ["Makes it fail", "Laat hem bezwijken"],
  trigger_none: ["nothing: as drawn", "niets: zoals getekend"],
  trigger_water: ["river up to the crest", "rivier tot de kruin"],
  trigger_strength: ["strengths, as far as needed", "sterktes, zo ver als nodig"],
  at_strength: ["Divide strengths by", "Deel sterktes door"],
  least_depth: ["Slides at least this deep [m]", "Afschuivingen ten minste zo diep [m]"],
  what: ["What to find", "Wat te bepalen"],
  what_verdict: ["What happens: slides, remaining crest, flooding", "Wat gebeurt er: afschuivingen, resterende kruin, overstroming"],
  what_factor: ["Factor of safety", "Stabiliteitsfactor"],
  check_again: ["Look at it again", "Opnieuw bekijken"],

  run: ["Run", "Rekenen"],
  stop: ["Stop", "Stoppen"],
  go_on: ["Go on", "Verder rekenen"],
  stopping: ["Stopping …", "Wordt gestopt …"],
  searching: ["Looking for equilibrium: step {step}", "Evenwicht wordt gezocht: stap {step}"],
  solving: ["t = {time} of {end} s, step {step} of {steps}", "t = {time} van {end} s, stap {step} van {steps}"],
  left: ["{time} left", "nog {time}"],
  left_at_most: ["at most {time} left", "nog hoogstens {time}"],
  factor_so_far: ["Factor of safety: {line}", "Stabiliteitsfactor: {line}"],
  writing_report: ["Writing the report …", "Het rapport wordt geschreven …"],

  result: ["Result", "Resultaat"],
  factor_is: ["Factor of safety: {factor}", "Stabiliteitsfactor: {factor}"],
  mechanism: ["The mechanism at failure", "Het mechanisme bij bezwijken"],
  was_stopped: ["Stopped at t = {time} s. What there is so far is below; \"{go_on}\" continues from there.",
    "Gestopt op t = {time} s. Hieronder staat wat er tot dan toe is; \"{go_on}\" rekent daarvandaan verder."],
  was_ended: ["Stopped before there was anything to keep: a search cannot be interrupted half-way.",
    "Gestopt voordat er iets te bewaren was: een zoektocht kan niet halverwege worden onderbroken."],
  stopped_itself: ["The run stopped itself.", "De berekening is vanzelf gestopt."],
  report: ["Report of the run", "Rapport van de berekening"],
  words_of_program: ["What the program says", "Wat het programma zegt"],
  save: ["Save", "Bewaren"],
  save_report: ["Report (HTML)", "Rapport (HTML)"],
  save_case: ["Case and results (zip)", "Case en resultaten (zip)"],
  save_dxf: ["Profile (DXF)", "Profiel (DXF)"],
  save_csv: ["Profile (CSV)", "Profiel (CSV)"],
  save_stix: ["D-Stability (.stix)", "D-Stability (.stix)"],

  bad_file: ["{name} cannot be used.", "{name} kan niet worden gebruikt."],
  bad_kind: ["{name} is none of the files that this page takes.", "{name} is geen bestand dat deze pagina aanneemt."],
  bad_folder: ["A folder cannot be dropped. Choose the files in it.", "Een map kan niet. Kies de bestanden erin."],
  bad_size: ["{name} has {size}; this page takes files up to 200 MB.", "{name} is {size}; deze pagina neemt bestanden tot 200 MB."],
  bad_zip: ["{name} is damaged, or no zip file.", "{name} is beschadigd, of geen zipbestand."],
  bad_zip_large: ["{name} unpacks to more than 400 MB. Take the case and its tables alone.",
    "{name} is uitgepakt meer dan 400 MB. Neem alleen de case en zijn tabellen."],
  bad_report: ["{name} holds no case: it is no report of a run by Terp.", "{name} bevat geen case: het is geen rapport van een berekening met Terp."],
  bad_several: ["There are several cases: {names}. Drop one, with its tables.", "Er zijn meer cases: {names}. Sleep er één hierheen, met zijn tabellen."],
  bad_browser: ["This browser is too old for the solver: Chrome and Edge from 97, Firefox from 113, Safari from 16.4 can.",
    "Deze browser is te oud voor het rekenhart: Chrome en Edge vanaf 97, Firefox vanaf 113 en Safari vanaf 16.4 kunnen het."],
  bad_page: ["This file was cut short. Fetch terp.html anew.", "Dit bestand is niet compleet. Haal terp.html opnieuw op."],
  fault: ["The program ended by a fault of its own: {text}. Your files are as they were.", "Het programma is door een eigen fout geëindigd: {text}. Uw bestanden zijn zoals ze waren."],
  no_memory: ["There is not enough memory. Take larger cells, or close other tabs.", "Er is niet genoeg geheugen. Neem grotere cellen, of sluit andere tabbladen."],
  version: ["Terp {version}, terp.html of {size}, SHA-256 of the solver {sum}.", "Terp {version}, terp.html van {size}, SHA-256 van het rekenhart {sum}."],
  seconds: ["{s} s", "{s} s"],
  minutes: ["{m} min", "{m} min"],
  hours: ["{h} h", "{h} uur"],
} satisfies Record<string, [string, string]>;

export type TextKey = keyof typeof TEXTS;

let language: Language = "en";

export function chooseLanguage(codes: readonly string[]): void {
  const known = codes.map((code) => LANGUAGES.find((l) => code.toLowerCase().startsWith(l.code))?.code);
  language = known.find((code) => code !== undefined) ?? "en";
}

export const currentLanguage = (): Language => language;

export function say(key: TextKey, values: Record<string, string | number> = {}): string {
  return TEXTS[key][language === "nl" ? 1 : 0].replace(/\{(\w+)\}/g, (whole, name: string) => (name in values ? String(values[name]) : whole));
}

/** With the decimal sign of the language. */
export function number(value: number, digits = 3): string {
  return Number(value.toPrecision(digits)).toLocaleString(language === "nl" ? "nl-NL" : "en-GB", { maximumSignificantDigits: digits });
}

export function duration(seconds: number): string {
  if (seconds < 90) return say("seconds", { s: Math.max(1, Math.round(seconds)) });
  return seconds < 5400 ? say("minutes", { m: Math.round(seconds / 60) }) : say("hours", { h: number(seconds / 3600, 2) });
}

export function bytes(n: number): string {
  return n >= 1e9 ? `${number(n / 1e9, 2)} GB` : `${number(n / 1e6, 2)} MB`;
}
