#include "sweep/words/nearest_text.h"

#include "analysis/results/text.h"
#include "sweep/words/symbols.h"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

constexpr double idle = 0.1;  ///< of the largest move: below, a parameter hardly takes part

/// Several bodies have friction laws with the same letters.
std::string body_of(const std::string& path)
{
    for (const auto* body : {"motor", "transmission", "link"})
        if (path.starts_with(std::string("friction.") + body + ".")) return std::string(" (") + body + ")";
    return "";
}

std::string symbol(const NearestMove& move, Units units)
{
    return symbol_of(move.path, units) + (move.less.empty() ? "" : " − " + symbol_of(move.less, units)) +
           body_of(move.path);
}

std::string move_text(const NearestMove& move, Units units)
{
    const double ratio = move.to / move.from;
    if (ratio > 2) return symbol(move, units) + " grows to " + plain_number(ratio) + " times its value";
    if (ratio < 0.5) return symbol(move, units) + " falls to 1/" + plain_number(1 / ratio) + " of its value";
    const double change = ratio - 1;
    return symbol(move, units) + (change < 0 ? " falls by " : " grows by ") + plain_number(100 * std::abs(change), 2) +
           " %";
}

/// Those that take part, the largest first.
std::vector<NearestMove> leading_moves(const NearestBoundary& n)
{
    auto moves = n.moves;
    const auto size = [](const NearestMove& m) { return std::abs(std::log(m.to / m.from)); };
    std::sort(moves.begin(), moves.end(), [&](const auto& a, const auto& b) { return size(a) > size(b); });
    const double largest = size(moves.front());
    std::erase_if(moves, [&](const auto& m) { return size(m) < idle * largest; });
    return moves;
}

}  // namespace

std::string nearest_text(const NearestBoundary& n, Units units)
{
    if (!n.decided) return "The joint has no linear verdict, hence no margin.";
    const std::string event = n.stable ? "Stick-slip appears" : "Sliding becomes stable";
    if (!n.found)
        return std::string("No change of these parameters by up to ×10 ") +
               (n.stable ? "causes stick-slip." : "makes sliding stable.");
    const auto moves = leading_moves(n);
    std::string text = event + " if ";
    for (std::size_t i = 0; i < moves.size(); ++i)
        text += (i == 0                  ? ""
                 : i == 1                ? " while "
                 : i + 1 == moves.size() ? " and "
                                         : ", ") +
                move_text(moves[i], units);
    return text + ".";
}

Headline nearest_headline(const NearestBoundary& n, Units units)
{
    Headline h{Headline::Tone::neutral, "no boundary near", nearest_text(n, units)};
    if (!n.found) return h;
    h.meaning += " Nearest change of all uncertain parameters together.";
    const auto moves = leading_moves(n);
    const double change = moves.front().to / moves.front().from - 1;
    h.value = symbol(moves.front(), units) + (change < 0 ? " −" : " +") + plain_number(100 * std::abs(change), 2) +
              " %" + (moves.size() > 1 ? " with others" : "");
    h.tone = !n.stable                            ? Headline::Tone::bad
             : n.distance < std::log(near_factor) ? Headline::Tone::warning
                                                  : Headline::Tone::good;
    return h;
}

std::string uncertain_numbers(const NearestBoundary& n, Units units)
{
    constexpr std::size_t most = 6;  // that a reader takes in
    if (n.moves.empty() || n.moves.size() > most)
        return "all " + std::to_string(n.direction.size()) + " uncertain parameters";
    std::string text;
    for (std::size_t i = 0; i < n.moves.size(); ++i)
        text += (i == 0 ? "" : i + 1 == n.moves.size() ? " and " : ", ") + symbol(n.moves[i], units);
    return text;
}

void name_symbols(Report& report, const NearestBoundary& n, Units units)
{
    if (!n.decided || !n.found) return;
    std::string text;
    for (const auto& move : leading_moves(n))
        text += (text.empty() ? "" : " ") + symbol(move, units) + ": " + name_of(move.path) +
                (move.less.empty() ? "" : " minus " + name_of(move.less)) + ".";
    report.findings.push_back(text);
}

std::string off_text(double share)
{
    return "±" + plain_number(100 * share, 2) + "\u00a0%";
}

}  // namespace stickslip
