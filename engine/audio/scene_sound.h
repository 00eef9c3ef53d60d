#pragma once
// What a scene sounds like, as plain data: docs/sound.md.
//
// A blow is heard as it is felt: by the modes of haptics/effects/impact_vibration/distance_model.h, with
// their amplitudes and their decay, moved up by `pitch`, since the 12 to 40 Hz that shake a hand are below
// what loudspeakers play.

#include <memory>
#include <vector>

#include "haptics/effects/impact_vibration/distance_model.h"
#include "haptics/geometry/distance_field.h"
#include "haptics/geometry/feature_mesh.h"
#include "haptics/geometry/object_map.h"
#include "haptics/geometry/pointshell.h"
#include "haptics/math/linear.h"
#include "haptics/scene/impact_material.h"

namespace fulcrum::audio {

struct SceneSound {
  double gain = 1;    // of blows and sliding, 0 to 1
  double pitch = 16;  // times the frequencies that are felt: four octaves
  double slide = 1;   // of sliding beside blows, 0 to 1; 0: none is built
  DistanceModel distance = DistanceModel::sinusoid;
  double reach = 0;                                         // m, of the tool from the handle
  std::vector<ImpactMaterial> materials{ImpactMaterial()};  // of each object of the scene, by its number
  std::shared_ptr<const ObjectMap> objects;                 // null: all is of the first material
  std::shared_ptr<const Pointshell> tool_shell;             // as the tick has them; null: blows are those of
  std::shared_ptr<const DistanceField> scene_field;  // records that tell of impacts, and nothing slides
  std::shared_ptr<const FeatureMesh> tool_features, scene_features;  // in place of those, on triangles
  double tick_s = 1e-3;
};

// Where the scene is heard from.
struct Listener {
  Vec3 p_W = Vec3::Zero();        // (3) m
  Vec3 ahead_W = -Vec3::UnitZ();  // (3) of any length but zero
  Vec3 up_W = Vec3::UnitY();      // (3) not along ahead_W
};

// What the task sounds of, at the listener's own place.
enum class Chime { checkpoint, completed, hard_touch };
inline constexpr int kChimes = 3;

}  // namespace fulcrum::audio
