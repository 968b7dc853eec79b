#include "sweep/program/verbs/guarantee_option.h"

#include "sweep/engine/build.h"
#include "sweep/files/json/calibration_json.h"
#include "sweep/files/records/signals.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/study/guarantee/order_statistic.h"
#include "sweep/study/guarantee/own_cases.h"
#include "sweep/words/guarantee_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace stickslip {
namespace {

constexpr double confidence = 0.95;

/// What a calibration lacks for this joint.
std::vector<std::string> what_is_missing(const Guarantee& g, const Joint& joint, const std::vector<Record>& records)
{
    std::vector<std::string> why;
    if (g.calibration.method != method_hash())
        why.push_back("it was answered by other sources of the diagnosis (" + g.calibration.method + ", here " +
                      method_hash() + "); answer its cases again");
    if (!g.calibration.joint.empty() && g.calibration.joint != hash_of(joint))
        why.push_back(stranger_text({.why = guarantee::Stranger::Why::joint}));
    std::vector<guarantee::Place> population;
    for (const auto& c : g.calibration.cases) population.push_back(c.place);
    for (const auto& stranger : guarantee::strangers(place_among(joint, records), population))
        why.push_back(stranger_text(stranger));
    if (!g.promise.kept) why.push_back(too_few_cases_text(g.promise));
    return why;
}

}  // namespace

void GuaranteeOption::add_to(Verb& verb)
{
    verb.add_option("--guarantee", coverage,
                    "also give a set of causes that contains the true one for this share of such joints, for example "
                    "0.95; needs --calibration")
        ->check(between(0.5, 0.999));
    verb.add_option("--calibration", files,
                    "answered cases of joints like this one, of calibrate or of blind --calibration; several files "
                    "count as one")
        ->one_value()
        ->check(existing_file());
}

guarantee::Place place_among(const Joint& joint, const std::vector<Record>& records)
{
    std::vector<std::string> columns;
    for (const auto& signal : signals())
        if (std::ranges::all_of(records, [&](const Record& r) { return !(r.*(signal.column)).empty(); }) &&
            std::ranges::count(columns, std::string(signal.name)) == 0)
            columns.emplace_back(signal.name);
    return guarantee::place_of(joint, records, std::move(columns));
}

std::optional<Guarantee> guarantee_for(const GuaranteeOption& option, const Joint& joint,
                                       const std::vector<Record>& records)
{
    if (!option.asked()) {
        if (!option.files.empty()) throw BadInput("--calibration: is for --guarantee, which was not given");
        return std::nullopt;
    }
    const int needed = guarantee::fewest_that_cover(option.coverage, confidence);
    if (option.files.empty())
        throw BadInput(fmt::format(
            "--guarantee {:g}: needs --calibration FILE, at least {} answered cases of joints like this one; "
            "stickslip calibrate JOINT RECORD -o calibration.json makes them on this joint",
            option.coverage, needed));
    Guarantee g;
    g.calibration = read_calibrations(option.files);
    g.promise = guarantee::promise_of(g.calibration, option.coverage, confidence);
    auto why = what_is_missing(g, joint, records);
    if (why.empty()) return g;
    for (auto& text : why)
        text = fmt::format("--guarantee {:g}: no promise from {}: {}", option.coverage, option.files.front(), text);
    throw BadInput(why);
}

blind::Answer answer_of(const Diagnosis& d)
{
    blind::Answer answer{.verdict = name_of(d.verdict)};
    for (const auto& cause : d.effects)
        answer.ranked.push_back(cause.names), answer.probabilities.push_back(cause.probability);
    answer.ambiguous_with = d.ambiguous_with;
    answer.gap_before = d.overall.before, answer.gap_after = d.overall.after;
    return answer;
}

void add_set(const Guarantee& g, JointDiagnosis& found)
{
    Diagnosis& d = found.diagnosis;
    if (found.contradicted || d.interrupted) return;
    d.set = guarantee::set_of(answer_of(d), g.promise, g.calibration, guarantee::possible_causes(found.before));
}

}  // namespace stickslip
