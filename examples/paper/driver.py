#!/usr/bin/python3
"""Runs what reproduces the paper, then draws its figures and tests its claims; examples/reproduce_paper.sh calls it.

driver.py --programs DIR --out DIR [--coarse] [--figures-only] [--jobs N] [--runs-only] [--only WORD]
          [--again]

A run whose summary.json is there and whose configuration is the wanted one is kept; any other is made anew, also one that
was interrupted. Exit codes: 0 done, 1 something failed, 2 the command line is wrong.
"""

import argparse
import fcntl
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

import catalogue

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = {"cavity": "examples/cavity/cavity", "paper_study": "examples/paper/paper_study"}
OF_STUDY = ("--material", "--frame-times", "--particle-times")
FIRST_GUESS = 70  # ns per particle and step, until a run has shown it


class Trouble(Exception):
    """One sentence for the user."""


def split(options):
    """The options as pairs: (those of cavity, those that only paper_study knows)."""
    pairs = list(zip(options[::2], options[1::2]))
    return [p for p in pairs if p[0] not in OF_STUDY], [p for p in pairs if p[0] in OF_STUDY]


def flat(pairs):
    return [word for pair in pairs for word in pair]


def plan(run, programs, out):
    """What the program would do: its configuration as text, and its estimates."""
    common, own = split(run.options)
    command = [programs[run.program], *flat(common), "--dry-run", "--overwrite", "--out", str(out / run.name)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise Trouble(f"{run.name}: {done.stderr.strip()}")
    lines = [line.split(None, 1) for line in done.stdout.splitlines() if line.strip()]
    pairs = {key: value.strip() for key, *rest in lines for value in rest}
    estimates = {key: float(pairs.pop(key)) for key in ("particles", "steps")}
    last = list(pairs).index("out")
    configuration = {key: pairs[key] for key in list(pairs)[:last]}
    configuration.pop("threads", None)
    if run.program == "paper_study":
        given = dict(own)
        configuration["material"] = given.get("--material", "default")
        for key, option in (("frame_times_ns", "--frame-times"), ("particle_times_ns", "--particle-times")):
            configuration[key] = json.dumps([float(t) for t in given.get(option, "").split(",") if t])
    return configuration, estimates


def as_text(value):
    return value if isinstance(value, str) else json.dumps(value)


def finished(folder, wanted):
    """The run's summary if it is the wanted one, or None."""
    try:
        summary = json.loads((folder / "summary.json").read_text())
        found = summary["configuration"]
    except (OSError, ValueError, KeyError):
        return None
    same = all(same_text(as_text(found.get(key)), value) for key, value in wanted.items())
    return summary if same else None


def same_text(a, b):
    try:
        return json.loads(a) == json.loads(b)
    except ValueError:
        return a == b


def prune(folder, kind, times):
    """Deletes the frames of other times, and names the others only in the .pvd."""
    collection = folder / "frames" / f"{kind}.pvd"
    if not collection.exists():
        return
    tree = ElementTree.parse(collection)
    for parent in tree.getroot().iter("Collection"):
        for entry in list(parent):
            if not any(abs(1e9 * float(entry.get("timestep")) - t) < 1e-3 for t in times):
                (collection.parent / entry.get("file")).unlink(missing_ok=True)
                parent.remove(entry)
    tree.write(collection)


class Job:
    """A run that is being made. Throws BlockingIOError if another driver is making it."""

    def __init__(self, run, programs, out):
        self.run, self.folder, self.start = run, out / run.name, time.monotonic()
        self.log = open(out / f"{run.name}.log", "a")
        fcntl.flock(self.log, fcntl.LOCK_EX | fcntl.LOCK_NB)
        self.log.truncate(0)
        self.folder.mkdir(parents=True, exist_ok=True)
        shutil.rmtree(self.folder / "frames", ignore_errors=True)
        (self.folder / "summary.json").unlink(missing_ok=True)
        command = [programs[run.program], *run.options, "--threads", "1", "--overwrite", "--out", str(self.folder)]
        self.process = subprocess.Popen(command, stdout=self.log, stderr=self.log)

    def close(self):
        """Tidies up. Returns a sentence if the run could not be made; one that broke down has a summary that says so."""
        self.log.close()
        if not (self.folder / "summary.json").exists():
            lines = pathlib.Path(self.log.name).read_text().strip().splitlines()
            return f"{self.run.name} failed: {lines[-1] if lines else 'without a word'} (exit code {self.process.returncode})"
        prune(self.folder, "grid", self.run.grid_times)
        prune(self.folder, "particles", self.run.particle_times)
        return None


def duration(seconds):
    return f"{seconds:.0f} s" if seconds < 90 else f"{seconds / 60:.0f} min"


def remember(measured, run, summary):
    """The cost of a particle's step in this preset, the greatest seen of runs that take long enough to tell."""
    if summary["particles"] * summary["steps"] > 1e7 and summary["ns_per_particle_step"] > 0:
        old = measured.get(run.options[1], 0)
        measured[run.options[1]] = max(0.5 * (old + summary["ns_per_particle_step"]), summary["ns_per_particle_step"])


class Queue:
    """The runs that are still to be made, and those that are being made."""

    def __init__(self, runs, programs, out, again):
        self.programs, self.out, self.again, self.total = programs, out, again, len(runs)
        self.plans = {run.name: plan(run, programs, out) for run in runs}
        self.measured, self.waiting, self.running, self.trouble = {}, [], [], []
        for run in runs:
            summary = None if again else finished(out / run.name, self.plans[run.name][0])
            if summary:
                remember(self.measured, run, summary)
            else:
                self.waiting.append(run)

    def done(self):
        return self.total - len(self.waiting) - len(self.running)

    def start_next(self):
        run = self.waiting.pop(0)
        if not self.again and finished(self.out / run.name, self.plans[run.name][0]):
            return  # another driver has made it meanwhile
        try:
            self.running.append(Job(run, self.programs, self.out))
        except BlockingIOError:
            self.waiting.append(run)
            time.sleep(1)

    def collect(self):
        """Takes in the jobs that have ended, and says so."""
        for job in [j for j in self.running if j.process.poll() is not None]:
            self.running.remove(job)
            sentence = job.close()
            if sentence:
                self.trouble.append(sentence)
            else:
                summary = json.loads((job.folder / "summary.json").read_text())
                remember(self.measured, job.run, summary)
                sentence = f"{job.run.name}, {duration(time.monotonic() - job.start)}"
                sentence += f" (it broke down: {summary['failure']})" if summary["failure"] else ""
            yield sentence

    def seconds_left(self):
        """Of one core."""
        of = {name: 1e-9 * estimates["particles"] * estimates["steps"] for name, (_, estimates) in self.plans.items()}
        left = sum(of[run.name] * self.measured.get(run.options[1], FIRST_GUESS) for run in self.waiting)
        return left + sum(max(0, of[job.run.name] * self.measured.get(job.run.options[1], FIRST_GUESS) -
                              (time.monotonic() - job.start)) for job in self.running)

    def end(self):
        for job in self.running:
            job.process.terminate()
            job.process.wait()


def make_runs(runs, programs, out, jobs, again):
    queue = Queue(runs, programs, out, again)
    print(f"{queue.done()} of {len(runs)} runs are there", flush=True)
    try:
        while queue.waiting or queue.running:
            if queue.waiting and len(queue.running) < jobs:
                queue.start_next()
            else:
                time.sleep(0.05)
            for sentence in queue.collect():
                print(f"[{queue.done()}/{len(runs)}] {sentence}; about {duration(queue.seconds_left() / jobs)} left", flush=True)
    finally:
        queue.end()
    if queue.trouble:
        raise Trouble("; ".join(queue.trouble))


def under_display(command):
    if os.environ.get("DISPLAY"):
        return command
    if not shutil.which("xvfb-run"):
        raise Trouble("there is neither a display nor xvfb-run, so the figures cannot be drawn (Debian: apt install xvfb)")
    return ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24"] + command


def follow_up(out, name):
    """Figures and claims from the runs, each in a process of its own."""
    for command in (under_display([sys.executable, str(HERE / "figures.py"), str(out), name]),
                    [sys.executable, str(HERE / "claims.py"), str(out), name]):
        if subprocess.run(command).returncode != 0:
            raise Trouble(f"{pathlib.Path(command[-3]).name} could not do its work; the reason is above")


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="CMake's build directory")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="where runs, figures and the table go")
    parser.add_argument("--coarse", action="store_true", help="coarser meshes: minutes instead of an hour")
    parser.add_argument("--figures-only", action="store_true", help="no runs: figures and claims from those that are there")
    parser.add_argument("--runs-only", action="store_true", help="no figures and no claims")
    parser.add_argument("--only", default="", metavar="WORD", help="only runs whose names begin so; no figures, no claims")
    parser.add_argument("--again", action="store_true", help="make finished runs anew, as after a change of the library")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time, of one thread each")
    return parser.parse_args()


def main():
    given = read_arguments()
    try:
        if given.jobs < 1:
            raise Trouble(f"--jobs is {given.jobs}; it must be at least 1")
        chosen = catalogue.COARSE if given.coarse else catalogue.FULL
        programs = {name: str(given.programs / path) for name, path in PROGRAMS.items()}
        for path in programs.values():
            if not os.access(path, os.X_OK):
                raise Trouble(f"{path} is not there; build it first")
        out = given.out / chosen.name
        if not given.figures_only:
            listing = subprocess.run([programs["paper_study"], "--material", "list"], capture_output=True, text=True)
            out.mkdir(parents=True, exist_ok=True)
            (out / "choices.txt").write_text(listing.stdout)
            choices = [line.split()[0] for line in listing.stdout.splitlines()]
            runs = [run for run in catalogue.all_runs(chosen, choices) if run.name.startswith(given.only)]
            make_runs(runs, programs, out, given.jobs, given.again)
        if not given.runs_only and not given.only:
            follow_up(out, chosen.name)
    except (Trouble, OSError) as trouble:
        print(f"reproduce_paper: {trouble}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("reproduce_paper: interrupted; started again, it goes on from here", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
