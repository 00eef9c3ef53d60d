#include "engine/app/prepare/tape_header.h"

#include <utility>

#include "engine/app/cli/version.h"
#include "engine/assets/sha256.h"
#include "engine/files/file_error.h"
#include "engine/files/regular_file.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "haptics/actuation/actuators.h"
#include "haptics/contact/shell_walk.h"

namespace fulcrum::app {

namespace {

Result<std::string> hash_of(const scenario::Scenario& scenario, const scenario::ModelEntry& model) {
  Result<RegularFile> file = RegularFile::open_within(scenario.folder, model.file.path);
  Result<std::string> hash = file ? sha256_hex(std::move(*file)) : file.error();
  if (!hash) return read_error(model.file.path, hash.error());
  return hash;
}

}  // namespace

Result<record::TapeHeader> tape_header(const Prepared& prepared, const std::string& device,
                                       const std::string& hand) {
  const scenario::Scenario& scenario = prepared.scenario;
  record::TapeHeader header;
  header.program_version = kVersion;
  header.simd = simd_target();
  header.scenario = prepared.name;
  header.scenario_file = scenario.texts.scenario;
  header.files = scenario.texts.files;
  header.overrides = scenario.overrides;
  header.seed = scenario.seed;
  header.hand = hand;
  header.device = device;
  header.tick_s = prepared.haptic.scene.tick_s;
  for (const scenario::ModelEntry& model : scenario.models) {
    Result<std::string> hash = hash_of(scenario, model);
    if (!hash) return hash.error();
    header.hashes[model.file.name] = std::move(*hash);
  }
  return header;
}

Result<Prepared> prepare_from_tape(const record::Tape& tape) {
  const record::TapeHeader& header = tape.header;
  // header.simd is told, not asked for: every SIMD target gives the same bits (haptics/contact/shell_walk.h).
  const Result<std::filesystem::path> file = scenario::find_scenario(header.scenario);
  if (!file)
    return Error{"The tape's scenario cannot be found, and with it the models it needs: " +
                 file.error().sentence};
  scenario::Checked<scenario::Scenario> loaded = scenario::load_scenario_texts(
      {header.scenario_file, header.files}, file->parent_path(), header.overrides);
  if (!loaded)
    return Error{"The scenario in the tape cannot be used:\n" + scenario::to_text(loaded.faults())};
  for (const scenario::ModelEntry& model : loaded->models) {
    const Result<std::string> hash = hash_of(*loaded, model);
    if (!hash) return hash.error();
    const auto recorded = header.hashes.find(model.file.name);
    if (recorded == header.hashes.end() || recorded->second != *hash)
      return Error{"'" + model.file.path.string() +
                   "' is not the model that the tape was made with: restore that "
                   "version, or record the run anew."};
  }
  std::optional<Prepared> prepared = prepare(header.scenario, std::move(*loaded));
  if (!prepared) return Error{"The tape's scenario could not be made ready."};
  return std::move(*prepared);
}

std::vector<std::string> other_devices(const record::Tape& tape) {
  std::vector<std::string> names;
  for (const auto& [name, path] : scenario::device_files(scenario::content_roots())) {
    const auto in_tape = tape.header.files.find("devices/" + name + ".yaml");
    if (in_tape == tape.header.files.end()) continue;
    const Result<RegularFile> file = RegularFile::open(path);
    const Result<std::string> text = file ? file->first_bytes(in_tape->second.size() + 1) : file.error();
    if (!text || *text != in_tape->second) names.push_back(name);
  }
  return names;
}

record::TraceColumns trace_columns(const World& world, const scenario::TaskDesc& task) {
  const DeviceDesc& device = world.desc().device;
  RecordNames names;
  for (int motor = 0; motor < Actuators::count(device); ++motor)
    names.motors.push_back(Actuators::name(device, motor));
  if (device.vibrotactile)
    for (const ChannelDesc& channel : device.vibrotactile->channels) names.channels.push_back(channel.name);
  const TickRecord record = world.blank_record();
  record::TraceRow like{record};
  if (task.hard_touch) like.hard_touches = 0;
  return {world.desc().tick_s, std::move(names), like};
}

std::optional<record::ChannelRecording> channel_recording(const SceneDesc& scene) {
  const std::optional<ChannelUse> use = channel_use(scene, scene);
  if (!use) return std::nullopt;
  return record::ChannelRecording{*scene.device.vibrotactile, use->signal};
}

}  // namespace fulcrum::app
