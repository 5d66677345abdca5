#!/usr/bin/python3
"""Draws the paper's figures 1 to 9, the paper's scheme and the default scheme on the finest mesh side by side.

figures.py DIR SET [NUMBER...]     DIR/figures/paper_figure_1.png ... from the runs in DIR; SET is full or coarse

The surfaces need a display, or xvfb-run. Exit code: 0 all drawn, 1 not.
"""

import pathlib
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from PIL import Image  # noqa: E402

import catalogue  # noqa: E402
import curves  # noqa: E402
import cuts  # noqa: E402
import measures  # noqa: E402
import surfaces  # noqa: E402


class Runs:
    """The runs of a set, by name."""

    def __init__(self, folder, name):
        self.folder, self.set = pathlib.Path(folder), catalogue.SETS[name]
        self.known, self.told = {}, set()

    def __getitem__(self, name):
        if name not in self.known:
            self.known[name] = measures.Run(self.folder / name)
        return self.known[name]

    def paper(self, speed=100):
        return self[f"paper_v{speed}"]

    def default(self, h, speed=100):
        return self[f"default_h{h:g}_v{speed}"]

    def mesh_sequence(self, speed=100):
        """The meshes, from coarse to fine, on which this speed has been run with the default scheme."""
        meshes = self.set.fields if speed in (100, 1000) else self.set.trend
        there = tuple(h for h in meshes if (self.folder / f"default_h{h:g}_v{speed}" / "summary.json").exists())
        if there != meshes and speed not in self.told:
            self.told.add(speed)
            print(f"the finest runs at {speed} m/s are not there yet; going on without", file=sys.stderr)
        return there or meshes

    def finest(self, speed=100):
        """The default scheme on the finest mesh that this speed was run on."""
        return self.default(self.mesh_sequence(speed)[-1], speed)

    def sides(self, speed=100):
        """What is drawn side by side."""
        return self.paper(speed), self.finest(speed)


FIGURES = {1: surfaces.velocity, 2: cuts.early, 3: surfaces.isobars_9, 4: surfaces.isobars_11, 5: surfaces.temperature,
           6: curves.growth, 7: cuts.density_and_pressure, 8: cuts.temperature_and_velocity, 9: curves.extremes}


def main():
    runs = Runs(sys.argv[1], sys.argv[2])
    numbers = [int(word) for word in sys.argv[3:]] or list(FIGURES)
    folder = runs.folder / "figures"
    folder.mkdir(exist_ok=True)
    for number in numbers:
        try:
            figure, dpi = FIGURES[number](runs)
        except (measures.Missing, OSError) as reason:
            print(f"figure {number} cannot be drawn: {reason}", file=sys.stderr)
            return 1
        file = folder / f"paper_figure_{number}.png"
        figure.savefig(file, dpi=dpi)
        if file.stat().st_size > 350e3:
            Image.open(file).convert("RGB").quantize(256).save(file, optimize=True)
        plt.close(figure)
        print(file, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
