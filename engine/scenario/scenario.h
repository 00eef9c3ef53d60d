#pragma once
// A scenario as plain data, as the file has it. assemble.h makes of it what ticks and what is drawn.
//
// Poses of the tool are those of its model's own frame M here: the author places what a modelling program
// shows. assemble.h moves them to T, the centre of mass.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/assets/length_unit.h"
#include "engine/render/visual_desc.h"
#include "engine/scenario/fault.h"
#include "engine/scenario/guide.h"
#include "engine/scenario/task.h"
#include "engine/scenario/variant.h"
#include "haptics/bake/field_bake.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/device/hand.h"
#include "haptics/math/names_of.h"
#include "haptics/scene/coupling_gains.h"
#include "haptics/world/scene_desc.h"

namespace fulcrum::scenario {

// A file that the scenario names; it lies in the scenario's folder.
struct FileRef {
  std::string name;            // as written
  std::filesystem::path path;  // resolved, absolute
  Place where;                 // of the name, for a sentence about the file's contents
};

enum class ModelRole { scene, tool, decor };  // touched; held in the hand; seen only

struct ModelEntry {
  std::string name;
  FileRef file;
  FileRef drawn;  // what is seen of it, where that is another file; without a name: `file`
  ModelRole role = ModelRole::scene;
  bool marked = false;  // of the file's objects those alone that are marked with this role and `material`
  LengthUnit unit = LengthUnit::m;  // of the file's numbers
  Vec3 scale = Vec3::Ones();        // along the file's own axes
  Pose X_MF;  // of the file's origin, scaled, in M; of what is no tool in W, where nothing else is placed
  std::string cut_of;  // the name of the model that it shows cut open; empty: none
  std::string
      material;  // what a blow on it sounds like, content/materials/MATERIAL.yaml; empty: the effect's
  bool lettering = false;  // it is to be read, and is not drawn where it would be mirror-written
};

// Replaces what the models' material of this name says.
struct MaterialOverride {
  std::string name;
  Place where;
  std::optional<Vec3> base_colour;      // linear
  std::optional<double> metallic;       // 0 to 1
  std::optional<double> roughness;      // 0 to 1
  Vec3 scatter_distance{Vec3::Zero()};  // m, of red, green and blue; zero: light does not spread below it
};

struct ToolEntry {
  std::optional<double> density;    // kg/m^3, one of the two at most; neither: the mass of ToolDesc
  std::optional<double> mass;       // kg
  Pose X_HM;                        // the model in the handle, when nothing touches it
  Pose X_WM_start;                  // where the model is at tick 0
  Vec3 touch_point = Vec3::Zero();  // p_MC (3) m, the point that has to reach the checkpoints
  std::string touch_name;           // what the tool has there; empty: it has no name
  bool weight = ToolDesc{}.weight;
};

struct DeviceEntry {
  std::string model;   // devices/MODEL.yaml, of the program's content
  bool own = false;    // of the scenario's folder instead: it is simulated only
  std::string beside;  // devices/BESIDE.yaml: its channels, its strip stand in `desc`; empty: the model's own
  DeviceDesc desc;     // what that file says
  MappingDesc mapping;
  AllocationDesc allocation;
  bool drawn = false;           // its arms are seen, where it has such
  std::optional<double> floor;  // m, y in W of what they stand on; none: nothing is drawn under them
};

// The hand that knows how: what a trial is compared with, and whose way can be shown.
inline constexpr std::string_view kExpertHand = "expert";

struct HandEntry {
  std::string name;
  FileRef path;
  HandDesc desc;                    // its seed is the scenario's
  std::vector<Waypoint> waypoints;  // of M, what the path's file says
};

// What is heard of the scene.
struct SoundEntry {
  double gain = 1, pitch = 16, slide = 1;  // audio/scene_sound.h
  std::string material = "steel";          // of models that name none, content/materials/MATERIAL.yaml
};

// The picture of all around that the scene has its light from, in place of the studio.
struct SurroundingsEntry {
  FileRef file;       // equirectangular, .hdr; its middle is towards +x
  float turn = 0;     // rad, about +y
  bool seen = false;  // behind the scene, in place of the background
};

struct View {
  std::string name;
  render::Camera camera;
  bool cut = false;  // shows models cut open, where there are such
};

// The exact text of the scenario and of every file of text that it read, so that a tape can embed them.
struct SourceTexts {
  std::string scenario;  // the key in `files` of the scenario itself
  std::map<std::string, std::string>
      files;  // "scenario.yaml", "expert.yaml", "devices/phantom_like.yaml", ...
};

// For whom a scenario is, among those beside it.
enum class Difficulty { easy, medium, hard };

// What the response constraint measures contact on: the tool's points in a distance field of the scene, or
// the triangles of both as they are. Other responses look points up.
enum class ContactSurface { points, triangles };

// The slowest and the fastest loop that a scenario may ask for.
inline constexpr double kSlowestTicks_Hz = 100, kFastestTicks_Hz = 20000;

struct Scenario {
  std::string title;
  std::string about;                     // one line
  std::optional<Difficulty> difficulty;  // none: nobody has said
  double time_limit = 0;                 // s
  std::int64_t seed = 1;
  double tick_rate_Hz = 1000;
  bool left_handed = false;      // all below is mirrored; the models are where they are loaded (mirror.h)
  std::string why_right_handed;  // though the device's calibration asks for the left hand; empty: it does not
  std::vector<ModelEntry> models;
  std::vector<MaterialOverride> materials;
  ToolEntry tool;
  FieldDesc field;
  PointshellDesc shell{.deviation = 50e-6};
  ContactDesc contact;
  ContactSurface surface = ContactSurface::triangles;
  double edges = 0;  // m, between points on the scene's sharp edges, where contact is on points; 0: none
  Integrator integrator = SceneDesc{}.integrator;
  CouplingGains coupling;
  VelocityEstimatorDesc velocity_estimator;
  DeviceEntry device;
  EffectDescs effects;  // that it names; the materials of impact vibration are looked up below
  ImpactDetectorDesc impact;
  std::string impact_material;  // of models that name none; empty: no effect asks what models are made of
  std::map<std::string, ImpactMaterial> impact_materials;  // that are named, what their files say
  std::optional<HoldingPointDesc> holding_point;
  std::vector<Checkpoint> checkpoints;
  double dwell = TaskDesc{}.dwell;   // s
  std::optional<double> hard_touch;  // N
  Order order = Order::given;
  std::vector<Avoided> avoid;
  ScoreWeights score;
  VariantDesc variant;  // checkpoints are what it has made of them
  std::vector<HandEntry> hands;
  std::optional<GuideDesc> guide;
  std::optional<SoundEntry> sound;
  std::vector<View> views;  // the first is where a window starts
  std::optional<render::KeyLight> light = render::KeyLight{};
  render::Ambient ambient;  // its picture is read when the scene is assembled
  std::optional<SurroundingsEntry> surroundings;
  render::Background background;

  std::filesystem::path folder;        // of the scenario's file, absolute
  std::vector<std::string> overrides;  // KEY=VALUE, in the order given
  SourceTexts texts;
};

}  // namespace fulcrum::scenario

template <>
inline constexpr std::array<std::string_view, 3> fulcrum::names_of<fulcrum::scenario::ModelRole>{
    "scene", "tool", "decor"};
template <>
inline constexpr std::array<std::string_view, 2> fulcrum::names_of<fulcrum::scenario::ContactSurface>{
    "points", "triangles"};
template <>
inline constexpr std::array<std::string_view, 3> fulcrum::names_of<fulcrum::scenario::Difficulty>{
    "easy", "medium", "hard"};
