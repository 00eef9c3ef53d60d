#pragma once
// What the tests' OpenXR runtime shows and does, from a file that $FULCRUM_XR_SCRIPT names. A line each; #
// and what follows is a comment.
//
//   size W H             of one eye's picture, pixels
//   fov L R U D          rad, of the left eye; the right one's is its mirror image
//   eyes M               m, between them
//   focus N              each session has the focus from its frame N on (default 3)
//   pace MS              the least time that a frame takes
//
// The rest happens at a frame, counted from 1 by calls of xrWaitFrame:
//
//   N head X Y Z [QX QY QZ QW]        where it is from then on: m, in what local space is at first
//   N hand left|right X Y Z [...]     the same of a grip
//   N press left|right PART           such as select, and release
//   N hide, N show                    something else has the focus, and no longer
//   N blind, N sees                   where the head is is not known, and known again
//   N dark, N light                   no picture is wanted, and one is again
//   N stall, N flow                   pictures are not given to draw in, and are again
//   N recenter X Y Z                  local space moves so far
//   N size W H                        from the next time that pictures are asked for
//   N rest                            the headset is taken off, and put on again
//   N break                           the session is lost as soon as room is made for pictures
//   N lose, N pending                 the session is lost, without a word and with one
//   N die                             the runtime itself is gone: its instance is lost
//   N exit                            who wears it ends the session
//   N picture left|right|quad FILE    what is shown of it in that frame, as a PPM; N 0: in each, the last one
//   N wait FILE                       frames are not counted until that file is there
//   N hang FILE                       xrWaitFrame does not return until then

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/xr/openxr.h"

namespace runtime {

struct Event {
  std::uint64_t frame = 0;
  std::string what;
  std::vector<std::string> words;  // that follow
};

struct Script {
  std::uint32_t width = 320, height = 320;
  std::array<float, 4> fov{-0.7F, 0.6F, 0.6F, -0.65F};
  float eyes_apart = 0.063F;
  std::uint64_t focus = 3;
  int pace_ms = 0;
  std::vector<Event> events;  // frames ascending
};

// The file that $FULCRUM_XR_SCRIPT names; without it, as above. Ends the program where a line is wrong.
Script read_script();

// X Y Z [QX QY QZ QW], from words[first] on.
XrPosef pose_in(const std::vector<std::string>& words, std::size_t first);

}  // namespace runtime
