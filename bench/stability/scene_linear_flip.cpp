#include "scene.hpp"

namespace stability {

static void scenes() {
  const SceneReport<Scheme<shape::Linear, transfer::Flip, update::Usl>> report("linear FLIP USL");
  report.run("paper_1000", {.speed = 1000}, 12, 0.5);
  report.run("paper_100", {.speed = 100}, 7.2, 0.4);
  small_scenes(report);
}
static const Registered registered("scene_linear_flip", &scenes);

}  // namespace stability
