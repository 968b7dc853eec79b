// One number of a joint by its path, of which searches ask again and again.
#include "analysis/joint/parameters.h"

#include <stdexcept>

namespace stickslip {
namespace {

/// Visits a joint for the number at a path and writes nothing else down.
struct NumberFinder {
    std::string_view exact, of_one;  ///< the path, and what it is called where its list has one entry
    std::string prefix;              ///< ends in a dot where it is not empty
    double *at_exact = nullptr, *at_of_one = nullptr;

    bool is(std::string_view path, std::string_view key) const
    {
        return path.size() == prefix.size() + key.size() && path.starts_with(prefix) && path.ends_with(key);
    }
    void take(std::string_view key, double& value)
    {
        if (is(exact, key)) at_exact = &value;
        if (!at_of_one && is(of_one, key)) at_of_one = &value;
    }
    void number(const Field& f, double& value) { take(f.key, value); }
    void numbers(const Field& f, NumberList& list)
    {
        if (list.size == 1) return take(f.key, list[0]);
        for (int i = 0; i < list.size; ++i) take(std::string(f.key) + "." + std::to_string(i), list[i]);
    }
    void flag(std::string_view, std::string_view, bool&) {}
    void text(std::string_view, std::string_view, std::string&) {}
    void samples(std::string_view, std::string_view, std::string&, KernelTablePtr&) {}
    template <class Enum, std::size_t n>
    void choice(std::string_view, std::string_view, Enum&, const Choice<Enum> (&)[n])
    {
    }
    template <class Struct>
    void table(std::string_view key, std::string_view, Struct& s)
    {
        const auto outer = prefix.size();
        prefix += key, prefix += '.';
        // what does not begin the path holds nothing of it
        if (exact.starts_with(prefix)) Struct::fields(s, *this);
        prefix.resize(outer);
    }
    template <class Struct, int capacity>
    void rows(std::string_view key, std::string_view help, ShortList<Struct, capacity>& list)
    {
        for (int i = 0; i < list.size; ++i) table(std::string(key) + "." + std::to_string(i), help, list[i]);
    }
    template <class Law>
    void law(Law& law)
    {
        std::visit([this](auto& l) { std::decay_t<decltype(l)>::fields(l, *this); }, law);
    }
};

double* found_at(Joint& joint, std::string_view path)
{
    NumberFinder finder{path, path, {}};
    if (path.ends_with(".0")) finder.of_one.remove_suffix(2);  // a list of one answers to "L" and to "L.0"
    Joint::fields(joint, finder);
    return finder.at_exact ? finder.at_exact : finder.at_of_one;
}

}  // namespace

const double* find_parameter(const Joint& joint, std::string_view path)
{
    return found_at(const_cast<Joint&>(joint), path);  // the walk reads; it is written for joints that are read in
}

JointNumber::JointNumber(Joint& joint, double& number) : joint_(joint), number_(number)
{
    const auto& pose = joint.pose.coordinates;
    posed_ = !pose.empty() && &number >= &pose.front() && &number <= &pose.back();
}

JointNumber number_at(Joint& joint, std::string_view path)
{
    double* number = found_at(joint, path);
    if (!number) throw std::invalid_argument("the joint has no number " + std::string(path));
    return {joint, *number};
}

Quantity quantity_of(const Joint& given, std::string_view path)
{
    Joint joint = given;
    const double* number = find_parameter(joint, path);
    for (const auto& leaf : parameters(joint))
        if (leaf.value == number) return leaf.quantity;
    return Quantity::number;
}

}  // namespace stickslip
