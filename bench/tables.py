#!/usr/bin/python3
"""Writes the tables of docs/performance.md from the results of bench/run_all.sh.

A table stands between the lines `<!-- table NAME -->` and `<!-- end -->` of the page; the rest of the page is prose and
stays. A table whose benchmark has not run stays too.
"""

import re

import results

PAGE = results.ROOT / "docs" / "performance.md"
PHASES = ["scatter", "grid", "gather", "second_grid", "deform"]


def table(head, body):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in body]) if body else ""


def ns(value):
    return f"{value:.0f}" if value >= 10 else f"{value:.1f}"


def gain(text, row):
    """A ratio of times on the wall, unless others used the cores: then no number is better than a wrong one."""
    return text if row.get("share", 1) > 0.9 else "(disturbed)"


def machine():
    now = results.rows("phases").get("machine/before")
    after = results.rows("phases").get("machine/after")
    if not now or not after:
        return ""
    what = [("multiply-adds in double precision, one core", "fma_double_gflops", "Gflop/s"),
            ("multiply-adds in single precision, one core", "fma_float_gflops", "Gflop/s"),
            ("in-place update of 26 columns, one core", "bandwidth_one_gbs", "GB/s"),
            ("in-place update of 26 columns, two cores", "bandwidth_two_gbs", "GB/s")]
    return table(["limit", "before the run", "after"],
                 [[name, f"{now[key]:.0f} {unit}", f"{after[key]:.0f} {unit}"] for name, key, unit in what])


def textbook():
    found = results.rows("step")
    return table(["scheme", "mote, ns per particle-step", "textbook loop", "ratio"],
                 [[results.title(name.removeprefix("textbook/")), ns(r["mote_ns"]), ns(r["textbook_ns"]),
                   f"{r['ratio']:.2f}"] for name, r in found.items() if name.startswith("textbook/")])


def threads():
    found = results.rows("step")
    kinds = {"two_threads": "two threads instead of one", "float": "float instead of double",
             "aflip": "AffineFlip instead of APIC"}
    body = []
    for name, r in found.items():
        kind, _, scheme = name.partition("/")
        if kind in kinds:
            body.append([kinds[kind], results.title(scheme), ns(r["first_ns"]), ns(r["second_ns"]),
                         gain(f"{r['gain']:.2f}", r)])
    return table(["change", "scheme", "before, ns", "after, ns", "gain"], body)


def floors():
    single = dict(results.schemes("float"))
    body = []
    for name, r in results.schemes():
        f = single[name]
        body.append([results.title(name), f"{r['flops']:.0f}", f"{r['bytes']:.0f}", ns(r["floor_ns"]), ns(r["step_ns"]),
                     f"{r['over_floor']:.1f}", ns(f["floor_ns"]), ns(f["step_ns"]), f"{f['over_floor']:.1f}"])
    return table(["scheme", "operations", "bytes", "floor, ns", "measured, ns", "ratio", "float: floor", "measured",
                  "ratio"], body)


def phases():
    body = []
    for name, r in results.schemes():
        cells = [f"{ns(r[p + '_ns'])} ({ns(r[p + '_floor_ns'])})" if p + "_ns" in r else "" for p in PHASES]
        between = r["step_ns"] - sum(r.get(p + "_ns", 0) for p in PHASES)
        body.append([results.title(name)] + cells + [ns(max(between, 0)), ns(r["step_ns"]), ns(r["sort_ns"])])
    return table(["scheme", "scatter", "grid", "gather", "second grid", "deform", "between", "step", "one sort"], body)


def scaling():
    return table(["particles", "per cell", "threads", "ns per particle-step", "relative to the reference",
                  "one sort, ns"],
                 [[f"{r['particles']:,.0f}", f"{r['per_cell']:.0f}", f"{r['on_threads']:.0f}", ns(r["ns"]),
                   gain(f"{r['relative']:.2f}", r), ns(r["sort_ns"])] for r in results.rows("scaling").values()])


def skips():
    names = {"empty": "eight times the empty room around a body", "parts/nothing": "nothing (control)",
             "parts/no_heat": "no heat",
             "parts/no_heat_no_yield": "no heat, no yield (elastic shear)",
             "parts/no_strength": "no heat, no strength (a fluid)"}
    found = results.rows("skips")
    body = []
    if "quarter" in found:
        r = found["quarter"]
        body.append(["a quarter of the body, whole run", f"{r['full_s']:.1f} s", f"{r['quarter_s']:.1f} s",
                     f"{r['saving']:.2f}", ""])
    for name, words in names.items():
        if name in found:
            r = found[name]
            body.append([words, f"{ns(r['full_ns'])} ns", f"{ns(r['without_ns'])} ns", f"{r['saving']:.2f}",
                         f"{r['full_bytes']:.0f} to {r['without_bytes']:.0f}"])
    return table(["change", "before", "after", "before / after", "bytes per particle"], body)


def memory():
    return table(["scheme", "particles", "columns", "peak after the fill", "peak after steps and sorts"],
                 [[results.title(name), f"{r['particles']:,.0f}", f"{r['column_bytes']:.0f} B",
                   f"{r['peak_after_fill']:.0f} B", f"{r['peak_after_steps']:.0f} B"]
                  for name, r in results.rows("memory").items()])


def compiling():
    return table(["what", "compiler", "seconds"], [[f"`{what}`", compiler, f"{s:.1f}"]
                                                   for what, compiler, s in results.compile_times()
                                                   if what.startswith("first_program")])


def headers():
    alone = [(s, what) for what, _, s in results.compile_times() if what.endswith(".hpp")]
    return table(["header", "seconds alone"], [[f"`{what}`", f"{s:.2f}"] for s, what in sorted(alone)[::-1][:10]])


def main():
    page = PAGE.read_text()
    for make in (machine, textbook, threads, floors, phases, scaling, skips, memory, compiling, headers):
        text = make()
        region = re.compile(rf"(<!-- table {make.__name__} -->\n).*?(<!-- end -->)", re.DOTALL)
        if not region.search(page):
            raise SystemExit(f"{PAGE}: no region for the table {make.__name__}")
        if text:
            page = region.sub(lambda m, text=text: m[1] + text + "\n" + m[2], page)
    PAGE.write_text(page)


if __name__ == "__main__":
    main()
