#include "engine/ui/start_layout.h"

#include <algorithm>

namespace fulcrum::ui {
namespace {

using Part = StartPage::Part;

constexpr float kDenseBelow = 560.0F;  // height of a picture
constexpr float kListWide = 310.0F;
constexpr float kListLeast = 225.0F;
constexpr float kSheetMost = 600.0F;
constexpr float kSheetLeast = 230.0F;
constexpr float kBetween = 10.0F;  // buttons
// Parts of the room for buttons that each takes, and how wide they are at the most.
constexpr float kParts[] = {150.0F, 120.0F, 90.0F};
constexpr float kAllParts = 360.0F;

// The first of `most` in a row of `all`, so that one of them is about in the middle.
std::size_t first_about(std::size_t one, std::size_t most, std::size_t all) {
  if (all <= most) return 0;
  const std::size_t middle = most / 2;
  return std::min(one > middle ? one - middle : 0, all - most);
}

}  // namespace

StartLayout::StartLayout(const StartPage& page, float width, float height)
    : page_(page), dense_(height < kDenseBelow), end_setting_(page.settings.size()) {
  const float inside = height - 2.0F * margin();
  const bool beside = width >= kListLeast + kSheetLeast + 3.0F * margin();
  const float list_wide =
      beside ? std::clamp(0.46F * (width - 3.0F * margin()), kListLeast, kListWide) : width - 2.0F * margin();
  const float left = beside ? 2.0F * margin() + list_wide : margin();
  fit_sheet(inside);
  const float high = sheet_high();
  sheet_ = {{left, height - margin() - high}, {std::min(kSheetMost, width - left - margin()), high}};
  list_ = {{margin(), margin()}, {list_wide, beside ? inside : sheet_.at.y - 2.0F * margin()}};
  note_above_ = beside && sheet_.at.y - 2.0F * margin() >= 80.0F;
  const float rows = (list_.size.y - list_head() - 8.0F) / scenario_row();
  has_list_ = rows >= 1.0F;
  const auto most = static_cast<std::size_t>(std::max(1.0F, rows));
  first_ = first_about(page.chosen, most, page.scenarios.size());
  end_ = std::min(page.scenarios.size(), first_ + most);
}

float StartLayout::sheet_high() const {
  const float about = static_cast<float>(about_lines_) * about_line();
  const float facts = has_facts_ ? 24.0F : 0.0F, help = has_help_ ? 22.0F : 0.0F;
  const auto settings = static_cast<float>(end_setting_ - first_setting_);
  return head() + about + facts + 8.0F + settings * setting_row() + 8.0F + button_high() + help +
         (dense_ ? 8.0F : 14.0F);
}

void StartLayout::fit_sheet(float room) {
  if (sheet_high() > room) has_help_ = false;
  while (sheet_high() > room && about_lines_ > 1) --about_lines_;
  if (sheet_high() > room) has_facts_ = false;
  if (sheet_high() > room) about_lines_ = 0;
  if (sheet_high() <= room) return;
  const float over = sheet_high() - room;
  const auto gone = static_cast<std::size_t>(over / setting_row()) + 1;
  const std::size_t all = page_.settings.size(), most = all > gone ? all - gone : 0;
  first_setting_ = first_about(page_.focus == Part::setting ? page_.index : 0, most, all);
  end_setting_ = first_setting_ + most;
}

Area StartLayout::scenario(std::size_t i) const {
  const float y = list_.at.y + list_head() + scenario_row() * static_cast<float>(i - first_);
  return {{list_.at.x + 8.0F, y}, {list_.size.x - 16.0F, scenario_row() - 4.0F}};
}

Area StartLayout::setting(std::size_t i) const {
  const float about = static_cast<float>(about_lines_) * about_line() + (has_facts_ ? 24.0F : 0.0F);
  const float y = about_top() + about + 8.0F + setting_row() * static_cast<float>(i - first_setting_);
  return {{sheet_.at.x + inset() - 10.0F, y}, {sheet_.size.x - 2.0F * inset() + 20.0F, setting_row() - 3.0F}};
}

Area StartLayout::button(Part part) const {
  const std::size_t at = part == Part::start ? 0 : part == Part::settings ? 1 : 2;
  const float room = std::min(kAllParts, sheet_.size.x - 2.0F * inset() - 2.0F * kBetween);
  float left = sheet_.at.x + inset();
  for (std::size_t i = 0; i < at; ++i) left += room * kParts[i] / kAllParts + kBetween;
  const float bottom = sheet_.at.y + sheet_.size.y - (dense_ ? 8.0F : 14.0F) - (has_help_ ? 22.0F : 0.0F);
  return {{left, bottom - button_high()}, {room * kParts[at] / kAllParts, button_high()}};
}

}  // namespace fulcrum::ui
