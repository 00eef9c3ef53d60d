#include "engine/assets/bake_cache.h"

#include <cstdlib>
#include <cstring>
#include <future>
#include <optional>
#include <span>
#include <vector>

#include "engine/assets/baked_bytes.h"
#include "engine/assets/mapped_file.h"
#include "engine/assets/sha256.h"
#include "engine/files/put_file.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;

fs::path default_folder() {
  const auto from = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value != nullptr ? value : "");
  };
  // XDG base directory specification: a relative path is to be ignored.
  if (const fs::path cache = from("XDG_CACHE_HOME"); cache.is_absolute()) return cache / "fulcrum";
  if (const fs::path home = from("HOME"); home.is_absolute()) return home / ".cache" / "fulcrum";
  return {};
}

template <class T>
void hash_value(Sha256& hasher, const T& value) {
  hasher.update(std::as_bytes(std::span(&value, 1)));
}

Sha256 hash_of(const Solid& solid, std::string_view kind) {
  Sha256 hasher;
  hasher.update(kBakeFormat);
  hasher.update(kind);
  hash_value(hasher, solid.mesh.vertices.size());
  for (const Vec3& p : solid.mesh.vertices) hasher.update(std::as_bytes(std::span(p.data(), 3)));
  hasher.update(std::as_bytes(std::span(solid.mesh.triangles)));
  return hasher;
}

// A file is its content's SHA-256 as 64 digits, then the content.
enum class Found { nothing, damaged, whole };

template <class T>
struct Read {
  Found found = Found::nothing;
  std::optional<T> value;  // where whole
};

// Other processes only ever put a whole file in its place, so what is mapped does not change.
template <class T, class Parse>
Read<T> read_checked(const fs::path& path, const Parse& parse) {
  constexpr std::size_t checksum_size = 64;
  const std::optional<MappedFile> file = MappedFile::open(path);
  if (!file) return {};
  if (file->bytes().size() < checksum_size) return {Found::damaged, std::nullopt};
  const auto content = file->bytes().subspan(checksum_size);
  // Summing takes longer than parsing, which trusts nothing anyway: side by side.
  std::future<std::string> sum = std::async([content] { return sha256_hex(content); });
  std::optional<T> value = parse(content);
  const bool good = std::memcmp(sum.get().data(), file->bytes().data(), checksum_size) == 0;
  return {good && value ? Found::whole : Found::damaged, std::move(value)};
}

bool write_checked(const fs::path& path, std::span<const std::byte> content) {
  const std::string sum = sha256_hex(content);
  return put_file(path, {std::as_bytes(std::span(sum)), content});
}

std::vector<std::byte> to_bytes(const std::vector<std::byte>& bytes) {
  return bytes;
}

template <class T, class Parse, class Bake>
Result<Baked<T>> load_or_bake(const fs::path& folder, const std::string& name, const Parse& parse,
                              const Bake& bake) {
  const fs::path path = folder / name;
  std::string note;
  if (!folder.empty()) {
    Read<T> read = read_checked<T>(path, parse);
    if (read.found == Found::whole) return Baked<T>{std::move(*read.value), true, ""};
    if (read.found == Found::damaged)
      note = "the cached bake " + path.string() + " was damaged and has been made anew.";
  }
  Result<T> made = bake();
  if (!made) return made.error();
  if (!folder.empty() && !write_checked(path, to_bytes(*made))) {
    note = "the bake could not be kept in " + folder.string() +
           " and will be made anew next time: make that folder writable, or set XDG_CACHE_HOME.";
  }
  return Baked<T>{std::move(*made), false, std::move(note)};
}

std::string shell_name(const Solid& solid, const char* kind, const PointshellDesc& desc) {
  Sha256 hasher = hash_of(solid, kind);
  hash_value(hasher, desc.spacing_m);
  hash_value(hasher, desc.sharp_angle_rad);
  hash_value(hasher, desc.deviation);
  hash_value(hasher, desc.seed);
  return hasher.finish_hex() + ".shell";
}

}  // namespace

BakeCache::BakeCache() : folder_(default_folder()) {}
BakeCache::BakeCache(fs::path folder) : folder_(std::move(folder)) {}

Result<Baked<DistanceField>> BakeCache::field(const Solid& solid, const FieldDesc& desc,
                                              const Progress& progress) const {
  Sha256 hasher = hash_of(solid, "field");
  for (const double length :
       {desc.voxel_m.value_or(0.0), desc.band_m.value_or(0.0), desc.voxel_m ? 0.0 : desc.error_m})
    hash_value(hasher, length);
  hash_value(hasher, desc.format);
  return load_or_bake<DistanceField>(folder_, hasher.finish_hex() + ".field", field_from_bytes,
                                     [&] { return bake_field(solid, desc, progress); });
}

Result<Baked<Pointshell>> BakeCache::pointshell(const Solid& solid, const PointshellDesc& desc) const {
  return load_or_bake<Pointshell>(
      folder_, shell_name(solid, "pointshell", desc), pointshell_from_bytes,
      [&] { return bake_pointshell(solid, desc); });
}

Result<Baked<Pointshell>> BakeCache::edges(const Solid& solid, const PointshellDesc& desc) const {
  return load_or_bake<Pointshell>(
      folder_, shell_name(solid, "edges", desc), pointshell_from_bytes,
      [&] { return bake_edges(solid, desc); });
}

Baked<std::vector<std::byte>> BakeCache::bytes(
    const std::string& name, const std::function<bool(std::span<const std::byte>)>& is_whole,
    const std::function<std::vector<std::byte>()>& make) const {
  using Bytes = std::vector<std::byte>;
  const auto parse = [&](std::span<const std::byte> content) {
    return is_whole(content) ? std::optional<Bytes>(std::in_place, content.begin(), content.end())
                             : std::nullopt;
  };
  return *load_or_bake<Bytes>(folder_, name, parse, [&] { return Result<Bytes>(make()); });
}

}  // namespace fulcrum
