"""The results that bench/run_all.sh leaves in build/bench, for tables.py and plot.py."""

import csv
import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
DIRECTORY = ROOT / "build" / "bench"
USUAL = ["linear", "quadratic", "cubic"]
NAMES = {"flip": "FLIP", "apic": "APIC", "aflip": "AffineFlip", "usl": "USL", "musl": "MUSL"}


def rows(benchmark):
    """{row: {counter: value}} of one benchmark program; empty if it has not run. Rows that failed are left out."""
    path = DIRECTORY / f"{benchmark}.json"
    if not path.exists():
        return {}
    found = {}
    for row in json.loads(path.read_text())["benchmarks"]:
        if not row.get("error_occurred"):
            found[row["name"].split("/iterations")[0]] = row
    return found


def schemes(precision="double"):
    """[(scheme, counters)] of the benchmark of phases in a fixed order."""
    found = rows("phases")
    wanted = [f"{s}/{t}/{u}" for s in USUAL for t in ("flip", "apic", "aflip") for u in ("usl", "musl")]
    return [(w, found[f"{w}/{precision}"]) for w in wanted if f"{w}/{precision}" in found]


def title(scheme):
    """linear/flip/usl -> linear, FLIP, USL"""
    return ", ".join(NAMES.get(part, part) for part in scheme.split("/"))


def compile_times():
    """[(what, compiler, seconds)]"""
    path = DIRECTORY / "compile_time.csv"
    if not path.exists():
        return []
    with path.open() as file:
        return [(r["what"], r["compiler"], float(r["seconds"])) for r in csv.DictReader(file)]
