#include "engine/ui/columns.h"

#include <algorithm>

#include "engine/ui/panels.h"

namespace fulcrum::ui {
namespace {

constexpr float kTwoColumns = 490.0F;   // width of a picture that has room for panels at both sides
constexpr float kLeastBeside = 480.0F;  // width of a timeline beside the gauges
constexpr float kLowDebrief = 600.0F;   // height of a picture in which every line counts
constexpr float kBand = 118.0F;
constexpr float kSlimBand = 44.0F;

// A card in the middle, that takes all keys and presses.
bool has_card(const OverlayState& state) {
  return state.keys_visible || state.debrief.has_value();
}

Area band_of(const OverlayState& state, float width, float height) {
  if (state.force != Force::stopped) return {};
  // Above the list of the keys, which has been asked for.
  if (state.keys_visible) return {{-4.0F, -4.0F}, {width + 8.0F, kSlimBand + 4.0F}};
  const float top = std::max(0.0F, 0.30F * height - kBand / 2.0F);
  return {{-4.0F, top}, {width + 8.0F, kBand}};
}

// What of the right column is there, and how slim.
struct Right {
  bool motors, cues, holding, hints, slim;
};

// From the best that may be to the least.
constexpr Right kRights[] = {{true, true, true, true, false},    {true, true, true, true, true},
                             {true, true, true, false, true},    {false, true, true, true, false},
                             {false, true, true, true, true},    {false, true, true, false, true},
                             {false, false, true, true, false},  {false, false, true, false, false},
                             {false, true, false, true, true},   {false, true, false, false, true},
                             {false, false, false, true, false}, {false, false, false, false, false}};

// Lays the right column out; false: it does not fit above `bottom`.
bool lay_right(Columns& to, const OverlayState& state, const Right& right, float width, float margin,
               float bottom) {
  const float left = width - margin - kColumn;
  float y = margin;
  const auto put = [&](float high) -> Area {
    if (!(high > 0.0F)) return {};
    const Area area{{left, y}, {kColumn, high}};
    y += high + kPanelGap;
    return area;
  };
  to.hints = right.hints;
  to.slim_cues = right.slim;
  to.health = put(health_height(state, right.hints));
  to.cues = put(right.cues ? cues_height(state, right.slim) : 0.0F);
  to.holding = put(right.holding ? holding_height(state) : 0.0F);
  const float motors = right.motors ? motors_height(state) : 0.0F;
  to.motors = motors > 0.0F ? Area{{left, bottom - motors}, {kColumn, motors}} : Area{};
  return y - kPanelGap <= (motors > 0.0F ? to.motors.at.y - kPanelGap : bottom);
}

void lay_bottom(Columns& to, const OverlayState& state, float width, float height) {
  const float margin = margin_of(height);
  const float column = width >= kTwoColumns ? kColumn + margin : 0.0F;
  const float dials = dials_width(state, width - 2.0F * margin - column);
  float bottom = height - margin;
  if (state.timeline) {
    to.slim_timeline = state.debrief && height < kLowDebrief;
    const float high = timeline_panel_height(state, height, to.slim_timeline);
    const float motors = motors_height(state) > 0.0F && !has_card(state) ? kColumn + margin : 0.0F;
    const float left = margin + (dials > 0.0F ? dials + margin : 0.0F), right = width - margin - motors;
    const bool beside = right - left >= kLeastBeside && !state.debrief;
    to.timeline = beside ? Area{{left, bottom - high}, {right - left, high}}
                         : Area{{margin, bottom - high}, {width - 2.0F * margin, high}};
    if (!beside) bottom -= high + kPanelGap;
  }
  if (!(dials > 0.0F)) return;
  const float list = checkpoints_height(state, state.checkpoints.size());
  to.slim_dials = margin + list + kPanelGap + dials_height(false) > bottom;
  const float high = dials_height(to.slim_dials);
  const float one_row = state.checkpoints.empty() ? 0.0F : checkpoints_height(state, 1) + kPanelGap;
  if (margin + one_row + high <= bottom) to.dials = {{margin, bottom - high}, {dials, high}};
}

}  // namespace

bool touch(const Area& a, const Area& b) {
  if (!(a.size.x > 0.0F) || !(b.size.x > 0.0F)) return false;
  return a.at.x < b.at.x + b.size.x && b.at.x < a.at.x + a.size.x && a.at.y < b.at.y + b.size.y &&
         b.at.y < a.at.y + a.size.y;
}

Columns columns_of(const OverlayState& state, float width, float height) {
  Columns columns;
  columns.band = band_of(state, width, height);
  lay_bottom(columns, state, width, height);
  const float margin = margin_of(height);
  if (width >= kTwoColumns) {
    const bool below = columns.timeline.at.x + columns.timeline.size.x > width - margin - kColumn;
    const float bottom = below ? columns.timeline.at.y - kPanelGap : height - margin;
    for (const Right& right : kRights) {
      const bool all = !has_card(state);
      if (!all && (right.motors || right.cues || right.holding)) continue;
      if (lay_right(columns, state, right, width, margin, bottom)) break;
    }
  }
  for (Area* const area : {&columns.health, &columns.cues, &columns.holding, &columns.motors, &columns.dials})
    if (touch(*area, columns.band)) *area = {};
  return columns;
}

Columns columns_of(const Canvas& canvas, const OverlayState& state) {
  Columns columns = columns_of(state, canvas.width(), canvas.height());
  for (Area* const area :
       {&columns.health, &columns.cues, &columns.holding, &columns.motors, &columns.dials, &columns.timeline})
    *area = unless_covered(canvas, state, *area);
  return columns;
}

Area unless_covered(const Canvas& canvas, const OverlayState& state, const Area& area) {
  const Area card = state.keys_visible ? keys_area(canvas, state) : debrief_area(canvas, state);
  const bool covered = touch(area, card) || touch(area, returning_area(canvas, state)) ||
                       touch(area, band_of(state, canvas.width(), canvas.height()));
  return covered ? Area() : area;
}

}  // namespace fulcrum::ui
