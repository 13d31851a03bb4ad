"""A dike of one's own: picture, factor of safety, a study of 50, P(F given a slide) over the level, and a film.

usage: own_dike.py [FOLDER [CELL [NUMBER]]]"""
import pathlib
import sys

import terp

folder, cell, number = (sys.argv[1:] + ["own_dike", "1.0", "50"][len(sys.argv) - 1:])[:3]
folder, cell, number = pathlib.Path(folder), float(cell), int(number)
folder.mkdir(exist_ok=True)
clay = {"model": "tresca_softening", "density": 1750, "stiffness_ratio": 100, "poisson_ratio": 0.49, "eta": 20.0,
        "sensitivity": 2.0, "softening": {"length": 2 * cell}}
case = terp.Case({
    "title": "Clay dike on soft clay", "mesh": {"size": [52.0, 10.0], "origin": [0.0, -5.0], "cell": cell},
    "material": {"dike": {**clay, "su_peak": "16 kPa"}, "soft": {**clay, "su_peak": "10 kPa"}},
    "body": [{"material": "soft", "polygon": [[0, -5], [52, -5], [52, 0], [0, 0]], "points_per_cell": 3},
             {"material": "dike", "polygon": [[8, 0], [32, 0], [22, 4], [18, 4]], "points_per_cell": 3}],
    "water": {"phreatic_line": [[0, 2.0], [52, -0.5]]}, "flood": {"water_level": 2.0},
    "forces": {"gravity": [0, -9.81], "damping": {"local": 0.05}},
    "boundary": {"left": "roller", "right": "roller", "bottom": "fixed"},
    "stage": [{"name": "held", "set": {"at_strength": 0.5}, "until": "at_rest", "at_most": 10.0},
              {"name": "free", "set": {"at_strength": 1.0}, "ramp": 5.0, "until": "verdict", "at_most": 20.0}],
    "output": {"fields": {"every": 0.5}}})

terp.check(case).plot().figure.savefig(folder / "section.png", dpi=150)
safety = terp.stability(case)
print(f"factor of safety {safety.factor:.2f}")
safety.plot().figure.savefig(folder / "mechanism.png", dpi=150)

study = terp.study({
    "random": [{"key": f"material.{soil}.su_peak", "distribution": "lognormal", "mean": mean, "cov": 0.3}
               for soil, mean in (("dike", "16 kPa"), ("soft", "10 kPa"))],
    "estimator": {"kind": "monte_carlo"}, "stop": {"number": number}, "events": {"volume": 5.0, "displacement": 0.5},
}, folder / "study", case=case)
print(study)
study.plot().figure.savefig(folder / "flood_after_slide.png", dpi=150)

slides = study.table["realisation"][study.table["slide"] == 1]
terp.animate(study.run_of(slides[0]), "eps_eq_p", folder / "slide.gif")
