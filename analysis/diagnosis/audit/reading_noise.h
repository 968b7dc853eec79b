// Noise of readings, of commands and of efforts.
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/results/note.h"

#include <vector>

namespace stickslip::gap {

/// Standard deviation of white noise on a smooth signal: third differences, var(Δ³y) = 20 σ². Insensitive to motion
/// that is smooth over four samples.
double noise_of(const std::vector<double>& y);

struct ReadingNoise {
    double sigma = 0;
    double kept = 0;  ///< part of it that stays from row to row; 0: white
};
/// Noise that may have a memory, as behind a filter in the encoder: third differences of every second, third, … reading
/// show more of it. Where they show the same, that of noise_of().
ReadingNoise noise_with_memory(const std::vector<double>& y);

/// Standard deviation of what a sampled controller makes of white noise of its readings.
double noise_of_command(const Control& control, double reading);

/// Where no noise is documented and what there is stays below half a step of the encoder, a record mostly at rest shows
/// none of it: every record gets the largest estimate, since all have one encoder, and `notes` says so.
void share_noise(std::vector<Case>& cases, const Sensor& documented, std::vector<Note>& notes);

/// Largest less least value; 0 of none.
double span_of(const std::vector<double>& values);

/// Sigma of a reading from the sensor's numbers.
double reading_sigma(const Sensor& sensor, double span);

}  // namespace stickslip::gap
