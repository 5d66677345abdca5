#!/usr/bin/env python3
"""Writes the tables of docs/stability.md.

  mote_bench_stability > stability.csv          (all parts, or some)
  python3 bench/stability_tables.py docs/stability.md stability.csv... [--cavity DIR...]

Each DIR is an output folder of the cavity program, named speed_shape_transfer_update, with the program's messages in
DIR.log. What lies between `<!-- table NAME -->` and `<!-- end -->` is replaced; a table without rows is left alone.
"""
import argparse
import collections
import csv
import math
import os
import re


def number(x):
    if math.isnan(x):
        return "nan"
    if math.isinf(x):
        return "lost"
    if x == 0 or 0.01 <= abs(x) < 1e4:
        return f"{x:.3g}"
    return f"{x:.1e}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(r) + " |" for r in rows])


class Measured:
    def __init__(self, files):
        self.value = {}
        self.schemes = []
        for name in files:
            for r in csv.DictReader(open(name)):
                if r["scheme"] not in self.schemes:
                    self.schemes.append(r["scheme"])
                key = (r["experiment"], r["scheme"], float(r["parameter"]), r["quantity"])
                self.value[key] = float(r["value"])

    def parameters(self, experiment, quantity):
        return sorted({k[2] for k in self.value if k[0] == experiment and k[3] == quantity})

    def get(self, *key):
        return self.value.get(key, math.nan)

    def rows(self, experiment, columns):
        """A row per scheme that has the experiment; columns: (parameter, quantity)."""
        for s in self.schemes:
            if any((experiment, s, *c) in self.value for c in columns):
                yield [s] + [self.cell(experiment, s, c) for c in columns]

    def cell(self, experiment, scheme, column):
        failed = self.get(experiment, scheme, column[0], "NumericalError") == 1
        return ("error, " if failed else "") + number(self.get(experiment, scheme, *column))


def wide(m, experiment, quantity, name="{:g}"):
    p = m.parameters(experiment, quantity)
    rows = list(m.rows(experiment, [(x, quantity) for x in p]))
    return rows and table(["scheme"] + [name.format(x) for x in p], rows)


def several(m, experiment, columns):
    rows = list(m.rows(experiment, [c[:2] for c in columns]))
    return rows and table(["scheme"] + [c[2] for c in columns], rows)


def scenes(m):
    rows = []
    for name, scheme in dict.fromkeys((k[0], k[1]) for k in m.value if k[3] == "ended_ns"):
        columns = [(-1, q) for q in ("ended_ns", "p_min_gpa", "p_max_gpa", "energy_error")]
        rows.append([name, scheme] + [m.cell(name, scheme, c) for c in columns])
    return rows and table(["scene", "scheme", "ended, ns", "least P, GPa", "largest P, GPa", "energy error"], rows)


def layers(m):
    rows = []
    for k in sorted({k[:3] for k in m.value if k[3] == "layer_mean_gpa" and "100" == k[0][-3:]}, key=lambda k: (k[0], k[1], k[2])):
        rows.append([k[0], k[1], f"{k[2]:g}"] + [m.cell(*k[:2], (k[2], f"layer_{q}_gpa")) for q in ("mean", "scatter", "max")])
    return rows and table(["scene", "scheme", "layer's height at the start, um", "mean", "scatter", "largest"], rows)


def cavity(folders):
    rows = collections.OrderedDict()
    for folder in folders:
        speed, *words = os.path.basename(folder.rstrip("/")).split("_")
        try:
            with open(os.path.join(folder, "history.csv")) as f:
                history = list(csv.DictReader(f))
        except FileNotFoundError:
            continue
        low = min(float(r["p_min_mpa"]) for r in history) / 1e3
        high = max(float(r["p_max_mpa"]) for r in history) / 1e3
        time = float(history[-1]["time_ns"])
        said = open(folder.rstrip("/") + ".log").read()
        failed = re.search(r"cavity: (particle.*?|the time step has collapsed.*?)(, which|\.|\()", said)
        end = f"`NumericalError` after {time:.1f} ns" if failed else f"{time:.1f} ns"
        error = 100 * float(history[-1]["energy_error"])
        rows[(speed, " ".join(words))] = [speed, " ".join(words), end, f"{low:.2f}", f"{high:.2f}", f"{error:.1f} %"]
    return rows and table(["m/s", "scheme", "reached", "least P, GPa", "largest P, GPa", "energy error at the end"],
                          list(rows.values()))


def main():
    a = argparse.ArgumentParser()
    a.add_argument("page")
    a.add_argument("csv", nargs="*")
    a.add_argument("--cavity", nargs="*", default=[])
    o = a.parse_args()
    m = Measured(o.csv)
    tables = {
        "courant_small": wide(m, "courant_small", "most_energy"),
        "courant_large": wide(m, "courant_large", "most_energy"),
        "drift_small": wide(m, "drift_small", "energy"),
        "drift_small_amplitude": wide(m, "drift_small", "amplitude"),
        "drift_large": wide(m, "drift_large", "energy"),
        "drift_large_amplitude": wide(m, "drift_large", "amplitude"),
        "surface_mass": wide(m, "surface", "mass", "1e{:g}"),
        "surface_kick": wide(m, "surface", "kick", "1e{:g}"),
        "surface_strain": wide(m, "surface", "strain", "1e{:g}"),
        "surface_swing": wide(m, "surface", "swing", "1e{:g}"),
        "per_cell": wide(m, "per_cell", "most_energy"),
        "jitter": several(m, "jitter", [(0.5, "most_energy", "largest energy, worst of 50 seeds"), (0.5, "lost", "blown up")]),
        "crash": wide(m, "crash", "pressure"),
        "crash_middle": wide(m, "crash", "middle"),
        "tear": several(m, "tear", [(v, q, f"{n}, {v}") for v in (400, 1000, 5000)
                                    for q, n in (("p_min_gpa", "least P, GPa"), ("volume_max", "largest V/V0"))]),
        "collide": several(m, "collide", [(5000, "pressure", "largest P, exact 1"), (5000, "energy", "energy error"),
                                          (5000, "momentum", "momentum error")]),
        "stretch_least": wide(m, "stretch", "least"),
        "stretch_most": wide(m, "stretch", "most"),
        "alone": several(m, "alone", [(1000, "speed", "speed error"), (1000, "volume_min", "least V/V0"),
                                      (1000, "volume_max", "largest V/V0")]),
        "spin": several(m, "spin", [(100, q, n) for q, n in (("turns", "turns"), ("kinetic", "kinetic energy"),
                                                             ("angular_momentum", "angular momentum"),
                                                             ("size", "diameter"))]),
        "fly": several(m, "fly", [(1000, q, n) for q, n in (("kinetic", "kinetic energy"), ("stress_mpa", "largest |P|, MPa"),
                                                            ("size", "width"))]),
        "surface_release": wide(m, "surface", "release", "1e{:g}"),
        "crash_viscous": wide(m, "crash_viscous", "pressure"),
        "scenes": scenes(m),
        "layers": layers(m),
        "cavity": cavity(o.cavity),
    }
    page = open(o.page).read()
    for name, text in tables.items():
        if text:
            page = re.sub(rf"(<!-- table {name} -->\n).*?(<!-- end -->)",
                          lambda found: found.group(1) + text + "\n" + found.group(2), page, flags=re.S)
    open(o.page, "w").write(page)


if __name__ == "__main__":
    main()
