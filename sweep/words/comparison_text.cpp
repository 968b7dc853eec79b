#include "sweep/words/comparison_text.h"

#include "analysis/results/text.h"
#include "sweep/words/cause_text.h"
#include "sweep/words/diagnosis_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

using Kind = GapRegression::Kind;

std::string size_of_gap(double gap)
{
    return plain_number(gap, 3) + " times the noise floor";
}

std::string number_text(const std::optional<FittedParameter>& number)
{
    return number ? with_error(number->value, number->standard_error, number->unit) : "–";
}

/// "viscous friction, change"
std::string words_of(const NumberChange& c)
{
    auto words = parameter_words(c.name);
    if (const auto colon = words.find(": "); colon != std::string::npos) words.replace(colon, 1, ",");
    return words;
}

/// Of the difference of two values that were found apart.
double change_error(const NumberChange& c)
{
    return std::hypot(c.before->standard_error, c.after->standard_error);
}

std::string gap_words(const DiagnosisComparison& c)
{
    const auto &was = c.before.overall, &is = c.after.overall;
    switch (c.gap) {
        case GapChange::none:
            return "Neither diagnosis found a gap.";
        case GapChange::appeared:
            return "New: a " + outcome_words(c.after) + "; before there was none.";
        case GapChange::gone:
            return "The gap is gone; before, there was a " + outcome_words(c.before) + ".";
        case GapChange::not_comparable:
            return "There is nothing to compare: " + outcome_words(c.before) + " before, " + outcome_words(c.after) +
                   " now.";
        default:
            break;
    }
    const char* verb = c.gap == GapChange::same    ? "is as large as before"
                       : c.gap == GapChange::grown ? "grew"
                                                   : "shrank";
    return fmt::format("The gap {}: {} before, {} now.", verb, size_of_gap(was.before), size_of_gap(is.before));
}

std::string cause_words(const DiagnosisComparison& c)
{
    std::string text;
    if (c.gap == GapChange::appeared || c.gap == GapChange::gone) return text;
    if (!c.appeared.empty())
        text += " Named now and not before: " + fmt::format("{}", fmt::join(c.appeared, ", ")) + ".";
    if (!c.gone.empty()) text += " Named before and not now: " + fmt::format("{}", fmt::join(c.gone, ", ")) + ".";
    if (c.perhaps_same_cause) text += " These may be the same cause: one of the records cannot distinguish them.";
    return text;
}

std::string moved_words(const DiagnosisComparison& c)
{
    constexpr std::size_t most = 3;  // parameters in a sentence, the largest changes; the table has all
    std::string text;
    bool any = false;
    std::size_t moved = 0;
    for (const auto& change : c.numbers) {
        any |= change.in_both();
        if (!change.moved(standard_errors_of_a_move)) continue;
        const bool beside = change.of == FoundNumber::Of::correction && !c.kept.empty();
        if (beside || !is_reported(change, c)) continue;
        if (moved++ < most) text += " " + change_text(change) + ".";
    }
    if (moved > most)
        text += " " + counted(moved - most, "more parameter") + " changed by more than 3 standard errors.";
    if (!text.empty() || !any) return text;
    for (const auto& change : c.numbers)
        if (change.moved(standard_errors_of_a_move)) return " " + change_text(change) + ".";
    return " No parameter that both name changed by more than 3 standard errors.";
}

}  // namespace

std::string outcome_name(const DiagnosisFacts& facts)
{
    if (facts.interrupted) return "interrupted diagnosis";
    switch (facts.verdict) {
        case Verdict::no_gap:
            return "no gap";
        case Verdict::insufficient_data:
            return "too little data";
        case Verdict::unknown:
            return "gap of unknown cause";
        case Verdict::gap:
            break;
    }
    return "gap by " + together(facts.causes);
}

std::string outcome_words(const DiagnosisFacts& facts)
{
    return outcome_name(facts) +
           (facts.differs() && !facts.interrupted ? ", " + size_of_gap(facts.overall.before) : "");
}

std::string change_text(const NumberChange& c)
{
    if (!c.in_both()) return words_of(c) + ": " + number_text(c.before) + " → " + number_text(c.after);
    return fmt::format(
        "{}: {} → {}, {} standard errors", words_of(c), with_error(c.before->value, c.before->standard_error, c.unit),
        with_error(c.after->value, c.after->standard_error, c.unit), plain_number(std::abs(c.standard_errors), 3));
}

bool is_reported(const NumberChange& change, const DiagnosisComparison& step)
{
    if (change.of != FoundNumber::Of::parameter) return true;
    return std::none_of(step.numbers.begin(), step.numbers.end(),
                        [](const auto& other) { return other.of == FoundNumber::Of::sheet && other.in_both(); });
}

std::string comparison_sentence(const DiagnosisComparison& c)
{
    return gap_words(c) + cause_words(c) + moved_words(c);
}

std::string regression_text(const GapRegression& r, const DiagnosisComparison& c)
{
    const auto &was = c.before.overall, &is = c.after.overall;
    switch (r.kind) {
        case Kind::new_gap:
            return "a gap that the baseline does not have: " + outcome_words(c.after);
        case Kind::grown:
            return fmt::format("the gap grew from {} to {}", size_of_gap(was.before), size_of_gap(is.before));
        case Kind::remainder:
            return fmt::format("what the named cause leaves grew from {} to {}", size_of_gap(was.after),
                               size_of_gap(is.after));
        case Kind::new_cause:
            return "a cause that the baseline does not name: " + r.name;
        case Kind::number_moved:
            return change_text(r.number);
        case Kind::no_answer:
            break;
    }
    return "no answer: " + outcome_words(c.after) + "; the baseline has one";
}

Table changes_table(const DiagnosisComparison& c)
{
    Table t{"Parameters of both diagnoses, largest change first",
            {"parameter", "stands for", "before", "now", "change", "in standard errors"},
            {}};
    for (const auto& change : c.numbers) {
        if (!is_reported(change, c)) continue;
        const char* of = change.of == FoundNumber::Of::sheet       ? "joint"
                         : change.of == FoundNumber::Of::parameter ? "cause"
                                                                   : "refitted";
        t.rows.push_back({parameter_words(change.name), of, number_text(change.before), number_text(change.after),
                          change.in_both() ? with_error(change.change, change_error(change), change.unit) : "–",
                          change.in_both() ? plain_number(change.standard_errors, 3) : "named in one only"});
    }
    return t;
}

Table compared_gap_table(const DiagnosisComparison& c)
{
    Table t{"Measured against simulated as documented, held-out data",
            {"signal", "gap before", "gap now", "noise floor before", "noise floor now", "unit"},
            {}};
    for (const auto& is : c.after.gap)
        for (const auto& was : c.before.gap)
            if (is.signal == was.signal && is.unit == was.unit)
                t.rows.push_back({signal_words(is.signal), plain_number(was.before, 3), plain_number(is.before, 3),
                                  plain_number(was.floor, 3), plain_number(is.floor, 3), is.unit});
    t.rows.push_back({"all signals", plain_number(c.before.overall.before, 3), plain_number(c.after.overall.before, 3),
                      "1", "1", "× noise floor"});
    return t;
}

}  // namespace stickslip
