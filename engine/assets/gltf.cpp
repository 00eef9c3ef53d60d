#include "engine/assets/gltf.h"

#include <tiny_gltf.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_model.h"

namespace fulcrum {
namespace {

constexpr std::size_t kGlbHeader = 20;  // magic, version, length, and the first chunk's length and type
constexpr std::size_t kDeepest = 200;   // nested brackets; tinygltf reads "extras" by recursion

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

void check_depth(std::string_view json) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (in_string) {
      if (json[i] == '\\') ++i;
      if (i < json.size() && json[i] == '"') in_string = json[i - 1] == '\\';
      continue;
    }
    if (json[i] == '"') in_string = true;
    if (json[i] == '[' || json[i] == '{') ++depth;
    if ((json[i] == ']' || json[i] == '}') && depth > 0) --depth;
    if (depth > kDeepest) throw GltfFault("its description is nested absurdly deep; the file is damaged");
  }
}

void check_glb(std::span<const std::byte> bytes) {
  if (bytes.size() < 4 || word(bytes, 0) != 0x46546c67u) {  // "glTF"
    throw GltfFault("it is not a binary glTF file; export the model as glTF 2.0 (.glb)");
  }
  if (bytes.size() < kGlbHeader) throw GltfFault("it ends within its header; copy or export it again");
  if (word(bytes, 4) != 2)
    throw GltfFault("it is not of glTF version 2; export the model as glTF 2.0 (.glb)");
  if (word(bytes, 8) > bytes.size()) {
    throw GltfFault("it is truncated: " + std::to_string(bytes.size()) + " of " +
                    std::to_string(word(bytes, 8)) + " bytes are there; copy or export it again");
  }
  const std::size_t json_bytes = word(bytes, 12);
  if (json_bytes > bytes.size() - kGlbHeader)
    throw GltfFault("its description is cut off; copy or export it again");
  check_depth({reinterpret_cast<const char*>(bytes.data()) + kGlbHeader, json_bytes});
}

void check_extensions(const tinygltf::Model& file) {
  for (const std::string& extension : file.extensionsRequired) {
    const bool compressed = extension == "KHR_draco_mesh_compression" ||
                            extension == "EXT_meshopt_compression" || extension == "KHR_mesh_quantization";
    if (compressed) {
      throw GltfFault("it needs " + extension +
                      ", which is not supported; export it without mesh compression");
    }
  }
}

// Textures are left out, so images are not decoded.
bool skip_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                void*) {
  return true;
}

// Bytes that come without a folder have no files beside them.
tinygltf::FsCallbacks no_files() {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string&, void*) { return false; };
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>*, std::string* error, const std::string&, void*) {
    *error = "no file beside it";
    return false;
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  return callbacks;
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text.substr(0, 300);
}

// folder: where the files lie that the file names; none if it may not name any.
Model parse(std::span<const std::byte> bytes, bool binary,
            const std::optional<std::filesystem::path>& folder) {
  if (bytes.size() > std::numeric_limits<unsigned>::max())
    throw GltfFault("it is larger than 4 GB; simplify it");
  const auto size = static_cast<unsigned>(bytes.size());
  const auto* text = reinterpret_cast<const char*>(bytes.data());
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(skip_image, nullptr);
  if (!folder) loader.SetFsCallbacks(no_files());
  const std::string base = folder ? folder->string() : std::string();
  tinygltf::Model file;
  std::string fault, warning;
  bool read = false;
  if (binary) {
    check_glb(bytes);
    read = loader.LoadBinaryFromMemory(&file, &fault, &warning, reinterpret_cast<const unsigned char*>(text),
                                       size, base);
  } else {
    check_depth({text, size});
    read = loader.LoadASCIIFromString(&file, &fault, &warning, text, size, base);
  }
  check_extensions(file);
  if (!read)
    throw GltfFault("it cannot be read as glTF (" + one_line(fault) +
                    "); export it again as glTF 2.0 (.glb)");
  return model_from_gltf(file);
}

// tinygltf and the JSON parser below it throw on some damaged files.
Result<Model> parse_guarded(std::span<const std::byte> bytes, bool binary,
                            const std::optional<std::filesystem::path>& folder, std::string_view name) {
  std::string sentence(name);
  try {
    return parse(bytes, binary, folder);
  } catch (const GltfFault& fault) {
    sentence.append(": ").append(fault.what()).append(".");
  } catch (const std::exception& fault) {
    sentence.append(": it is damaged (")
        .append(one_line(fault.what()))
        .append("); export it again as glTF 2.0 (.glb).");
  }
  return Error{std::move(sentence)};
}

}  // namespace

Result<Model> parse_glb(std::span<const std::byte> bytes, std::string_view name) {
  return parse_guarded(bytes, true, std::nullopt, name);
}

Result<Model> load_gltf(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return Error{name +
                 ": there is no such file; check the path, or build the models (the build generates them)."};
  }
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return Error{name + ": it is a folder or a device, not a file; name a .glb or .gltf file."};
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<char> content;
  if (file) {
    content.resize(static_cast<std::size_t>(file.tellg()));
    file.seekg(0);
    file.read(content.data(), static_cast<std::streamsize>(content.size()));
  }
  if (!file) {
    return Error{name + ": it cannot be read (" + std::strerror(errno) + "); check its permissions."};
  }
  return parse_guarded(std::as_bytes(std::span(content)), path.extension() != ".gltf", path.parent_path(),
                       name);
}

}  // namespace fulcrum
