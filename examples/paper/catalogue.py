"""The runs that reproduce the paper: what each is for, and its options. Two sets: full, and coarse (a few minutes)."""

import dataclasses

SPEEDS = (50, 100, 150, 200, 300, 400, 600, 800, 1000)  # m/s
FIELD_TIMES = (0, 0.8, 1.2, 2, 3, 6, 7.2, 9, 11, 12)  # ns, of the figures' and claims' fields
CENTRES, SMALL_RADIUS = (15, 20, 30), 3  # um
CHOICE_SPEEDS = (100, 400)
JITTER = 0.1


@dataclasses.dataclass(frozen=True)
class Run:
    """A run: its folder's name, the program's name, the options without --out; the times (ns) of the frames to keep."""
    name: str
    program: str
    options: tuple
    grid_times: tuple = ()
    particle_times: tuple = ()


@dataclasses.dataclass(frozen=True)
class Set:
    """Meshes (um) of the runs, coarse to fine, and the size of the ensembles."""
    name: str
    paper: tuple       # options of the paper's scheme
    trend: tuple       # default scheme, all speeds
    fields: tuple      # default scheme, the speeds that are refined furthest
    paper_mesh: float
    paper_finer: float
    places: float      # default scheme, other places and sizes of the cavity
    seeds: int


FULL = Set("full", ("--preset", "paper"), (1, 0.5), (1, 0.5, 0.25), 1, 0.5, 1, 8)
COARSE = Set("coarse", ("--preset", "paper", "--domain", "quarter"), (2, 1), (2, 1), 1, 1.25, 1, 3)
SETS = {s.name: s for s in (FULL, COARSE)}


def words(times):
    return ",".join(f"{t:g}" for t in times)


def mesh(h):
    return ("--spacing", f"{h:g}")


def paper_runs(s):
    """The paper's scheme: speeds, places, sizes, fills, refinement, conduction, no cavity, jitter."""
    def cavity(name, *options, grid=(), particles=()):
        return Run("paper_" + name, "cavity", s.paper + options, grid, particles)

    yield cavity("v100", "--frames", "76", grid=FIELD_TIMES, particles=(6,))
    for speed in SPEEDS:
        if speed != 100:
            frames = "26" if speed == 1000 else "0"
            yield cavity(f"v{speed}", "--speed", str(speed), "--frames", frames, grid=(0, 7.2, 12))
    for z in CENTRES:
        yield cavity(f"centre{z}", "--centre-z", str(z), "--frames", "0")
    yield cavity(f"radius{SMALL_RADIUS}", "--radius", str(SMALL_RADIUS), "--frames", "0")
    yield cavity("bar", "--radius", "0", "--until", "9", "--frames", "10", grid=(3, 7, 9))
    yield cavity("conduction", "--conductivity", "237", "--until", "12", "--frames", "0")
    yield cavity("fraction", "--fill", "fraction", "--until", "12", "--frames", "2", grid=(12,))
    yield cavity("other_mesh", "--domain", "quarter", *mesh(s.paper_finer), "--until", "12", "--frames", "2",
                 grid=(12,))
    for seed in range(1, s.seeds + 1):
        yield cavity(f"seed{seed}", "--jitter", str(JITTER), "--seed", str(seed), "--until", "12", "--frames", "2",
                     grid=(12,))


def study(name, *options, grid=(), particles=()):
    """A run of the default scheme; frames at chosen times only."""
    extra = ("--frame-times", words(grid)) if grid else ()
    extra += ("--particle-times", words(particles)) if particles else ()
    return Run(name, "paper_study", ("--preset", "accurate") + options + ("--frames", "0") + extra, grid, particles)


def default_runs(s):
    """The default scheme: speeds, places, sizes, fills, no cavity, jitter."""
    for h in s.trend:
        for speed in SPEEDS:
            if speed not in (100, 1000):
                yield study(f"default_h{h:g}_v{speed}", *mesh(h), "--speed", str(speed))
    for z in CENTRES:
        yield study(f"default_centre{z}", *mesh(s.places), "--centre-z", str(z))
    yield study(f"default_radius{SMALL_RADIUS}", *mesh(s.places), "--radius", str(SMALL_RADIUS))
    coarse = mesh(s.trend[0])
    yield study("default_bar", *coarse, "--radius", "0", "--until", "9", grid=(3, 7, 9))
    yield study("default_lattice", *coarse, "--fill", "lattice", "--until", "12", grid=(12,))
    for seed in range(1, s.seeds + 1):
        yield study(f"default_seed{seed}", *coarse, "--jitter", str(JITTER), "--seed", str(seed), "--until", "12", grid=(12,))


def field_runs(s):
    """The default scheme with frames at the figures' times, to the finest mesh; the longest come last."""
    for h in s.fields:
        for speed, times in ((100, FIELD_TIMES), (1000, (0, 7.2, 12))):
            options = mesh(h) + ("--speed", str(speed))
            particles = (6,) if speed == 100 and h == s.trend[-1] else ()
            yield study(f"default_h{h:g}_v{speed}", *options, grid=times, particles=particles)


def choice_runs(s, choices):
    """One run per reading of the paper's equations and speed."""
    for name in choices:
        for speed in CHOICE_SPEEDS:
            yield study(f"choice_{name}_v{speed}", *mesh(s.trend[0]), "--speed", str(speed), "--until", "12", "--material", name)


def all_runs(s, choices):
    """In the order in which they are to run."""
    return [*paper_runs(s), *default_runs(s), *choice_runs(s, choices), *field_runs(s)]
