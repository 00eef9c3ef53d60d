#include "engine/assets/importable.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

namespace fulcrum {

bool is_importable(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array<std::string_view, 7> kKnown{".obj", ".stl", ".ply", ".3ds", ".fbx", ".dae", ".off"};
  return std::ranges::find(kKnown, extension) != kKnown.end();
}

}  // namespace fulcrum
