#include "sweep/program/verbs/usage.h"

#include "sweep/program/verbs/word_option.h"

#include <fmt/format.h>

namespace stickslip {
namespace {

std::vector<std::string> verb_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const auto* verb : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!verb->get_group().empty()) names.push_back(verb->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& verb)
{
    std::vector<std::string> names;
    for (const auto* option : verb.get_options())
        for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// What is wrong with the arguments of a verb: one that nothing takes, an option with too many, or what the library
/// says.
std::string verb_error(const CLI::App& verb, const CLI::ParseError& error)
{
    if (dynamic_cast<const CLI::ExtrasError*>(&error)) {
        const auto strangers = verb.remaining();
        const auto stranger = strangers.empty() ? std::string() : strangers.front();
        const auto name = stranger.substr(0, stranger.find('='));
        return name.starts_with("-") ? "there is no option " + in_quotes(name) + ", options are " +
                                           listed(option_names(verb)) + did_you_mean(name, option_names(verb))
                                     : in_quotes(name) + " is one argument too many";
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
        for (const auto* option : verb.get_options())
            if (const int most = option->get_items_expected_max(); static_cast<int>(option->count()) > most)
                return fmt::format("{}: got {}, expected at most {}", option->get_name(), option->count(), most);
    return error.what();
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& arguments)
{
    const auto chosen = app.get_subcommands();
    if (chosen.empty()) {
        const auto verbs = verb_names(app);
        if (arguments.empty())
            return "stickslip: no command given. Commands: " + listed(verbs) +
                   ".\nExample: stickslip sweep -o out\nstickslip --help says what each verb does.\n";
        const auto& given = arguments.front();
        const bool option = given.starts_with("-");
        return std::string("stickslip: there is no ") + (option ? "option " : "verb ") + in_quotes(given) + ", " +
               (option ? "a verb comes first; verbs are " : "verbs are ") + listed(verbs) +
               (option ? did_you_mean(given, option_names(app)) : did_you_mean(given, verbs)) + "\n";
    }
    const CLI::App& verb = *chosen.front();
    std::string text = "stickslip " + verb.get_name() + ": " + verb_error(verb, error);
    text += "\n";
    if (const auto footer = verb.get_footer(); !footer.empty()) text += footer + "\n";
    return text;
}

}  // namespace stickslip
