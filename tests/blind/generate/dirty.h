// What keeps machines from being their documents: numbers that are a few per cent off, small terms that nobody wrote
// down, forms that are not the catalogue's, noise that is not white, clocks that are not even.
#pragma once
#include "tests/blind/generate/effects.h"
#include "tests/blind/generate/loop.h"

#include <optional>

namespace blind {

struct Dirt {
    double inertia = 1, coulomb = 1, viscous = 1, gravity = 1;  ///< true over documented
    double asymmetry = 0, ripple = 0, cogging = 0, drift = 0;   ///< of the Coulomb level
    double ripple_rate = 1, cogging_rate = 1, phase = 0, drift_time = 10;
    std::vector<double> level;  ///< Coulomb level of every record over that of the machine
    std::vector<double> cut;    ///< s, of the front of every record: the log begins in motion
    bool other_forms = false;
    double second_harmonic = 0, back_driving = 1, hardening = 0;
    double colour = 0, spikes = 0;  ///< correlation from tick to tick; share of readings
    double jitter = 0;              ///< of the rows' times, in rows
    double lost = 0;                ///< share of rows
    bool milliseconds = false;      ///< the column of the time says them
    std::uint64_t seed = 0;
};

/// The dirt of a case with so many records. `forms`: the mechanism can show forms that are not the catalogue's.
Dirt draw_dirt(const Nominal& nominal, std::size_t records, bool forms, Draw& draw);

/// Puts it on the machine of record r, behind its effects. Says which forms it changed.
std::vector<std::string> soil(Machine& machine, const Nominal& nominal, const Dirt& dirt, std::size_t record);

/// The log as it reaches the file.
Record weathered(Record record, const Dirt& dirt, std::size_t index, double period);

/// What of the joint file is off, under the names that it gives them.
std::vector<Parameter> corrections(const Nominal& nominal, const Dirt& dirt);

}  // namespace blind
