// What a case is before anything is wrong with it: joint, motions, columns, noise, and what simulations of it differ
// by.
#pragma once
#include "tests/blind/generate/dirty.h"
#include "tests/blind/generate/gap.h"
#include "tests/blind/generate/nominal.h"
#include "tests/blind/generate/random.h"

#include <functional>
#include <optional>
#include <stdexcept>

namespace blind {

/// Raised when a draw came out unusable (no gap to see, unstable loop); the next try draws again.
struct Unusable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Which columns a case writes.
struct Columns {
    std::string name = "full";
    bool reference_position = true, reference_velocity = true, velocity = true, command = true, effort = true,
         supply = false;
};
const std::vector<Columns>& column_sets();

struct Setting {
    Nominal nominal;
    std::vector<Machine> machines;  ///< the nominal one of each record: gains may differ between records
    std::vector<Excitation> excitations;
    Columns columns;
    int stride = 1;
    bool noise_stated = true;
    std::uint64_t noise_seed = 0;
    std::optional<Dirt> dirt;

    std::vector<Signal> signals;  ///< what a simulation of the closed loop predicts and the columns show
    Ensemble ensemble;            ///< the nominal joint, simulated with different noise
    double peak_command = 0;      ///< largest drive signal of the nominal records

    /// Seed of the noise that belongs to record r itself.
    std::uint64_t record_seed(std::size_t r) const { return seed_of(noise_seed, 1000 + r); }
    std::vector<Record> record(const std::vector<Machine>& with) const;
    /// Distance of the records of these machines from the nominal joint, in floors.
    double gap_of(const std::vector<Machine>& with) const;
    Gap gap(const std::vector<Record>& records, const std::vector<Machine>& truth) const;
};

/// What a case leaves open is drawn. `families` are the joints that will do.
struct SettingWish {
    std::string kind, columns;
    std::vector<std::string> families;
    bool may_change_gains = true, dirty = false;
    bool forms = true;  ///< the mechanism can show forms that are not the catalogue's
    std::string controller = "pd";
};
Setting draw_setting(const SettingWish& wish, Draw& draw, std::uint64_t noise_seed);

inline constexpr double smallest_gap = 2, largest_gap = 40;  // floors

/// The size between its bounds at which the machines `at` that size are `wanted` floors from nominal; bounds may keep
/// it from that. Throws Unusable if the gap is then below smallest_gap or above `most`.
double size_for_gap(const Setting& setting, double smallest, double largest, double wanted,
                    const std::function<std::vector<Machine>(double)>& at, double most = largest_gap);

}  // namespace blind
