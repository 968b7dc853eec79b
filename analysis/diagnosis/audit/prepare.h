// From records to cases: per-record overrides, noise, scales.
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/diagnosis/records/record.h"
#include "analysis/results/note.h"

#include <string>

namespace stickslip::gap {

/// Standard deviation of white noise on a smooth signal: third differences, var(Δ³y) = 20 σ². Insensitive to motion
/// that is smooth over four samples.
double noise_of(const std::vector<double>& y);

/// Standard deviation of what a sampled controller makes of white noise of its readings.
double noise_of_command(const Control& control, double reading);

/// The joint with the numbers that held in this record. Throws std::invalid_argument for an override whose path the
/// joint does not have.
Joint joint_in(const Record& record, const Joint& nominal);

/// A case from a record: overrides applied, put on its clock, noise as documented or, where the joint does not say or
/// the record shows a quarter more, as estimated; `notes` says which. Throws as joint_in() does.
Case prepare(const Record& record, const Joint& nominal, std::vector<Note>& notes);

/// Where no noise is documented and what there is stays below half a step of the encoder, a record mostly at rest shows
/// none of it: every record gets the largest estimate, since all have one encoder, and `notes` says so.
void share_noise(std::vector<Case>& cases, const Sensor& documented, std::vector<Note>& notes);

/// Largest less least value; 0 of none.
double span_of(const std::vector<double>& values);

/// Sigma of a reading from the sensor's numbers.
double reading_sigma(const Sensor& sensor, double span);

/// What one of everything means for these cases.
Scales scales_of(const std::vector<Case>& cases);

}  // namespace stickslip::gap
