#include "engine/app/doctor/machine_files.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <vector>

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

// The first word of a file; nothing where there is none.
std::optional<std::string> word_in(const fs::path& file) {
  std::ifstream in(file);
  std::string word;
  if (!(in >> word)) return std::nullopt;
  return word;
}

std::optional<std::uint16_t> hexadecimal_in(const fs::path& file) {
  const std::optional<std::string> word = word_in(file);
  std::uint16_t value = 0;
  if (!word) return std::nullopt;
  const auto [end, error] = std::from_chars(word->data(), word->data() + word->size(), value, 16);
  if (error != std::errc() || end != word->data() + word->size()) return std::nullopt;
  return value;
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

std::string joined(const std::set<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all.append(all.empty() ? "" : ", ").append(word);
  return all;
}

}  // namespace

Finding governor_of(const fs::path& sys) {
  std::set<std::string> governors;
  for (const fs::path& cpu : entries(sys / "devices/system/cpu"))
    if (const auto governor = word_in(cpu / "cpufreq/scaling_governor")) governors.insert(*governor);
  if (governors.empty())
    return {"processor", Health::good, "Nothing here changes the processors' speed.", ""};
  if (governors == std::set<std::string>{"performance"})
    return {"processor", Health::good, "The processors run at full speed (performance).", ""};
  std::string says = "The processors may run slowly (";
  says.append(joined(governors)).append("), so that a tick can take several times as long as another.");
  return {"processor", Health::fair, std::move(says),
          "as root: echo performance | tee /sys/devices/system/cpu/cpu*/cpufreq/scaling_governor"};
}

Finding usb_sleep_of(const fs::path& sys, const std::function<bool(std::uint16_t, std::uint16_t)>& is_ours) {
  std::string cure;
  std::set<std::string> sleepy;
  int seen = 0;
  for (const fs::path& device : entries(sys / "bus/usb/devices")) {
    const auto vendor = hexadecimal_in(device / "idVendor"), product = hexadecimal_in(device / "idProduct");
    if (!vendor || !product || !is_ours(*vendor, *product)) continue;
    ++seen;
    if (word_in(device / "power/control") != "auto") continue;
    sleepy.insert(device.filename().string());
    cure.append(cure.empty() ? "as root: echo on | tee " : " ").append((device / "power/control").string());
  }
  if (seen == 0) return {"usb", Health::good, "None of our devices is on USB here.", ""};
  if (sleepy.empty()) return {"usb", Health::good, "Our devices on USB are kept awake.", ""};
  std::string says = "The kernel may put a device to sleep that is quiet for a while (";
  says.append(joined(sleepy)).append("): its first report comes late then.");
  return {"usb", Health::fair, std::move(says), std::move(cure)};
}

}  // namespace fulcrum::app
