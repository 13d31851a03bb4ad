// Words of the pages of a study, a reach and a sequence of meshes, in English and Dutch: part of the table in texts.ts.

export const DOCUMENT_TEXTS = {
  low_to_high: ["{low} to {high}", "{low} tot {high}"],
  low_and_high: ["{low} and {high}", "{low} en {high}"],

  // Sizes of cells
  mesh_window: ["{title}: cell sizes", "{title}: celgroottes"],
  mesh_subtitle: ["Does the result depend on the mesh? {case}, a change counts from {tolerance} on",
    "Hangt het resultaat af van het rekennet? {case}, een verandering telt vanaf {tolerance}"],
  mesh_foot: ["The numbers: convergence.json.", "De getallen: convergence.json."],
  mesh_as_given: ["as given", "zoals gegeven"],
  mesh_over_size: ["Over the size of the cells", "Tegen de celgrootte"],
  mesh_size_axis: ["size of the cells [m]", "celgrootte [m]"],
  mesh_in_words: ["In words", "In woorden"],
  mesh_change: ["change", "verandering"],
  mesh_order: ["order", "orde"],
  mesh_limit: ["limit", "limiet"],
  mesh_error: ["error", "fout"],
  mesh_answer: ["answer", "antwoord"],
  mesh_answer_none: ["–", "–"],
  mesh_answer_same: ["the same", "gelijk"],
  mesh_answer_settled: ["settled", "ligt vast"],
  mesh_answer_unresolved: ["within its resolution", "binnen de resolutie"],
  mesh_answer_tends: ["tends to a limit", "gaat naar een limiet"],
  mesh_answer_depends: ["depends on the mesh", "hangt af van het rekennet"],
  mesh_answer_some_sizes: ["depends on the mesh: only some sizes have it",
    "hangt af van het rekennet: alleen sommige groottes hebben het"],
  mesh_variants: ["All variants", "Alle varianten"],
  mesh_range: ["range", "spreiding"],
  mesh_share: ["share", "aandeel"],
  mesh_how: ["How to read this", "Hoe dit te lezen"],
  mesh_how_change: ["Change: between the two smallest sizes, as a share of the value; of a place, of its distance " +
    "since t = 0, at least one cell.",
    "Verandering: tussen de twee kleinste groottes, als deel van de waarde; van een plaats als deel van de afstand " +
    "sinds t = 0, ten minste één cel."],
  mesh_how_order: ["Order: observed order p of the three smallest sizes, whatever their ratios, from (y₃ − y₂)/(y₂ " +
    "− y₁) = r₂₁ᵖ (r₃₂ᵖ − 1)/(r₂₁ᵖ − 1) (Celik et al., J. Fluids Eng. 130 (2008) 078001). Size of a mesh: root of " +
    "the mean area of its cells.",
    "Orde: waargenomen orde p van de drie kleinste groottes, bij elke verhouding, uit (y₃ − y₂)/(y₂ − y₁) = r₂₁ᵖ " +
    "(r₃₂ᵖ − 1)/(r₂₁ᵖ − 1) (Celik e.a., J. Fluids Eng. 130 (2008) 078001). Grootte van een rekennet: wortel van de " +
    "gemiddelde oppervlakte van de cellen."],
  mesh_how_limit: ["Limit: Richardson's extrapolation, in the charts at size 0 with its error. Error: grid " +
    "convergence index, 1.25 |y₁ − y₂|/(r₂₁ᵖ − 1) (Roache, J. Fluids Eng. 116 (1994) 405–413), of the smallest size.",
    "Limiet: extrapolatie volgens Richardson, in de grafieken bij grootte 0 met de fout. Fout: grid convergence " +
    "index, 1,25 |y₁ − y₂|/(r₂₁ᵖ − 1) (Roache, J. Fluids Eng. 116 (1994) 405–413), van de kleinste grootte."],
  mesh_how_none: ["None of them where the values go up and down, where their differences do not fall, or where p is " +
    "not between 1/2 and 2.",
    "Geen van deze waar de waarden op en neer gaan, waar de verschillen niet afnemen, of waar p niet tussen 1/2 en " +
    "2 ligt."],

  // Element tests
  element_pictures: ["Stresses and strains", "Spanningen en rekken"],
  element_path: ["Path of the stress", "Spanningspad"],
  element_deviator: ["Deviator stress over strain", "Deviatorspanning tegen rek"],
  element_void_ratio: ["Void ratio over pressure", "Poriëngetal tegen druk"],
  element_volume_over_p: ["Volume over pressure", "Volume tegen druk"],
  element_volume: ["Volume over strain", "Volume tegen rek"],
  element_water: ["Pore pressure over strain", "Waterspanning tegen rek"],
  element_shear: ["Shear stress over strain", "Schuifspanning tegen rek"],
  element_p: ["mean pressure p'", "gemiddelde druk p'"],
  element_q: ["deviator stress q", "deviatorspanning q"],
  element_strain: ["deviator strain", "deviatorrek"],
  element_e: ["void ratio e", "poriëngetal e"],
  element_volume_strain: ["volume strain", "volumerek"],
  element_u: ["pore pressure u", "waterspanning u"],
  element_shear_strain: ["shear strain xy", "schuifrek xy"],
  element_tau: ["shear stress xy", "schuifspanning xy"],
  element_foot: ["Pressure is positive, strain is positive in extension. The numbers: the CSV tables beside this page.",
    "Druk is positief, rek is positief bij uitzetting. De getallen: de CSV-tabellen naast deze pagina."],

  // A reach
  reach_title: ["Sections of a reach", "Dwarsprofielen van een traject"],
  reach_counts: ["Solved: {solved} of {all} sections. Stands: {stands}; damaged, holds the water: {damaged}; still " +
    "moving: {still_moving}; floods briefly or by little: {near}; floods: {floods}; no verdict on the water: {none}; " +
    "no result: {open}.",
    "Berekend: {solved} van {all} dwarsprofielen. Standzeker: {stands}; beschadigd, keert het water: {damaged}; " +
    "beweegt nog: {still_moving}; loopt kort over of net: {near}; loopt over: {floods}; geen oordeel over " +
    "overstromen: {none}; zonder resultaat: {open}."],
  reach_moving: ["Not at rest at the end: {n}.", "Aan het eind niet in rust: {n}."],
  reach_caution: ["Water that would flow over is not simulated. A verdict after a trigger is not that of the " +
    "section as it is.",
    "Water dat zou overstromen is niet berekend. Een oordeel na een opgelegde trigger is niet dat van het " +
    "dwarsprofiel zoals het is."],
  reach_section: ["Section", "Dwarsprofiel"],
  reach_at_most: ["at most {factor}", "ten hoogste {factor}"],
  reach_picture: ["Ground before and after", "Profiel voor en na"],
  reach_verdict: ["Verdict", "Oordeel"],
  reach_height: ["Height that remains", "Hoogte restprofiel"],
  reach_freeboard: ["Freeboard", "Resterende waakhoogte"],
  reach_factor: ["Factor of safety", "Stabiliteitsfactor"],
  reach_time: ["Time", "Rekentijd"],
  reach_refused: ["Refused", "Geweigerd"],
  reach_failed: ["Failed", "Mislukt"],
  reach_not_finished: ["Not finished", "Niet afgerond"],
  reach_moved_before: ["As it is: no verdict, as it had not come to rest.",
    "Zonder trigger: geen oordeel, want niet tot rust gekomen."],
  reach_at_rest: ["not at rest", "niet in rust"],
  reach_stored: ["stored", "opgeslagen"],
  reach_report: ["report page", "rapport"],
  reach_assumed: ["what was assumed", "aannamen"],
  reach_foot: ["The same as tables: reach.csv, reach.json.", "Hetzelfde als tabel: reach.csv, reach.json."],

  // A study
  study_window: ["{title}: study", "{title}: studie"],
  study_subtitle: ["{n} realisations of {case}, {counts}", "{n} realisaties van {case}, {counts}"],
  study_solved: ["{n} solved", "{n} berekend"],
  study_as_drawn: ["{n} slide as drawn", "{n} schuiven af zoals getekend"],
  study_failed: ["{n} failed", "{n} mislukt"],
  study_foot: ["All realisations: results.csv.", "Alle realisaties: results.csv."],
  study_probabilities: ["Probabilities", "Kansen"],
  study_probability: ["Probability", "Kans"],
  study_probability_axis: ["probability", "kans"],
  study_floods: ["The land floods", "Het land overstroomt"],
  study_slides: ["The slope slides", "De helling schuift af"],
  study_none: ["No realisation is solved yet.", "Er is nog geen realisatie berekend."],
  study_not_known: ["{what} with a probability that is not known; with {confidence} % confidence it lies between " +
    "{low} and {high}.",
    "{what} met een kans die niet bekend is; met {confidence} % betrouwbaarheid ligt zij tussen {low} en {high}."],
  study_answer: ["{what} with probability {p}; with {confidence} % confidence it lies between {low} and {high}.",
    "{what} met kans {p}; met {confidence} % betrouwbaarheid ligt zij tussen {low} en {high}."],
  study_answer_points: ["{what} with probability {p}; as far as independent realisations would say, with " +
    "{confidence} % confidence it lies between {low} and {high}. No bound is proven for points that fill the space " +
    "evenly.",
    "{what} met kans {p}; voor zover onafhankelijke realisaties dat zouden zeggen, ligt zij met {confidence} % " +
    "betrouwbaarheid tussen {low} en {high}. Voor punten die de ruimte gelijkmatig vullen is geen grens bewezen."],
  study_missing: ["Of {n} of {all} realisations it is not known. They are no random sample, as it is mostly weak " +
    "soil that a run fails with, so the estimate may be too low: use the bounds, in which each counts as both.",
    "Van {n} van de {all} realisaties is het niet bekend. Zij zijn geen aselecte steekproef, want een berekening " +
    "mislukt meestal met zwakke grond, dus de schatting kan te laag zijn: gebruik de grenzen, waarin elk als beide " +
    "telt."],
  study_slide_too: ["A slide happens with probability {p}.", "Een afschuiving gebeurt met kans {p}."],
  study_worth: ["Of 100 slides {n} flood the land ({low} to {high}): that is what the residual strength is worth.",
    "Van 100 afschuivingen leiden er {n} tot een overstroming ({low} tot {high}): zoveel is de reststerkte waard."],
  study_worth_not_known: ["How many of 100 slides flood the land is not known: {low} to {high}.",
    "Hoeveel van 100 afschuivingen tot een overstroming leiden is niet bekend: {low} tot {high}."],
  study_estimate: ["estimate", "schatting"],
  study_lower: ["lower bound", "ondergrens"],
  study_upper: ["upper bound", "bovengrens"],
  study_bounds: ["{confidence} % bounds", "{confidence} %-grenzen"],
  study_bounds_points: ["{confidence} % bounds, if independent", "{confidence} %-grenzen, indien onafhankelijk"],
  study_realisations: ["realisations", "realisaties"],
  study_meaning: ["meaning", "betekenis"],
  study_of: ["{n} of {all}", "{n} van {all}"],
  study_of_pairs: ["{n} of {all} pairs", "{n} van {all} paren"],
  study_unknown: ["{n} unknown", "{n} onbekend"],
  study_slide_words: ["a slide: {volume} m² or more moved by more than {distance} m",
    "een afschuiving: {volume} m² of meer verplaatste meer dan {distance} m"],
  study_flood_words: ["the land floods (docs/flood.md)", "het land overstroomt (docs/flood.md)"],
  study_both_words: ["the land floods, where there is a slide", "het land overstroomt, als er een afschuiving is"],
  study_what_p_is: ["The probability is that of this section with the random input of the study file, under the " +
    "load and the water of the case: not per year, and not of the length of a dike. Bounds hold what the number of " +
    "realisations leaves open, not what the model or the input leave open.",
    "De kans is die van dit dwarsprofiel met de aselecte invoer van het studiebestand, onder de belasting en het " +
    "water van de berekening: niet per jaar, en niet van de lengte van een dijk. De grenzen bevatten wat het aantal " +
    "realisaties openlaat, niet wat het model of de invoer openlaat."],
  study_clopper: ["They are by Clopper and Pearson: of all studies like this one at least that share has the true " +
    "probability between them.",
    "Zij zijn die van Clopper en Pearson: van alle studies zoals deze heeft ten minste dat deel de ware kans " +
    "ertussen."],
  study_clopper_points: ["They are by Clopper and Pearson, as of independent realisations: of studies of these at " +
    "least that share has the true probability between them.",
    "Zij zijn die van Clopper en Pearson, als van onafhankelijke realisaties: van studies daarvan heeft ten minste " +
    "dat deel de ware kans ertussen."],
  study_over_n: ["{name} over the realisations", "{name} over de realisaties"],
  study_growth_help: ["The bounds over the realisations are those of each number of realisations alone.",
    "De grenzen over de realisaties zijn die van elk aantal realisaties apart."],
  study_how_sure: ["How sure, and what remains", "Hoe zeker, en wat overblijft"],
  study_remains: ["What remains", "Wat overblijft"],
  study_highest: ["Highest ground that remains", "Hoogste grond die overblijft"],
  study_over_level: ["P(F|I) over the level of the water", "P(F|I) tegen de waterstand"],
  study_level_axis: ["level of the water [m]", "waterstand [m]"],
  study_over_level_help: ["P(F|I) over the level is the share of the slides that leave less ground than that. It is " +
    "the ground that they left with the water of the study: far from its level the water would leave other ground.",
    "P(F|I) tegen de waterstand is het deel van de afschuivingen dat minder grond overlaat. Het is de grond die " +
    "overbleef bij het water van de studie: ver van die stand zou het water andere grond overlaten."],
  study_height_axis: ["height at the end [m]", "hoogte aan het eind [m]"],
  study_volume: ["Volume that slid", "Afgeschoven volume"],
  study_volume_axis: ["volume that slid [m²]", "afgeschoven volume [m²]"],
  failure_path: ["Failure path", "Faalpad"],
  path_event: ["event", "gebeurtenis"],
  path_given: ["given", "gegeven"],
  failure_path_help: ["Each event is given the one before it. Follow-up slides are further retreats of the crest. " +
    "Soil that cannot stand as drawn counts as a slide of which no more is known.",
  "Elke gebeurtenis is gegeven de vorige. Vervolgafschuivingen zijn verdere terugvallen van de kruin. Grond die " +
    "zoals getekend niet kan staan, telt als een afschuiving waarvan verder niets bekend is."],
  study_happened: ["What happened", "Wat er gebeurde"],
  study_kind: ["kind", "soort"],
  study_share: ["share", "aandeel"],
  study_median_slid: ["slid [m²], median", "afgeschoven [m²], mediaan"],
  study_median_remains: ["remains [m], median", "blijft over [m], mediaan"],
  study_example: ["for example", "bijvoorbeeld"],
  study_kinds_help: ["Slides are counted as retreats of the crest (docs/formats.md); a slide beside it leaves the " +
    "crest where it is. The example is the one with the median volume: terp study run STUDY.toml --keep N opens it.",
    "Afschuivingen worden geteld als terugval van de kruin (docs/formats.md); een afschuiving ernaast laat de kruin " +
    "waar hij is. Het voorbeeld is dat met het mediane volume: terp study run STUDY.toml --keep N opent het."],
  kind_not_run: ["not run: stands at the factor", "niet berekend: blijft staan bij de factor"],
  kind_failed: ["failed", "mislukt"],
  kind_as_drawn: ["slides as drawn", "schuift af zoals getekend"],
  kind_no_slide: ["no slide", "geen afschuiving"],
  kind_stands: ["stands", "blijft staan"],
  kind_more_slides: ["slides more than once", "schuift meer dan eens af"],
  kind_slides: ["slides", "schuift af"],
  kind_beside: ["slides beside the crest", "schuift naast de kruin af"],
  kind_floods: ["and the land floods", "en het land overstroomt"],
  kind_holds: ["and holds the water", "en keert het water"],
  study_matters: ["What matters", "Wat ertoe doet"],
  study_with_slide: ["with a slide", "met een afschuiving"],
  study_with_falling: ["with falling at the factor", "met bezwijken bij de factor"],
  study_with_coarse: ["with a coarse slide", "met een grove afschuiving"],
  study_with_height: ["with the height that remains", "met de hoogte van het restprofiel"],
  study_matters_help: ["Spearman's rank correlation: +1 or −1 where the input decides alone, near 0 where it does " +
    "not matter. Of n realisations, one below 2/√n may be chance. Keys are written without “material.”; of a field " +
    "it is the mean over its trend.",
    "Rangcorrelatie van Spearman: +1 of −1 waar de invoer alleen beslist, rond 0 waar zij er niet toe doet. Bij n " +
    "realisaties kan een kleinere dan 2/√n toeval zijn. Sleutels staan zonder “material.”; van een veld is het het " +
    "gemiddelde over zijn trend."],
  study_realisations_title: ["Realisations", "Realisaties"],
  study_field: ["{key}, field", "{key}, veld"],
  study_slid_unit: ["slid [m²]", "afgeschoven [m²]"],
  study_remains_unit: ["remains [m]", "blijft over [m]"],
  study_slides_at: ["slides at [s]", "schuift af op [s]"],
  study_floods_at: ["floods at [s]", "overstroomt op [s]"],
  study_why: ["why there is no result", "waarom er geen resultaat is"],
  study_first_rows: ["The first {n} of {all}; results.csv has all.",
    "De eerste {n} van {all}; results.csv heeft ze alle."],
  study_keep: ["terp study run STUDY.toml --keep 17 solves realisation 17 once more, with the same bits, and with " +
    "all that the report of a run shows.",
    "terp study run STUDY.toml --keep 17 berekent realisatie 17 nog eens, met dezelfde bits, en met alles wat het " +
    "rapport van een berekening toont."],
  row_failed: ["failed", "mislukt"],
  row_not_run: ["not run", "niet berekend"],
  row_slide: ["slide", "afschuiving"],
  row_stands: ["stands", "blijft staan"],
  row_not_known: ["not known", "niet bekend"],
  row_floods: ["floods", "overstroomt"],
  row_holds: ["holds", "keert"],

  // A method that chooses its realisations
  method_not_hit: ["{name} is not known: no place that the method tried hit the event.",
    "{name} is niet bekend: geen plaats die de methode probeerde trof de gebeurtenis."],
  method_at_most: ["Roughly, it is not above {p}.", "Ruwweg is zij niet hoger dan {p}."],
  method_roughly: ["coefficient of variation {cov}, roughly {range} with {confidence} % confidence",
    "variatiecoëfficiënt {cov}, ruwweg {range} met {confidence} % betrouwbaarheid"],
  method_input: ["input", "invoer"],
  method_design: ["design point", "ontwerppunt"],
  method_influence: ["influence", "invloed"],
  method_is_of: ["{name} is the probability of: {event}.", "{name} is de kans op: {event}."],
  method_influence_is: ["Influence is the share of a number in the variance of the limit state about the design " +
    "point (squares of direction cosines).",
    "Invloed is het aandeel van een getal in de variantie van de grenstoestand rond het ontwerppunt (kwadraten van " +
    "richtingscosinussen)."],

  // A fragility curve
  fragility: ["Fragility", "Fragiliteit"],
  fragility_curve: ["Fragility curve", "Fragiliteitscurve"],
  fragility_slide: ["slide, P(I|h)", "afschuiving, P(I|h)"],
  fragility_flood: ["flood, P(F|h)", "overstroming, P(F|h)"],
  fragility_after_slide: ["P(F|I, h)", "P(F|I, h)"],
  fragility_among_slides: ["Floods among slides", "Overstromingen onder de afschuivingen"],
  fragility_load: ["Distribution of the load", "Verdeling van de belasting"],
  fragility_not_exceeded: ["probability not exceeded", "onderschrijdingskans"],
  fragility_below: ["{what} with the probabilities below, at each {load}.",
    "{what} met de kansen hieronder, bij elke waarde van {load}."],
  fragility_needs_levels: ["For one probability over all levels, each level needs realisations of which it is known.",
    "Voor één kans over alle niveaus zijn op elk niveau realisaties nodig waarvan het bekend is."],
  fragility_needs_load: ["For one probability over all levels, give the distribution of the load in [fragility].",
    "Geef voor één kans over alle niveaus de verdeling van de belasting in [fragility]."],
  fragility_over: ["{what} with probability {p}, over the distribution of the {load}.",
    "{what} met kans {p}, over de verdeling van {load}."],
  fragility_bounds_both: ["With {confidence} % confidence it lies between {straight} if the curve is straight " +
    "between its levels and level beyond them, and between {rising} if it is only known to rise.",
    "Met {confidence} % betrouwbaarheid ligt zij tussen {straight} als de curve recht is tussen haar niveaus en " +
    "vlak daarbuiten, en tussen {rising} als alleen bekend is dat zij stijgt."],
  fragility_bounds_falls: ["With {confidence} % confidence it lies between {straight} if the curve is straight " +
    "between its levels and level beyond them; it falls from one level to a higher one by more than chance, so that " +
    "no bounds of a rising curve hold.",
    "Met {confidence} % betrouwbaarheid ligt zij tussen {straight} als de curve recht is tussen haar niveaus en " +
    "vlak daarbuiten; zij daalt van een niveau naar een hoger niveau meer dan door toeval, zodat geen grenzen van " +
    "een stijgende curve gelden."],
  fragility_events: ["I is {slide}; F is: {flood}.", "I is {slide}; F is: {flood}."],
  fragility_worth: ["P(F|I, h) is the share of the slides at a level that flood the land: it says what the residual " +
    "strength of the dike is worth there.",
    "P(F|I, h) is het deel van de afschuivingen op een niveau dat tot een overstroming leidt: het zegt wat de " +
    "reststerkte van de dijk daar waard is."],
  fragility_help: ["The samples are the same at all levels. Bounds of a level are those of Clopper and Pearson; " +
    "bounds over all levels hold at all of them at once. Where the load is a year's highest water, the probability " +
    "is per year; it is of this section alone.",
    "De steekproef is dezelfde op alle niveaus. Grenzen van een niveau zijn die van Clopper en Pearson; grenzen " +
    "over alle niveaus gelden op alle tegelijk. Waar de belasting het hoogste water van een jaar is, is de kans per " +
    "jaar; zij is die van dit dwarsprofiel alleen."],
  fragility_files: ["fragility.csv has the table.", "fragility.csv bevat de tabel."],
  fragility_files_water: ["fragility.csv has the table; fragility_slide.json and fragility_flood.json have it for " +
    "D-Stability.",
    "fragility.csv bevat de tabel; fragility_slide.json en fragility_flood.json bevatten haar voor D-Stability."],

  // A sweep, and what would be drawn
  sweep_over: ["Results over {key}", "Resultaten tegen {key}"],
  sweep_slide: ["slide, I (1: yes)", "afschuiving, I (1: ja)"],
  sweep_flood: ["flood, F (1: yes)", "overstroming, F (1: ja)"],
  sweep_lines: ["A line for each value of {keys}.", "Een lijn voor elke waarde van {keys}."],
  sweep_drawn: ["{n} of {all} are drawn.", "{n} van de {all} zijn getekend."],
  sweep_same: ["The same in all realisations that are solved: {results}.",
    "Gelijk in alle realisaties die berekend zijn: {results}."],
  samples_window: ["{title}: samples", "{title}: steekproef"],
  samples_subtitle: ["What {n} realisations of {case} would be drawn with",
    "Waarmee {n} realisaties van {case} getrokken zouden worden"],
  samples_histograms: ["Histograms of the input", "Histogrammen van de invoer"],
  samples_field: ["Field of {key}", "Veld van {key}"],
  samples_picture: ["realisation {n}, over the trend: dark 0.5, bright 2",
    "realisatie {n}, over de trend: donker 0,5, licht 2"],
} as const;
