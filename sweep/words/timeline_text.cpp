#include "sweep/words/timeline_text.h"

#include "analysis/results/text.h"
#include "sweep/words/comparison_text.h"

#include <fmt/format.h>

namespace stickslip {
namespace {

bool worth_telling(const DiagnosisComparison& step)
{
    return step.gap == GapChange::appeared || step.gap == GapChange::gone || step.gap == GapChange::grown ||
           step.gap == GapChange::shrunk;
}

/// The first word of a sentence of its own, within another one.
std::string continued(std::string sentence)
{
    if (!sentence.empty() && sentence.front() >= 'A' && sentence.front() <= 'Z') sentence.front() += 'a' - 'A';
    return sentence;
}

}  // namespace

std::string timeline_sentence(const Timeline& t)
{
    std::string text = fmt::format("{} from {} to {}.", counted(t.runs.size(), "run"), date_text(t.runs.front().at),
                                   date_text(t.runs.back().at));
    std::size_t last = t.steps.size();
    for (std::size_t i = 0; i < t.steps.size(); ++i)
        if (worth_telling(t.steps[i])) last = i;
    if (last < t.steps.size())
        return text + fmt::format(" The last change of the gap lies between {} and {}: {}", date_text(t.runs[last].at),
                                  date_text(t.runs[last + 1].at), continued(comparison_sentence(t.steps[last])));
    return text + fmt::format(" The gap did not change: {} in the last run.", outcome_words(t.runs.back().facts));
}

}  // namespace stickslip
