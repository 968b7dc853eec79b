#include "analysis/joint/parameters.h"

#include "analysis/base/number_text.h"

#include <algorithm>
#include <numeric>

namespace stickslip {
namespace {

std::string list_text(const std::vector<double>& values)
{
    std::string text;
    for (const double v : values) text += (text.empty() ? "" : " ") + number_text(v);
    return text;
}

/// A struct that has rules beyond ranges says them in `problem()`.
template <class Struct>
std::string problem_of(const Struct& s)
{
    if constexpr (requires { s.problem(); }) return s.problem();
    return {};
}

/// Visits a joint and keeps every leaf with its full path.
struct LeafCollector {
    struct Other {
        std::string path, text;
    };  // a flag, choice or text

    std::string prefix;
    bool in_law = false;  ///< in the numbers of a law itself or in a row of its lists, not in a term or curve below it
    std::vector<Parameter> numbers_;
    std::vector<Other> others;
    std::vector<Problem> problems;
    std::vector<TableSlot> tables;

    std::string path(std::string_view key) const
    {
        return prefix.empty() ? std::string(key) : prefix + "." + std::string(key);
    }

    Role role_of(const Field& f) const { return f.role == Role::plain && in_law ? Role::law : f.role; }
    void number(const Field& f, double& value)
    {
        numbers_.push_back({path(f.key), f.quantity, f.range, f.need, std::string(f.help), &value, role_of(f)});
    }
    void numbers(const Field& f, NumberList& list)
    {
        if (list.size == 0 && f.need == Need::required) problems.push_back({path(f.key), "is missing"});
        for (int i = 0; i < list.size; ++i) {
            const std::string name = list.size == 1 ? path(f.key) : path(f.key) + "." + std::to_string(i);
            numbers_.push_back({name, f.quantity, f.range, f.need, std::string(f.help), &list[i], role_of(f)});
        }
        others.push_back({path(f.key) + ".size", std::to_string(list.size)});
    }
    void flag(std::string_view key, std::string_view, bool& value)
    {
        others.push_back({path(key), value ? "true" : "false"});
    }
    void text(std::string_view key, std::string_view, std::string& value) { others.push_back({path(key), value}); }

    /// The numbers of a table stand for themselves in the canonical text: a file name says nothing of what is in it.
    void samples(std::string_view key, std::string_view, std::string& name, KernelTablePtr& table)
    {
        others.push_back({path(key), name});
        if (table) {
            others.push_back({path(key) + ".time", list_text(table->time)});
            others.push_back({path(key) + ".value", list_text(table->value)});
        }
        tables.push_back({path(key), &name, &table});
    }

    template <class Enum, std::size_t n>
    void choice(std::string_view key, std::string_view, Enum& value, const Choice<Enum> (&choices)[n])
    {
        for (const auto& c : choices)
            if (c.value == value) others.push_back({path(key), std::string(c.name)});
    }
    template <class Struct>
    void table(std::string_view key, std::string_view, Struct& s)
    {
        below(key, s, false);
    }
    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view, ShortList<Struct, capacity>& list)
    {
        others.push_back({path(key) + ".size", std::to_string(list.size)});
        for (int i = 0; i < list.size; ++i) below(std::string(key) + "." + std::to_string(i), list[i], in_law);
    }
    template <class Struct>
    void below(std::string_view key, Struct& s, bool of_law)
    {
        const std::string outer = prefix;
        const bool was_in_law = in_law;
        prefix = path(key), in_law = of_law;
        Struct::fields(s, *this);
        if (auto text = problem_of(s); !text.empty()) problems.push_back({prefix, text});
        prefix = outer, in_law = was_in_law;
    }
    template <class Law>
    void law(Law& law)
    {
        const bool was_in_law = in_law;
        in_law = true;
        others.push_back({path("law"), std::string(std::visit([](auto& l) { return l.info.name; }, law))});
        std::visit(
            [this](auto& l) {
                std::decay_t<decltype(l)>::fields(l, *this);
                if (auto text = problem_of(l); !text.empty()) problems.push_back({prefix, text});
            },
            law);
        in_law = was_in_law;
    }
};

LeafCollector collect(Joint& joint)
{
    LeafCollector collector;
    Joint::fields(joint, collector);
    if (auto text = joint.problem(); !text.empty()) collector.problems.push_back({"joint", text});
    return collector;
}

int edit_distance(std::string_view a, std::string_view b)
{
    std::vector<int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        int diagonal = row[0];
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({substitute, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::vector<Parameter> parameters(Joint& joint)
{
    return collect(joint).numbers_;
}

std::vector<TableSlot> tables(Joint& joint)
{
    return collect(joint).tables;
}

std::vector<std::string> nearest_names(std::string_view given, const std::vector<std::string>& known)
{
    std::vector<std::pair<int, std::string>> ranked;
    for (const auto& name : known) {
        const auto last = name.substr(name.rfind('.') + 1);
        const int distance = std::min(edit_distance(given, name), edit_distance(given, last));
        if (distance <= static_cast<int>(std::max<std::size_t>(2, given.size() / 3)))
            ranked.emplace_back(distance, name);
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> names;
    for (std::size_t i = 0; i < ranked.size() && i < 3; ++i) names.push_back(ranked[i].second);
    return names;
}

std::vector<Problem> check(const Joint& given)
{
    Joint joint = given;
    auto collected = collect(joint);
    auto& problems = collected.problems;
    for (const auto& p : collected.numbers_) {
        if (!is_set(*p.value)) {
            if (p.need == Need::required) problems.push_back({p.path, "is missing: " + p.help});
        } else if (!p.range.holds(*p.value) && !(p.need == Need::optional && *p.value == infinity)) {
            problems.push_back({p.path, "is " + number_text(*p.value) + ", expected " + describe(p.range)});
        }
    }
    return problems;
}

std::string canonical_text(const Joint& given)
{
    Joint joint = given;
    const auto collected = collect(joint);
    std::string text;
    for (const auto& other : collected.others) text += other.path + " = " + other.text + "\n";
    if (joint.pose.of) text += "pose.of = " + joint.pose.of->id + "\n";
    for (const auto& p : collected.numbers_) text += p.path + " = " + number_text(*p.value) + "\n";
    return text;
}

std::string describe(const Range& range)
{
    std::string text;
    if (range.low == -infinity && range.high == infinity)
        text = "any finite number";
    else if (range.high == infinity)
        text = (range.low_open ? "> " : "≥ ") + number_text(range.low);
    else if (range.low == -infinity)
        text = (range.high_open ? "< " : "≤ ") + number_text(range.high);
    else
        text = std::string("within ") + (range.low_open ? "(" : "[") + number_text(range.low) + ", " +
               number_text(range.high) + (range.high_open ? ")" : "]");
    return range.whole ? "a whole number " + text : text;
}

}  // namespace stickslip
