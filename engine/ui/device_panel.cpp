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
constexpr float kFoot = 16.0F;
constexpr float kBetween = 24.0F;  // columns
constexpr float kName = 100.0F;    // width of an axis's name
constexpr float kValue = 76.0F;    // of its value
constexpr float kBar = 10.0F;      // height
constexpr float kCloseWide = 86.0F, kCloseHigh = 30.0F;
constexpr std::size_t kNoteLines = 6;

// Axes in one column where the picture is high enough, else in two.
struct Layout {
  Area area;
  std::size_t rows;  // of axes

  Area close() const {
    return {{area.at.x + area.size.x - 14.0F - kCloseWide, area.at.y + 12.0F}, {kCloseWide, kCloseHigh}};
  }
};

Layout layout_of(const DevicePanel& panel, float width, float height) {
  const auto height_of = [](std::size_t rows) {
    return kHead + kRow * static_cast<float>(rows + 1) + kLine * static_cast<float>(kNoteLines) + kFoot;
  };
  const float widest = width - 2.0F * theme::kMargin;
  std::size_t rows = panel.axes.size();
  float wide = kWidth;
  if (height_of(rows) > height - 8.0F) {
    rows = (rows + 1) / 2;
    wide = 2.0F * kWidth;
  }
  const ImVec2 size{std::min(wide, widest), height_of(rows)};
  return {{{(width - size.x) / 2.0F, std::max(4.0F, (height - size.y) / 2.0F)}, size}, rows};
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
  std::string notes;
  for (const std::string& note : panel.notes) notes += note + "\n";
  ImFont* const font = canvas.fonts().small;
  for (const std::string& line :
       canvas.lines(font, notes + "Esc, or B on a pad, closes this.", width, kNoteLines)) {
    canvas.text(font, at, theme::kSecondary, line);
    at.y += kLine;
  }
}

}  // namespace

void draw_device_panel(const Canvas& canvas, const DevicePanel& panel) {
  const Layout layout = layout_of(panel, canvas.width(), canvas.height());
  const Area& area = layout.area;
  const Fonts& fonts = canvas.fonts();
  const float width = area.size.x - 2.0F * kInset;
  canvas.card(area.at, area.size, theme::kModal);
  ImVec2 at{area.at.x + kInset, area.at.y + 16.0F};
  const Area close = layout.close();
  ImFont* const title =
      canvas.widest({fonts.number, fonts.strong, fonts.small}, panel.title, close.at.x - at.x - 8.0F);
  canvas.text(title, at, theme::kText, canvas.fitted(title, panel.title, close.at.x - at.x - 8.0F));
  canvas.box(close.at, close.size, theme::kButton, 7.0F);
  canvas.text(fonts.strong, {close.at.x + close.size.x / 2.0F, close.at.y + 6.0F}, theme::kText, "Close",
              Align::centre);
  at.y = area.at.y + kHead;
  const bool two = layout.rows < panel.axes.size();
  const float column = two ? (width - kBetween) / 2.0F : width;
  for (std::size_t i = 0; i < panel.axes.size(); ++i) {
    const std::size_t row = i % layout.rows, which = i / layout.rows;
    draw_axis(canvas,
              {at.x + (column + kBetween) * static_cast<float>(which), at.y + kRow * static_cast<float>(row)},
              column, panel.axes[i]);
  }
  at.y += kRow * static_cast<float>(layout.rows);
  const bool bad = !panel.trouble.empty();
  canvas.text(fonts.body, {at.x, at.y + 4.0F}, bad ? canvas.colours().bad : theme::kText,
              canvas.fitted(fonts.body, bad ? panel.trouble : panel.buttons, width));
  at.y += kRow + 4.0F;
  draw_notes(canvas, at, width, panel);
}

bool closes_device_panel(const DevicePanel& panel, render::Extent picture, const Look& look, double x,
                         double y) {
  const PanelPoint at = panel_point(picture, look, x, y);
  const Area button = layout_of(panel, at.width, at.height).close();
  return at.x >= button.at.x && at.y >= button.at.y && at.x < button.at.x + button.size.x &&
         at.y < button.at.y + button.size.y;
}

}  // namespace fulcrum::ui
