#include "sweep/files/json/timeline_json.h"

#include "sweep/files/json/comparison_json.h"
#include "sweep/words/comparison_text.h"
#include "sweep/words/plain_text.h"
#include "sweep/words/timeline_text.h"

namespace stickslip {

using Json = nlohmann::ordered_json;

Json timeline_json(const Timeline& t)
{
    Json json = {
        {"format", "stickslip-timeline/1"}, {"joint", t.title}, {"sentence", plain_text(timeline_sentence(t))}};
    json["runs"] = Json::array();
    for (std::size_t i = 0; i < t.runs.size(); ++i) {
        Json run = {{"date", date_text(t.runs[i].at)}};
        run.update(facts_json(t.runs[i].facts));
        run["since_the_run_before"] = nullptr;
        if (i > 0) {
            const auto& step = t.steps[i - 1];
            Json moved = Json::array();
            for (const auto& change : step.numbers)
                if (change.moved(standard_errors_of_a_move))
                    moved.push_back({{"name", change.name},
                                     {"of", name_of(change.of)},
                                     {"change", change.change},
                                     {"standard_errors", change.standard_errors}});
            run["since_the_run_before"] = {
                {"gap", name_of(step.gap)}, {"appeared", step.appeared}, {"gone", step.gone}, {"moved", moved}};
        }
        json["runs"].push_back(std::move(run));
    }
    return json;
}

}  // namespace stickslip
