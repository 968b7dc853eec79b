// The options --disturbance and --size, which simulate and evaluate share.
#pragma once
#include "sweep/files/text/bad_input.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/word_option.h"
#include "sweep/study/spec.h"

#include "sweep/program/verbs/command_line.h"

#include <string>
#include <vector>

namespace stickslip {

struct DisturbanceOption {
    std::string kind;
    double size = missing;

    void add_to(Verb& verb)
    {
        std::vector<std::string> kinds;
        for (const auto& k : DisturbanceSpec::kinds) kinds.emplace_back(k.name);
        verb.add_option("--disturbance", kind, "what is disturbed; default: a spec's own, else position")
            ->check(one_of(kinds));
        verb.add_option("--size", size,
                        "size of the disturbance in SI; default: a spec's own, else small, in the slow mode")
            ->check(finite_number());
    }

    /// The disturbance of the command line, or else that of the spec. A size belongs to its kind: another kind starts
    /// without. Throws BadInput where nothing would be disturbed; a start at none of V0 is one from rest.
    Disturbance disturbance(const NonlinearSpec& spec) const
    {
        Disturbance d = spec.disturbance.disturbance;
        for (const auto& k : DisturbanceSpec::kinds)
            if (k.name == kind) d = {k.value, missing};
        if (is_set(size)) d.size = size;
        if (size == 0 && d.kind != DisturbanceKind::start)
            throw BadInput("--size: got 0, expected a disturbance other than 0");
        return d;
    }
};

}  // namespace stickslip
