#pragma once
// Where everything of the start page is, in theme units: the same for drawing and for the pointer. A low or
// narrow picture has less air between things, then less of what is only told, and at last no list.

#include "engine/ui/canvas.h"
#include "engine/ui/start_page.h"

namespace fulcrum::ui {

class StartLayout {
public:
  // The page must outlive it. Of a picture that wide and high.
  StartLayout(const StartPage& page, float width, float height);

  bool is_dense() const { return dense_; }
  float margin() const { return dense_ ? 10.0F : 18.0F; }
  float inset() const { return dense_ ? 14.0F : 24.0F; }
  float title_top() const { return dense_ ? 8.0F : 18.0F; }  // from a card's top

  bool has_list() const { return has_list_; }
  const Area& list() const { return list_; }
  // As many scenarios as there is room for, those about the chosen one.
  std::size_t first() const { return first_; }
  std::size_t end() const { return end_; }
  Area scenario(std::size_t i) const;

  const Area& sheet() const { return sheet_; }
  // There is room for a few lines over the sheet.
  bool has_note_above() const { return note_above_; }
  float about_top() const { return sheet_.at.y + head(); }
  float about_line() const { return dense_ ? 16.0F : 20.0F; }
  std::size_t about_lines() const { return about_lines_; }
  bool has_facts() const { return has_facts_; }
  float facts_top() const { return about_top() + static_cast<float>(about_lines_) * about_line() + 4.0F; }
  // As many settings as there is room for, those about the one in focus.
  std::size_t first_setting() const { return first_setting_; }
  std::size_t end_setting() const { return end_setting_; }
  Area setting(std::size_t i) const;
  Area button(StartPage::Part part) const;
  bool has_help() const { return has_help_; }
  float help_top() const { return sheet_.at.y + sheet_.size.y - (dense_ ? 20.0F : 27.0F); }

private:
  float head() const { return dense_ ? 40.0F : 58.0F; }
  float setting_row() const { return dense_ ? 30.0F : 34.0F; }
  float scenario_row() const { return dense_ ? 32.0F : 40.0F; }
  float list_head() const { return dense_ ? 46.0F : 66.0F; }
  float button_high() const { return dense_ ? 30.0F : 38.0F; }
  float sheet_high() const;
  void fit_sheet(float room);

  const StartPage& page_;
  bool dense_ = false, has_list_ = true, has_facts_ = true, has_help_ = true, note_above_ = false;
  std::size_t about_lines_ = 3;
  std::size_t first_ = 0, end_ = 0, first_setting_ = 0, end_setting_ = 0;
  Area list_, sheet_;
};

}  // namespace fulcrum::ui
