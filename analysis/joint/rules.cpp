#include "analysis/joint/rules.h"

#include <variant>

namespace stickslip {
namespace {

/// Visits every table and law of a joint and no number.
struct RuleWalk {
    bool obeyed = true;

    template <class Struct>
    void judge(const Struct& s)
    {
        if constexpr (requires { s.problem(); }) obeyed = obeyed && s.problem().empty();
    }
    /// A form of estimate that nobody stated is a file's concern: no number along an axis brings it about, and joints
    /// that are built in code have the usual one.
    void judge(const Control& control)
    {
        if (!is_set(control.period) || control.velocity_estimate.form != EstimateForm::unstated) {
            obeyed = obeyed && control.problem().empty();
            return;
        }
        Control stated = control;
        stated.velocity_estimate.form = EstimateForm::backward_difference;
        judge(stated);
    }
    void number(const Field&, double) {}
    void numbers(const Field&, const NumberList&) {}
    void flag(std::string_view, std::string_view, bool) {}
    void text(std::string_view, std::string_view, const std::string&) {}
    void samples(std::string_view, std::string_view, const std::string&, const KernelTablePtr&) {}
    template <class Enum, std::size_t n>
    void choice(std::string_view, std::string_view, Enum, const Choice<Enum> (&)[n])
    {
    }
    template <class Struct>
    void table(std::string_view, std::string_view, const Struct& s)
    {
        Struct::fields(s, *this);
        judge(s);
    }
    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view help, const ShortList<Struct, capacity>& list)
    {
        for (int i = 0; i < list.size; ++i) table(key, help, list[i]);
    }
    template <class Law>
    void law(const Law& law)
    {
        std::visit(
            [this](const auto& l) {
                std::decay_t<decltype(l)>::fields(l, *this);
                judge(l);
            },
            law);
    }
};

}  // namespace

bool obeys_rules(const Joint& joint)
{
    RuleWalk walk;
    Joint::fields(joint, walk);
    walk.judge(joint);
    return walk.obeyed;
}

}  // namespace stickslip
