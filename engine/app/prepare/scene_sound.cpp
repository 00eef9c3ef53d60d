#include "engine/app/prepare/scene_sound.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::app {
namespace {

Vec3 heard_at(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace

std::optional<audio::SceneSound> scene_sound(const Prepared& prepared, const SceneDesc& scene) {
  const std::optional<scenario::SoundEntry>& entry = prepared.scenario.sound;
  if (!entry) return std::nullopt;
  audio::SceneSound sound;
  sound.gain = entry->gain;
  sound.pitch = entry->pitch;
  sound.slide = entry->slide;
  sound.tick_s = scene.tick_s;
  sound.reach = tool_reach(scene, scene.tool.X_HT.inverse().p);
  sound.materials = prepared.haptic.heard;
  sound.objects = prepared.haptic.objects;
  sound.tool_shell = scene.tool_shell;
  sound.scene_field = scene.scene_field;
  sound.tool_features = scene.tool_features;
  sound.scene_features = scene.scene_features;
  // The effect may be left out on this device: what tells the distance is heard all the same.
  if (scene.impact_vibration) sound.distance = scene.impact_vibration->distance;
  return sound;
}

audio::Listener listener_at(const render::Camera& camera) {
  const Vec3 eye = heard_at(camera.eye), ahead = heard_at(camera.target) - eye;
  // A camera that looks straight down has its up as the renderer takes it then.
  const bool along = ahead.cross(Vec3::UnitY()).norm() < 1e-3 * ahead.norm();
  return {eye, ahead, along ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitY())};
}

}  // namespace fulcrum::app
