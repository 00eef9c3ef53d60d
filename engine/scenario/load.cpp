#include "engine/scenario/load.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <system_error>
#include <utility>

#include "engine/scenario/content.h"
#include "engine/scenario/content_file.h"
#include "engine/scenario/describe.h"
#include "engine/scenario/mirror.h"
#include "engine/scenario/nearby.h"
#include "engine/scenario/overrides.h"
#include "engine/scenario/text_store.h"
#include "engine/scenario/tree_reader.h"
#include "engine/scenario/words.h"
#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {

namespace {

void append(Faults& to, Faults from) {
  std::ranges::move(from, std::back_inserter(to));
}

Faults read_keys(const std::string& text, std::string_view source, const std::filesystem::path& folder,
                 const Describe& describe) {
  const auto root = parse_yaml(text, source);
  if (!root) return root.faults();
  return read_tree(*root, folder, describe);
}

// Where the value of `key` stands, for a fault about the file that it names.
Mark mark_of(const Node& root, std::initializer_list<std::string_view> path) {
  const Node* node = &root;
  for (const std::string_view part : path) {
    const NodeEntry* entry = node->find(part);
    if (!entry) break;
    node = &entry->value;
  }
  return node->mark;
}

Faults read_hand(HandEntry& hand, const Node& root, const std::filesystem::path& folder, TextStore& texts) {
  if (hand.path.name.empty()) return {};  // its key was refused already
  const auto text =
      texts.get(hand.path.name, [&] { return RegularFile::open_within(folder, hand.path.path); });
  if (!text) {
    const Mark mark = mark_of(root, {"hands", hand.name, "path"});
    return {mark.fault("cannot read " + in_quotes(hand.path.name) + ": " + text.error().sentence +
                       nearby_files(hand.path.name, folder))};
  }
  return read_keys(*text, hand.path.name, folder,
                   [&](KeyVisitor& visitor) { describe_hand_path(visitor, hand.waypoints); });
}

// `key`: what the text is called among those that are kept. `at`: the path of the key that names the file.
Faults read_content(const ContentFile& file, const std::string& key, const std::string& named,
                    const Node& root, std::initializer_list<std::string_view> at,
                    const std::filesystem::path& folder, TextStore& texts, const Describe& describe) {
  const auto text = texts.get(key, [&] { return file.open(); });
  if (!text) {
    return {mark_of(root, at).fault("cannot read " + in_quotes(file.name()) + ": " + text.error().sentence +
                                    nearby_names(named, file.folders()))};
  }
  return read_keys(*text, file.name(), folder, describe);
}

// What vibrates or senses beside the model: an installed device, of which only channels and strip matter.
Faults read_beside(DeviceEntry& device, const Node& root, const std::filesystem::path& folder,
                   TextStore& texts) {
  if (device.beside.empty()) return {};
  const ContentFile file(folder, "devices", device.beside);
  if (texts.reads_files() && file.is_own())
    return {mark_of(root, {"device", "beside"})
                .fault(in_quotes(device.beside) +
                       " is a file of the scenario's folder: name an installed device")};
  DeviceDesc beside;
  Faults faults = read_content(file, file.name(), device.beside, root, {"device", "beside"}, folder, texts,
                               [&](KeyVisitor& visitor) { describe_device_file(visitor, beside); });
  if (faults.empty() && !beside.vibrotactile && !beside.strip)
    faults.push_back(
        mark_of(root, {"device", "beside"})
            .fault(in_quotes(device.beside) +
                   " has neither channels nor a strip: name a device that vibrates, or a strip"));
  if (beside.vibrotactile) device.desc.vibrotactile = std::move(beside.vibrotactile);
  if (beside.strip) device.desc.strip = beside.strip;
  return faults;
}

// Installed files say what real devices can bear. A scenario may bring a device that is to be simulated,
// under a name of its own.
Faults read_device(DeviceEntry& device, const Node& root, const std::filesystem::path& folder,
                   TextStore& texts) {
  if (device.model.empty()) return {};
  const ContentFile file(folder, "devices", device.model);
  const std::string own_key = "scenario:" + file.name();
  device.own = texts.reads_files() ? file.is_own() : texts.has(own_key);
  if (texts.reads_files() && device.own && file.is_installed()) {
    return {mark_of(root, {"device", "model"})
                .fault(in_quotes(device.model) + " is an installed device, and the scenario's folder has a " +
                       in_quotes(file.name()) +
                       " too: a scenario cannot change an installed device's figures; give its own device "
                       "another name")};
  }
  Faults faults =
      read_content(file, device.own ? own_key : file.name(), device.model, root, {"device", "model"}, folder,
                   texts, [&](KeyVisitor& visitor) { describe_device_file(visitor, device.desc); });
  append(faults, read_beside(device, root, folder, texts));
  return faults;
}

// The key of the calibration among the texts that are kept. A scenario names no file by an absolute path.
constexpr const char* kCalibrationText = "/calibration.yaml";

// What was measured of the device that a person holds, in place of its table's figures. Whether the scene is
// mirrored is the scenario's to say, or --set's, and only where neither does the calibration's.
Faults read_calibration(Scenario& scenario, const Node& root, const std::filesystem::path& file,
                        TextStore& texts) {
  if (texts.reads_files() ? file.empty() : !texts.has(kCalibrationText)) return {};
  const bool of_tape = file.empty();
  const std::string source = of_tape ? "the tape's calibration" : file.string();
  const std::string& model = scenario.device.model;
  const auto refused = [&](Faults faults) {
    const std::string cure = of_tape
                                 ? "record the run anew, since this tape cannot be replayed"
                                 : "calibrate it again with `fulcrum calibrate " + model +
                                       "`, or forget that with `fulcrum calibrate " + model + " --forget`";
    for (Fault& fault : faults) fault.sentence.append(": ").append(cure);
    return faults;
  };
  const auto text = texts.get(kCalibrationText, [&] { return RegularFile::open(file); });
  if (!text) return refused({{source, 0, 0, "cannot read the calibration: " + text.error().sentence}});
  Calibration calibration;
  Faults faults = read_keys(*text, source, file.parent_path(),
                            [&](KeyVisitor& visitor) { describe_calibration_file(visitor, calibration); });
  if (!faults.empty()) return refused(std::move(faults));
  if (calibration.device != model)
    return refused({{source, 0, 0,
                     "it is a calibration of " + in_quotes(calibration.device) + ", and the device is " +
                         in_quotes(model)}});
  Result<DeviceDesc> device = calibrated(scenario.device.desc, calibration);
  if (!device) return refused({{source, 0, 0, device.error().sentence}});
  scenario.device.desc = std::move(*device);
  if (!calibration.left_handed || root.find("left_handed") != nullptr) return {};
  scenario.why_right_handed = why_not_mirrored(scenario);
  scenario.left_handed = scenario.why_right_handed.empty();
  return {};
}

// Each material that is named, once.
Faults read_materials(Scenario& scenario, const Node& root, TextStore& texts) {
  Faults faults;
  const auto read = [&](const std::string& name, std::initializer_list<std::string_view> at) {
    if (name.empty() || scenario.impact_materials.contains(name)) return;
    ImpactMaterial& material = scenario.impact_materials[name];
    const ContentFile file(scenario.folder, "materials", name);
    append(faults, read_content(file, file.name(), name, root, at, scenario.folder, texts,
                                [&](KeyVisitor& visitor) { describe_material_file(visitor, material); }));
  };
  for (const ModelEntry& model : scenario.models) read(model.material, {"models", model.name, "material"});
  read(scenario.impact_material, impact_material_key());
  if (scenario.sound) read(scenario.sound->material, sound_material_key());
  return faults;
}

// `source`: how faults call the text. `name`: what it is called among the texts that are kept.
Inspected inspect(const std::string& text, const std::string& source, const std::string& name,
                  const std::filesystem::path& folder, std::span<const std::string> overrides,
                  TextStore& texts, const std::filesystem::path& calibration = {}) {
  Inspected read;
  Scenario& scenario = read.scenario;
  Faults& faults = read.faults;
  auto parsed = parse_yaml(text, source);
  if (!parsed) {
    faults = parsed.faults();
    return read;
  }
  const Node& root = read.root = std::move(*parsed);

  if (!overrides.empty()) {
    Scenario described;  // takes what listing the keys appends to it
    const auto keys = list_keys([&](KeyVisitor& visitor) { describe_scenario(visitor, described); });
    if (faults = apply_overrides(read.root, overrides, keys); !faults.empty()) return read;
  }

  std::error_code error;
  scenario.folder = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, error);
  if (error) scenario.folder = std::filesystem::absolute(folder, error);
  scenario.overrides.assign(overrides.begin(), overrides.end());
  faults =
      read_tree(root, scenario.folder, [&](KeyVisitor& visitor) { describe_scenario(visitor, scenario); });
  for (HandEntry& hand : scenario.hands) {
    hand.desc.seed = static_cast<std::uint64_t>(scenario.seed);
    append(faults, read_hand(hand, root, scenario.folder, texts));
  }
  append(faults, read_device(scenario.device, root, scenario.folder, texts));
  if (faults.empty()) faults = read_calibration(scenario, root, calibration, texts);
  append(faults, read_materials(scenario, root, texts));
  if (!faults.empty()) return read;

  vary(scenario.checkpoints, scenario.variant, scenario.order, scenario.seed);
  if (scenario.left_handed) {
    if (const std::string why = why_not_mirrored(scenario); !why.empty()) {
      faults = {mark_of(root, {"left_handed"})
                    .fault("'left_handed' cannot be here, since " + why + ": leave it out, or say false")};
      return read;
    }
    mirror(scenario);
  }
  texts.put(name, text);
  scenario.texts = {name, texts.take_used()};
  return read;
}

Checked<Scenario> scenario_or_faults(Inspected read) {
  if (!read.faults.empty()) return std::move(read.faults);
  return std::move(read.scenario);
}

}  // namespace

Checked<Scenario> load_scenario(const std::filesystem::path& file, std::span<const std::string> overrides,
                                const std::filesystem::path& calibration) {
  const auto text = read_text(RegularFile::open_within(file.parent_path(), file.filename()));
  if (!text) return Faults{{file.string(), 0, 0, "cannot read the scenario: " + text.error().sentence}};
  TextStore texts;
  return scenario_or_faults(inspect(*text, file.string(), file.filename().string(), file.parent_path(),
                                    overrides, texts, calibration));
}

Inspected inspect_scenario(const std::filesystem::path& file, std::span<const std::string> overrides) {
  Inspected read;
  const auto text = read_text(RegularFile::open_within(file.parent_path(), file.filename()));
  if (!text) {
    read.faults = {{file.string(), 0, 0, "cannot read the scenario: " + text.error().sentence}};
    return read;
  }
  TextStore texts;
  return inspect(*text, file.string(), file.filename().string(), file.parent_path(), overrides, texts);
}

Place Inspected::place(std::string_view path) const {
  const Node* node = &root;
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('.'));
    path.remove_prefix(std::min(part.size() + 1, path.size()));
    std::size_t index = 0;
    if (const NodeEntry* entry = node->find(part))
      node = &entry->value;
    else if (std::from_chars(part.data(), part.data() + part.size(), index).ec == std::errc() &&
             index < node->items.size())
      node = &node->items[index];
    else
      break;
  }
  return node->mark.place();
}

Checked<Calibration> load_calibration(const std::filesystem::path& file) {
  const auto text = read_text(RegularFile::open(file));
  if (!text) return Faults{{file.string(), 0, 0, "cannot read the calibration: " + text.error().sentence}};
  Calibration calibration;
  Faults faults = read_keys(*text, file.string(), file.parent_path(),
                            [&](KeyVisitor& visitor) { describe_calibration_file(visitor, calibration); });
  if (!faults.empty()) return faults;
  return calibration;
}

Checked<DeviceDesc> load_device(const std::filesystem::path& file) {
  const auto text = read_text(RegularFile::open(file));
  if (!text) return Faults{{file.string(), 0, 0, "cannot read the device: " + text.error().sentence}};
  DeviceDesc device;
  Faults faults = read_keys(*text, file.string(), file.parent_path(),
                            [&](KeyVisitor& visitor) { describe_device_file(visitor, device); });
  if (!faults.empty()) return faults;
  return device;
}

Checked<Scenario> load_scenario_text(std::string_view text, const std::filesystem::path& folder,
                                     std::span<const std::string> overrides) {
  TextStore texts;
  return scenario_or_faults(
      inspect(std::string(text), kScenarioFile, kScenarioFile, folder, overrides, texts));
}

Checked<Scenario> load_scenario_texts(const SourceTexts& texts, const std::filesystem::path& folder,
                                      std::span<const std::string> overrides) {
  const auto text = texts.files.find(texts.scenario);
  if (text == texts.files.end())
    return Faults{{texts.scenario, 0, 0, "the scenario is not among the texts that were kept of it"}};
  TextStore store(texts.files);
  return scenario_or_faults(inspect(text->second, texts.scenario, texts.scenario, folder, overrides, store));
}

}  // namespace fulcrum::scenario
