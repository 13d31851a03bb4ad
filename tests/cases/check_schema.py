"""`terp schema` takes every case of the repository, and none of a few with a mistake.

usage: check_schema.py TERP CASES_FOLDER
"""
import json
import pathlib
import subprocess
import sys
import tomllib

import jsonschema

MISTAKES = {  # what an editor should mark: KEY of a good case, and the value that is wrong
    ("scheme",): "mpm_gpp",
    ("mesh", "cel"): 0.1,
    ("mesh", "cell"): -0.1,
    ("body", 0, "material"): 3,
    ("material", "clay", "densety"): 1990.0,
    ("forces", "damping", "local"): 1.5,
    ("method", "shares"): "overlapping",
    ("output", "fields", "names"): ["stresses"],
    ("mesh", "size"): ["16 m", "3 m/s"],
    ("time", "end"): "soon",
    ("material", "clay", "friction_angle"): 30.0,  # of another law
    ("material", "clay", "su_peak"): "8 kg",
    ("material", "clay", "su_residual"): "2 kN/m3",
    ("material", "clay", "eta"): "soft",
    ("material", "clay", "su_remoulded"): {"dept": [[0, 2e6]]},
    ("material", "clay", "plastic_strain"): 3,
    ("material", "clay", "strength"): ["cu"],
    ("material", "clay", "residual_strength"): -1.0,
    ("material", "clay", "components"): 7,
    ("material", "clay", "parameters"): 3.0,
    ("material", "clay", "state"): "cu",
    ("material", "clay", "color"): 3,
    ("stage",): [{"set": "time.end=3"}],
    ("water", "phreatic_line"): 2.0,
    ("water", "head_lines"): [[0.0, 1.0]],
}

TAKEN = {
    ("material", "clay", "su_peak"): ["8 kPa", "8e3 + 1.5E3*max(0, 2 - y)", "(x > 3) ? 8e3 : 2*pi*1e3",
                                      {"table": [[0, 2e3]], "water": "daily"}, {"shansep": {"S": 0.2}}],
    ("material", "clay", "su_residual"): ["8 kN/m2", {"csv": "a.csv"}],
}

LEFT_OUT = [("mesh",), ("body",), ("time", "end"), ("body", 0, "material"), ("material", "clay", "model"),
            ("material", "clay", "su_peak")]


def without(case, keys):
    """The case without one of its keys."""
    here = case = json.loads(json.dumps(case))
    for key in keys[:-1]:
        here = here[key]
    del here[keys[-1]]
    return case


def with_mistake(case, keys, value):
    """The case with one value set; lists and tables on the way exist or are made."""
    here = case = json.loads(json.dumps(case))
    for key in keys[:-1]:
        here = here[key] if isinstance(key, int) else here.setdefault(key, {})
    here[keys[-1]] = value
    return case


def main(terp, cases):
    """Exits with 1 and the faults if there are any."""
    schema = json.loads(subprocess.run([terp, "schema"], check=True, capture_output=True).stdout)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    files = [path for path in pathlib.Path(cases).rglob("*.toml") if path.name != "expected.toml"
             and "estimator" not in tomllib.loads(path.read_text())]  # studies have keys of their own
    faults = []
    for path in files:
        for error in validator.iter_errors(tomllib.loads(path.read_text())):
            faults.append(f"{path}: {'.'.join(map(str, error.absolute_path))}: {error.message[:200]}")
    good = tomllib.loads((pathlib.Path(cases) / "column_collapse" / "model_2.toml").read_text())
    for keys, value in MISTAKES.items():
        if validator.is_valid(with_mistake(good, keys, value)):
            faults.append(f"{'.'.join(map(str, keys))} = {value!r} was taken")
    for keys, values in TAKEN.items():
        for value in values:
            for error in validator.iter_errors(with_mistake(good, keys, value)):
                faults.append(f"{'.'.join(map(str, keys))} = {value!r}: {error.message[:200]}")
    for keys in LEFT_OUT:
        if validator.is_valid(without(good, keys)):
            faults.append(f"a case without {'.'.join(map(str, keys))} was taken")
    print(f"{len(files)} cases, {len(MISTAKES) + len(LEFT_OUT)} mistakes")
    sys.exit("\n".join(faults) if faults or len(files) < 50 else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
