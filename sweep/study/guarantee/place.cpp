#include "sweep/study/guarantee/place.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace stickslip::guarantee {
namespace {

const char* model_name(Model model)
{
    switch (model) {
        case Model::single_mass:
            return "single-mass";
        case Model::two_mass:
            return "two-mass";
        case Model::three_mass:
            return "three-mass";
        default:
            return "lever";
    }
}

std::string kind_of(const Joint& joint)
{
    const auto& control = joint.control;
    std::string kind = joint.mechanism.motion == Motion::revolute ? "revolute " : "prismatic ";
    kind += model_name(joint.mechanism.model);
    kind += joint.actuator.kind == ActuatorKind::dc_motor ? ", dc-motor" : ", effort";
    kind += control.structure == Structure::cascade ? ", cascade" : control.k_i > 0 ? ", pid" : ", pd";
    return kind + (joint.load.gravity_amplitude != 0 ? ", gravity" : "");
}

double median_step(const std::vector<Record>& records)
{
    std::vector<double> steps;
    for (const auto& r : records)
        for (std::size_t k = 1; k < r.time.size(); ++k) steps.push_back(r.time[k] - r.time[k - 1]);
    if (steps.empty()) return missing;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// Noise and step of the encoder, as the joint states them, as a part of the travel.
double noise_of_travel(const Joint& joint, const std::vector<Record>& records)
{
    double travel = 0;
    for (const auto& r : records)
        if (!r.position.empty()) {
            const auto [low, high] = std::ranges::minmax(r.position);
            travel = std::max(travel, high - low);
        }
    const double stated = std::hypot(joint.sensor.position_noise, joint.sensor.encoder_quantum / std::sqrt(12.0));
    return stated > 0 && travel > 0 ? stated / travel : missing;
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : " ") + name;
    return text;
}

struct Number {
    const char* name;
    double Place::*value;
};

constexpr Number numbers[] = {{"records", &Place::records}, {"duration", &Place::duration},
                              {"period", &Place::period},   {"step", &Place::step},
                              {"noise", &Place::noise},     {"bandwidth", &Place::bandwidth}};

/// Least and largest of a draw are not those of its population. Reason: of 59 draws one in thirty lies beyond either.
constexpr double beyond = 1.25;

/// A number that some of the population do not state may be missing; one that none states may be anything.
void compare(const Place& place, const std::vector<const Place*>& alike, std::vector<Stranger>& found)
{
    for (const auto& [name, value] : numbers) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        bool unstated = false;
        for (const auto* other : alike) {
            const double x = other->*value;
            std::isnan(x) ? void(unstated = true) : void((low = std::min(low, x), high = std::max(high, x)));
        }
        const double own = place.*value;
        const bool missing = std::isnan(own);
        if (low > high || (missing && unstated)) continue;
        if (missing || own < low / beyond || own > high * beyond)
            found.push_back({.why = Stranger::Why::range, .number = name, .value = own, .low = low, .high = high});
    }
}

/// What the population has in place of what is missing in it.
template <class Get>
std::string known(const std::vector<const Place*>& places, Get get)
{
    std::set<std::string> different;
    for (const auto* place : places) different.insert(get(*place));
    std::string text;
    for (const auto& one : different) text += (text.empty() ? "" : "; ") + one;
    return text;
}

}  // namespace

Place place_of(const Joint& joint, const std::vector<Record>& records, std::vector<std::string> columns)
{
    Place place;
    place.kind = kind_of(joint);
    place.columns = std::move(columns);
    place.noise_documented = joint.sensor.position_noise > 0;
    place.records = static_cast<double>(records.size());
    for (const auto& r : records)
        if (!r.time.empty()) place.duration += r.time.back() - r.time.front();
    place.period = joint.control.period;
    place.step = median_step(records);
    place.noise = noise_of_travel(joint, records);
    const double stiffness = joint.control.k_p * joint.actuator.effort_gain, inertia = joint.mechanism.inertia;
    if (stiffness > 0 && inertia > 0) place.bandwidth = std::sqrt(stiffness / inertia);
    return place;
}

std::vector<Stranger> strangers(const Place& place, const std::vector<Place>& population)
{
    std::vector<const Place*> alike;
    for (const auto& other : population) alike.push_back(&other);
    std::vector<Stranger> found;
    const auto keep = [&](auto get, Stranger::Why why) {
        const std::string own = get(place);
        std::vector<const Place*> same;
        for (const auto* other : alike)
            if (get(*other) == own) same.push_back(other);
        if (same.empty())
            found.push_back({.why = why, .given = own, .known = known(alike, get)});
        else
            alike = std::move(same);
    };
    keep([](const Place& p) { return p.kind; }, Stranger::Why::kind);
    keep([](const Place& p) { return listed(p.columns); }, Stranger::Why::columns);
    keep([](const Place& p) { return std::string(p.noise_documented ? "stated" : "not stated"); },
         Stranger::Why::noise);
    if (found.empty()) compare(place, alike, found);
    return found;
}

}  // namespace stickslip::guarantee
