// Laws by which the slider of a friction rig may answer its load point, and their fit to a measured force.
#pragma once
#include "analysis/diagnosis/records/record.h"
#include "analysis/results/quantity.h"

#include <vector>

namespace stickslip::gap {

/// What resists the slider beyond a constant level. V* is the load point's first speed.
enum class RigLaw { level, velocity, logarithm, load, drift, slip, ageing, time };

struct RigParameter {
    const char* name;
    Quantity quantity;
};

/// A law as a candidate cause: the effect of the catalogue that it is a form of.
struct RigRival {
    RigLaw law;
    const char *effect, *form;
    std::vector<RigParameter> parameters;  ///< after the spring's stiffness
};

/// All of them, the constant level first.
const std::vector<RigRival>& rig_rivals();

/// A stretch of a record in which the load point goes one way: displacement and time from zero, friction counted
/// against the motion.
struct RigRun {
    std::vector<double> time, displacement, friction;
    std::vector<double> normal;    ///< load on the contact, empty where it was not logged
    double start_speed = 0;        ///< of the load point, at which the slider already slides steadily
    std::size_t record = 0;        ///< that it is of
    std::size_t from = 0, to = 0;  ///< its rows there
    std::size_t level = 0;         ///< runs with one number here have one level
};

/// All runs of a rig's records, at most 6000 rows together; one law answers them all.
struct Rig {
    std::vector<RigRun> runs;
    std::size_t levels = 0;
    double speed = 0;     ///< of the load point at first: V*
    double travel = 0;    ///< of the load point, the longest
    double range = 0;     ///< of the friction about its level
    double duration = 0;  ///< s, the longest

    std::size_t rows() const;
};

/// Every run has a level of its own, for no two slides of a contact begin alike; where the normal load was logged and
/// differs between runs, all of one direction have one level, and the load has to explain what they differ by. Behind
/// a turn a run begins where the friction has come to its median: before that the spring unloads.
Rig rig_of(const std::vector<Record>& records);

/// Standard deviation of the friction about a line, in the median block of 100 rows: readings of a rig are often
/// smoothed, and third differences would then take the noise for much less than it is.
double rig_noise(const Rig& rig);

/// How many folds the rows belong to in turn, in blocks of 20: whoever measures writes more rows where more happens, so
/// that every fold has its part of a transient.
inline constexpr int rig_folds = 3;

/// Numbers of a law in SI: the spring's stiffness first.
using RigNumbers = std::vector<double>;

/// Force less its level along every run, of a massless slider behind the spring. Slip and ageing law:
/// analysis/README.md, friction laws, (4)-(5).
std::vector<std::vector<double>> rig_force(const Rig& rig, RigLaw law, const RigNumbers& p);

/// Mean square of the misfit with the levels refitted to the rows outside `fold` (−1: to all); over those rows, or with
/// `outside` over the fold. `levels`, when given, receives them.
double rig_square(const Rig& rig, const std::vector<std::vector<double>>& force, int fold, bool outside,
                  std::vector<double>* levels = nullptr);

struct RigFit {
    RigNumbers p;
    std::vector<double> x;  ///< what the search works with
    double square = 0;      ///< mean square over the rows that were fitted
};

/// The best of searches from several starts, on all rows.
RigFit fit_rig(const Rig& rig, const RigRival& rival);
/// The fit again without one fold, from where the fit to all rows came to.
RigFit refit_rig(const Rig& rig, const RigRival& rival, int fold, const RigFit& from);

}  // namespace stickslip::gap
