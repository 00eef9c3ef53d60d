#include "engine/app/settings/settings.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "engine/app/cli/terminal.h"
#include "engine/files/file_error.h"
#include "engine/files/put_file.h"
#include "engine/files/regular_file.h"
#include "engine/files/user_folders.h"
#include "engine/scenario/words.h"

namespace fulcrum::app {
namespace {

using SettingsJson = nlohmann::ordered_json;

// So few bytes cannot nest deeper than the stack allows.
constexpr std::uint64_t kMostSettings = 1 << 12;

constexpr std::string_view kTextKey = "text_size", kPaletteKey = "palette", kPictureKey = "picture",
                           kVolumeKey = "volume";
constexpr std::array<std::string_view, 4> kSettingKeys = {kTextKey, kPaletteKey, kPictureKey, kVolumeKey};
constexpr std::array<std::string_view, 2> kPaletteWords = {"standard",
                                                           "colour_blind"};  // as of ui::PaletteName
constexpr std::string_view kAutomaticPicture = "automatic";
constexpr std::array<std::string_view, render::kQualityLevels.size() + 1> kPictureNames = {
    kAutomaticPicture, "best", "high", "medium", "low", "lowest"};

// An object, empty where there is no file. Errors: clauses.
Result<SettingsJson> read_settings_document(const std::filesystem::path& path) {
  std::error_code unknown;
  if (path.empty() || !std::filesystem::exists(path, unknown)) return SettingsJson::object();
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return file.error();
  const Result<std::string> bytes = file->first_bytes(kMostSettings + 1);
  if (!bytes) return bytes.error();
  if (bytes->size() > kMostSettings)
    return Error{"it has more than " + std::to_string(kMostSettings) + " bytes"};
  try {
    SettingsJson document = SettingsJson::parse(*bytes);
    if (document.is_object()) return document;
    return Error{"it is no JSON object in {}"};
  } catch (const SettingsJson::parse_error& fault) {
    const std::size_t before = std::min(fault.byte > 0 ? fault.byte - 1 : 0, bytes->size());
    const auto line = 1 + std::ranges::count(std::string_view(*bytes).substr(0, before), '\n');
    return Error{"line " + std::to_string(line) + " is no JSON"};
  } catch (const SettingsJson::exception&) {
    return Error{"it has a number that is too large"};
  }
}

// What cannot be read is somebody's all the same: it is kept beside what replaces it, and so is what was kept
// before. Absent: it is; else why it cannot be.
std::optional<Error> set_aside(const std::filesystem::path& path) {
  const std::string name = path.string() + ".unread";
  std::filesystem::path kept = name;
  std::error_code failed;
  for (int count = 2; std::filesystem::exists(std::filesystem::symlink_status(kept, failed)); ++count)
    kept = name + "-" + std::to_string(count);
  std::filesystem::rename(path, kept, failed);
  if (failed) return kept_file_error("move away", path, failed.value());
  complain(path.string() + " could not be read: it is kept as " + kept.string() +
           ", and a new one is written.");
  return std::nullopt;
}

// Reads fields of a document, and says what it cannot use.
class SettingsFields {
public:
  SettingsFields(const std::filesystem::path& path, const SettingsJson& document)
      : path_(path), document_(document) {
    for (const auto& [key, value] : document.items()) {
      if (std::ranges::find(kSettingKeys, key) != kSettingKeys.end()) continue;
      ignore(key, "there is no such setting" + scenario::did_you_mean(key, kSettingKeys, "it may go."));
    }
  }

  // The index of what it names; none: it is not there, or named none, which is told of.
  std::optional<std::size_t> word(std::string_view key, std::span<const std::string_view> words) const {
    const auto found = document_.find(key);
    if (found == document_.end()) return std::nullopt;
    if (found->is_string()) {
      const auto named = std::ranges::find(words, found->get_ref<const std::string&>());
      if (named != words.end()) return static_cast<std::size_t>(named - words.begin());
    }
    ignore(key, "it has to be one of " + scenario::joined(words) + ".");
    return std::nullopt;
  }

  // The nearest of the values; none: it is not there, or not between the first and the last, which is told
  // of.
  std::optional<float> size(std::string_view key, std::span<const float> values) const {
    const auto found = document_.find(key);
    if (found == document_.end()) return std::nullopt;
    if (found->is_number()) {
      const auto given = found->get<double>();
      if (given >= values.front() && given <= values.back())
        return *std::ranges::min_element(
            values, {}, [&](float value) { return std::abs(static_cast<double>(value) - given); });
    }
    char range[64];
    std::snprintf(range, sizeof range, "it has to be a number from %g to %g.",
                  static_cast<double>(values.front()), static_cast<double>(values.back()));
    ignore(key, range);
    return std::nullopt;
  }

private:
  void ignore(std::string_view key, const std::string& why) const {
    complain(path_.string() + ": '" + std::string(key) + "' is left out: " + why);
  }

  const std::filesystem::path& path_;
  const SettingsJson& document_;
};

}  // namespace

std::filesystem::path settings_file() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "settings.json";
}

Settings read_settings() {
  const std::filesystem::path path = settings_file();
  const Result<SettingsJson> document = read_settings_document(path);
  if (!document) {
    complain(path.string() + ": " + document.error().sentence +
             ", so that the settings are as at the first start: mend it, or remove it.");
    return {};
  }
  const SettingsFields fields(path, *document);
  Settings settings;
  settings.look.text = fields.size(kTextKey, kTextSizes).value_or(settings.look.text);
  if (const auto palette = fields.word(kPaletteKey, kPaletteWords))
    settings.look.palette = static_cast<ui::PaletteName>(*palette);
  if (const auto picture = fields.word(kPictureKey, kPictureNames); picture && *picture > 0)
    settings.picture = *picture - 1;
  settings.volume = fields.size(kVolumeKey, kVolumes).value_or(settings.volume);
  return settings;
}

std::optional<Error> write_settings(const Settings& settings) {
  const std::filesystem::path path = settings_file();
  if (path.empty()) return Error{"Neither XDG_CONFIG_HOME nor HOME names a folder for them: set one."};
  const Result<SettingsJson> before = read_settings_document(path);
  if (!before)
    if (std::optional<Error> failure = set_aside(path)) return failure;
  SettingsJson document = before ? *before : SettingsJson::object();
  document[std::string(kTextKey)] = settings.look.text;
  document[std::string(kPaletteKey)] = kPaletteWords[static_cast<std::size_t>(settings.look.palette)];
  document[std::string(kPictureKey)] = kPictureNames[settings.picture ? *settings.picture + 1 : 0];
  document[std::string(kVolumeKey)] = settings.volume;
  const std::string text = document.dump(1, ' ', false, SettingsJson::error_handler_t::replace) + '\n';
  if (put_file(path, {std::as_bytes(std::span(text))})) return std::nullopt;
  return kept_file_error("write", path, errno);
}

}  // namespace fulcrum::app
