// A first program: a point is pressed 2 mm into a floor, and the floor pushes back.
#include <cstdio>

#include "floor.h"

int main() {
  using namespace fulcrum;
  Result<SceneDesc> scene = floor_and_point();
  if (!scene) return std::fprintf(stderr, "%s\n", scene.error().sentence.c_str()), 1;
  Result<World> world = World::build(*scene);
  if (!world) return std::fprintf(stderr, "%s\n", world.error().sentence.c_str()), 1;

  for (int tick = 0; tick < 1000; ++tick) {
    const double height = 5e-3 - 7e-3 * tick / 999;  // m, of the handle over the floor
    DeviceSample sample;
    sample.X_DH = scene->mapping.handle_in_device({Quat::Identity(), Vec3(0, height, 0)});
    const StepResult result = step(*world, sample, {});
    if (tick % 100 == 99)
      std::printf("hand %+.2f mm, tool %+.3f mm, force %.2f N\n", 1e3 * height,
                  1e3 * result.record.X_WT.p.y(), result.command.F_H_D.force.norm());
  }
}
