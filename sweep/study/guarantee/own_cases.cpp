#include "sweep/study/guarantee/own_cases.h"

#include "analysis/diagnosis/audit/prepare.h"
#include "analysis/diagnosis/audit/reading_noise.h"
#include "analysis/diagnosis/fit/fit.h"
#include "analysis/diagnosis/plant/simulator.h"
#include "analysis/numerics/seeded_noise.h"
#include "analysis/simulation/sampled/loop_record.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stickslip::guarantee {
namespace {

/// What the cause makes, as a multiple of what the rest of the machine makes (at least twice the noise floor): as in
/// the dirty blind cases of tests/blind. Less is no cause of the gap but one of the things that a document is off by.
constexpr double least_multiple = 1.5, most_multiple = 4, least_rest = 2;
/// By how much documents of machines are off.
constexpr double least_off = 0.02, most_off = 0.1;

class Draw {
  public:
    explicit Draw(std::uint64_t seed) : noise_(seed) {}
    double between(double low, double high) { return low + (high - low) * noise_.uniform(); }
    double log_between(double low, double high) { return low * std::pow(high / low, noise_.uniform()); }
    double sign() { return noise_.uniform() < 0.5 ? -1 : 1; }
    std::size_t below(std::size_t n)
    {
        return std::min(n - 1, static_cast<std::size_t>(noise_.uniform() * static_cast<double>(n)));
    }
    double off() { return sign() * between(least_off, most_off); }

  private:
    SeededNoise noise_;
};

/// A seed of its own for every item of a stream.
std::uint64_t seed_of(std::uint64_t seed, std::uint64_t item)
{
    constexpr std::uint64_t prime = 0x100000001B3ull;
    return seed * prime + item + 1;
}

/// As a machine is beside its document.
Joint not_quite(Joint joint, Draw& draw)
{
    for (double* inertia : {&joint.mechanism.inertia, &joint.mechanism.motor_inertia, &joint.mechanism.link_inertia})
        if (*inertia > 0) *inertia *= 1 + draw.off();
    Friction& friction = gap::main_friction(joint);
    gap::shift_coulomb(friction, draw.off() * gap::coulomb_force(friction));
    gap::shift_viscous(friction, draw.off() * gap::viscous_slope(friction));
    joint.load.gravity_amplitude *= 1 + draw.off();
    return joint;
}

/// With the numbers that held in each record.
std::vector<Joint> in_records(const Joint& joint, const std::vector<Record>& records)
{
    std::vector<Joint> joints;
    for (const auto& r : records) joints.push_back(gap::joint_in(r, joint));
    return joints;
}

std::vector<const gap::EffectForm*> forms_of(const gap::Effect& effect, const Joint& joint)
{
    std::vector<const gap::EffectForm*> forms;
    for (const auto& form : effect.forms)
        if (form.apply && (!form.applies || form.applies(joint))) forms.push_back(&form);
    return forms;
}

/// Parameters about a seed of the catalogue, in units of their scales; what a frequency search would find is drawn
/// about what is usual.
std::vector<double> drawn_parameters(const gap::Candidate& candidate, Draw& draw)
{
    constexpr double twice = 2, least = 0.05, most = 5;
    const gap::EffectForm& form = *candidate.forms[0];
    const auto* seed = form.seeds.empty() ? nullptr : &form.seeds[draw.below(form.seeds.size())];
    const double size = draw.log_between(least, most);
    std::vector<double> scaled;
    for (std::size_t i = 0; i < candidate.parameter_count(); ++i) {
        const auto& p = candidate.parameter(i);
        double x = seed && i < seed->size() ? (*seed)[i] : 0;
        if (x == 0) x = p.prior * (p.logarithmic || p.low >= 0 ? 1 : draw.sign());
        const bool change = !p.logarithmic && p.low < 0;
        if (p.factor)
            x = std::pow(x, size * draw.log_between(1, twice));
        else
            x *= (change || i == 0 ? size : 1) * draw.log_between(1 / twice, twice);
        scaled.push_back(std::clamp(x, p.low, p.high));
    }
    return scaled;
}

/// Mean square of each signal of the loop, of the difference of two runs, summed over records.
struct Squares {
    double position = 0, command = 0;
    void add(const gap::Trace& one, const gap::Trace& other)
    {
        for (std::size_t k = 0; k < one.position.size(); ++k) {
            position += std::pow(one.position[k] - other.position[k], 2);
            command += std::pow(one.command[k] - other.command[k], 2);
        }
    }
};

/// By how much the loop of `with` misses that of `without`, as a multiple of the noise floor.
double gap_between(const std::vector<Joint>& without, const std::vector<Joint>& with,
                   const std::vector<Record>& records)
{
    Squares floor, gap;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const auto ticks = gap::on_clock(records[i], without[i]);
        const auto plant = gap::flatten(without[i]);
        const auto one = gap::simulate_closed_loop(plant, ticks, 1);
        floor.add(one, gap::simulate_closed_loop(plant, ticks, 2));
        gap.add(one, gap::simulate_closed_loop(gap::flatten(with[i]), ticks, 3));
    }
    const double position = gap.position / std::max(floor.position, 1e-300),
                 command = gap.command / std::max(floor.command, 1e-300);
    return std::sqrt(0.5 * (position + command));
}

/// The rows of what the loop did at which the user's log has rows, in the user's columns.
Record as_logged(const LoopRecord& run, const Record& like, const Joint& joint)
{
    Record r;
    r.name = like.name;
    r.overrides = like.overrides;
    r.at_rest_at_start = true;
    const bool drive = joint.actuator.kind == ActuatorKind::dc_motor;
    std::size_t k = 0;
    for (std::size_t row = 0; row < like.time.size() && k < run.time.size(); ++row) {
        const double t = like.time[row] - like.time[0];
        while (k + 1 < run.time.size() && run.time[k + 1] - run.time[0] <= t + 0.5 * joint.control.period) ++k;
        r.time.push_back(run.time[k] - run.time[0]);
        const auto take = [&](std::vector<double> Record::*column, const std::vector<double>& from) {
            if (!(like.*column).empty()) (r.*column).push_back(from[k]);
        };
        take(&Record::reference_position, run.reference_position);
        take(&Record::reference_velocity, run.reference_velocity);
        take(&Record::position, run.position);
        take(&Record::velocity, run.velocity);
        take(drive ? &Record::drive : &Record::effort_command, run.effort_command);
        take(&Record::effort_measured, run.effort_measured);
        if (!run.feed_forward.empty()) take(&Record::feed_forward, run.feed_forward);
    }
    return r;
}

ReferenceMotion reference_of(const Record& r)
{
    ReferenceMotion reference{r.time, r.reference_position, r.reference_velocity, r.feed_forward};
    for (auto& t : reference.time) t -= r.time[0];
    return reference;
}

/// Everything that has no place in a simulated record.
const char* unplayable(const Record& r)
{
    if (r.reference_position.empty()) return "no reference_position";
    if (r.position.empty()) return "no position";
    if (!r.load_effort.empty() || !r.inertia.empty())
        return "a known load or inertia, which the simulation does not play";
    if (!r.link_position.empty() || !r.current.empty())
        return "a second encoder or a current, which the simulation does not log";
    return nullptr;
}

}  // namespace

std::vector<std::string> possible_causes(const Joint& joint)
{
    std::vector<std::string> names;
    for (const auto& effect : gap::effects())
        if (!forms_of(effect, joint).empty()) names.emplace_back(effect.name);
    return names;
}

OwnCases::OwnCases(const Joint& joint, const std::vector<Record>& records) : joint_(joint), records_(records)
{
    if (!is_set(joint.control.period)) throw std::invalid_argument("control.period is missing: no loop to play");
    std::vector<Note> notes;
    std::vector<gap::Case> cases;
    double noise = 0;
    for (const auto& r : records) {
        if (const char* why = unplayable(r)) throw std::invalid_argument(r.name + ": has " + why);
        cases.push_back(gap::prepare(r, gap::joint_in(r, joint), notes));
        noise = std::max(noise, gap::noise_of(r.position));
    }
    scales_ = gap::scales_of(cases);
    if (joint_.sensor.position_noise == 0) joint_.sensor.position_noise = noise;
    causes_ = possible_causes(joint);
    causes_.emplace_back();  // none
}

double OwnCases::rows() const
{
    double rows = 0;
    for (const auto& r : records_) rows += static_cast<double>(r.rows());
    return rows;
}

std::optional<OwnCase> OwnCases::make(std::uint64_t seed, std::uint64_t n) const
{
    const auto round = n / causes_.size();
    auto order = causes_;
    Draw shuffled(seed_of(seed, ~round));
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[shuffled.below(i)]);
    const std::string& cause = order[n % causes_.size()];
    Draw draw(seed_of(seed, n));
    const Joint machine = not_quite(joint_, draw);
    const auto without = in_records(machine, records_);
    auto joints = without;
    OwnCase made;
    made.truth.dirty = true;
    made.truth.verdict = cause.empty() ? "no-gap" : "gap";
    made.truth.equivalent =
        cause.empty() ? blind::EffectSet{"inertia", "coulomb-level", "viscous", "gravity"} : blind::EffectSet{};
    if (!cause.empty()) {
        made.truth.effects = {cause};
        const auto forms = forms_of(*gap::effect_named(cause), joint_);
        constexpr int tries = 60;
        const std::vector<Joint> documented = in_records(joint_, records_);
        const double rest = std::max(least_rest, gap_between(documented, without, records_));
        bool shows = false;
        for (int i = 0; i < tries && !shows; ++i) {
            gap::Candidate candidate{{gap::effect_named(cause)}, {forms[draw.below(forms.size())]}, records_.size()};
            const auto si = gap::in_si(candidate, gap::to_fit(candidate, drawn_parameters(candidate, draw)), scales_);
            for (std::size_t r = 0; r < joints.size(); ++r) joints[r] = gap::edited(without[r], candidate, si, r);
            const double gap = gap_between(without, joints, records_);
            shows = gap >= least_multiple * rest && gap <= most_multiple * rest;
        }
        if (!shows) return std::nullopt;
    }
    for (std::size_t r = 0; r < records_.size(); ++r) {
        const auto run = record_along(joints[r], reference_of(records_[r]), seed_of(seed_of(seed, n), r));
        if (run.reason != Reason::none || run.time.empty()) return std::nullopt;
        made.records.push_back(as_logged(run, records_[r], joints[r]));
    }
    return made;
}

}  // namespace stickslip::guarantee
