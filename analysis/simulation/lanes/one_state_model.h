// A rate-and-state law with one state in the kernel.
#pragma once
#include "analysis/simulation/lanes/rosenbrock_model.h"

namespace stickslip::lanes {

template <class P, template <class> class Friction>
struct OneStateEquations : PackedGroups<P, Friction> {
    using Job = lanes::Job;
    using Answer = lanes::Answer;
    using Program = lanes::Program;
    using State = Triple<P>;
    static constexpr int size = 3;  ///< X, w, p
    static constexpr double slow = near_rest_logarithm;

    static State state(const P* y) { return {y[0], y[1], y[2]}; }
    /// A harmless problem for a lane without a job.
    static constexpr Job idle() { return {{1, 1, 1, 0}, -1, 1, true, {0, 0, 0}, false, {0, 0, 0}}; }

    void load(int lane, const Groups& groups)
    {
        this->K.set(lane, groups.K);
        this->per_M.set(lane, 1 / groups.M);
        this->friction.set_beta(lane, groups.beta);
        this->c.set(lane, groups.c);
    }
};

template <class P>
using SlipModel = RosenbrockModel<P, OneStateEquations<P, SlipState>>;
template <class P>
using AgeingModel = RosenbrockModel<P, OneStateEquations<P, AgeingState>>;

}  // namespace stickslip::lanes
