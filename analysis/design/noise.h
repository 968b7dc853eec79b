// What sensor noise does to a controlled joint: motion of the link and effort of the actuator.
#pragma once
#include "analysis/stability/linear_joint.h"
#include "analysis/stability/real_response.h"

namespace stickslip {

/// White noise of each sample. The velocity comes from its own sensor, or is differenced from the noisy position.
struct SensorNoise {
    double position = 0;        ///< σ_x
    double velocity = not_set;  ///< σ_v of an own sensor; not set: differenced
    double period = not_set;    ///< sample time T
    double filter = 0;   ///< time constant τ of the velocity filter, v_k = v_{k−1} + T/(τ+T)(d_k − v_{k−1})
    double average = 1;  ///< positions averaged before the difference
};

/// rms motion of the link: (1/π ∫ |X/U|² |n_u|² dω)^½ with the command's noise held over each sample,
/// |n_u|² = T sinc²(ωT/2) (σ_x² |k_p + k_v H|²), H the difference and filter at z = e^{iωT}; with an own sensor
/// T sinc² (σ_x² k_p² + σ_v² k_v² |filter|²). The loop itself is taken as continuous. NaN for an unstable joint.
double motion_noise(const LinearJoint& joint, const SensorNoise& noise);

/// What noise does under the joint's own real loop, whose controller reads it. Of a sampled loop, exactly at the
/// samples: (1/π ∫_0^π |G n_u|² dφ)^½, G the motion per added command, n_u as above with k_i T/(1 − z⁻¹), and for the
/// effort 1/(1 + L) in place of G. Of a continuous loop as above, G with dead time and lag, the effort with the
/// mechanism held. NaN for an unstable loop.
struct LoopNoise {
    double motion = missing, effort = missing;
};
enum class NoiseOf { motion, effort, both };  ///< what is asked for; NaN for the other
LoopNoise loop_noise(const Joint& joint, const LoopResponse& response, const SensorNoise& noise,
                     NoiseOf asked = NoiseOf::both);

/// rms command, k_p n_x + k_v n_v, over all frequencies of the sampled loop, the mechanism held.
double effort_noise(const LinearJoint& joint, const SensorNoise& noise);

}  // namespace stickslip
