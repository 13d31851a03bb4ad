// What is told of a file and of the section in it, in English and Dutch: remarks of the reader and doubts of the
// import. One table, so that no sentence is in one language alone. Not for: what was assumed, which stands where it is
// assumed.
#pragma once

#include "math/sentence.hpp"

namespace terp::reported_texts {

// ---- by the reader: a form without a place is a sentence ----

inline constexpr SentenceForm no_state_type{"There is no StateType here. The soil counts as normally consolidated.",
    "Hier staat geen StateType. De grond telt als normaal geconsolideerd."};
inline constexpr SentenceForm empty_state_line{"This state line has no places or no values. Left out.",
    "Deze toestandslijn heeft geen punten of geen waarden. Weggelaten."};
inline constexpr SentenceForm no_reference_places{
    "The reference line `{}` has no places. Left out.", "De referentielijn `{}` heeft geen punten. Weggelaten."};
inline constexpr SentenceForm no_reference_head{"The reference line `{}` has no head line. Left out.",
    "De referentielijn `{}` heeft geen stijghoogtelijn. Weggelaten."};
inline constexpr SentenceForm no_excavation_line{
    "This excavation has no line. It takes nothing away.", "Deze ontgraving heeft geen lijn. Zij neemt niets weg."};
inline constexpr SentenceForm no_spread{
    "The load `{}` has no Spread. Taken was: 0.", "De belasting `{}` heeft geen Spread. Aangehouden is: 0."};
inline constexpr SentenceForm unknown_calculation{
    "The CalculationType `{}` is not known to Terp.", "Het CalculationType `{}` is Terp niet bekend."};
inline constexpr SentenceForm no_foot{"{} slices have no foot. Left out.", "{} lamellen hebben geen voet. Weggelaten."};
inline constexpr SentenceForm unknown_model{
    "The strength model `{}` of the soil `{}` is not known to Terp: no strength follows from it.",
    "Het sterktemodel `{}` van de grond `{}` is Terp niet bekend: er volgt geen sterkte uit."};
inline constexpr SentenceForm leads_nowhere{
    "{} names what is not in the file (id {}).", "{} noemt iets dat niet in het bestand staat (id {})."};
inline constexpr SentenceForm result_of_none{
    "No calculation names this result. It was not used.", "Geen berekening noemt dit resultaat. Het is niet gebruikt."};
inline constexpr SentenceForm runs_back{
    "This line runs back. Where an x has several elevations, the first part of the line counts.",
    "Deze lijn loopt terug. Waar een x meer hoogten heeft, telt het eerste deel van de lijn."};
inline constexpr SentenceForm missing_key{"This key is missing{}{}, though files of this kind have it. Taken was: {}.",
    "Deze sleutel ontbreekt{}{}, terwijl bestanden van deze soort hem hebben. Aangehouden is: {}."};
inline constexpr SentenceForm times{" ({} times)", " ({} keer)"};
inline constexpr SentenceForm stage_number{"scenario {}, stage {}", "scenario {}, fase {}"};

// ---- by the reader, of a stage: what has no place in a continuum, or stops it ----

inline constexpr SentenceForm forbidden_lines{
    "Forbidden lines, which no slip plane of D-Stability crosses, often sheet piles: {}. Left out.",
    "Verboden lijnen, waar geen glijvlak van D-Stability door gaat, vaak damwanden: {}. Weggelaten."};
inline constexpr SentenceForm geotextiles{"Geotextiles: {}. Left out.", "Geotextielen: {}. Weggelaten."};
inline constexpr SentenceForm nails{"Nails: {}. Left out.", "Nagels: {}. Weggelaten."};
inline constexpr SentenceForm drawn_line{"`{}` at x = {:.2f} m", "`{}` bij x = {:.2f} m"};
inline constexpr SentenceForm line_loads{"Line loads: {}. Left out.", "Lijnlasten: {}. Weggelaten."};
inline constexpr SentenceForm trees{
    "Trees: {}. Their wind load is left out.", "Bomen: {}. Hun windbelasting is weggelaten."};
inline constexpr SentenceForm earthquake{
    "An earthquake is switched on. Left out.", "Er staat een aardbeving aan. Weggelaten."};
inline constexpr SentenceForm layer_load{
    "The layer with the id {} is a load with less than 100 % consolidation. Its excess pore pressure is left out.",
    "De laag met het id {} is een belasting met minder dan 100 % consolidatie. Haar wateroverspanning is weggelaten."};
inline constexpr SentenceForm layer_without_soil{"The layer `{}` (id {}) has no soil. This stage cannot be computed.",
    "De laag `{}` (id {}) heeft geen grond. Deze fase kan niet worden berekend."};
inline constexpr SentenceForm state_of_no_layer{
    "The state point `{}` is of a layer that this stage does not have (id `{}`). Left out.",
    "Het toestandspunt `{}` is van een laag die deze fase niet heeft (id `{}`). Weggelaten."};
inline constexpr SentenceForm two_states{
    "The layer with the id {} has two state points. This stage and later ones cannot be computed.",
    "De laag met het id {} heeft twee toestandspunten. Deze fase en latere kunnen niet worden berekend."};
inline constexpr SentenceForm no_layers{"This stage has no soil layers and cannot be computed.",
    "Deze fase heeft geen grondlagen en kan niet worden berekend."};

// ---- doubts: loads ----

inline constexpr SentenceForm load_of_no_size{"Load {}: it has no width or no size in the section.",
    "Belasting {}: zij heeft in het dwarsprofiel geen breedte of geen grootte."};
inline constexpr SentenceForm layers_as_loads{
    "Layers that count as loads without full consolidation: their excess pore pressure.",
    "Lagen die als belasting tellen zonder volledige consolidatie: hun wateroverspanning."};

// ---- doubts: states ----

inline constexpr SentenceForm of_state{"Stage `{}`, {}: {}.", "Fase `{}`, {}: {}."};
inline constexpr SentenceForm state_of_layer{"state `{}` of the layer {}", "toestand `{}` van de laag {}"};
inline constexpr SentenceForm state_of_line{"state `{}`", "toestand `{}`"};
inline constexpr SentenceForm layer_of_id{"with the id {}", "met het id {}"};
inline constexpr SentenceForm ocr_below_one{"its OCR is {:g}, below 1: it counts as 1, normally consolidated",
    "de OCR is {:g}, kleiner dan 1: zij telt als 1, normaal geconsolideerd"};
inline constexpr SentenceForm yield_below_stress{
    "its yield stress of {:.1f} kPa is below the effective stress there, {:.1f} kPa: the soil counts as normally "
    "consolidated",
    "de grensspanning van {:.1f} kPa is kleiner dan de korrelspanning daar, {:.1f} kPa: de grond telt als normaal "
    "geconsolideerd"};
inline constexpr SentenceForm large_pop{
    "its POP is {:.0f} kPa; soft soil has tens of kPa", "de POP is {:.0f} kPa; slappe grond heeft tientallen kPa"};
inline constexpr SentenceForm state_outside{
    "it lies at {:.2f}, {:.2f} m, outside of that layer. Its POP holds there all the same",
    "zij ligt op {:.2f}; {:.2f} m, buiten die laag. Haar POP geldt er toch"};
inline constexpr SentenceForm no_pop{
    "The layer `{}` has SHANSEP strength, but no state point or state line of any stage gives it a POP above zero: it "
    "counts as normally consolidated, the weakest that it can be.",
    "De laag `{}` heeft SHANSEP-sterkte, maar geen toestandspunt of toestandslijn van enige fase geeft haar een POP "
    "boven nul: zij telt als normaal geconsolideerd, de zwakste die zij kan zijn."};
inline constexpr SentenceForm pop_of_a_far_line{
    "The layer `{}` has no state point in any stage, and no state line touches it: its POP of {:.1f} kPa is that of a "
    "state line {:.2f} m {} it, at x = {:.2f} m. Is a state missing?",
    "De laag `{}` heeft in geen fase een toestandspunt, en geen toestandslijn raakt haar: haar POP van {:.1f} kPa is "
    "die van een toestandslijn {:.2f} m {} haar, bij x = {:.2f} m. Ontbreekt er een toestand?"};
inline constexpr SentenceForm below_it{"below", "onder"};
inline constexpr SentenceForm above_it{"above", "boven"};

// ---- doubts: water and river ----

inline constexpr SentenceForm no_phreatic_line{"Stage `{}` has no phreatic line: all of its soil counts as dry.",
    "Fase `{}` heeft geen freatische lijn: alle grond ervan telt als droog."};
inline constexpr SentenceForm no_phreatic_line_before{
    "Stage `{}` has no phreatic line: all of its soil counts as dry, and yield stresses are at least what it carries "
    "then.",
    "Fase `{}` heeft geen freatische lijn: alle grond ervan telt als droog, en grensspanningen zijn ten minste wat zij "
    "dan draagt."};
inline constexpr SentenceForm water_below_all{
    "The phreatic line of stage `{}` is at most at {:.2f} m, below all of its soil, which ends at {:.2f} m: all soil "
    "counts as dry. Is the water of another datum?",
    "De freatische lijn van fase `{}` komt niet hoger dan {:.2f} m, onder alle grond, die ophoudt op {:.2f} m: alle "
    "grond telt als droog. Is het water van een ander referentievlak?"};
inline constexpr SentenceForm deep_water{
    "The phreatic line of stage `{}` lies {:.1f} m or more below the ground, more than twice the height of the dike "
    "({:.1f} m). Is the water of another datum?",
    "De freatische lijn van fase `{}` ligt {:.1f} m of meer onder het maaiveld, meer dan tweemaal de hoogte van de "
    "dijk ({:.1f} m). Is het water van een ander referentievlak?"};
inline constexpr SentenceForm left_end{"left", "linker"};
inline constexpr SentenceForm right_end{"right", "rechter"};
inline constexpr SentenceForm tops_and_toes_differ{
    "The file has the top of its embankment's water side at the {} end, but its toe at the {} end. The river is taken "
    "to be at the {} end.",
    "Het bestand heeft de kruin van de waterzijde van de dijk aan het {}einde, maar de teen aan het {}einde. "
    "Aangenomen is dat de rivier aan het {}einde ligt."};
inline constexpr SentenceForm embankment_outside{
    "The file has a point of its embankment at x = {:.2f} m, outside of the section ({:.2f} to {:.2f} m). The river is "
    "taken to be at the {} end.",
    "Het bestand heeft een punt van de dijk bij x = {:.2f} m, buiten het dwarsprofiel ({:.2f} tot {:.2f} m). "
    "Aangenomen is "
    "dat de rivier aan het {}einde ligt."};
inline constexpr SentenceForm water_at_other_end{
    "The file has its embankment's water side at the {} end, but water stands on the ground at the {} end, and higher: "
    "{:.2f} m, not {:.2f} m. The river is taken to be at the {} end.",
    "Het bestand heeft de waterzijde van de dijk aan het {}einde, maar aan het {}einde staat water op het maaiveld, en "
    "hoger: {:.2f} m, niet {:.2f} m. Aangenomen is dat de rivier aan het {}einde ligt."};
inline constexpr SentenceForm equally_high{
    "Water stands equally high on the ground at both ends of the section ({:.2f} m), and the file names no water side "
    "of the embankment: the end of the river is not known.",
    "Aan beide einden van het dwarsprofiel staat het water even hoog op het maaiveld ({:.2f} m), en het bestand noemt "
    "geen waterzijde van de dijk: de rivierzijde is niet bekend."};
inline constexpr SentenceForm higher_but_dry{
    "The phreatic line is higher at the {} end ({:.2f} m, below the ground), but water stands on the ground at the {} "
    "end alone ({:.2f} m), and the file names no water side of the embankment. The river is taken to be at the {} end.",
    "De freatische lijn is hoger aan het {}einde ({:.2f} m, onder het maaiveld), maar alleen aan het {}einde staat "
    "water op het maaiveld ({:.2f} m), en het bestand noemt geen waterzijde van de dijk. Aangenomen is dat de rivier "
    "aan het {}einde ligt."};
inline constexpr SentenceForm dry_at_either_end{
    "No water stands on the ground at either end of the section: the case has no [flood], and no verdict on flooding.",
    "Aan geen einde van het dwarsprofiel staat water op het maaiveld: de invoer heeft geen [flood], en er is geen "
    "oordeel over overstromen."};
inline constexpr SentenceForm dry_at_the_river{
    "No water stands on the ground at the river's end ({}) of the section: the case has no [flood], and no verdict on "
    "flooding.",
    "Aan het {}einde van het dwarsprofiel, dat van de rivier, staat geen water op het maaiveld: de invoer heeft geen "
    "[flood], en er is geen oordeel over overstromen."};
inline constexpr SentenceForm narrow_river{
    "The water at the river's end ({:.2f} m) stands on less than a cell of ground: the case has no [flood], and no "
    "verdict on flooding.",
    "Het water aan de rivierzijde ({:.2f} m) staat op minder dan een cel maaiveld: de invoer heeft geen "
    "[flood], en er is geen oordeel over overstromen."};
inline constexpr SentenceForm above_crest{
    "The river of this stage ({:.2f} m) stands above the crest ({:.2f} m): it floods without any slide. A lower "
    "water_level judges a slide.",
    "De rivier van deze fase ({:.2f} m) staat boven de kruin ({:.2f} m): overstroming zonder afschuiving. Een lagere "
    "water_level beoordeelt een afschuiving."};

// ---- doubts: embankment ----

inline constexpr SentenceForm toe_water{"toe at the water side", "teen aan de waterzijde"};
inline constexpr SentenceForm top_water{"top at the water side", "kruin aan de waterzijde"};
inline constexpr SentenceForm top_land{"top at the land side", "kruin aan de landzijde"};
inline constexpr SentenceForm shoulder_land{
    "base of the shoulder at the land side", "voet van de berm aan de landzijde"};
inline constexpr SentenceForm toe_land{"toe at the land side", "teen aan de landzijde"};
inline constexpr SentenceForm point_without_ground{
    "The file has the {} of its embankment at x = {:.2f} m, where there is no ground.",
    "Het bestand heeft de {} van de dijk bij x = {:.2f} m, waar geen grond is."};
inline constexpr SentenceForm points_in_no_order{
    "The points of the embankment of the file are in no order: the {} is at x = {:.2f} m, the {} at x = {:.2f} m.",
    "De punten van de dijk in het bestand staan in geen volgorde: de {} ligt bij x = {:.2f} m, de {} bij x = {:.2f} "
    "m."};
inline constexpr SentenceForm point_on_other_side{
    "The file has the {} of its embankment at x = {:.2f} m, but the crest is at x = {:.2f} m and the river at the {} "
    "end: it lies on the wrong side of the crest.",
    "Het bestand heeft de {} van de dijk bij x = {:.2f} m, maar de kruin ligt bij x = {:.2f} m en de rivier aan het "
    "{}einde: zij ligt aan de verkeerde kant van de kruin."};

// ---- doubts: numbers and outlines ----

inline constexpr SentenceForm unusual_weight{
    "{} weighs {:g} kN/m3: {:g} to {:g} kN/m3 are usual. Is it in another unit?",
    "{} weegt {:g} kN/m3: gewoon is {:g} tot {:g} kN/m3. Is het een andere eenheid?"};
inline constexpr SentenceForm water_of_stage{"The water of the stage", "Het water van de fase"};
inline constexpr SentenceForm soil_above{
    "The soil `{}` above the phreatic line", "De grond `{}` boven de freatische lijn"};
inline constexpr SentenceForm soil_below{
    "The soil `{}` below the phreatic line", "De grond `{}` onder de freatische lijn"};
inline constexpr SentenceForm large_load{
    "The load `{}` is {:g} kPa, as much as {:.0f} m of soil. Is it in another unit?",
    "De belasting `{}` is {:g} kPa, zoveel als {:.0f} m grond. Is het een andere eenheid?"};
inline constexpr SentenceForm empty_below{
    "Below the layer `{}` no layer covers {:.3g} m2, up to {:.2f} m high, between x = {:.2f} and {:.2f} m: it is "
    "empty. Is a layer missing?",
    "Onder de laag `{}` bedekt geen laag {:.3g} m2, tot {:.2f} m hoog, tussen x = {:.2f} en {:.2f} m: daar is niets. "
    "Ontbreekt er een laag?"};
inline constexpr SentenceForm layers_overlap{
    "The layers {} overlap by {:.3g} m2 at {:.2f}, {:.2f} m: the one with the smaller outline counts.",
    "De lagen {} overlappen {:.3g} m2 bij {:.2f}; {:.2f} m: die met de kleinere omtrek telt."};
inline constexpr SentenceForm filled_below{
    "Below the layer `{}` the file has no soil, down to {:.2f} m under it: {:.1f} m2 were filled with that layer. Is a "
    "layer missing?",
    "Onder de laag `{}` heeft het bestand geen grond, tot {:.2f} m eronder: {:.1f} m2 is met die laag gevuld. "
    "Ontbreekt er een laag?"};

// ---- what was assumed ----

inline constexpr SentenceForm no_dilatancy{
    "{}: its dilatancy is empty in the file; taken was 0.", "{}: de dilatantie is leeg in het bestand; genomen is 0."};
inline constexpr SentenceForm reduced_friction{
    "{}: phi' = {:g} degrees and c' = {:g} kPa of the file were reduced to {:.2f} and {:.2f}, as D-Stability reduces "
    "them on slip planes of soil that dilates by {:g} degrees.",
    "{}: phi' = {:g} graden en c' = {:g} kPa van het bestand zijn verlaagd tot {:.2f} en {:.2f}, zoals D-Stability "
    "doet op glijvlakken in grond met {:g} graden dilatantie."};
inline constexpr SentenceForm line_of_table{
    "{}: its SigmaTauTable was replaced by the straight line nearest to it from 0 to {:.0f} kPa: {:.2f} kPa + {:.3f} "
    "sigma'_n.",
    "{}: de SigmaTauTable is vervangen door de rechte lijn die er van 0 tot {:.0f} kPa het dichtst bij ligt: {:.2f} "
    "kPa + {:.3f} sigma'_n."};
inline constexpr SentenceForm steep_line{
    "{}: the friction angle of its line is {:.1f} degrees; taken was {:g}, the most that the law takes. The soil is "
    "weaker than in the file.",
    "{}: de hoek van inwendige wrijving van die lijn is {:.1f} graden; genomen is {:g}, het hoogste dat het grondmodel "
    "kent. De grond is zwakker dan in het bestand."};
inline constexpr SentenceForm no_strength{
    "{}: the file has c' = 0 and phi' = 0 {} the phreatic line; taken was c' = {:g} kPa, so that the soil does not "
    "flow like water.",
    "{}: het bestand heeft c' = 0 en phi' = 0 {} de freatische lijn; genomen is c' = {:g} kPa, zodat de grond niet als "
    "water wegvloeit."};
inline constexpr SentenceForm least_su{
    "{}: s_u is at least {:g} kPa; in D-Stability it is zero where sigma'_v is zero.",
    "{}: s_u is ten minste {:g} kPa; in D-Stability is zij nul waar sigma'_v nul is."};
inline constexpr SentenceForm stiffness{"{}: stiffness, Poisson's ratio and K0 are defaults of {}.",
    "{}: stijfheid, dwarscontractie en K0 zijn standaardwaarden van de soort {}."};
inline constexpr SentenceForm strength_taken_away{
    "{}: by its name its author took its strength away, as engineers do where the ground lifts.",
    "{}: volgens de naam is de sterkte weggenomen, zoals bij opdrijven gebruikelijk is."};
inline constexpr SentenceForm face_cohesion{
    "{}: a cohesion of {:g} kPa down to {:g} m below the ground, in place of {:.2f} kPa, so that the face does not "
    "ravel. "
    "--face-cohesion 0 leaves it out.",
    "{}: een cohesie van {:g} kPa tot {:g} m onder het maaiveld, in plaats van {:.2f} kPa, zodat het talud niet "
    "afschilfert. "
    "--face-cohesion 0 laat haar weg."};
inline constexpr SentenceForm film{
    "Under the border at the top of {}, x from {:.1f} to {:.1f} m, a film of {:g} m has the strength of that border, "
    "{:.1f} to {:.1f} kPa: soil slides there where water pushes from below. A row of cells would carry {:.0f} kN/m "
    "more. --no-film leaves it out.",
    "Onder de bovenkant van {}, x van {:.1f} tot {:.1f} m, heeft een glijlaag van {:g} m de sterkte van die grens, "
    "{:.1f} tot {:.1f} kPa (opdrijfzone): daar schuift grond af waar water van onderen drukt. Een rij cellen zou "
    "{:.0f} kN/m meer dragen. --no-film laat haar weg."};
inline constexpr SentenceForm yield_grid{"{}: its grid of yield stresses gives those of the file within {:.1f} kPa.",
    "{}: het raster van grensspanningen geeft die van het bestand binnen {:.1f} kPa."};
inline constexpr SentenceForm load_spread{
    "Load {}: its spread of {:g} degrees is not set; the run computes how it spreads.",
    "Belasting {}: de spreiding van {:g} graden is niet opgelegd; de berekening bepaalt haar."};
inline constexpr SentenceForm load_consolidation{
    "Load {}: undrained soil does not gain strength from it, whatever its degree of consolidation; drained soil does "
    "at once, as at 100 %.",
    "Belasting {}: ongedraineerde grond wordt er niet sterker door, wat de consolidatiegraad ook is; gedraineerde "
    "grond meteen, als bij 100 %."};
inline constexpr SentenceForm all_dry{"The stage has no water: the case has none, and all soil is dry.",
    "De fase heeft geen water: de invoer ook niet, en alle grond is droog."};
inline constexpr SentenceForm water_beneath{"Stage {} has no water: in the case it stands below the section.",
    "Fase {} heeft geen water: in de invoer staat het onder het dwarsprofiel."};
inline constexpr SentenceForm changed_layers{
    "Layers or loads change between the stages of the file: the run has those of the analysed stage from the start. "
    "Yield stresses follow the ground, water and loads of each stage.",
    "Lagen of belastingen veranderen tussen de fasen van het bestand: de berekening heeft vanaf het begin die van de "
    "beschouwde fase. Grensspanningen volgen uit maaiveld, water en belasting van elke fase."};
inline constexpr SentenceForm changed_ground{
    "Earlier stages of the file have other ground.{} The run has the ground of the analysed stage from its start: "
    "settlement, stress and slides of the building are not in it. Yield stresses, and so undrained strengths, follow "
    "the ground, water and loads of each stage.",
    "Eerdere fasen van het bestand hebben ander maaiveld.{} De berekening heeft vanaf het begin het maaiveld van de "
    "beschouwde fase: zetting, spanning en afschuivingen van de aanleg zitten er niet in. Grensspanningen, en dus "
    "ongedraineerde sterktes, volgen uit maaiveld, water en belasting van elke fase."};
inline constexpr SentenceForm since{" Since {}: {}.", " Sinds {}: {}."};
inline constexpr SentenceForm was_added{
    "{:.1f} m2 were added (x = {:.1f} to {:.1f} m)", "{:.1f} m2 opgehoogd (x = {:.1f} tot {:.1f} m)"};
inline constexpr SentenceForm was_removed{
    "{:.1f} m2 were taken away (x = {:.1f} to {:.1f} m)", "{:.1f} m2 ontgraven (x = {:.1f} tot {:.1f} m)"};
inline constexpr SentenceForm river_moved{
    "The river stands at {:.2f} m instead of the {:.2f} m of the file (--river). The heads in the ground move in "
    "proportion to their height over the phreatic line at the land's end ({:.2f} m), as in a steady state.{} Undrained "
    "strengths are those of this water.",
    "De rivier staat op {:.2f} m in plaats van {:.2f} m in het bestand (--river). De stijghoogten in de grond bewegen "
    "mee, naar rato van hun hoogte boven de freatische lijn aan de landzijde ({:.2f} m), als in een stationaire "
    "toestand.{} Ongedraineerde sterktes horen bij dit water."};
inline constexpr SentenceForm after_fall{" After a fast fall the pressures in the outer slope would be higher.",
    " Na een snelle val zouden de waterspanningen in het buitentalud hoger zijn."};
inline constexpr SentenceForm river_there_already{
    "The river stands at {:.2f} m in the file already: --river changes nothing.",
    "De rivier staat in het bestand al op {:.2f} m: --river verandert niets."};

// ---- a study ----

inline constexpr SentenceForm study_of_file{"The distributions of the study are those of the file.",
    "De verdelingen van de probabilistische som zijn die van het bestand."};
inline constexpr SentenceForm study_not_of_file{
    "The distributions of the study are NOT of the file, which has none. Means are its plain values, coefficients of "
    "variation those of the kinds of soil in the table of defaults: P says what such a spread would mean, not how "
    "probable "
    "a flood is here. --soil-defaults takes a table of your own.",
    "De verdelingen van de probabilistische som zijn NIET van het bestand, dat er geen heeft. Gemiddelden zijn de "
    "gewone "
    "waarden, variatiecoëfficiënten die van de grondsoorten in de tabel met standaardwaarden: P zegt wat zo'n "
    "spreiding "
    "zou betekenen, niet hoe waarschijnlijk een overstroming hier is. --soil-defaults neemt een eigen tabel."};

}  // namespace terp::reported_texts
