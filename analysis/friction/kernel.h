// Friction given by its impulse response: the linear law of the paper's §4, measured or assumed.
#pragma once
#include <string>

#include "analysis/friction/kernel_table.h"
#include "analysis/friction/response.h"

namespace stickslip {

/// One decaying part of the kernel: weight · e^{−rate t}.
struct KernelExponential {
    double weight = not_set, rate = not_set;

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number({"weight", Quantity::stiffness, any_finite, Need::required, "weight of the exponential in g"},
                     self.weight);
        visit.number({"rate", Quantity::rate, positive, Need::required, "decay rate"}, self.rate);
    }
};

/// f(t) = f0 + f_v v(t) − ∫ g(t') v(t − t') dt',  v = V − V*                                            (13)
/// g(t) = Σ w_i e^{−r_i t} + Σ w_j δ(t − τ_j) + table. Linear by definition, hence about one velocity: nothing is known
/// of it elsewhere, and no nonlinear outcome exists. The exponentials are its states, θ̇_i = −r_i θ_i − w_i v; delays
/// and table need the history of the velocity.
struct Kernel {
    double f0 = 0;
    double f_v = not_set;
    double V_star = 0;
    ShortList<KernelExponential, max_states> exponentials{};
    DelayList impulses{};
    std::string table_name;  ///< "table" in files: where the samples come from; the reader of files fills `samples`
    KernelTablePtr samples;

    static constexpr LawInfo info{
        .name = "kernel",
        .formula =
            "f = f0 + f_v (V - V_star) - int g(t') (V(t - t') - V_star) dt', "
            "g = sum weight exp(-rate t) + delays + table",
        .source = "Dupont 1991, (11)-(18); Rice & Ruina 1983",
        .validity = "small changes about the velocity at which it was found",
        .steady_state_dependence = true,
        .needs_history = true,
        .linear_only = true,
    };

    int states() const { return exponentials.size; }
    double steady_force(double V) const { return f0 + (f_v - integral()) * (V - V_star); }

    States steady_state(double V) const
    {
        States theta{};
        for (int i = 0; i < exponentials.size; ++i)
            theta[i] = -exponentials[i].weight / exponentials[i].rate * (V - V_star);
        return theta;
    }

    /// Delays and table as after a long time at V.
    FrictionResponse respond(double V, const States& theta) const
    {
        FrictionResponse r;
        r.force = f0 + (f_v - history_integral()) * (V - V_star);
        r.by_velocity = f_v;
        for (int i = 0; i < exponentials.size; ++i) {
            const auto& e = exponentials[i];
            r.force += theta[i];
            r.by_state[i] = 1;
            r.rate[i] = -e.rate * theta[i] - e.weight * (V - V_star);
            r.rate_by_velocity[i] = -e.weight;
            r.rate_by_state[i] = -e.rate;
        }
        return r;
    }

    DelayList delays(double) const { return impulses; }
    KernelTablePtr table() const { return samples; }

    std::string problem() const
    {
        if (!table_name.empty() && !samples) return "table = \"" + table_name + "\" has not been read";
        return samples ? samples->problem() : "";
    }

    template <class Self, class Visitor>
    static void fields(Self& self, Visitor& visit)
    {
        visit.number(
            Field{"f0", Quantity::effort, any_finite, Need::optional, "friction at V_star", Role::label}.called(
                "f_{0}", "friction at the reference velocity"),
            self.f0);
        visit.number(Field{"f_v", Quantity::damping, any_finite, Need::required, "direct velocity effect"}.called(
                         "f_{v}", "instantaneous velocity slope"),
                     self.f_v);
        visit.number(Field{"V_star", Quantity::velocity, any_finite, Need::optional, "velocity at which friction is f0",
                           Role::label}
                         .called("V*", "reference velocity"),
                     self.V_star);
        visit.rows("exponentials", "decaying parts of the kernel", self.exponentials);
        visit.rows("delays", "delayed parts of the kernel", self.impulses);
        // a walker that knows samples digests or fills them; for any other the table is a file name
        if constexpr (requires { visit.samples("table", "", self.table_name, self.samples); })
            visit.samples("table", "file with two columns, time and g", self.table_name, self.samples);
        else
            visit.text("table", "file with two columns, time and g", self.table_name);
    }

  private:
    double history_integral() const
    {
        double sum = samples ? samples->transform(0).real() : 0;
        for (const auto& d : impulses) sum += d.weight;
        return sum;
    }
    double integral() const
    {
        double sum = history_integral();
        for (const auto& e : exponentials) sum += e.weight / e.rate;
        return sum;
    }
};

}  // namespace stickslip
