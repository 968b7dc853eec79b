// What delayed friction adds to a sampled loop: to its reading and rate at the ticks, and so to its commands.
#pragma once
#include <complex>
#include <utility>
#include <vector>

#include "analysis/loop/delayed_share.h"

namespace stickslip {

class TickedShare {
  public:
    using Complex = std::complex<double>;
    /// `responses`: of the loop without delayed friction, the gains that are turned first, at e^{sT} − 1.
    TickedShare(const TickedFriction& ticked, const std::vector<DelayedFriction>& friction, const Resolvent& responses);
    /// To the responses of what is turned, and of what is held.
    std::pair<Complex, Complex> at(Complex s) const;
    /// What one place costs, per one of a loop without delayed friction: four aliases take its time.
    double cost() const { return 1 + aliases_ / 4.0; }

  private:
    /// To the sampled reading and its rate.
    struct Added {
        Complex reading, rate;
    };
    /// One delay's answer to the mechanism that does not hear it, or another's to that answer and so on, from tick to
    /// tick.
    struct Answer {
        Resolvent of_ticks;
        int whole_ticks;
    };
    /// The force of one delay.
    struct Delayed {
        const DelayedFriction* friction;
        DelayedFriction::Delay delay;
    };
    Added answered_early(Complex s) const;
    Added answered_further(Complex s, int aliases) const;
    void take_answers();
    void take_answer(const std::vector<Delayed>& delays, double times);
    void take_turns();
    void choose_aliases(const Resolvent& responses);

    TickedFriction ticked_;
    double period_;
    std::vector<DelayedFriction> friction_;
    DelayedShare share_;
    std::vector<Answer> answers_;
    double fraction_ = 0;  ///< s, of the dead time beyond whole ticks
    /// By how much a delay turns from alias to alias, e^{−2πi t/T}: of the fraction, then of each delay.
    std::vector<Complex> turns_;
    int aliases_ = 0;
    int terms_ = 2;  ///< of the answers of delays to each other that are taken from tick to tick
};

}  // namespace stickslip
