#include "analysis/diagnosis/plant/record_form.h"

#include <optional>

namespace stickslip::gap {
namespace {

/// m/s: far below what an encoder resolves, and below the least speed of a step that leaves rest.
constexpr double gone_at_once = 1e-12;  // numerical: a limit of a law

std::optional<Friction> written_out(Friction f, const LuGre& law)
{
    if (f.has_bristle()) return std::nullopt;
    f.law = Stribeck{law.coulomb, law.sigma2, law.breakaway - law.coulomb, law.stribeck_velocity, 2};
    f.bristle = {law.sigma0, law.sigma1};
    return f;
}

std::optional<Friction> written_out(Friction f, const Dahl& law)
{
    if (f.has_bristle() || law.exponent != 1) return std::nullopt;
    f.law = CoulombViscous{law.coulomb, 0};
    f.bristle = {law.sigma0, 0};
    return f;
}

std::optional<Friction> written_out(Friction f, const RateAndStateRegularised& law)
{
    if (f.has_memory() || f.has_lag() || law.B.size > 1) return std::nullopt;
    f.law = CoulombViscous{law.f0, 0};
    f.memory.A = law.A, f.memory.V_star = law.V_star, f.memory.form = law.evolution;
    if (law.B.size == 1) f.memory.B = law.B[0], f.memory.L = law.L[0];
    return f;
}

std::optional<Friction> written_out(Friction f, const Ageing& law)
{
    if (f.has_memory() || f.has_lag() || law.B.size > 1) return std::nullopt;
    f.law = CoulombViscous{law.f0, 0};
    f.memory.A = law.A, f.memory.V_star = law.V_star, f.memory.form = MemoryForm::ageing;
    if (law.B.size == 1) f.memory.B = law.B[0], f.memory.L = law.L[0];
    return f;
}

std::optional<Friction> written_out(Friction f, const KineticStatic& law)
{
    f.law = law.breakaway > law.kinetic
                ? FrictionLaw(Stribeck{law.kinetic, 0, law.breakaway - law.kinetic, gone_at_once, 2})
                : FrictionLaw(CoulombViscous{law.kinetic, 0});
    return f;
}

template <class Law>
std::optional<Friction> written_out(const Friction&, const Law&)
{
    return std::nullopt;
}

std::optional<Friction> written_out(const Friction& f)
{
    return std::visit([&](const auto& law) { return written_out(f, law); }, f.law);
}

template <class JointType, class Take>
void each_friction(JointType& joint, Take&& take)
{
    if (joint.mechanism.model == Model::single_mass) return take(joint.friction);
    take(joint.frictions.motor), take(joint.frictions.link);
}

}  // namespace

Joint record_form(const Joint& joint)
{
    Joint written = joint;
    each_friction(written, [](Friction& f) {
        if (auto other = written_out(f)) f = *other;
    });
    return written;
}

std::string rewritten_law(const Joint& joint)
{
    std::string name;
    each_friction(joint, [&](const Friction& f) {
        if (name.empty() && written_out(f)) name = info(f.law).name;
    });
    return name;
}

std::vector<std::string> left_out_of_records(const Joint& joint)
{
    std::vector<std::string> keys;
    const auto& n = joint.normal;
    if (n.displacement != 0) keys.emplace_back("normal.displacement");
    if (n.velocity != 0) keys.emplace_back("normal.velocity");
    if (n.acceleration != 0) keys.emplace_back("normal.acceleration");
    if (n.from_load != 0) keys.emplace_back("normal.from_load");
    if (joint.neighbour.size > 0) keys.emplace_back("neighbour");
    return keys;
}

}  // namespace stickslip::gap
