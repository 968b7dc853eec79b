// A pack of joints that predict their records tick by tick and are corrected by a slow observer.
#pragma once
#include "analysis/diagnosis/plant/runs.h"

namespace stickslip::gap {

template <class P, class K = Kind>
class Observer {
  public:
    explicit Observer(const Kind& kind) : mechanics_(kind) {}

    /// All runs, each lane taking the next one when it is through.
    void through(std::span<const Run> runs)
    {
        std::size_t next = 0;
        int going = 0;
        for (int i = 0; i < lanes; ++i) {
            put(i, runs[std::min(next, runs.size() - 1)]);
            if (next++ < runs.size())
                ++going;
            else
                idle(i);
        }
        find_common();
        while (going > 0) {
            std::size_t count = static_cast<std::size_t>(-1);
            for (int i = 0; i < lanes; ++i)
                if (goes_[i]) count = std::min(count, run_[i]->to - mechanics_.tick(i));
            for (; count > 0; --count) step();
            for (int i = 0; i < lanes; ++i) {
                if (!goes_[i] || mechanics_.tick(i) < run_[i]->to) continue;
                if (next < runs.size()) {
                    put(i, runs[next++]);
                } else {
                    put(i, *run_[i]);
                    idle(i), --going;
                }
            }
            find_common();
        }
    }

  private:
    static constexpr int lanes = P::lanes;

    void put(int lane, const Run& r)
    {
        run_[lane] = &r, goes_[lane] = true;
        mechanics_.load(lane, *r.plant, *r.ticks, r.command, r.from);
        mechanics_.start(lane, r.velocity, r.rest);
        since_.set(lane, 0), omega_.set(lane, r.omega);
        longest_.set(lane, 0.5 / std::max(r.omega, 1e-9));
        asks_more_ = false, asks_effort_ = false;
        for (const auto* run : run_) {
            asks_more_ = asks_more_ || (run && run->predicted_effort);
            asks_effort_ = asks_effort_ || (run && run->effort);
        }
    }
    /// Whether every lane that goes is at the same row: then it is read once for all of them. What the others read
    /// matters to none.
    void find_common()
    {
        const Ticks* ticks = nullptr;
        bool common = true;
        for (int i = 0; i < lanes; ++i) {
            if (!goes_[i]) continue;
            if (!ticks) ticks = run_[i]->ticks, first_ = i;
            common = common && run_[i]->ticks == ticks && mechanics_.tick(i) == mechanics_.tick(first_);
        }
        common_ = common && ticks;
        mechanics_.read_once(common_ ? first_ : -1);
    }
    void idle(int lane)
    {
        goes_[lane] = false;
        mechanics_.stop(lane);
    }

    void step()
    {
        P read(0.0), step(0.0);
        typename P::MaskType logged;
        if (common_) {
            const Ticks& t = *run_[first_]->ticks;
            const std::size_t k = mechanics_.tick(first_);
            read = P(t.position[k]), step = P(t.step[k]);
            for (int i = 0; i < lanes; ++i) logged.set(i, t.logged[k] != 0);
        }
        for (int i = 0; i < lanes && !common_; ++i) {
            const Ticks& t = *run_[i]->ticks;
            const std::size_t k = mechanics_.tick(i);
            read.set(i, t.position[k]), step.set(i, t.step[k]), logged.set(i, t.logged[k] != 0);
        }
        const P error = read - mechanics_.reading(), zero(0.0);
        const P T = min(since_, longest_);
        mechanics_.correct(select(logged, error, zero), 1.6 * omega_ * T, omega_ * omega_ * T);
        since_ = select(logged, zero, since_) + step;
        for (int i = 0; i < lanes; ++i)
            if (goes_[i] && logged[i]) run_[i]->position[mechanics_.tick(i)] = error[i];
        if (asks_more_ || asks_effort_) tell_effort();
        mechanics_.advance();
    }

    void tell_effort()
    {
        const P effort = mechanics_.effort_now(), velocity = mechanics_.seen_velocity();
        for (int i = 0; i < lanes; ++i) {
            if (!goes_[i]) continue;
            const Run& r = *run_[i];
            const std::size_t k = mechanics_.tick(i);
            if (r.effort) r.effort[k] = r.ticks->effort[k] - effort[i];  // NaN where it was not measured
            if (r.predicted_effort) r.predicted_effort[k] = effort[i], r.predicted_velocity[k] = velocity[i];
        }
    }

    Mechanics<P, K> mechanics_;
    const Run* run_[lanes]{};
    bool goes_[lanes]{};
    bool common_ = false;
    int first_ = 0;  ///< of the lanes that go
    P since_ = 0, omega_ = 0, longest_ = 0;
    bool asks_more_ = false, asks_effort_ = false;
};

/// Friction of one level and one slope, which most joints have.
inline constexpr Terms plain_friction{.plain = true, .one_slope = true};
inline constexpr Form one_mass{.motor = plain_friction, .link = plain_friction};
inline constexpr Form two_masses{.two_mass = true, .motor = plain_friction, .link = plain_friction};
inline constexpr Form with_backlash{
    .two_mass = true, .has_backlash = true, .motor = plain_friction, .link = plain_friction};

/// Takes runs through in lanes of this kind, by a time step that has nothing but what they need where it was built.
template <class P>
void through(std::span<const Run> runs, const Kind& kind)
{
    const auto known = [&]<Form form>() {
        if (!(static_cast<const Form&>(kind) == form)) return false;
        Observer<P, KindOf<form>>(kind).through(runs);
        return true;
    };
    if (known.template operator()<one_mass>() || known.template operator()<two_masses>() ||
        known.template operator()<with_backlash>())
        return;
    Observer<P>(kind).through(runs);
}

}  // namespace stickslip::gap
