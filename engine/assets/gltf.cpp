#include "engine/assets/gltf.h"

#include <tiny_gltf.h>

#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_model.h"
#include "engine/assets/importable.h"
#include "engine/files/plain_text.h"
#include "engine/files/regular_file.h"

namespace fulcrum {
namespace {

constexpr std::size_t kGlbHeader = 20;  // magic, version, length, and the first chunk's length and type
constexpr std::size_t kDeepest = 200;   // nested brackets
constexpr std::uint64_t kLargest = std::numeric_limits<unsigned>::max();  // bytes, tinygltf's measure

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

// tinygltf reads some values by recursion, as deep as they are nested. How deep that is, the same parser says
// that tinygltf uses, without building anything.
class DepthCheck final : public nlohmann::json_sax<nlohmann::json> {
public:
  bool too_deep() const { return depth_ > kDeepest; }

  bool start_object(std::size_t) override { return enter(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool number_float(double, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(nlohmann::json::binary_t&) override { return true; }
  bool key(std::string&) override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

private:
  bool enter() {
    ++depth_;
    return !too_deep();
  }
  bool leave() {
    --depth_;
    return true;
  }

  std::size_t depth_ = 0;
};

// What is wrong with the text otherwise, tinygltf says.
void check_depth(std::string_view json) {
  DepthCheck check;
  nlohmann::json::sax_parse(json, &check);
  if (check.too_deep()) throw GltfFault("its description is nested absurdly deep; the file is damaged");
}

void check_glb(std::span<const std::byte> bytes) {
  if (bytes.size() < 4 || word(bytes, 0) != 0x46546c67u)  // "glTF"
    throw GltfFault("it is not a binary glTF file; export the model as glTF 2.0 (.glb)");
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

// Images stay as their files have them: only what is drawn is decoded. Those in a buffer are read from there
// once its bounds have been checked, which tinygltf does not do.
bool keep_image(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                int size, void*) {
  if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

// The files that a .gltf names. Without a folder it may name none.
struct Beside {
  struct Unread {
    std::string path, why;
  };
  std::optional<std::filesystem::path> folder;  // all of them lie in it
  std::vector<Unread> unread;                   // those that could not be read, in their order
  std::vector<std::string> named;               // all of them
};

bool read_beside(std::vector<unsigned char>* bytes, std::string*, const std::string& path, void* beside) {
  Beside& files = *static_cast<Beside*>(beside);
  const auto refuse = [&](const std::string& why) {
    files.unread.push_back({path, why});
    return false;
  };
  files.named.push_back(path);
  if (!files.folder) return refuse("there is no folder beside it");
  const Result<RegularFile> file = RegularFile::open_within(*files.folder, path);
  if (!file) return refuse(file.error().sentence);
  const Result<std::string> content = file->first_bytes(kLargest + 1);
  if (!content) return refuse(content.error().sentence);
  if (content->size() > kLargest) return refuse("it is larger than 4 GB");
  if (content->empty()) return refuse("it is empty");
  bytes->assign(content->begin(), content->end());
  return true;
}

tinygltf::FsCallbacks callbacks_for(Beside& beside) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.FileExists = [](const std::string&, void*) { return true; };  // reading says why there is none
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = read_beside;
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  callbacks.user_data = &beside;
  return callbacks;
}

constexpr std::size_t kLongestClause = 300;  // bytes, of what others say

std::string one_line(std::string_view said) {
  std::string text = plain_text(said);
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return short_text(text, kLongestClause);
}

// Why the file of each image could not be read; empty: it was, or the image is in a buffer or a URI. tinygltf
// asks for each such file once, in the order of the images, and goes on where there is none; where there is
// none for a buffer it does not go on.
std::vector<std::string> why_unread(const tinygltf::Model& file, const Beside& beside) {
  std::vector<std::string> why(file.images.size());
  auto unread = beside.unread.begin();
  for (std::size_t i = 0; i < why.size(); ++i) {
    const tinygltf::Image& image = file.images[i];
    if (image.bufferView >= 0 || !image.image.empty()) continue;
    why[i] =
        image.uri.empty() || unread == beside.unread.end() ? "it names no file" : plain_text((unread++)->why);
  }
  return why;
}

// `place`: the folder of the file, where the names begin that it holds.
Model parse(std::string_view text, bool binary, Beside beside, const std::filesystem::path& place) {
  if (text.size() > kLargest) throw GltfFault("it is larger than 4 GB; simplify it");
  const auto size = static_cast<unsigned>(text.size());
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(keep_image, nullptr);
  loader.SetFsCallbacks(callbacks_for(beside));
  tinygltf::Model file;
  std::string fault, warning;
  bool read = false;
  if (binary) {
    check_glb(std::as_bytes(std::span(text)));
    read = loader.LoadBinaryFromMemory(
        &file, &fault, &warning, reinterpret_cast<const unsigned char*>(text.data()), size, place.string());
  } else {
    check_depth(text);
    read = loader.LoadASCIIFromString(&file, &fault, &warning, text.data(), size, place.string());
  }
  check_extensions(file);
  // A picture that is not there stops nothing, and is no reason.
  const bool picture = warning.find("for image[") != std::string::npos;
  if (!read && !beside.unread.empty() && !picture) {
    const Beside::Unread& last = beside.unread.back();
    throw GltfFault("it names the file " + short_text(last.path, kLongestClause) +
                    ", which cannot be read: " + last.why);
  }
  if (!read)
    throw GltfFault("it cannot be read as glTF (" + one_line(fault) +
                    "); export it again as glTF 2.0 (.glb)");
  Model model = model_from_gltf(file, why_unread(file, beside));
  model.beside = std::move(beside.named);
  return model;
}

// tinygltf and the JSON parser below it throw on some damaged files.
Result<Model> parse_guarded(std::string_view text, bool binary, Beside beside,
                            const std::filesystem::path& place, std::string_view name) {
  std::string sentence(name);
  try {
    return parse(text, binary, std::move(beside), place);
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
  return parse_guarded({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, true, {}, {}, name);
}

Result<Model> load_gltf(const std::filesystem::path& folder, const std::filesystem::path& file) {
  const auto unread = [&](const Error& why) {
    return Error{file.string() + ": " + why.sentence +
                 "; name a .glb or .gltf file that can be read, or build the models (the build makes them)."};
  };
  if (is_importable(file))
    return Error{file.string() + ": it is no glTF file: `fulcrum import " + file.filename().string() +
                 "` makes a .glb of it; name that."};
  const Result<RegularFile> opened = RegularFile::open_within(folder, file);
  if (!opened) return unread(opened.error());
  const Result<std::string> content = opened->first_bytes(kLargest + 1);
  if (!content) return unread(content.error());
  return parse_guarded(*content, file.extension() != ".gltf", {folder, {}, {}}, file.parent_path(),
                       file.string());
}

}  // namespace fulcrum
