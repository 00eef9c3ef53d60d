#include "engine/ui/settings_page.h"

#include <algorithm>

#include "engine/ui/cue_panel.h"
#include "engine/ui/menu_widgets.h"
#include "engine/ui/panels.h"
#include "engine/ui/theme.h"

namespace fulcrum::ui {
namespace {

constexpr float kMostWide = 560.0F;
constexpr float kLineHigh = 18.0F;  // of the note
constexpr float kNoteLines = 2.0F;

// Where everything is, in theme units: the same for drawing and for the pointer.
class Layout {
public:
  Layout(const SettingsPage& page, float width, float height)
      : dense_(height < 460.0F), rows_(static_cast<float>(page.rows.size())) {
    const float margin = dense_ ? 10.0F : theme::kMargin;
    const float room = height - 2.0F * margin;
    row_high_ = dense_ ? 29.0F : 38.0F;
    has_note_ = whole() <= room;
    if (whole() > room) row_high_ = std::max(18.0F, row_high_ - (whole() - room) / rows_);
    const ImVec2 size{std::min(kMostWide, width - 2.0F * margin), whole()};
    card_ = {{(width - size.x) / 2.0F, (height - size.y) / 2.0F}, size};
  }

  const Area& card() const { return card_; }
  float inset() const { return dense_ ? 16.0F : 26.0F; }
  float title_top() const { return card_.at.y + (dense_ ? 10.0F : 18.0F); }
  bool has_note() const { return has_note_; }
  float note_top() const { return card_.at.y + head() + rows_ * row_high_ + 6.0F; }

  Area row(std::size_t i) const {
    return {{card_.at.x + inset() - 8.0F, card_.at.y + head() + row_high_ * static_cast<float>(i)},
            {card_.size.x - 2.0F * inset() + 16.0F, row_high_ - 3.0F}};
  }
  Area button() const {
    const float high = button_high();
    return {{card_.at.x + inset(), card_.at.y + card_.size.y - high - foot()}, {110.0F, high}};
  }

private:
  float head() const { return dense_ ? 42.0F : 62.0F; }
  float foot() const { return dense_ ? 10.0F : 18.0F; }
  float button_high() const { return dense_ ? 30.0F : 38.0F; }
  float whole() const {
    const float note = has_note_ ? kNoteLines * kLineHigh + 6.0F : 0.0F;
    return head() + rows_ * row_high_ + note + 8.0F + button_high() + foot();
  }

  bool dense_;
  bool has_note_ = true;
  float rows_;
  float row_high_ = 0.0F;
  Area card_;
};

}  // namespace

void draw_settings(const Canvas& canvas, const SettingsPage& page) {
  const Layout layout(page, canvas.width(), canvas.height());
  const Fonts& fonts = canvas.fonts();
  const auto [at, size] = layout.card();
  const float left = at.x + layout.inset(), width = size.x - 2.0F * layout.inset();
  canvas.card(at, size, theme::kModal);
  canvas.text(fonts.number, {left, layout.title_top()}, theme::kText, "Settings");
  for (std::size_t i = 0; i < page.rows.size(); ++i)
    draw_menu_row(canvas, layout.row(i), page.rows[i], page.focus == i);
  if (layout.has_note()) {
    float y = layout.note_top();
    for (const std::string& line : canvas.lines(fonts.small, page.note, width, 2)) {
      canvas.text(fonts.small, {left, y}, theme::kSecondary, line);
      y += kLineHigh;
    }
  }
  const Area button = layout.button();
  draw_menu_button(canvas, button, "Back", page.focus >= page.rows.size(), true);
  const float help = button.at.x + button.size.x + 16.0F;
  if (canvas.measure(fonts.small, page.help).x <= left + width - help)  // half of it would be of no help
    canvas.text(fonts.small, {help, button.at.y + button.size.y / 2.0F - 8.0F}, theme::kFaint, page.help);
}

std::optional<SettingsHit> settings_hit(const SettingsPage& page, render::Extent picture, const Look& look,
                                        double x, double y) {
  const PanelPoint at = panel_point(picture, look, x, y);
  const Layout layout(page, at.width, at.height);
  const ImVec2 point{at.x, at.y};
  for (std::size_t i = 0; i < page.rows.size(); ++i)
    if (holds(layout.row(i), point)) return SettingsHit{i, side_of(layout.row(i), point)};
  if (holds(layout.button(), point)) return SettingsHit{page.rows.size(), 0};
  return std::nullopt;
}

}  // namespace fulcrum::ui
