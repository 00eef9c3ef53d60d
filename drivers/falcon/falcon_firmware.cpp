#include "drivers/falcon/falcon_firmware.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include "engine/files/user_folders.h"
#include "engine/files/regular_file.h"

namespace fulcrum::falcon {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = 256 * 1024;  // all the memory of its processor

Error cannot_be_used(const fs::path& file, const std::string& why) {
  std::string sentence = "its firmware, ";
  sentence.append(file)
      .append(", cannot be used (")
      .append(why)
      .append(
          "): put nvent_firmware.bin of libnifalcon there, or let FULCRUM_FALCON_FIRMWARE name another "
          "file.");
  return Error{std::move(sentence)};
}

Error is_missing(const fs::path& file) {
  std::string sentence =
      "its firmware is needed, which is Novint's and does not come with Fulcrum: copy nvent_firmware.bin, "
      "from the folder firmware of libnifalcon (github.com/libnifalcon/libnifalcon), to ";
  sentence.append(file).append(", or let FULCRUM_FALCON_FIRMWARE name it.");
  return Error{std::move(sentence)};
}

}  // namespace

Result<std::vector<std::uint8_t>> find_firmware() {
  const char* const given = std::getenv("FULCRUM_FALCON_FIRMWARE");
  const bool named = given != nullptr && *given != 0;
  const fs::path folder = config_folder();
  if (!named && folder.empty()) return is_missing("~/.config/fulcrum/falcon_firmware.bin");
  const fs::path path = named ? fs::path(given) : folder / "falcon_firmware.bin";
  std::error_code ignored;
  if (!named && !fs::exists(path, ignored)) return is_missing(path);
  const Result<RegularFile> file = RegularFile::open(path);
  if (!file) return cannot_be_used(path, file.error().sentence);
  const Result<std::string> bytes = file->first_bytes(kMostBytes + 1);
  if (!bytes) return cannot_be_used(path, bytes.error().sentence);
  if (bytes->empty()) return cannot_be_used(path, "it is empty");
  if (bytes->size() > kMostBytes) return cannot_be_used(path, "it is larger than 256 KiB");
  return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
}

}  // namespace fulcrum::falcon
