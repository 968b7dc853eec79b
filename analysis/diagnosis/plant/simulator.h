// Simulates a joint along a record: closed loop as the machine ran, or predicted step by step from the logged command.
#pragma once
#include "analysis/diagnosis/plant/plant.h"
#include "analysis/diagnosis/records/ticks.h"

#include <cstdint>
#include <span>
#include <vector>

namespace stickslip::gap {

/// What a simulated loop would have logged, one entry a tick.
struct Trace {
    std::vector<double> position, velocity, command, effort;
    std::vector<double> true_position, true_velocity;  ///< of the body that the encoder sees, before the encoder
    bool predicted = false;                            ///< along the measured motion, not simulated from its start
};

/// The whole loop (docs/theory.md, real loops): encoder (noise, then quantum; the start is anywhere within a quantum),
/// velocity recursion, command and hold, dead time → lag → gain → saturation, mechanism. `seed` 0 gives a run without
/// noise; equal seeds give equal noise.
Trace simulate_closed_loop(const Plant& plant, const Ticks& ticks, std::uint64_t seed);

/// The controller's command from the measured motion: what it would have commanded at each tick.
std::vector<double> command_of(const Plant& plant, const Ticks& ticks);

/// The integral of this controller's error over the measured motion, before each tick's reading; empty where it keeps
/// none. It does not depend on the mechanism.
std::vector<double> integral_of(const Joint& joint, const Ticks& ticks);

/// The command that drives a prediction of this joint: logged where it was logged, else computed by its controller.
std::vector<double> known_command(const Plant& plant, const Ticks& ticks);
/// The same without a copy where it was logged; else it is put into `room`.
std::span<const double> known_command(const Plant& plant, const Ticks& ticks, std::vector<double>& room);

/// What a prediction gets wrong, one entry a tick, NaN where nothing was logged.
struct Innovation {
    std::vector<double> position;  ///< encoder minus prediction
    std::vector<double> effort;    ///< measured minus predicted effort
    std::vector<double> velocity;  ///< predicted velocity of the body that the encoder sees
    std::vector<double> predicted_effort;
};

/// Drives the joint with a known command and corrects it with a slow observer, q += 2ζωT e, v += ω²T e (ζ = 0.8).
/// omega = 0 leaves it alone: an open-chain simulation.
void predict(const Plant& plant, const Ticks& ticks, std::span<const double> command, double omega, Innovation& out);

/// What of an innovation is wanted: the position alone, the effort too, or all of it.
enum class Wanted { position, effort, all };

/// One of many predictions.
struct Prediction {
    Plant plant;
    const Ticks* ticks;
    std::span<const double> command;
    double omega;
    Innovation* out;
    Wanted wanted = Wanted::all;
};

/// Many predictions side by side in the lanes of the processor. The bits of each depend neither on the others nor on
/// the instruction set.
void predict_all(std::span<const Prediction> all);

/// How much larger than the encoder's variance the innovation's is for a free inertia under this observer.
double noise_amplification(double omega, double step);
/// The innovation of a free inertia under this observer after a reading that is off by one, reading by reading.
std::vector<double> innovation_response(double omega, double step);

/// Variance of the innovation over that of a velocity by which the joint is faster at every reading, independently, s².
double kick_amplification(double omega, double step);

/// Variance of the observer's velocity just after a correction, over the encoder's variance, 1/s².
double velocity_noise_amplification(double omega, double step);

}  // namespace stickslip::gap
