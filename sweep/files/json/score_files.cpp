// The score's files: answers and truths in, table and JSON out.
#include "sweep/study/score.h"

#include "sweep/study/binomial.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <stdexcept>

namespace stickslip::blind {
namespace {

using Json = nlohmann::ordered_json;

EffectSet effect_set(const Json& j)
{
    if (j.is_string()) return {j.get<std::string>()};
    if (j.is_object()) return j.at("names").get<EffectSet>();
    return j.get<EffectSet>();
}

std::vector<EffectSet> effect_sets(const Json& j)
{
    std::vector<EffectSet> sets;
    for (const auto& item : j) sets.push_back(effect_set(item));
    return sets;
}

double number_or_nan(const Json& j, const char* key)
{
    return j.contains(key) && j[key].is_number() ? j[key].get<double>() : missing;
}

/// Reads {case: …} with one reader a case; whatever goes wrong is reported with the name of the case.
template <class T, class Read>
std::map<std::string, T> parse_cases(const std::string& text, const char* what, Read read)
{
    std::map<std::string, T> all;
    Json json;
    try {
        json = Json::parse(text);
    } catch (const nlohmann::json::exception& e) {
        throw std::invalid_argument(fmt::format("{}: {}", what, e.what()));
    }
    if (!json.is_object()) throw std::invalid_argument(fmt::format("{}: expected an object of cases", what));
    for (const auto& [name, j] : json.items()) {
        try {
            all[name] = read(j);
        } catch (const nlohmann::json::exception& e) {
            throw std::invalid_argument(fmt::format("{}: {}: {}", what, name, e.what()));
        }
    }
    return all;
}

Json json(const Share& s)
{
    Json j = {{"right", s.right}, {"of", s.of}};
    j["share"] = s.of ? Json(s.value()) : Json(nullptr);
    j["at_least"] = s.of ? Json(share_at_least(s.right, s.of)) : Json(nullptr);
    j["at_most"] = s.of ? Json(share_at_most(s.right, s.of)) : Json(nullptr);
    return j;
}

Json json(double x)
{
    return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json json(const std::map<std::string, Share>& shares)
{
    Json j = Json::object();
    for (const auto& [name, share] : shares) j[name] = json(share);
    return j;
}

enum class Good { many, few };

/// With the exact bound of one side at 95 %, on the side that could be the worse.
std::string line(const char* what, const Share& s, const char* aim, Good good = Good::many)
{
    if (s.of == 0) return "";
    const std::string bound = good == Good::many ? fmt::format("at least {:.1f}", 100 * share_at_least(s.right, s.of))
                                                 : fmt::format("at most {:.1f}", 100 * share_at_most(s.right, s.of));
    return fmt::format("{:<46}{:>5} of {:<5}{:>7.1f} %   {:<14}   {}\n", what, s.right, s.of, 100 * s.value(), bound,
                       aim);
}

std::string group(const char* what, const std::map<std::string, Share>& shares)
{
    std::string text;
    for (const auto& [name, share] : shares) text += line(("  " + name).c_str(), share, "");
    return text.empty() ? "" : fmt::format("{}\n{}", what, text);
}

}  // namespace

std::map<std::string, Answer> parse_answers(const std::string& text)
{
    return parse_cases<Answer>(text, "answers", [](const Json& j) {
        Answer a;
        a.verdict = j.at("verdict");
        if (j.contains("effects")) a.ranked = effect_sets(j["effects"]);
        if (j.contains("probabilities")) a.probabilities = j["probabilities"].get<std::vector<double>>();
        if (j.contains("ambiguous_with")) a.ambiguous_with = effect_sets(j["ambiguous_with"]);
        a.gap_before = number_or_nan(j, "gap_before");
        a.gap_after = number_or_nan(j, "gap_after");
        return a;
    });
}

std::map<std::string, Truth> parse_truths(const std::string& text)
{
    return parse_cases<Truth>(text, "truth", [](const Json& j) {
        Truth t;
        t.verdict = j.at("verdict");
        t.effects = j.at("effects").get<EffectSet>();
        t.equivalent = j.value("equivalent", EffectSet{});
        t.kind = j.value("kind", "");
        t.strength = j.value("strength", "");
        t.engine = j.value("engine", "");
        t.joint = j.value("joint", "");
        t.columns = j.value("columns", "");
        t.dirty = j.value("dirty", false);
        if (j.contains("true_gap")) {
            t.gap_before = number_or_nan(j["true_gap"], "before");
            t.gap_after = number_or_nan(j["true_gap"], "after");
        }
        return t;
    });
}

std::string score_text(const Score& s)
{
    std::string text;
    if (!s.state.empty()) text += fmt::format("{} cases; bounds of one side at 95 %\n", s.state);
    text += line("single effects: named first", s.top1, "aim 98 with the next line");
    text += line("  by the very name", s.top1_exact, "");
    text += line("  first, or in an ambiguity set of two", s.named, "aim 98");
    text += line("pairs: both named first", s.pairs_both, "aim 90");
    text += line("  or in an ambiguity set of two", s.pairs_both_or_ambiguous, "");
    text += line("  members of pairs named", s.pair_members, "");
    text += line("false alarms without an effect", s.false_alarms, "aim 1 or less", Good::few);
    text += line("abstained outside the catalogue", s.abstained, "aim 95");
    text += line("hopeless data called so", s.insufficient, "");
    text += line("verdicts", s.verdicts, "");
    text += line("explained share within a tenth of the truth's", s.explained_within_tenth, "");
    text += line("shrink at most a tenth above the truth's", s.within_tenth, "");
    if (std::isfinite(s.median_shrink))
        text += fmt::format("median gap after / before: answered {:.3f}, truth {:.3f}\n", s.median_shrink,
                            s.median_truth_shrink);
    if (std::isfinite(s.brier)) {
        text += fmt::format("Brier score {:.4f}, expected calibration error {:.4f} (aim < 0.05)\n", s.brier,
                            s.calibration_error);
        for (const auto& b : s.reliability)
            if (b.right.of)
                text += fmt::format("  said {:.2f} on average, right {:.2f} of {}\n", b.mean_probability,
                                    b.right.value(), b.right.of);
    }
    text += group("by effect", s.by_effect) + group("by strength", s.by_strength) + group("by engine", s.by_engine) +
            group("by joint", s.by_joint) + group("by columns", s.by_columns);
    std::string wrong;
    for (const auto& j : s.cases)
        if (!j.right_or_ambiguous)
            wrong += fmt::format("  {:<10} {:<7} {:<7} {:<7} {:<44} said {}\n", j.name, j.kind, j.strength, j.engine,
                                 j.expected, j.answered_at_all ? j.answered : "nothing");
    if (!s.parts.empty()) text = "";  // stated for each kind of joint
    for (const Score& part : s.parts) text += score_text(part);
    return wrong.empty() || !s.parts.empty() ? text : text + "not named\n" + wrong;
}

namespace {

Json score_object(const Score& s)
{
    Json j;
    j["singles"] = {{"top1", json(s.top1)}, {"top1_exact", json(s.top1_exact)}, {"named", json(s.named)}};
    j["pairs"] = {{"both", json(s.pairs_both)},
                  {"both_or_ambiguous", json(s.pairs_both_or_ambiguous)},
                  {"members", json(s.pair_members)}};
    j["false_alarms"] = json(s.false_alarms);
    j["abstained"] = json(s.abstained);
    j["insufficient"] = json(s.insufficient);
    j["verdicts"] = json(s.verdicts);
    j["calibration"] = {
        {"brier", json(s.brier)}, {"expected_error", json(s.calibration_error)}, {"bins", Json::array()}};
    for (const auto& b : s.reliability)
        j["calibration"]["bins"].push_back({{"low", b.low},
                                            {"high", b.high},
                                            {"mean_probability", b.right.of ? Json(b.mean_probability) : Json(nullptr)},
                                            {"right", json(b.right)}});
    j["shrink"] = {{"median", json(s.median_shrink)},
                   {"median_truth", json(s.median_truth_shrink)},
                   {"within_tenth", json(s.within_tenth)},
                   {"explained_within_tenth", json(s.explained_within_tenth)}};
    j["by_effect"] = json(s.by_effect);
    j["by_strength"] = json(s.by_strength);
    j["by_engine"] = json(s.by_engine);
    j["by_joint"] = json(s.by_joint);
    j["by_columns"] = json(s.by_columns);
    j["by_kind"] = json(s.by_kind);
    j["cases"] = Json::array();
    for (const auto& c : s.cases)
        j["cases"].push_back({{"case", c.name},
                              {"kind", c.kind},
                              {"expected", c.expected},
                              {"answered", c.answered},
                              {"right", c.right},
                              {"right_or_ambiguous", c.right_or_ambiguous},
                              {"probability", json(c.probability)},
                              {"shrink", json(c.shrink)},
                              {"truth_shrink", json(c.truth_shrink)}});
    for (const Score& part : s.parts) j[part.state] = score_object(part);
    return j;
}

}  // namespace

std::string score_json(const Score& s)
{
    Json j = {{"format", "stickslip-score/2"}};
    j.update(score_object(s));
    return j.dump(1) + "\n";
}

}  // namespace stickslip::blind
