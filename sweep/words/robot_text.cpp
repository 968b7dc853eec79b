#include "sweep/words/robot_text.h"

#include "sweep/words/diagnosis_tables.h"

#include <fmt/format.h>

#include <functional>

namespace stickslip {
namespace {

using Status = JointOutcome::Status;

std::vector<std::string> names_of(const RobotAnswer& robot, const std::function<bool(const JointOutcome&)>& among)
{
    std::vector<std::string> names;
    for (const auto& joint : robot.joints)
        if (among(joint)) names.push_back(joint.name);
    return names;
}

std::string listed(const std::vector<std::string>& names)
{
    return fmt::format("{}", fmt::join(names, ", "));
}

bool is(const JointOutcome& joint, Verdict verdict)
{
    return joint.status == Status::diagnosed && joint.diagnosis.verdict == verdict;
}

}  // namespace

std::string causes_words(const Diagnosis& d)
{
    std::string text;
    for (const auto& cause : named_causes(d))
        text += fmt::format("{}{} ({}{})", text.empty() ? "" : ", then ", together(cause.names),
                            whole_percent(cause.share), text.empty() ? " of its gap" : "");
    return text.empty() ? "no effect of the catalogue" : text;
}

std::string outcome_words(const JointOutcome& joint)
{
    if (joint.status == Status::refused) return "refused";
    if (joint.status == Status::not_reached) return "not reached";
    if (joint.ended_early()) return "interrupted";
    if (joint.contradicted) return "units contradict each other";
    switch (joint.diagnosis.verdict) {
        case Verdict::gap:
            return "gap";
        case Verdict::no_gap:
            return "no gap";
        case Verdict::unknown:
            return "gap of unknown cause";
        case Verdict::insufficient_data:
            break;
    }
    return "too little data";
}

std::string robot_sentence(const RobotAnswer& robot)
{
    const auto all = robot.joints.size();
    const auto differ = names_of(robot, [](const auto& j) { return j.differs(); });
    const auto same = names_of(robot, [](const auto& j) { return is(j, Verdict::no_gap); });
    const auto poor = names_of(robot, [](const auto& j) { return is(j, Verdict::insufficient_data); });
    const auto refused = names_of(robot, [](const auto& j) { return j.status == Status::refused; });
    const auto early = names_of(robot, [](const auto& j) { return j.ended_early(); });
    const auto left = names_of(robot, [](const auto& j) { return j.status == Status::not_reached; });
    if (same.size() == all)
        return all == 1 ? "The joint moves as its file says."
                        : fmt::format("All {} joints move as their files say.", all);
    std::string text;
    for (const auto& joint : robot.joints)
        if (joint.differs()) text += (text.empty() ? "" : "; ") + joint.name + " by " + causes_words(joint.diagnosis);
    const auto told = differ.size() + same.size();  // what the others do is not known
    if (told == 0)
        text = all == 1 ? "The joint was not diagnosed." : fmt::format("None of {} joints was diagnosed.", all);
    else
        text = differ.empty() ? fmt::format("None of {} diagnosed joints differs from its file.", told)
                              : fmt::format("{} of {} joints {} from {}: {}.", differ.size(), all,
                                            differ.size() == 1 ? "differs" : "differ",
                                            differ.size() == 1 ? "its file" : "their files", text);
    if (!same.empty()) text += fmt::format(" {} {} as documented.", listed(same), same.size() == 1 ? "moves" : "move");
    if (!poor.empty()) text += fmt::format(" The records are not sufficient for {}.", listed(poor));
    if (!refused.empty()) text += fmt::format(" Not diagnosed: {}.", listed(refused));
    if (!early.empty()) text += fmt::format(" Interrupted at {}.", listed(early));
    if (!left.empty()) text += fmt::format(" Interrupted before {}.", listed(left));
    return text;
}

}  // namespace stickslip
