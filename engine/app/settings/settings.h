#pragma once
// What a person has set for all scenes, kept in $XDG_CONFIG_HOME/fulcrum/settings.json, or
// ~/.config/fulcrum/settings.json (docs/settings.md).

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>

#include "engine/render/quality.h"
#include "engine/ui/look.h"
#include "haptics/math/result.h"

namespace fulcrum::app {

inline constexpr std::array<float, 3> kTextSizes = {1.0F, 1.25F, 1.5F};
inline constexpr std::array<float, 5> kVolumes = {0.0F, 0.25F, 0.5F, 0.75F, 1.0F};

struct Settings {
  ui::Look look;                       // its text is one of kTextSizes
  std::optional<std::size_t> picture;  // of render::kQualityLevels; none: as measured frame times allow
  float volume = 1.0F;                 // one of kVolumes: what is heard, times this

  // Of the picture when a scene begins: where nothing is set, what AutoQuality begins with.
  render::Quality first_quality() const {
    return picture ? render::kQualityLevels[*picture] : render::AutoQuality().quality();
  }
};

// What is not there is as at the first start. What is wrong is, too, each with a sentence on stderr.
Settings read_settings();
// Empty: neither XDG_CONFIG_HOME nor HOME names a folder.
std::filesystem::path settings_file();
// What the file says beyond these is kept. Absent: they are remembered; else why not, which hinders nothing.
std::optional<Error> write_settings(const Settings& settings);

}  // namespace fulcrum::app
