#pragma once
// What the tests' OpenXR runtime shows and does, from a file that $FULCRUM_XR_SCRIPT names. A line each; #
// and what follows is a comment.
//
//   size W H             of one eye's picture, pixels
//   fov L R U D          rad, of the left eye; the right one's is its mirror image
//   eyes M               m, between them
//   focus N              each session has the focus from its frame N on (default 3)
//   pace MS              the least time from one frame to the next
//   tracking WHAT        of hands without controllers: yes (the default); none, for a runtime without the
//                        extension; off, for a headset that is told not to
//   largest W H          pixels that a picture may have (4096 4096 at first)
//   blend WHAT           how pictures go with the room: opaque (the default), or additive
//   look N               pictures are read back, and judged, in every Nth frame alone (default 1)
//
// The rest happens at a frame, counted from 1 by calls of xrWaitFrame:
//
//   N head X Y Z [QX QY QZ QW]        where it is from then on: m, in what local space is at first
//   N hand left|right X Y Z [...]     the same of a grip; what it aims from is kAim of that
//   N guess left|right, N track ...   where it is is not seen but guessed, and seen again
//   N bare left|right X Y Z [...]     a hand without a controller: its palm
//   N tips left|right INDEX LITTLE    mm, from its thumb's tip to those of two fingers (80 80 at first)
//   N cover left|right, N uncover ... it is out of sight, and back
//   N spoil left|right HOW            what is said of its palm is no place: nan, unturned, far; well again
//   N handle X Y Z                    of a Touch whose maker's library is the tests' own: m, in its base;
//                                     frames are not counted until its driver has been told
//   N sleep left|right, N wake ...    nobody says what is pressed, and it is said again
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
//   N ending                          the runtime says that it is about to end
//   N die                             the runtime itself is gone: its instance is lost
//   N exit                            who wears it ends the session
//   N picture left|right|quad FILE    what is shown of it in that frame, as a PPM; N 0: in each, the last one
//   N wait FILE                       frames are not counted until that file is there
//   N hang FILE [CALL]                xrWaitFrame, or xrEndFrame, does not return until then

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
  std::uint64_t look = 1;
  std::uint32_t largest_width = 4096, largest_height = 4096;
  XrEnvironmentBlendMode blend = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  std::string tracking = "yes";
  std::vector<Event> events;  // frames ascending
};

// The file that $FULCRUM_XR_SCRIPT names; without it, as above. Ends the program where a line is wrong.
Script read_script();

// m, in the grip, of the place from which a hand aims; it is turned as the grip is.
inline constexpr XrVector3f kAim{0, -0.02F, -0.06F};

// X Y Z [QX QY QZ QW], from words[first] on.
XrPosef pose_in(const std::vector<std::string>& words, std::size_t first);

}  // namespace runtime
