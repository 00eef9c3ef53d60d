#pragma once
// A sine as a device hears it that holds each sample for a tick.
//
// Held samples of a tone f carry it with sinc(f T) of its amplitude, sin(pi x) / (pi x): 0.9355 at 200 Hz and
// 1 kHz (A. V. Oppenheim, R. W. Schafer, "Discrete-Time Signal Processing", zero-order hold). The samples are
// made larger by its inverse, so that what is held has the amplitude that was asked for, at any tick rate.
// The phase is kept in turns and is a function of the number of samples alone: 200 Hz at 1 kHz is the same
// five samples for ever.

namespace fulcrum {

// With fewer samples a period, what is held is mostly the tone's mirror images.
inline constexpr double kMinSamplesPerPeriod = 2.5;

class HeldSine {
public:
  // frequency_Hz: below half of 1 / tick_s.
  HeldSine(double frequency_Hz, double tick_s);

  // The next sample of a tone of amplitude 1, from phase 0 on; its own amplitude is 1 / sinc(f T).
  double next() noexcept;
  void restart() noexcept { turns_ = 0; }

  double largest() const { return peak_; }  // no sample is larger

private:
  double turns_per_tick_;
  double peak_;
  double turns_ = 0;
};

}  // namespace fulcrum
