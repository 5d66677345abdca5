#include "scene.hpp"

namespace stability {

static void scenes() {
  const SceneReport<Default> report("quadratic AffineFlip USL");
  report.run("paper_100", {.speed = 100}, 7.2, 0.4);
  report.run("paper_1000", {.speed = 1000}, 12, 1);
  small_scenes(report);
}
static const Registered registered("scene_quadratic_aflip", &scenes);

/// A block of half the width, so that a refined run is affordable.
static void refined() {
  const SceneReport<Default> coarse("quadratic AffineFlip USL"), fine("quadratic AffineFlip USL at 0.5 um");
  coarse.run("narrow_100", {.half_width = 10}, 7.2, 0.4);
  coarse.run("narrow_1000", {.half_width = 10, .speed = 1000}, 12, 0.5);
  fine.run("narrow_100", {.spacing = 0.5, .half_width = 10}, 7.2, 0.4);
  fine.run("narrow_1000", {.spacing = 0.5, .half_width = 10, .speed = 1000}, 12, 0.5);
}
static const Registered refined_registered("scene_refined", &refined);

}  // namespace stability
