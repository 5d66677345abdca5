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


def with_bar(value, bar, digits=0):
    return number(value, digits) + (f" ± {bar:.{digits}f}" if np.isfinite(bar) else " (one mesh)")


def sequence(meshes, values, digits=0):
    """The values that a converged one rests on."""
    return ", ".join(f"{number(v, digits)} on {h:g} µm" for h, v in zip(meshes, values))


def converged(runs, of_run, speed=100):
    """(value, bar, values by mesh) of the default scheme."""
    meshes = runs.mesh_sequence(speed)
    values = [of_run(runs.default(h, speed)) for h in meshes]
    return (*measures.converge(meshes, values), values)


def of_default(runs, of_run, digits=0, speed=100):
    value, bar, values = converged(runs, of_run, speed)
    return f"{with_bar(value, bar, digits)} ({sequence(runs.mesh_sequence(speed), values, digits)})"


def spread(runs, of_run, scheme="paper"):
    """(mean, standard deviation) over the jittered lattices."""
    values = [of_run(runs[f"{scheme}_seed{seed}"]) for seed in range(1, runs.set.seeds + 1)]
    return float(np.mean(values)), float(np.std(values, ddof=1))


def judge(paper, scheme, value, bar):
    """Whether a number holds: the converged value within 10% (or its bar) of the paper's; else an artefact if the paper's
    scheme alone comes within 25%; else qualitative if it has the sign and at least half of the size."""
    bar = bar if np.isfinite(bar) else 0
    if abs(value - paper) <= max(0.1 * abs(paper), bar):
        return HOLDS
    if abs(scheme - paper) <= 0.25 * abs(paper) and abs(scheme - paper) < abs(value - paper):
        change = 100 * (paper / value - 1)
        return f"{ARTEFACT}: the paper's number is {abs(change):.0f}% {'larger' if change > 0 else 'smaller'}"
    return QUALITATIVE if 0.5 <= value / paper <= 2 else NOT
