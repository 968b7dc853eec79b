// Each kernel that a law asks for, at the width that a source file is compiled for.
#pragma once
#include "analysis/simulation/lanes/kernels.h"
#include "analysis/simulation/lanes/lane_kernel.h"
#include "analysis/simulation/lanes/one_state_model.h"
#include "analysis/simulation/lanes/stribeck_model.h"
#include "analysis/simulation/lanes/ticked_kernel.h"
#include "analysis/simulation/lanes/two_mass_model.h"
#include "analysis/simulation/lanes/watched_model.h"

namespace stickslip::lanes {

template <int width, int count>
void run_wide(const Job* jobs, Answer* answers, std::size_t number, const Settings& settings, StateLaw law)
{
    law == StateLaw::ageing ? Kernel<AgeingModel, width, count>(jobs, answers, number, settings).run()
                            : Kernel<SlipModel, width, count>(jobs, answers, number, settings).run();
}

template <int width, int count>
void run_wide(const StribeckJob* jobs, StribeckAnswer* answers, std::size_t number, const Settings& settings)
{
    Kernel<StribeckModel, width, count>(jobs, answers, number, settings).run();
}

template <int width, int count>
void run_wide(const WatchedJob* jobs, WatchedAnswer* answers, std::size_t number, const Settings& settings,
              WatchedLaw law)
{
    switch (law) {
        case WatchedLaw::two_slip_states:
            return Kernel<TwoSlipModel, width, count>(jobs, answers, number, settings).run();
        case WatchedLaw::two_ageing_states:
            return Kernel<TwoAgeingModel, width, count>(jobs, answers, number, settings).run();
        case WatchedLaw::lugre:
            return Kernel<LuGreModel, width, count>(jobs, answers, number, settings).run();
        case WatchedLaw::slip_on_link:
            return Kernel<SlipOnLink, width, count>(jobs, answers, number, settings).run();
        case WatchedLaw::ageing_on_link:
            return Kernel<AgeingOnLink, width, count>(jobs, answers, number, settings).run();
        case WatchedLaw::slip_on_motor:
            return Kernel<SlipOnMotor, width, count>(jobs, answers, number, settings).run();
        case WatchedLaw::ageing_on_motor:
            return Kernel<AgeingOnMotor, width, count>(jobs, answers, number, settings).run();
        case WatchedLaw::slip_on_both:
            return Kernel<SlipOnBoth, width, count>(jobs, answers, number, settings).run();
        case WatchedLaw::ageing_on_both:
            return Kernel<AgeingOnBoth, width, count>(jobs, answers, number, settings).run();
    }
}

template <int width, int count>
void run_wide(const TickedJob* jobs, std::size_t number, TickedKind kind)
{
    const bool ageing = kind.law == StateLaw::ageing;
    if (kind.lags)
        ageing ? TickedKernel<LaggingAgeing, width, count>(jobs, number).run()
               : TickedKernel<LaggingSlip, width, count>(jobs, number).run();
    else
        ageing ? TickedKernel<HeldAgeing, width, count>(jobs, number).run()
               : TickedKernel<HeldSlip, width, count>(jobs, number).run();
}

}  // namespace stickslip::lanes
