// The options --force… and --normal-load…, which simulate and evaluate share: d(t) of (9) and σ_n(t) of (1).
#pragma once
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/series_file.h"
#include "sweep/program/verbs/disturbance_option.h"
#include "sweep/program/verbs/word_option.h"
#include "sweep/study/disturbed_motion.h"

#include "sweep/program/verbs/command_line.h"

#include <string>

namespace stickslip {

struct SurroundingsOption {
    AskedDisturbance force;
    std::string load_file;
    double nominal_load = 1;

    void add_to(Verb& verb)
    {
        verb.add_option("--force", force.kind,
                        "disturbing force d(t) on the link: impulse | step | sine | noise | a file with time and force")
            ->check(one_of_or_file({"impulse", "step", "sine", "noise"}));
        verb.add_option("--force-size", force.size, "N·s of an impulse, N of others, a factor on a file")
            ->check(finite_number())
            ->capture_default_str();
        verb.add_option("--omega", force.omega, "rad/s of a sine; default: the peak of |X/D|")
            ->check(positive_number());
        verb.add_option("--seed", force.seed, "seed of the noise")->check(whole_number())->capture_default_str();
        verb.add_option("--normal-load", load_file,
                        "normal load on the link's friction over time: a record with time and normal_load")
            ->check(existing_file());
        verb.add_option("--nominal-load", nominal_load,
                        "the normal load at which the numbers of the friction law hold, in the record's unit")
            ->check(positive_number())
            ->capture_default_str();
    }
    void add_duration_to(Verb& verb, const char* by_default)
    {
        verb.add_option("--duration", force.duration, std::string("s; default: ") + by_default)
            ->check(positive_number());
    }

    /// The force, with its record where it is a file. Throws BadInput for a file that cannot be read.
    AskedDisturbance force_on(const Joint& joint) const
    {
        AskedDisturbance asked = force;
        if (is_force_file(asked))
            asked.record = read_series(asked.kind, "force", SeriesQuantity{Quantity::effort, units_of(joint)});
        return asked;
    }

    bool loaded() const { return !load_file.empty(); }

    /// The record of the normal load, per the nominal one. Throws BadInput where it is not positive.
    TimeSeries normal_load() const
    {
        auto series = read_series(load_file, "normal_load");
        for (double& load : series.value) {
            load /= nominal_load;
            if (!(load > 0)) throw BadInput(load_file + ": a normal load must be > 0");
        }
        return series;
    }
};

}  // namespace stickslip
