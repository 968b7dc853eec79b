#include "analysis/diagnosis/fit/residuals.h"

#include "analysis/diagnosis/fit/candidate_numbers.h"
#include "analysis/diagnosis/policy/search.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <type_traits>

namespace stickslip::gap {
namespace {

/// Adds one channel's blocks to the objective and lists their mean squares; gives the mean square of all.
double add_blocks(const std::vector<double>& scaled, std::size_t begin, std::size_t count, std::size_t block,
                  double& objective, std::vector<double>& blocks)
{
    const double scale = policy::large_block;
    double total = 0, robust = 0;
    for (std::size_t b = 0; b < count; b += block) {
        const std::size_t end = std::min(b + block, count);
        double sum = 0;
        for (std::size_t i = b; i < end; ++i) sum += scaled[begin + i] * scaled[begin + i];
        total += sum;
        const double rows = static_cast<double>(end - b);
        blocks.push_back(sum / rows);
        robust += rows * scale * std::log1p(blocks.back() / scale);
    }
    const double n = static_cast<double>(std::max<std::size_t>(count, 1));
    objective += robust / n;
    return total / n;
}

std::size_t block_rows(const Case& c)
{
    return std::max<std::size_t>(4, static_cast<std::size_t>(block_time / c.row_step));
}

std::size_t residual_count(const Case& c)
{
    return c.ticks.rows() * (c.effort_sigma > 0 ? 2 : 1);
}

/// Appends one scaled residual for every row.
template <class Scaled>
void append_rows(const Case& c, std::vector<double>& to, Scaled scaled)
{
    const std::size_t before = to.size(), size = c.ticks.size();
    to.resize(before + size);
    double* next = to.data() + before;
    const bool all = c.ticks.judged.empty() && !(c.skip_from < c.skip_to);
    for (std::size_t k = 0; k < size; ++k)
        if (c.ticks.logged[k]) *next++ = all || c.judged(k) ? scaled(k) : 0;
    to.resize(static_cast<std::size_t>(next - to.data()));
}

/// Appends the scaled residuals of one record: position rows, then effort rows.
void append_residuals(const Case& c, double omega, const Innovation& innovation, std::vector<double>& scaled)
{
    const double per_floor = 1 / (reading_floor(c, omega) * std::sqrt(noise_amplification(omega, c.row_step)));
    constexpr double far = 1e6;  // numerical: a diverged prediction is bad, not infinitely bad
    append_rows(c, scaled, [&](std::size_t k) {
        const double e = innovation.position[k] * per_floor;
        return std::isfinite(e) ? std::clamp(e, -far, far) : far;
    });
    if (!(c.effort_sigma > 0)) return;
    const double per_effort = 1 / effort_floor(c, omega);
    append_rows(c, scaled, [&](std::size_t k) {
        const double e = innovation.effort[k] * per_effort;
        return std::isfinite(e) ? std::clamp(e, -far, far) : 0;
    });
}

/// One place of one question.
struct Look {
    Question* question;
    std::size_t place;

    const Place& at() const { return question->places[place]; }
    /// Whether it needs this record anew.
    bool needs(const Case& c) const
    {
        if (!question->known || at().moved == no_parameter) return true;
        const auto own = record_of(*question->candidate, at().moved);
        return !own || *own == std::min(c.number, question->candidate->records - 1);
    }
};

/// The predictions of a few places, side by side.
class Predictions {
  public:
    void go(std::span<const Look> looks)
    {
        for (const auto& look : looks)
            for (const auto& c : *look.question->cases)
                if (look.needs(c)) add(c, look);
        predict_all(all_);
        auto innovation = innovations_.cbegin();
        for (const auto& look : looks) {
            const auto* known = look.question->known;
            auto& scaled = look.question->answers[look.place];
            std::size_t count = 0;
            for (const auto& c : *look.question->cases) count += residual_count(c);
            scaled.reserve(count);
            for (const auto& c : *look.question->cases) {
                if (look.needs(c)) {
                    append_residuals(c, look.at().omega, *innovation++, scaled);
                    continue;
                }
                const auto from = known->begin() + static_cast<std::ptrdiff_t>(scaled.size());
                scaled.insert(scaled.end(), from, from + static_cast<std::ptrdiff_t>(residual_count(c)));
            }
        }
    }

  private:
    void add(const Case& c, const Look& look)
    {
        Plant plant = edited_plant(c.joint, *look.question->candidate, look.at().si, c.number);
        plant.step_factor = c.step_factor;
        const auto command = command_of(c, plant);
        all_.push_back({plant, &c.ticks, command, look.at().omega, &innovations_.emplace_back(),
                        c.effort_sigma > 0 ? Wanted::effort : Wanted::position});
    }
    /// A command that is computed from the readings is the same wherever the controller is.
    std::span<const double> command_of(const Case& c, const Plant& plant)
    {
        const auto computed = std::ranges::find_if(
            commands_, [&](const auto& known) { return known.record == &c && same_controller(known.plant, plant); });
        if (computed != commands_.end()) return computed->command;
        auto& made = commands_.emplace_back(Command{&c, plant, {}, {}});
        return made.command = known_command(plant, c.ticks, made.room);
    }
    /// Byte by byte: what differs in what is no number is computed twice.
    static bool same_controller(const Plant& a, const Plant& b)
    {
        static_assert(std::is_trivially_copyable_v<Control> && std::is_trivially_copyable_v<Load>);
        return a.two_mass == b.two_mass && a.feedback_link == b.feedback_link && a.ratio == b.ratio &&
               std::memcmp(&a.control, &b.control, sizeof a.control) == 0 &&
               std::memcmp(&a.load, &b.load, sizeof a.load) == 0;
    }

    struct Command {
        const Case* record;
        Plant plant;
        std::vector<double> room;
        std::span<const double> command;
    };
    std::vector<Prediction> all_;
    std::deque<Command> commands_;
    std::deque<Innovation> innovations_;
};

/// The places that have to be looked at, and those of the others that fill lanes.
std::vector<Look> looks_at(std::span<Question* const> questions)
{
    constexpr std::size_t few_lanes = 4, pack = 8;
    std::vector<Look> looks, others;
    std::size_t runs = 0;
    for (auto* q : questions) {
        q->answers.resize(q->places.size());
        runs += q->needed * q->cases->size();
        for (std::size_t i = 0; i < q->places.size(); ++i) (i < q->needed ? looks : others).push_back({q, i});
    }
    const std::size_t filled = runs <= few_lanes ? few_lanes : (runs + pack - 1) / pack * pack;
    for (const auto& look : others) {
        runs += look.question->cases->size();
        if (runs <= (look.question->sure ? std::max(filled, 2 * pack) : filled)) looks.push_back(look);
    }
    return looks;
}

}  // namespace

void answer(std::span<Question* const> questions)
{
    // enough to fill the lanes, not so much that long records fill the memory
    constexpr std::size_t most_ticks = 2'000'000, fewest = 4;
    const auto looks = looks_at(questions);
    for (std::size_t from = 0, to = 0; from < looks.size(); from = to) {
        for (std::size_t ticks = 0; to < looks.size() && (ticks < most_ticks || to - from < fewest); ++to)
            for (const auto& c : *looks[to].question->cases) ticks += c.ticks.size();
        Predictions().go(std::span(looks).subspan(from, to - from));
    }
}

std::vector<std::vector<double>> residuals_at(const std::vector<Case>& cases, const Candidate& candidate,
                                              const std::vector<Place>& places, const std::vector<double>* known)
{
    Question question{&cases, &candidate, places, places.size(), false, known};
    Question* one = &question;
    answer({&one, 1});
    return std::move(question.answers);
}

Evaluation judged(const std::vector<Case>& cases, const std::vector<double>& scaled)
{
    Evaluation result;
    std::size_t begin = 0;
    for (const auto& c : cases) {
        const std::size_t block = block_rows(c), rows = c.ticks.rows();
        Misfit misfit;
        misfit.position = add_blocks(scaled, begin, rows, block, result.objective, misfit.position_blocks);
        if (c.effort_sigma > 0)
            misfit.effort = add_blocks(scaled, begin + rows, rows, block, result.objective, misfit.effort_blocks);
        begin += residual_count(c);
        result.records.push_back(misfit);
    }
    result.objective /= static_cast<double>(cases.size());
    return result;
}

/// Weights of the scaled residuals that make a weighted least-squares step a step on the robust objective.
void block_weights(const std::vector<Case>& cases, const std::vector<double>& scaled, std::vector<double>& weights)
{
    const double scale = policy::large_block;
    weights.resize(scaled.size());
    std::size_t begin = 0;
    for (const auto& c : cases) {
        const std::size_t rows = c.ticks.rows();
        const std::size_t channels = c.effort_sigma > 0 ? 2 : 1, block = block_rows(c);
        for (std::size_t ch = 0; ch < channels; ++ch, begin += rows)
            for (std::size_t b = 0; b < rows; b += block) {
                const std::size_t end = std::min(b + block, rows);
                double sum = 0;
                for (std::size_t i = b; i < end; ++i) sum += scaled[begin + i] * scaled[begin + i];
                const double w = 1 / (1 + sum / static_cast<double>(end - b) / scale) / static_cast<double>(rows);
                for (std::size_t i = b; i < end; ++i) weights[begin + i] = w;
            }
    }
}

}  // namespace stickslip::gap
