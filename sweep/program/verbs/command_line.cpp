#include "sweep/program/verbs/command_line.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace stickslip {

Check existing_file()
{
    return {[](const std::string& value) {
                std::string path = value;
                return CLI::ExistingFile(path);
            },
            CLI::ExistingFile.get_description()};
}

std::optional<double> number_in(const std::string& value)
{
    double number = 0;
    if (!CLI::detail::lexical_cast(value, number)) return std::nullopt;
    return number;
}

void refuse_option(const std::string& option, const std::string& why)
{
    throw CLI::ValidationError(option, why);
}

Option Option::required()
{
    option_->required();
    return *this;
}

Option Option::check(const Check& check)
{
    option_->check(
        CLI::Validator([complaint = check.complaint](std::string& value) { return complaint(value); }, check.type));
    return *this;
}

Option Option::capture_default_str()
{
    option_->capture_default_str();
    return *this;
}

Option Option::needs(const Option& other)
{
    option_->needs(other.option_);
    return *this;
}

Option Option::excludes(const Option& other)
{
    option_->excludes(other.option_);
    return *this;
}

Option Option::expected(int count)
{
    option_->expected(count);
    return *this;
}

Option Option::expected(int least, int most)
{
    option_->expected(least, most);
    return *this;
}

Option Option::one_value()
{
    option_->allow_extra_args(false);
    return *this;
}

template <class Value>
Option Verb::add_option(const std::string& names, Value& value, const std::string& help)
{
    return Option(verb_->add_option(names, value, help));
}

template Option Verb::add_option(const std::string&, std::string&, const std::string&);
template Option Verb::add_option(const std::string&, double&, const std::string&);
template Option Verb::add_option(const std::string&, int&, const std::string&);
template Option Verb::add_option(const std::string&, unsigned&, const std::string&);
template Option Verb::add_option(const std::string&, std::uint64_t&, const std::string&);
template Option Verb::add_option(const std::string&, std::vector<std::string>&, const std::string&);

Option Verb::add_flag(const std::string& names, bool& value, const std::string& help)
{
    return Option(verb_->add_flag(names, value, help));
}

void Verb::footer(const std::string& text)
{
    verb_->footer(text);
}

void Verb::callback(std::function<void()> run)
{
    verb_->callback(std::move(run));
}

Verb CommandLine::add_verb(const std::string& name, const std::string& description)
{
    return Verb(app_->add_subcommand(name, description));
}

}  // namespace stickslip
