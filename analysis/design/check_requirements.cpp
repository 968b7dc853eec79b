#include "analysis/design/check_requirements.h"

#include "analysis/design/judge.h"
#include "analysis/stability/steady.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stickslip {

Requirements requirements_of(const Joint& joint)
{
    Requirements r;
    r.noise.position = std::hypot(joint.sensor.position_noise, joint.sensor.encoder_quantum / std::sqrt(12.0));
    r.noise.period = joint.control.period;
    r.noise.filter = joint.control.velocity_estimate.tau;
    r.noise.average = joint.control.velocity_estimate.average;
    r.effort_limit = joint.actuator.limit;
    if (joint.actuator.kind == ActuatorKind::effort)  // the controller's own limit is one of its signal
        r.effort_limit = std::min(r.effort_limit, joint.control.effort_limit * std::abs(joint.actuator.effort_gain));
    return r;
}

void check_sense(const Joint& joint, const Requirements& r)
{
    const auto refuse = [](const std::string& text) { throw std::invalid_argument(text); };
    const bool silent = !(r.noise.position > 0) && !(r.noise.velocity > 0), timeless = !(r.noise.period > 0);
    const std::string why_noise = "without noise every gain is equally good",
                      why_time = "noise of samples needs the time between them";
    if (silent && timeless)  // all that is missing at once
        refuse("position_noise (or velocity_noise) and requirements.sample_time: are not set; " + why_noise + ", and " +
               why_time);
    if (silent) refuse("position_noise: neither it nor velocity_noise is set, and " + why_noise);
    if (timeless) refuse("sample_time: is not set; " + why_time);
    if (joint.control.structure == Structure::cascade)
        refuse(
            "gains: design turns k_p and k_v, a cascade has neither alone; describe it by its sum of gains with "
            "control.structure = \"pid\"");
    if (loop_kind(joint) == LoopKind::sampled) {
        const auto& c = joint.control;
        const auto same = [&](const char* name, double asked, const char* key, double has) {
            constexpr double close = 1e-9;
            if (std::abs(asked - has) <= close * std::abs(has)) return;
            std::ostringstream text;
            text << name << ": is " << asked << ", but " << key << " of the loop that reads the sensor is " << has
                 << "; expected equal ones, or no " << name;
            refuse(text.str());
        };
        same("sample_time", r.noise.period, "control.period", c.period);
        same("filter", r.noise.filter, "control.velocity_estimate.tau", c.velocity_estimate.tau);
        same("average", r.noise.average, "control.velocity_estimate.average", c.velocity_estimate.average);
    }
    const auto range = gain_range(joint, r);
    const auto ends = [](const char* name, double low, double high, bool stated) {
        std::ostringstream text;
        text << name << "_from: is " << low << ", " << name << "_to is " << high
             << (stated ? "" : " (not stated, from the joint's own gains)") << "; expected a start below the end";
        return text.str();
    };
    if (!(range.k_p.low > 0 && range.k_p.low < range.k_p.high))
        refuse(ends("k_p", range.k_p.low, range.k_p.high, is_set(r.k_p_high)));
    if (!(range.k_v.low >= 0 && range.k_v.low < range.k_v.high))
        refuse(ends("k_v", range.k_v.low, range.k_v.high, is_set(r.k_v_high)));
    const auto steady = steady_sliding(joint);
    if (steady.reason == Reason::none && is_set(r.least_velocity) && !(r.least_velocity <= std::abs(steady.velocity))) {
        std::ostringstream text;
        text << "least_velocity: is " << r.least_velocity << ", above the commanded velocity " << steady.velocity
             << "; a joint that slides there says nothing of it";
        refuse(text.str());
    }
}

}  // namespace stickslip
