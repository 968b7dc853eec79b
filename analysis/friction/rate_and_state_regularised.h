// Rate-and-state friction through rest and in reverse.
#pragma once
#include "analysis/friction/ageing.h"

namespace stickslip {

/// f = A asinh(V/(2V*) e^{ψ/A}) and its derivatives; ψ is what the contact resists at V*.
struct RegularisedForce {
    double force, by_velocity, by_level;
};

/// For |f| ≫ A this is (ψ + A ln(|V|/V*)) sgn V; at V = 0 it passes through zero with a steep but finite slope.
/// With u = sinh(f/A): ∂f/∂ψ = u/√(1+u²) = tanh(f/A), ∂f/∂V = A tanh(f/A)/V. Evaluated in logarithms, since e^{ψ/A}
/// overflows for hard contacts. Source: Rice & Ben-Zion (1996); Lapusta, Rice, Ben-Zion & Zheng (2000).
inline RegularisedForce regularised_force(double A, double V_star, double level, double V)
{
    if (V == 0) return {0, A / (2 * V_star) * std::exp(level / A), 0};
    const double exponent = std::log(std::abs(V) / (2 * V_star)) + level / A;  // ln |u|
    constexpr double far = 18;  // asinh u = ln 2u to the last digit for ln u > 18
    const double magnitude = A * (exponent > far ? exponent + std::log(2.0) : std::asinh(std::exp(exponent)));
    const double saturation = std::tanh(magnitude / A);
    return {std::copysign(magnitude, V), A * saturation / std::abs(V), std::copysign(saturation, V)};
}

enum class MemoryForm { slip, ageing };
inline constexpr Choice<MemoryForm> memory_forms[] = {{"slip", MemoryForm::slip}, {"ageing", MemoryForm::ageing}};

/// The evolution of a state at the speed |V|, by either law.
inline Evolution evolve(MemoryForm law, double B, double L, double V_star, double speed, double theta)
{
    return law == MemoryForm::slip ? slip_evolution(B, L, speed, std::log(speed / V_star), theta)
                                   : ageing_evolution(B, L, V_star, speed, theta);
}

/// f = A asinh(V/(2V*) e^{(f0 + Σ θ_i)/A}), states after (5) or the ageing law at the speed |V|. In fast sliding it is
/// the logarithmic law, in both directions; at rest, states in hand, it is a function of V rather than a set.
/// Steady sliding keeps the singularity of ln |V| at V = 0: there a contact with B > A strengthens without end.
struct RateAndStateRegularised : RateStateParameters {
    MemoryForm evolution = MemoryForm::slip;

    static constexpr LawInfo info{
        .name = "rate-and-state-regularised",
        .formula = "f = A asinh(V/(2 V*) exp((f0 + sum theta_i)/A)), theta_i as in the slip or ageing law at |V|",
        .source = "Rice & Ben-Zion 1996; Lapusta et al. 2000",
        .validity = "all velocities; steady sliding V ≠ 0",
        .steady_state_dependence = true,
        .direct_effect = true,
        .slip_distance = true,
        .odd = true,
        .dissipative = true,
    };

    States steady_state(double V) const { return RateStateParameters::steady_state(std::abs(V)); }
    double steady_force(double V) const { return regularised_force(A, V_star, level(steady_state(V)), V).force; }

    FrictionResponse respond(double V, const States& theta) const
    {
        const auto contact = regularised_force(A, V_star, level(theta), V);
        const double speed = std::abs(V), direction = V == 0 ? 0 : std::copysign(1.0, V);
        FrictionResponse r;
        r.force = contact.force;
        r.by_velocity = contact.by_velocity;
        for (int i = 0; i < B.size; ++i) {
            const auto change = evolve(evolution, B[i], L[i], V_star, speed, theta[i]);
            r.by_state[i] = contact.by_level;
            r.rate[i] = change.rate;
            r.rate_by_velocity[i] = direction * change.by_speed;
            r.rate_by_state[i] = change.by_state;
        }
        return r;
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        RateStateParameters::fields(self, visit);
        visit.choice("evolution", "how the states change", self.evolution, memory_forms);
    }

  private:
    double level(const States& theta) const
    {
        double sum = f0;
        for (int i = 0; i < B.size; ++i) sum += theta[i];
        return sum;
    }
};

}  // namespace stickslip
