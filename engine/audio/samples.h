#pragma once
// The samples of what is heard: pure, the same bits each time.
//
// A blow of v m/s on a material of attack A, decay d and frequency f (haptics/scene/impact_material.h) sounds
//     y(t) = L sum_n a_n e^(-d t) sin(2 pi p f_n t) / max(1, sum_n |a_n|)
//     L = gain kPeak x / (1 + x)      x = A v / kHalf
// with f_n and a_n the modes that the handle is shaken by and p the scene's pitch. It begins with 0. L grows
// with the blow without an end and stays below kPeak. The sound lasts until a thousandth is left, kLongest at
// most, and its last kFade goes to 0 on a line. Modes above kHighest are left out.
//
// Sliding is noise through a resonance at the first material's frequency, as beside the hand. K. van den
// Doel, P. G. Kry, D. K. Pai, "FoleyAutomatic: Physically-based sound effects for interactive simulation and
// animation", SIGGRAPH 2001, have a surface's noise ring the modes of what it is; of many modes one is here.
// Its level is theirs, the root of the power that friction takes, F v.

#include <span>
#include <vector>

#include "engine/audio/scene_sound.h"
#include "engine/audio/tick_listener.h"

namespace fulcrum::audio {

inline constexpr int kRate_Hz = 48000;
inline constexpr double kPeak = 0.3;                 // of full scale, for one blow
inline constexpr double kHalf = 0.4;                 // N, A v of a blow that is half as loud as the loudest
inline constexpr double kLongest = 2, kFade = 5e-3;  // s
inline constexpr double kHighest = 0.45 * kRate_Hz;  // Hz

// From -1 to 1. Empty: the blow is none, or nothing of it can be heard.
std::vector<float> struck_samples(const SceneSound& scene, const Blow& blow);
// L of it.
double struck_level(const SceneSound& scene, const Blow& blow);

// A loop without a seam, at the level 1.
inline constexpr double kSlideLoop = 1.5;  // s
std::vector<float> slide_samples(const SceneSound& scene);
// 0 to 1, times what slide_samples() has.
double slide_level(const Slide& slide);

std::vector<float> chime_samples(Chime chime);

}  // namespace fulcrum::audio
