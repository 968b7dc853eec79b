#include "sweep/report/pages/robot_report.h"

#include "analysis/results/point.h"
#include "analysis/results/text.h"
#include "sweep/words/diagnosis_tables.h"
#include "sweep/words/diagnosis_text.h"
#include "sweep/words/effect_words.h"
#include "sweep/words/robot_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Tone = Headline::Tone;
using Status = JointOutcome::Status;

/// Shares below it read as 0 %.
constexpr double worth_telling = 0.005;

bool found(const JointOutcome& joint, Verdict verdict)
{
    return joint.status == Status::diagnosed && joint.diagnosis.verdict == verdict;
}

/// The page of a joint, where it has one.
std::string link_of(const JointOutcome& joint, bool linked)
{
    return linked && joint.status == Status::diagnosed ? joint.name + "/report.html" : "";
}

/// Names of effects that any joint was found to have, those of the largest share first.
std::vector<std::string> effects_of(const RobotAnswer& robot)
{
    std::vector<std::pair<std::string, double>> largest;
    for (const auto& joint : robot.joints)
        for (const auto& cause : named_causes(joint.diagnosis))
            for (const auto& name : cause.names) {
                const auto same = std::find_if(largest.begin(), largest.end(),
                                               [&](const auto& entry) { return entry.first == name; });
                if (same == largest.end())
                    largest.emplace_back(name, cause.share);
                else
                    same->second = std::max(same->second, cause.share);
            }
    std::stable_sort(largest.begin(), largest.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::vector<std::string> names;
    for (const auto& [name, share] : largest) names.push_back(name);
    return names;
}

struct Cell {
    std::string text;
    double share = missing;
};

/// Of causes that only act together the share stands at each, and says with which.
Cell cell_of(const std::vector<CauseShare>& causes, const std::string& effect)
{
    for (const auto& cause : causes) {
        if (std::find(cause.names.begin(), cause.names.end(), effect) == cause.names.end()) continue;
        std::vector<std::string> others;
        for (const auto& name : cause.names)
            if (name != effect) others.push_back(name);
        return {whole_percent(cause.share) + (others.empty() ? "" : " with " + together(others)), cause.share};
    }
    return {};
}

/// Of a joint whose gap has no name all of it remains.
Cell remainder_of(const JointOutcome& joint)
{
    if (joint.ended_early()) return {};
    if (found(joint, Verdict::unknown)) return {"all of it", 1};
    if (!found(joint, Verdict::gap)) return {};
    double left = 1 - (joint.diagnosis.ladder.empty() ? 0 : joint.diagnosis.corrected_share);
    for (const auto& cause : named_causes(joint.diagnosis)) left -= cause.share;
    left = std::clamp(left, 0.0, 1.0);
    return {whole_percent(left), left};
}

Table causes_table_of(const RobotAnswer& robot, bool linked, TableMarks& all_marks)
{
    const auto effects = effects_of(robot);
    const bool refitted = std::any_of(robot.joints.begin(), robot.joints.end(), [](const auto& j) {
        return found(j, Verdict::gap) && !j.diagnosis.ladder.empty() && j.diagnosis.corrected_share > worth_telling;
    });
    Table t{"Share of each cause in the gap of each joint", {"joint", "outcome"}, {}};
    for (const auto& effect : effects) t.columns.push_back(effect_words(effect));
    if (refitted) t.columns.emplace_back("parameters refitted");
    t.columns.emplace_back("what remains");
    CellMarks& marks = all_marks[t.title];
    for (const auto& joint : robot.joints) {
        const auto causes = named_causes(joint.diagnosis);
        std::vector<Cell> cells{{joint.name}, {outcome_words(joint)}};
        for (const auto& effect : effects) cells.push_back(cell_of(causes, effect));
        const double share = joint.diagnosis.corrected_share;
        if (refitted)
            cells.push_back(found(joint, Verdict::gap) && !joint.diagnosis.ladder.empty() && share > worth_telling
                                ? Cell{whole_percent(share), share}
                                : Cell{});
        cells.push_back(remainder_of(joint));
        marks.links.push_back(link_of(joint, linked));
        t.rows.emplace_back();
        marks.shares.emplace_back();
        for (auto& cell : cells) {
            t.rows.back().push_back(std::move(cell.text));
            marks.shares.back().push_back(cell.share);
        }
    }
    return t;
}

std::string in_floors(double gap)
{
    return gap > 0 ? plain_number(gap, 3) : "–";
}

Table numbers_table(const RobotAnswer& robot, bool linked, TableMarks& marks)
{
    Table t{"Each joint's first cause",
            {"joint", "first cause", "probability", "cannot be distinguished from", "gap as documented",
             "gap with the cause"},
            {}};
    for (const auto& joint : robot.joints) {
        const auto& d = joint.diagnosis;
        const auto causes = named_causes(d);
        std::string rivals;
        for (const auto& names : d.ambiguous_with) rivals += (rivals.empty() ? "" : ", ") + together(names);
        t.rows.push_back({joint.name, causes.empty() ? "–" : together(causes[0].names),
                          causes.empty() ? "–" : whole_percent(causes[0].probability), rivals.empty() ? "–" : rivals,
                          in_floors(d.overall.before), causes.empty() ? "–" : in_floors(d.overall.after)});
        marks[t.title].links.push_back(link_of(joint, linked));
    }
    return t;
}

void add_alerts(const RobotAnswer& robot, Report& r)
{
    for (const auto& joint : robot.joints) {
        for (const auto& problem : joint.problems) r.alerts.push_back({Tone::bad, joint.name + ": " + problem});
        if (found(joint, Verdict::insufficient_data))
            for (const auto& reason : joint.diagnosis.reasons)
                r.alerts.push_back({Tone::warning, joint.name + ": " + note_text(reason)});
        if (joint.diagnosis.interrupted)
            r.alerts.push_back({Tone::warning, joint.name + ": interrupted; the results so far are shown"});
        else if (joint.lacks_gains)
            r.alerts.push_back({Tone::warning, joint.name + ": interrupted; its page lacks gains"});
        if (joint.status == Status::not_reached)
            r.alerts.push_back({Tone::warning, joint.name + ": interrupted before its turn"});
    }
}

std::vector<Headline> cards(const RobotAnswer& robot)
{
    const auto count = [&](auto&& among) { return std::count_if(robot.joints.begin(), robot.joints.end(), among); };
    const auto differ = count([](const auto& j) { return j.differs(); });
    const auto same = count([](const auto& j) { return found(j, Verdict::no_gap); });
    const auto rest = static_cast<std::ptrdiff_t>(robot.joints.size()) - differ - same;
    std::vector<Headline> all{
        {differ ? Tone::warning : Tone::neutral, std::to_string(differ),
         differ == 1 ? "joint differs from its file" : "joints differ from their files"},
        {same ? Tone::good : Tone::neutral, std::to_string(same),
         same == 1 ? "joint moves as documented, to the noise" : "joints move as documented, to the noise"}};
    if (rest)
        all.push_back({Tone::bad, std::to_string(rest),
                       rest == 1 ? "joint without a conclusion" : "joints without a conclusion"});
    const JointOutcome* worst = nullptr;
    for (const auto& joint : robot.joints)
        if (joint.differs() && (!worst || joint.diagnosis.overall.before > worst->diagnosis.overall.before))
            worst = &joint;
    if (worst && worst->diagnosis.overall.before > 0)
        all.push_back({Tone::neutral, worst->name,
                       fmt::format("has the largest gap: {} × the noise floor on held-out data",
                                   in_floors(worst->diagnosis.overall.before))});
    return all;
}

}  // namespace

RobotPage robot_report(const RobotAnswer& robot, std::vector<std::pair<std::string, std::string>> provenance,
                       bool linked)
{
    RobotPage page;
    Report& r = page.report;
    r.title = robot.title.empty() ? "Sim-to-real gap of a robot" : "Sim-to-real gap of " + robot.title;
    r.subtitle = robot.joints.size() == 1 ? "one joint" : std::to_string(robot.joints.size()) + " joints";
    r.verdict = robot_sentence(robot);
    const bool silent = std::any_of(robot.joints.begin(), robot.joints.end(), [](const auto& joint) {
        return !joint.differs() && !found(joint, Verdict::no_gap);
    });
    const bool differ =
        std::any_of(robot.joints.begin(), robot.joints.end(), [](const auto& joint) { return joint.differs(); });
    r.tone = silent ? Tone::bad : differ ? Tone::warning : Tone::good;
    r.headlines = cards(robot);
    add_alerts(robot, r);
    Section causes{
        "causes",
        "Joints and causes",
        "Each cell is the share of a cause in the squared gap of that joint beyond the noise, on held-out data, after "
        "the causes found before it. Shares of different joints do not add up. An empty cell: not named.",
        {},
        {causes_table_of(robot, linked, page.marks)}};
    if (linked) causes.text += " The name of a joint links to its page, with motions, intervals and rivals.";
    r.sections.push_back(std::move(causes));
    r.sections.push_back({"numbers",
                          "How large, and how sure",
                          "Gaps are multiples of the noise floor on held-out data: noise alone makes 1.",
                          {},
                          {numbers_table(robot, linked, page.marks)}});
    r.sections.push_back(
        {"data",
         "Data",
         "robot.json beside this page holds these numbers under stable names; the folder of each joint "
         "has its diagnosis.json and, where a cause was named, corrected-joint.toml.",
         {},
         {}});
    r.not_checked = {
        "Forces between joints, unless the records have them as load_effort and inertia: each joint was diagnosed "
        "alone, and a force that depends on other joints can look like a cause."};
    r.provenance = std::move(provenance);
    return page;
}

}  // namespace stickslip
