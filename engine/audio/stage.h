#pragma once
// The sources of a scene in OpenAL: blows where they fell, sliding where the tool touches, chimes at the
// listener. One thread's, whose context is in use.
//
// At most kSounding blows and chimes sound together. One more has the weakest of them fade, or, where it is
// the weakest itself, is left out. Nothing is cut: what has to end goes to 0 within kFadeOut, in which it
// still has its source.

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/audio/samples.h"
#include "engine/audio/scene_sound.h"
#include "engine/audio/tick_listener.h"

namespace fulcrum::audio {

class Stage {
public:
  static constexpr std::size_t kSounding = 12, kSources = 20;
  static constexpr double kFadeOut = 0.03;  // s
  // m: what is nearer is no louder, what is twice as far half as loud.
  static constexpr double kReference = 0.5;

  // scene: must outlive it.
  explicit Stage(const SceneSound& scene);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  void hear_from(const Listener& listener);
  // Of all: 0 silent, 1 as it is.
  void set_volume(double volume);

  // What was started, to ask heard_after() of.
  struct Started {
    std::size_t voice = 0;
    std::int64_t number = 0;
  };
  // None: it cannot be heard, or there are stronger ones enough.
  std::optional<Started> strike(const Blow& blow);
  void chime(Chime chime);
  void slide(const std::optional<Slide>& slide);
  // Time goes on by so many seconds.
  void turn(double seconds);

  // s, from now until its first sample reaches the loudspeaker; below 0: it has by then. None: the library
  // has not begun to mix it, or it has ended.
  std::optional<double> heard_after(const Started& started) const;

  std::int64_t dropped() const { return dropped_; }  // for stronger ones
  std::size_t sounding() const;

private:
  struct Voice {
    unsigned source = 0, buffer = 0;
    double level = 0, decay = 0;  // of what sounds, now; 1/s
    double fades = 0;             // s left; 0: it does not
    bool sounds = false;
    std::int64_t number = 0;  // of what it plays
  };
  std::optional<std::size_t> room_for(double level);
  std::optional<Started> play(const std::vector<float>& samples, double level, double decay, const Vec3* p_W);

  const SceneSound& scene_;
  std::vector<Voice> voices_;
  unsigned slide_source_ = 0, slide_buffer_ = 0;
  double slide_gain_ = 0;
  bool slides_ = false;
  std::int64_t started_ = 0, dropped_ = 0;
};

}  // namespace fulcrum::audio
