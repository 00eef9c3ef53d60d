// An effect of one's own, outside the tree: a breeze along x that blows while nothing is touched. It is built
// into a World beside those that the scene names, by a program of one's own: `fulcrum run` does not load it.
// Its value stands in the tick's record with a name, a unit and a meaning, for describe() to find, and every
// limit of the device is between it and the motors.
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "floor.h"

namespace {

using namespace fulcrum;

class Breeze final : public Effect {
public:
  explicit Breeze(double force) : force_(force) {}

  Wrench shape(const EffectTick& tick) noexcept override {
    blowing_ = tick.regions.empty() ? force_ : 0;
    return {Vec3(blowing_, 0, 0), Vec3::Zero()};
  }
  void record(EffectRecords& records) const noexcept override { records.own.add(kForce, blowing_); }
  BuiltPart part() const override { return {"breeze", "pushes until something is touched", sizeof *this}; }

private:
  static constexpr Quantity kForce{"breeze/force", "N", "D", "Of the breeze on the handle."};
  double force_;
  double blowing_ = 0;
};

// The visitor of describe() (haptics/signal/quantity.h) that this program needs: a column by its name.
class Column {
public:
  explicit Column(std::string_view name) : name_(name) {}
  void number(const Quantity& what, double value) {
    if (what.name == name_) value_ = value;
  }
  void time(const Quantity&, std::int64_t) {}
  void count(const Quantity&, std::int64_t) {}
  void vector(const Quantity&, const Vec3&) {}
  void length(const Quantity&, const Vec3&) {}
  void pose(const Quantity&, const Pose&) {}
  void wrench(const Quantity&, const Wrench&) {}
  void each(const Quantity&, std::span<const double>, std::span<const std::string>) {}
  void unseen(const auto&) {}
  const RecordNames& names() const { return names_; }
  double value() const { return value_; }

private:
  std::string_view name_;
  RecordNames names_;
  double value_ = 0;
};

}  // namespace

int main() {
  Result<SceneDesc> scene = floor_and_point();
  if (!scene) return std::fprintf(stderr, "%s\n", scene.error().sentence.c_str()), 1;
  std::vector<std::unique_ptr<Effect>> own;
  own.push_back(std::make_unique<Breeze>(1.5));
  Result<World> world = World::build(*scene, std::move(own));
  if (!world) return std::fprintf(stderr, "%s\n", world.error().sentence.c_str()), 1;

  std::printf("timestamp,device/force/x,breeze/force\n");
  for (int tick = 0; tick < 2000; ++tick) {
    const double height = tick < 1000 ? 5e-3 : -1e-3;  // m: in the air for a second, then on the floor
    DeviceSample sample;
    sample.X_DH = scene->mapping.handle_in_device({Quat::Identity(), Vec3(0, height, 0)});
    const TickRecord record = step(*world, sample, {}).record;
    Column breeze("breeze/force");
    describe(breeze, record);
    if (tick % 100 == 99)
      std::printf("%g,%g,%g\n", tick * scene->tick_s, record.device_F_H_D.force.x(), breeze.value());
  }
}
