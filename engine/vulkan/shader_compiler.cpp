#include "engine/vulkan/shader_compiler.h"

#include <glslang/Include/ResourceLimits.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

namespace fulcrum::vulkan {
namespace {

std::optional<std::string> text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

class Includer : public glslang::TShader::Includer {
public:
  explicit Includer(std::filesystem::path folder) : folder_(std::move(folder)) {}

  IncludeResult* includeLocal(const char* name, const char* from, std::size_t) override {
    for (const std::filesystem::path& folder : {std::filesystem::path(from).parent_path(), folder_}) {
      const std::filesystem::path file = folder / name;
      if (const std::optional<std::string> text = text_of(file)) {
        auto* kept = new std::string(*text);
        return new IncludeResult(file.string(), kept->data(), kept->size(), kept);
      }
    }
    return nullptr;
  }

  void releaseInclude(IncludeResult* result) override {
    if (result != nullptr) {
      delete static_cast<std::string*>(result->userData);
      delete result;
    }
  }

private:
  std::filesystem::path folder_;
};

// glslang keeps tables for the whole process.
struct Process {
  Process() { glslang::InitializeProcess(); }
  ~Process() { glslang::FinalizeProcess(); }
};

}  // namespace

Result<std::vector<std::uint32_t>> compile_shader(const std::filesystem::path& file) {
  static const Process process;
  const std::optional<std::string> text = text_of(file);
  if (!text) return Error{"The shader " + file.string() + " cannot be read; does the file exist?"};
  const EShLanguage stage = file.extension() == ".vert" ? EShLangVertex : EShLangFragment;
  glslang::TShader shader(stage);
  const std::string name = file.string();
  const char* source = text->c_str();
  const int length = static_cast<int>(text->size());
  const char* label = name.c_str();
  shader.setStringsWithLengthsAndNames(&source, &length, &label, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
  const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  Includer includer(file.parent_path());
  if (!shader.parse(GetDefaultResources(), 460, false, messages, includer))
    return Error{"The shader " + name + " does not compile:\n" + shader.getInfoLog()};
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages))
    return Error{"The shader " + name + " does not link:\n" + program.getInfoLog()};
  std::vector<std::uint32_t> code;
  glslang::GlslangToSpv(*program.getIntermediate(stage), code);
  return code;
}

}  // namespace fulcrum::vulkan
