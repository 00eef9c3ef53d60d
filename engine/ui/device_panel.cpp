#include "engine/ui/device_panel.h"

#include <algorithm>
#include <cmath>

#include "engine/ui/cue_panel.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kWidth = 460.0F;
constexpr float kInset = 24.0F;
constexpr float kHead = 54.0F;
constexpr float kRow = 26.0F;
constexpr float kLine = 19.0F;
constexpr float kName = 100.0F;   // width of an axis's name
constexpr float kValue = 76.0F;   // of its value
constexpr float kBar = 10.0F;     // height
constexpr float kButton = 34.0F;  // of the button that closes
constexpr std::size_t kNoteLines = 5;

float height_of(const DevicePanel& panel) {
  return kHead + kRow * static_cast<float>(panel.axes.size() + 1) + kLine * static_cast<float>(kNoteLines) +
         kButton + 34.0F;
}

Area area_of(const DevicePanel& panel, float width, float height) {
  const ImVec2 size{std::min(kWidth, width - 2.0F * theme::kMargin), height_of(panel)};
  return {{(width - size.x) / 2.0F, std::max(4.0F, (height - size.y) / 2.0F)}, size};
}

Area button_of(const Area& panel) {
  return {{panel.at.x + kInset, panel.at.y + panel.size.y - kButton - 14.0F}, {110.0F, kButton}};
}

void draw_axis(const Canvas& canvas, ImVec2 at, float width, const DevicePanel::Axis& axis) {
  const Fonts& fonts = canvas.fonts();
  const float middle_y = at.y + kRow / 2.0F;
  const float half_text = canvas.measure(fonts.body, "A").y / 2.0F;
  canvas.disc({at.x + 4.0F, middle_y}, 4.0F, axis.moved ? canvas.colours().good : theme::kTrack);
  canvas.text(fonts.body, {at.x + 16.0F, middle_y - half_text}, axis.moved ? theme::kText : theme::kSecondary,
              axis.name);
  const float left = at.x + kName, bar = width - kName - kValue;
  const float zero = left + bar / 2.0F;
  canvas.box({left, middle_y - kBar / 2.0F}, {bar, kBar}, theme::kTrack, 3.0F);
  const float way = bar / 2.0F * static_cast<float>(std::clamp(axis.part, -1.0, 1.0));
  if (std::abs(way) >= 0.5F)
    canvas.box({zero + std::min(way, 0.0F), middle_y - kBar / 2.0F}, {std::abs(way), kBar},
               canvas.colours().accent, 0.0F);
  canvas.line({zero, middle_y - 9.0F}, {zero, middle_y + 9.0F}, theme::kFaint, 1.0F);
  canvas.text(fonts.small, {at.x + width, middle_y - half_text + 1.0F}, theme::kSecondary, axis.value,
              Align::right);
}

void draw_notes(const Canvas& canvas, ImVec2 at, float width, const DevicePanel& panel) {
  std::vector<std::string> lines;
  for (const std::string& note : panel.notes) {
    const std::vector<std::string> more = canvas.wrapped(canvas.fonts().small, note, width);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  if (lines.size() > kNoteLines) lines.resize(kNoteLines);
  for (const std::string& line : lines) {
    canvas.text(canvas.fonts().small, at, theme::kSecondary, line);
    at.y += kLine;
  }
}

}  // namespace

void draw_device_panel(const Canvas& canvas, const DevicePanel& panel) {
  const Area area = area_of(panel, canvas.width(), canvas.height());
  const Fonts& fonts = canvas.fonts();
  const float width = area.size.x - 2.0F * kInset;
  canvas.box(area.at, area.size, theme::kModal, theme::kRounding);
  canvas.frame(area.at, area.size, theme::kCardEdge, theme::kRounding, 1.0F);
  ImVec2 at{area.at.x + kInset, area.at.y + 16.0F};
  canvas.text(fonts.number, at, theme::kText, canvas.fitted(fonts.number, panel.title, width));
  at.y = area.at.y + kHead;
  for (const DevicePanel::Axis& axis : panel.axes) {
    draw_axis(canvas, at, width, axis);
    at.y += kRow;
  }
  const bool bad = !panel.trouble.empty();
  canvas.text(fonts.body, {at.x, at.y + 4.0F}, bad ? canvas.colours().bad : theme::kText,
              canvas.fitted(fonts.body, bad ? panel.trouble : panel.buttons, width));
  at.y += kRow + 4.0F;
  draw_notes(canvas, at, width, panel);
  const Area button = button_of(area);
  canvas.box(button.at, button.size, theme::kButton, 7.0F);
  canvas.text(fonts.strong, {button.at.x + button.size.x / 2.0F, button.at.y + 8.0F}, theme::kText, "Close",
              Align::centre);
  canvas.text(fonts.small, {button.at.x + button.size.x + 14.0F, button.at.y + 10.0F}, theme::kFaint,
              "Esc, or B on a pad, closes this");
}

bool closes_device_panel(const DevicePanel& panel, render::Extent picture, const Look& look, double x,
                         double y) {
  const PanelPoint at = panel_point(picture, look, x, y);
  const Area button = button_of(area_of(panel, at.width, at.height));
  return at.x >= button.at.x && at.y >= button.at.y && at.x < button.at.x + button.size.x &&
         at.y < button.at.y + button.size.y;
}

}  // namespace fulcrum::ui
