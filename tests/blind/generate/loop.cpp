#include "tests/blind/generate/loop.h"

#include "tests/blind/generate/plant.h"
#include "tests/blind/generate/random.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

namespace blind {
namespace {

constexpr double runaway = 100;        // times the largest reference: the loop is unstable
constexpr double same_instant = 1e-9;  // s

/// Dead time and lag behind the command. Commands take effect `dead_time` after they were given.
class Chain {
  public:
    explicit Chain(const Drive& drive) : drive_(drive) { signal_.lag = drive.lag; }

    void give(double t, double command) { waiting_.push_back({t + drive_.dead_time, command}); }
    /// Lets the command take effect whose time has come, if there is one.
    void update(double t)
    {
        while (!waiting_.empty() && waiting_.front().first <= t + same_instant) {
            signal_.lagged = signal_.at(t);
            signal_.begin = t;
            signal_.level = waiting_.front().second;
            waiting_.pop_front();
        }
    }
    double next_change(double end) const { return waiting_.empty() ? end : std::min(end, waiting_.front().first); }
    const DriveSignal& signal() const { return signal_; }

  private:
    const Drive& drive_;
    DriveSignal signal_;
    std::deque<std::pair<double, double>> waiting_;
};

class Encoder {
  public:
    Encoder(const Sensors& sensors, std::uint64_t seed) : s_(sensors), draw_(seed) {}
    double read(double q)
    {
        noise_ = s_.colour * noise_ + std::sqrt(1 - s_.colour * s_.colour) * draw_.normal();
        double noise = noise_;
        if (s_.spikes > 0 && draw_.chance(s_.spikes)) noise += 10 * draw_.sign();
        const double y = s_.scale * q + s_.offset + s_.position_noise * noise;
        return s_.quantum > 0 ? std::round(y / s_.quantum) * s_.quantum : y;
    }

  private:
    const Sensors& s_;
    Draw draw_;
    double noise_ = 0;
};

/// v_k = v_{k−1} + T/(τ+T) (d_k − v_{k−1}), d the backward difference of the mean of the last `average` readings.
class VelocityEstimate {
  public:
    VelocityEstimate(const Controller& c, double first)
        : step_(c.period), share_(c.period / (c.filter + c.period)), recent_(c.average, first), mean_(first)
    {
    }
    double update(double y)
    {
        recent_.pop_front();
        recent_.push_back(y);
        double mean = 0;
        for (double r : recent_) mean += r / recent_.size();
        v_ += share_ * ((mean - mean_) / step_ - v_);
        mean_ = mean;
        return v_;
    }

  private:
    double step_, share_, v_ = 0;
    std::deque<double> recent_;
    double mean_;
};

/// The law of a controller and its integral.
class Law {
  public:
    explicit Law(const Controller& c) : c_(c) {}
    double command(const Reference& ref, double y, double v)
    {
        const double error = ref.position - y;
        const double seen = error - std::clamp(error, -c_.dead_zone, c_.dead_zone);
        const double late = (c_.reference_velocity ? ref.velocity : 0) - v;
        double u = c_.coulomb * std::tanh(ref.velocity / c_.coulomb_speed);
        if (c_.cascade) {
            const double wanted = c_.position_gain * seen + late;
            sum_ += c_.period * wanted;
            u += c_.velocity_gain * wanted + c_.velocity_integral * sum_;
        } else {
            sum_ += c_.period * seen;
            u += c_.k_p * seen + c_.k_v * late + c_.k_i * sum_;
        }
        return std::clamp(u, -c_.limit, c_.limit);
    }

  private:
    const Controller& c_;
    double sum_ = 0;
};

}  // namespace

Record run_loop(const Machine& machine, const Excitation& excitation, std::uint64_t noise_seed, int stride)
{
    const auto& c = machine.controller;
    Plant plant(machine);
    const double start = excitation.at(0).position;
    plant.rest_at((start - machine.sensors.offset) / machine.sensors.scale);
    Chain chain(machine.drive);
    Encoder encoder(machine.sensors, seed_of(noise_seed, 0)), link_encoder(machine.sensors, seed_of(noise_seed, 1));
    Draw effort_noise(seed_of(noise_seed, 2));
    const int samples = static_cast<int>(std::floor(excitation.duration / c.period)) + 1;
    const int link = machine.mechanism.bodies - 1;
    double bound = 0;
    for (int k = 0; k < samples; k += 10) bound = std::max(bound, std::abs(excitation.at(k * c.period).position));

    double y = encoder.read(plant.position(0));
    VelocityEstimate estimate(c, y);
    Law law(c);
    Record r;
    for (int k = 0; k < samples; ++k) {
        const double t = k * c.period;
        if (k > 0) y = encoder.read(plant.position(0));
        const double v = k > 0 ? estimate.update(y) : 0;
        const Reference ref = excitation.at(t);
        const double command = law.command(ref, y, v);
        chain.give(t, command);
        chain.update(t);
        const DriveState drive = drive_effort(machine.drive, chain.signal().at(t), plant.velocity(0));
        const double noise[2] = {effort_noise.normal(), effort_noise.normal()};
        const double link_reading = link_encoder.read(plant.position(link));
        if (k % stride == 0) {
            r.time.push_back(t);
            r.reference_position.push_back(ref.position);
            r.reference_velocity.push_back(ref.velocity);
            r.position.push_back(y);
            r.velocity.push_back(v);
            r.command.push_back(command);
            r.effort.push_back(drive.effort + machine.sensors.effort_noise * noise[0]);
            if (machine.drive.kind != Drive::Kind::effort) {
                const double scale = machine.drive.torque_constant;
                r.current.push_back(drive.current + machine.sensors.effort_noise / scale * noise[1]);
                r.supply.push_back(drive.supply);
            }
            r.link_position.push_back(link_reading);
            r.true_position.push_back(plant.position(0));
            r.true_velocity.push_back(plant.velocity(0));
        }
        const double end = (k + 1) * c.period;
        while (plant.time() < end - same_instant) {
            plant.advance(chain.next_change(end), chain.signal());
            chain.update(plant.time());
        }
        if (!(std::abs(plant.position(0)) < runaway * (bound + 1e-3)))
            throw std::runtime_error("the loop of a case is unstable");
    }
    return r;
}

}  // namespace blind
