#pragma once
// What an author does to a scenario while it runs: looks up places, moves what there is, and has it written
// into the file. The file is the truth: what is written comes back as any other save does.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/edit/reloader.h"
#include "engine/app/edit/scene_pick.h"
#include "engine/scenario/write_back.h"

namespace fulcrum::app {

class SceneEditor {
public:
  // All of it as it is now. Pixels from the picture's top left.
  struct Seen {
    const Prepared& prepared;
    Pose X_WT;  // the tool
    render::Camera camera;
    render::Extent picture;
  };

  // As a Reloader's.
  SceneEditor(std::filesystem::path file, const scenario::Scenario& shown,
              std::filesystem::path calibration = {});

  Reloader& reloader() { return reloader_; }

  // With Control held. On a checkpoint: it is held. Anywhere else: what is there is looked up.
  void press(const Seen& seen, double x, double y);
  // The checkpoint that is held goes along, at its distance from the eye. Pixels.
  void drag(const Seen& seen, double dx, double dy);
  // And is written where it is now.
  void release(const Seen& seen);
  // Nothing is held any more, and nothing is written of it.
  void let_go() { held_.reset(); }
  // A checkpoint that is held, and where; the number of its marker.
  const std::optional<std::pair<std::size_t, Vec3>>& held() const { return held_; }

  // What put() is to write: each checkpoint, the start, the grasp, the view, the light.
  void next_item(const Prepared& prepared);
  // A checkpoint is put where the touch point is, the start where the tool is, the grasp at the place of the
  // tool's model that was looked up last; of the view that is shown, and of the light, the eye becomes the
  // camera's.
  void put(const Seen& seen, std::size_t view);

  // What was looked up or written, or is wrong with the newest save; otherwise what there is to do. A few
  // lines.
  std::string message(const Prepared& prepared) const;
  // What was looked up, for the clipboard; once.
  std::optional<std::string> take_text() { return std::exchange(text_, std::nullopt); }

private:
  enum class Kind { checkpoint, start, grasp, view, light };
  struct Item {
    Kind kind = Kind::checkpoint;
    std::size_t index = 0;  // of checkpoints
  };

  static std::vector<Item> items(const Prepared& prepared);
  static std::string name_of(const Prepared& prepared, const Item& item);
  // Why what is seen is not what the file says, so that nothing can be written of it; empty: it is.
  static std::string why_elsewhere(const Prepared& prepared, Kind kind,
                                   const std::vector<scenario::NumberChange>& changes);
  // The scenario's text, if it is that of what is seen, or what was written of that; otherwise `said_` has
  // why.
  std::optional<std::string> text_of(const Prepared& prepared);
  void write(const Prepared& prepared, Kind kind, std::vector<scenario::NumberChange> changes,
             const std::string& what);

  std::filesystem::path file_;
  Reloader reloader_;
  std::size_t item_ = 0;
  std::optional<Picked> picked_;
  std::optional<std::string> text_;
  std::optional<std::pair<std::size_t, Vec3>> held_;
  bool moved_ = false;
  std::string said_;
  std::string written_;  // the file's text as it was written last
};

}  // namespace fulcrum::app
