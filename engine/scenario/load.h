#pragma once
// Scenario files -> Scenario. What may be written in one is described in describe_scenario.h; schema.h writes
// it out.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/calibration.h"
#include "engine/scenario/fault.h"
#include "engine/scenario/scenario.h"
#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {

// `overrides`: KEY=VALUE, as --set takes them. KEY is a full dotted path (contact.stiffness,
// checkpoints.0.radius, hands.expert.tremor) or its last component where only one key ends so (response).
//
// Everything that a scenario names lies in its folder. Devices and materials are looked for there, in
// devices/ and materials/, and in the content roots (content.h).
//
// `calibration`: the file of the device that a person holds (calibration.h); empty: there is none, or nobody
// holds it. It is kept among the texts, so that a tape has it.
Checked<Scenario> load_scenario(const std::filesystem::path& file,
                                std::span<const std::string> overrides = {},
                                const std::filesystem::path& calibration = {});

// What could be read of a scenario, and all that is wrong with its texts.
struct Inspected {
  Scenario scenario;
  Faults faults;
  Node root;  // of the scenario's own text; without entries where that is not YAML

  // Where the value of a key stands, or what of its path is there.
  Place place(std::string_view path) const;
};

// For who wants to say everything at once: load_scenario() gives a scenario only where nothing is wrong.
Inspected inspect_scenario(const std::filesystem::path& file, std::span<const std::string> overrides = {});

// The same from a text, as if it lay in `folder`; files that it names are read from there.
Checked<Scenario> load_scenario_text(std::string_view text, const std::filesystem::path& folder,
                                     std::span<const std::string> overrides = {});

// The same from the texts of an earlier load (a tape's): no file of text is opened, and one that is not among
// the texts is a fault. Models are named relative to `folder`.
Checked<Scenario> load_scenario_texts(const SourceTexts& texts, const std::filesystem::path& folder,
                                      std::span<const std::string> overrides = {});

// What calibration_file() names, alone.
Checked<Calibration> load_calibration(const std::filesystem::path& file);

// A file of content/devices alone.
Checked<DeviceDesc> load_device(const std::filesystem::path& file);

}  // namespace fulcrum::scenario
