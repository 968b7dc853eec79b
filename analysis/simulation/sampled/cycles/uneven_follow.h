// Where a motion ends that an encoder or noise disturbs at every tick: no turn repeats, and stretches of it tell.
#pragma once
#include "analysis/simulation/sampled/cycles/loop_end.h"
#include "analysis/simulation/sampled/cycles/panes.h"

#include <optional>

namespace stickslip {

/// The jitter about steady sliding: what an encoder or noise makes of a motion that nothing else disturbs.
struct Jitter {
    double amplitude = missing, velocity_min = missing, velocity_max = missing;

    bool known() const { return amplitude == amplitude; }
};

struct UnevenOptions {
    double V0 = missing;
    double tick = missing;         ///< s
    double turn = missing;         ///< s, of the slow mode: about how long a turn is
    double held = 0;               ///< s, that a cycle may stand still
    double decay = missing;        ///< 1/s, of small disturbances; negative where they decay
    double winds = 0;              ///< 1/s, with which an integral finds its level; 0: none
    bool steady_attracts = false;  ///< small disturbances decay
    bool stays = false;            ///< once at rest, no effort that the loop can give moves it
    double noise = 0;              ///< the smallest motion that the encoder or its noise makes
    double lead = 0;               ///< ln of what the motion starts with, per what noise makes
    Jitter jitter;                 ///< where known
};

class UnevenFollow {
  public:
    explicit UnevenFollow(const UnevenOptions& options);

    /// After a tick, with its extrema.
    std::optional<LoopEnd> after_tick(const LoopTurn& tick);
    /// Where no more ticks may follow: the newest half of the motion, where it goes on as it is.
    LoopEnd cut_short() const;

  private:
    /// Three neighbouring stretches, the newest last, and all of them together.
    struct Three {
        Stretch part[3], all;
    };

    Stretch newest(std::size_t count, std::size_t skip = 0) const;
    Three three(std::size_t count) const;
    double length(std::size_t panes) const { return static_cast<double>(pane_) * static_cast<double>(panes) * o_.tick; }
    double peak(const Stretch& stretch) const;
    bool stands(const Stretch& stretch) const;
    bool like_jitter(const Stretch& stretch) const;
    bool only_jitters(const Stretch& stretch) const;
    bool out_of_noise() const;
    bool small_and_linear(std::size_t count) const;
    bool goes_on(const Three& three, std::size_t count) const;
    bool neither_grows_nor_fades(const Three& three, double between) const;
    std::optional<LoopEnd> decide() const;
    void follow_round(const LoopTurn& tick);
    LoopEnd measured(const Stretch& stretch) const;

    UnevenOptions o_;
    long pane_ = 0;  ///< ticks
    Panes panes_;
    long ticks_ = 0;
    bool slow_ = false;
    double last_size_ = missing;  ///< of a round
    bool rising_ = true;
    double top_ = -infinity, bottom_ = infinity,
           turns_back_ = infinity;  ///< by which a position turns that ends a round
};

}  // namespace stickslip
