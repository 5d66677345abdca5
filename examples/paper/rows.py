"""A row of the table of claims, and how verdicts are reached."""

import dataclasses

import numpy as np

import measures

HOLDS, QUALITATIVE, ARTEFACT, NOT = "holds", "holds qualitatively", "artefact of the scheme", "not reproduced"


@dataclasses.dataclass
class Row:
    claim: str
    measured: str
    paper: str
    scheme: str
    converged: str
    verdict: str

    def markdown(self):
        cells = (self.claim, self.measured, self.paper, self.scheme, self.converged, f"**{self.verdict}**")
        return "| " + " | ".join(str(c).replace("|", "\\|") for c in cells) + " |"


HEAD = ("| the paper | how it is measured here | its number | paper's scheme, here | converged | verdict |\n"
        "|---|---|---|---|---|---|")


def number(value, digits=0):
    return f"{value:.{digits}f}" if np.isfinite(value) else "not measured"


def percent(part, digits=0):
    """With its sign, unless it is zero at so many digits."""
    text = f"{100 * part:+.{digits}f}%"
    return text if float(text[:-1]) else text[1:]


def with_bar(limit, digits=0):
    """Value and bar; a digit more if the bar would else be 0."""
    if not np.isfinite(limit.bar):
        return f"{number(limit.value, digits)} (one mesh)"
    digits += float(f"{limit.bar:.{digits}f}") == 0
    bar = f"{limit.bar:.{digits}f}"
    return f"{number(limit.value, digits)} ± {bar if float(bar) else 'less than ' + bar[:-1] + '1'}"


def order(limit):
    """Which order the meshes show, in words; nothing for fewer than three."""
    if np.isfinite(limit.values).sum() < 3:
        return ""
    return f"order {limit.order:.1f}" if np.isfinite(limit.order) else "no order"


def in_full(limit, meshes, digits=0, unit=""):
    """A limit with its bar, the order, and the values that it rests on."""
    values, on = ", ".join(number(v, digits) for v in limit.values), ", ".join(f"{h:g}" for h in meshes)
    shown = order(limit)
    return f"{with_bar(limit, digits)}{unit} ({shown + '; ' if shown else ''}{values} on {on} µm)"


def converged(runs, of_run, speed=100):
    """A number of the default scheme, as a limit."""
    meshes = runs.mesh_sequence(speed)
    return measures.converge(meshes, [of_run(runs.default(h, speed)) for h in meshes])


def of_default(runs, of_run, digits=0, speed=100, unit=""):
    return in_full(converged(runs, of_run, speed), runs.mesh_sequence(speed), digits, unit)


def spread(runs, of_run, scheme="paper"):
    """(mean, standard deviation) over the jittered lattices."""
    values = [of_run(runs[f"{scheme}_seed{seed}"]) for seed in range(1, runs.set.seeds + 1)]
    return float(np.mean(values)), float(np.std(values, ddof=1))


def judge(paper, scheme, value, bar):
    """Whether a number holds: the converged value within 10% (or its bar) of the paper's; else an artefact if the paper's
    scheme alone comes within 25%; else qualitative if it has the sign and at least half of the size."""
    bar = bar if np.isfinite(bar) else 0  # one mesh
    if abs(value - paper) <= max(0.1 * abs(paper), bar):
        return HOLDS
    if abs(scheme - paper) <= 0.25 * abs(paper) and abs(scheme - paper) < abs(value - paper):
        change = 100 * (paper / value - 1)
        return f"{ARTEFACT}: the paper's number is {abs(change):.0f}% {'larger' if change > 0 else 'smaller'}"
    return QUALITATIVE if 0.5 <= value / paper <= 2 else NOT
