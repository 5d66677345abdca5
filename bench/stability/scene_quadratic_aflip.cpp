#include "scene.hpp"

namespace stability {

static void scenes() {
  const SceneReport<Default> report("quadratic AffineFlip USL");
  report.run("paper_100", {.speed = 100}, 7.2, 0.4);
  report.run("paper_1000", {.speed = 1000}, 12, 1);
  small_scenes(report);
}
static const Registered registered("scene_quadratic_aflip", &scenes);

static void refined() {
  SceneReport<Default>("quadratic AffineFlip USL, 0.5 um").run("paper_1000", {.spacing = 0.5, .speed = 1000}, 12, 1);
}
static const Registered refined_registered("scene_refined", &refined);

}  // namespace stability
