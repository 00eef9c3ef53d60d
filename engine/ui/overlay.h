#pragma once
// Gauges and text over the picture, drawn with Dear ImGui; the same in a window and in a file.

#include <memory>
#include <optional>

#include "engine/render/overlay_pass.h"
#include "engine/render/plan.h"
#include "engine/ui/overlay_state.h"
#include "engine/vulkan/device.h"

namespace fulcrum::ui {

struct PixelArea {
  std::uint32_t x = 0, y = 0;           // pixels, of its top left corner in the picture
  std::uint32_t width = 0, height = 0;  // pixels
};

class Overlay : public render::OverlayPass {
public:
  // The device must outlive the overlay. Where the font is not installed, ImGui's own is used, and
  // font_note() says so.
  static vulkan::Result<std::unique_ptr<Overlay>> create(vulkan::Device& device);
  ~Overlay() override;

  // Lays out what the next frame shows, for a picture of that size; text grows with its height.
  std::optional<vulkan::Error> prepare(const OverlayState& state, render::Extent picture);

  // Of the list of keys, as it was prepared last; 0: it was not visible.
  std::size_t keys_pages() const;
  // Where the prepared state has room for its second view; none: nowhere, or it has none.
  const std::optional<PixelArea>& second_view() const;

  // Empty, or one line to print: that the font is missing, and how to install it.
  const std::string& font_note() const;

  void record(VkCommandBuffer commands, const render::OverlayTarget& target) override;

private:
  class Implementation;
  explicit Overlay(std::unique_ptr<Implementation> implementation);

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fulcrum::ui
