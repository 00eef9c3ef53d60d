#pragma once
// What an author does to a scenario while it runs: looks up places, moves what there is, and has it written
// into the file. The file is the truth: what is written comes back as any other save does.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/edit/handles.h"
#include "engine/app/edit/reloader.h"
#include "engine/app/edit/scene_pick.h"
#include "engine/scenario/write_back.h"
#include "engine/ui/overlay_state.h"

namespace fulcrum::app {

class SceneEditor {
public:
  // All of it as it is now. Pixels from the picture's top left.
  struct Seen {
    const Prepared& prepared;
    Pose X_WT;  // the tool
    render::Camera camera;
    render::Extent picture;
    std::size_t view = 0;  // that the camera began in
  };

  // As a Reloader's.
  SceneEditor(std::filesystem::path file, const scenario::Scenario& shown,
              std::filesystem::path calibration = {});

  Reloader& reloader() { return reloader_; }

  // With Control held. On a handle: it is held; of several in one place the one that put() would write, else
  // one of the view that is seen. Anywhere else, and where a handle is not dragged: what is there is looked
  // up.
  void press(const Seen& seen, double x, double y);
  // The handle that is held goes along, at its distance from the eye. Pixels.
  void drag(const Seen& seen, double dx, double dy);
  // And is written where it is now.
  void release(const Seen& seen);
  // Nothing is held any more, and nothing is written of it.
  void let_go() { held_.reset(); }
  // The handle that is held, where it is now.
  const std::optional<Handle>& held() const { return held_; }

  // The handles as the picture shows them.
  std::vector<ui::HandleMark> marks(const Seen& seen) const;

  // What put() is to write: each handle but a view's target, which goes with its eye.
  void next_item(const Seen& seen);
  // What the task has is put where the touch point is, the start where the tool is, the grasp at the place of
  // the tool's model that was looked up last; a view becomes what is seen, and the light comes from the eye.
  void put(const Seen& seen);

  // What was looked up or written, or is wrong with the newest save; otherwise what there is to do. A few
  // lines.
  std::string message(const Seen& seen) const;
  // What was looked up, for the clipboard; once.
  std::optional<std::string> take_text() { return std::exchange(text_, std::nullopt); }

private:
  static std::vector<Handle> items(const Seen& seen);
  // That put() writes: the one that was chosen, as it is now.
  Handle chosen(const Seen& seen) const;
  bool is_preferred(const Handle& handle, const Seen& seen) const;
  void look_up(const Seen& seen, double x, double y);
  // Why what is seen is not what the file says, so that nothing can be written of it; empty: it is.
  static std::string why_elsewhere(const Prepared& prepared, Handle::Kind kind,
                                   const std::vector<scenario::NumberChange>& changes);
  // The scenario's text, if it is that of what is seen, or what was written of that; otherwise `said_` has
  // why.
  std::optional<std::string> text_of(const Prepared& prepared);
  void write(const Prepared& prepared, Handle::Kind kind, std::vector<scenario::NumberChange> changes,
             const std::string& what);

  std::filesystem::path file_;
  Reloader reloader_;
  std::optional<Handle> chosen_;  // none: the first
  std::optional<Picked> picked_;
  std::optional<std::string> text_;
  std::optional<Handle> held_;
  glm::vec2 pressed_{0.0F};  // px, where it was taken
  bool moved_ = false;
  std::string said_;
  std::string written_;  // the file's text as it was written last
};

}  // namespace fulcrum::app
