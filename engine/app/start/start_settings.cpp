#include "engine/app/start/start_settings.h"

#include <cerrno>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/files/file_error.h"
#include "engine/files/put_file.h"
#include "engine/files/regular_file.h"
#include "engine/files/user_folders.h"
#include "engine/session/identity.h"

namespace fulcrum::app {
namespace {

constexpr std::uint64_t kMostRead = 1 << 16;

std::string text_of(const nlohmann::json& document, const char* key) {
  const auto found = document.find(key);
  return found != document.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

std::filesystem::path start_file() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "start.json";
}

StartChoice read_start_choice() {
  const std::filesystem::path path = start_file();
  if (path.empty()) return {};
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return {};
  const Result<std::string> bytes = file->first_bytes(kMostRead);
  if (!bytes) return {};
  const nlohmann::json document = nlohmann::json::parse(*bytes, nullptr, false);
  if (!document.is_object()) return {};
  StartChoice choice{text_of(document, "participant"), text_of(document, "device"), false,
                     text_of(document, "scenario")};
  if (session::refuse_pseudonym(choice.participant)) choice.participant.clear();
  const auto left_handed = document.find("left_handed");
  choice.left_handed = left_handed != document.end() && *left_handed == true;
  return choice;
}

std::optional<Error> forget_start_participant(const std::string& participant) {
  StartChoice choice = read_start_choice();
  if (choice.participant != participant) return std::nullopt;
  choice.participant.clear();
  return write_start_choice(choice);
}

std::optional<Error> write_start_choice(const StartChoice& choice) {
  const std::filesystem::path path = start_file();
  if (path.empty()) return Error{"Neither XDG_CONFIG_HOME nor HOME names a folder for it: set one."};
  const nlohmann::ordered_json document = {{"participant", choice.participant},
                                           {"device", choice.device},
                                           {"left_handed", choice.left_handed},
                                           {"scenario", choice.scenario}};
  const std::string text = document.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  if (put_file(path, {std::as_bytes(std::span(text))})) return std::nullopt;
  return kept_file_error("write", path, errno);
}

}  // namespace fulcrum::app
