#include "engine/ui/fonts.h"

#include <cmath>
#include <filesystem>

namespace fulcrum::ui {
namespace {

constexpr const char* kFolder = "/usr/share/fonts/truetype/dejavu/";  // of fonts-dejavu-core

ImFont* load(const char* file, float size, bool installed) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  config.SizePixels = std::round(size);
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = true;
  return installed
             ? atlas.AddFontFromFileTTF((std::string(kFolder) + file).c_str(), config.SizePixels, &config)
             : atlas.AddFontDefault(&config);
}

}  // namespace

Fonts load_fonts(float scale, std::string& note) {
  ImGui::GetIO().Fonts->Clear();
  const bool installed = std::filesystem::exists(std::string(kFolder) + "DejaVuSans.ttf") &&
                         std::filesystem::exists(std::string(kFolder) + "DejaVuSans-Bold.ttf");
  note = installed ? "" : "The overlay uses a plain font: apt install fonts-dejavu-core for a better one.";
  return {
      load("DejaVuSans.ttf", 12.0F * scale, installed),
      load("DejaVuSans.ttf", 14.0F * scale, installed),
      load("DejaVuSans-Bold.ttf", 14.0F * scale, installed),
      load("DejaVuSans-Bold.ttf", 24.0F * scale, installed),
      load("DejaVuSans-Bold.ttf", 42.0F * scale, installed),
  };
}

}  // namespace fulcrum::ui
