// The controller audit: is the logged command that of the documented controller?
#pragma once
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/results/note.h"

#include <string>
#include <vector>

namespace stickslip::gap {

/// A parameter of the controller or the encoder that differs from its documentation.
struct AuditFinding {
    std::string effect;     ///< catalogue name
    std::string parameter;  ///< "gain-k_p.factor"
    double value = 0, stderr_ = 0;
    Quantity quantity = Quantity::number;
    double gain = 0;  ///< part of the command's unexplained mean square that it removes
};

struct Audit {
    std::vector<AuditFinding> findings;
    bool possible = false;           ///< command, reference and position were logged
    bool filter_seen = false;        ///< logged velocities follow a filter that is known now
    bool command_explained = false;  ///< the corrected controller reproduces the command
    double residual_after = 0;       ///< rms of the command's misfit over its rms
    std::vector<Note> notes;
};

/// Audits every case and corrects its joint: position grid, velocity filter, gains, controller limit.
Audit audit(std::vector<Case>& cases);

/// Whether a filter with this time constant lets through so differently from the documented one that it matters: its
/// share of a new difference, T/(τ + T), is off by more than the digits of a document are.
bool filters_differently(double documented_tau, double tau, double tick);

/// The grid that all readings lie on, 0 if there is none.
double grid_of(const std::vector<double>& readings);

/// Whether readings on this grid are clearly coarser than documented, by the step and by the noise.
bool coarser_grid(double quantum, const Sensor& documented);

/// The step in which logged commands are given, 0 if they are not: a duty cycle of a servo comes in whole counts.
double command_step(const Ticks& ticks);

}  // namespace stickslip::gap
