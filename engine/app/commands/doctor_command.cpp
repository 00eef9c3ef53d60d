#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "drivers/registry.h"
#include "drivers/sound/sound.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/doctor/held_devices.h"
#include "engine/app/doctor/machine_files.h"
#include "engine/app/doctor/wake_ups.h"
#include "engine/ui/window.h"
#include "engine/vulkan/device.h"
#include "engine/vulkan/instance.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

// A refusal says what is wrong, and from "To grant it" on what would cure it.
Finding granted(const char* what, const std::string& refusal, const char* good) {
  if (refusal.empty()) return {what, Health::good, good, ""};
  const std::size_t cure = refusal.find(" To grant it, ");
  if (cure == std::string::npos) return {what, Health::fair, refusal, ""};
  return {what, Health::fair, refusal.substr(0, cure),
          refusal.substr(cure + std::string_view(" To grant it, ").size())};
}

Finding punctual(const WakeUps& wake_ups) {
  std::string says = "Of 1000 ticks of 1 ms, " + std::to_string(wake_ups.late) +
                     " would have begun a tick late; the latest ";
  says.append(number_text(1e3 * wake_ups.worst_s, 2)).append(" ms.");
  if (wake_ups.late == 0) return {"wake-ups", Health::good, std::move(says), ""};
  return {"wake-ups", Health::fair, std::move(says),
          wake_ups.scheduling.empty()
              ? "close what keeps the processors busy; on a virtual machine, its host decides"
              : "real-time scheduling, above"};
}

// "good", in the colour that says so on a terminal; four letters each.
std::string in_health(Health health) {
  const std::string name(name_of(health));
  return health == Health::good ? green(name) : health == Health::fair ? yellow(name) : red(name) + " ";
}

Finding graphics() {
  const auto instance = vulkan::Instance::create({});
  if (!instance)
    return {"graphics", Health::bad, instance.error().sentence, "headless runs go on without a picture"};
  const auto chosen = vulkan::choose(vulkan::list_devices(*instance), "");
  if (!chosen)
    return {"graphics", Health::bad, chosen.error().sentence, "headless runs go on without a picture"};
  if (chosen->kind != "software") return {"graphics", Health::good, "Drawn by " + chosen->name + ".", ""};
  return {"graphics", Health::fair,
          "Drawn in software, by " + chosen->name + ": a window shows few pictures a second.",
          "where there is a graphics card, install its Vulkan driver"};
}

Finding display() {
  const std::string why = ui::why_no_window();
  if (why.empty()) return {"display", Health::good, "A window can be opened.", ""};
  return {"display", Health::bad, why, ""};
}

// Of the card that `--device mouse+audio` plays on. What is wrong is said before the colon, its cure after
// it.
Finding sound_card() {
  const Result<std::string> card = sound::describe_sound({}, 1e-3);
  if (card) return {"sound", Health::good, *card, ""};
  const std::string& wrong = card.error().sentence;
  const std::size_t colon = std::min(wrong.find(": "), wrong.size());
  std::string says = "Nothing can vibrate by sound: ";
  return {"sound", Health::fair, says.append(wrong.substr(0, colon)) + ".",
          colon == wrong.size() ? "" : wrong.substr(colon + 2)};
}

std::vector<Finding> examine() {
  const WakeUps wake_ups = measure_wake_ups();
  const std::string no_window = ui::why_no_window();
  return {granted("scheduling", wake_ups.scheduling, "The haptic thread is scheduled in real time."),
          granted("memory", wake_ups.memory, "The program's memory is locked."),
          punctual(wake_ups),
          governor_of("/sys"),
          usb_sleep_of("/sys", &knows_usb),
          graphics(),
          display(),
          sound_card(),
          devices_in(list_devices(no_window), best_device(no_window))};
}

int doctor_command(bool json) {
  const std::vector<Finding> findings = examine();
  if (json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Finding& f : findings)
      all.push_back({{"what", f.what}, {"health", name_of(f.health)}, {"says", f.says}, {"cure", f.cure}});
    std::printf("%s\n", all.dump(2).c_str());
    return kCompleted;
  }
  for (const Finding& f : findings) {
    std::printf("%-10s  %s  %s\n", f.what.c_str(), in_health(f.health).c_str(), f.says.c_str());
    if (!f.cure.empty()) std::printf("%18s%s\n", "", dim("-> " + f.cure).c_str());
  }
  return kCompleted;
}

}  // namespace

void add_doctor(Program& program) {
  const auto json = std::make_shared<bool>(false);
  program.add(
      "doctor", "Whether this machine is fit for a haptic run, and what would make it so",
      [json](Arguments& arguments) { arguments.json("As JSON", *json); },
      [json] { return doctor_command(*json); });
}

}  // namespace fulcrum::app
