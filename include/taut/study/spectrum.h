#pragma once

#include <taut/study/motion_track.h>

namespace taut::study
{
/// Amplitudes at frequencies k / T of a motion of the length T: a line
/// a sin(2 pi f t) at one of them has the height a.
struct Spectrum
{
  std::vector<double> frequencies; ///< (Hz)
  std::vector<double> amplitudes;  ///< in the unit of the motion
};

struct SpectrumLine
{
  double frequency = 0; ///< (Hz)
  double amplitude = 0;
};

/// One-sided spectrum of a track less its mean, under Hann's window, which
/// leaks far less than none into frequencies that are not near. As many even
/// times as the track has rows are taken of its cubics. Fewer than 8 rows give
/// an empty spectrum.
Spectrum compute_spectrum(const MotionTrack& track);

/// The highest line, between the frequencies of the spectrum: for a line that
/// stands alone exact, from the shape of the window. Zero if there is none.
SpectrumLine find_highest_line(const Spectrum& spectrum);

/// Amplitude of the part of a track at one frequency, over a whole number of
/// whose periods it must extend.
double compute_line(const MotionTrack& track, double frequency);
} // namespace taut::study
