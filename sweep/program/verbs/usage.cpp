#include "sweep/program/verbs/usage.h"

#include "analysis/joint/parameters.h"

#include <fmt/format.h>

#include <regex>
#include <string_view>

namespace stickslip {
namespace {

std::string in_quotes(const std::string& text)
{
    return '"' + text + '"';
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string did_you_mean(const std::string& given, const std::vector<std::string>& known)
{
    auto near = nearest_names(given, known);
    if (near.empty() && !given.empty())
        for (const auto& name : known)
            if (name.starts_with(given)) near.push_back(name);
    return near.empty() ? "" : "; did you mean " + near.front() + "?";
}

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

std::vector<std::string> split_at_commas(std::string rest)
{
    std::vector<std::string> parts;
    rest += ',';
    for (auto comma = rest.find(','); comma != std::string::npos; comma = rest.find(',')) {
        parts.push_back(rest.substr(0, comma));
        rest.erase(0, comma + 1);
    }
    return parts;
}

/// "--threads: x not in {a,b}" and its like in the words of every other message of this program.
std::string value_error(const std::string& message)
{
    std::smatch m;
    const auto given = [&] { return m[1].str() + ": got " + in_quotes(m[2]); };
    if (std::regex_match(message, m, std::regex(R"((\S+): (.*) not in \{(.*)\})"))) {
        const auto allowed = split_at_commas(m[3]);
        return given() + ", expected " + listed(allowed) + did_you_mean(m[2], allowed);
    }
    if (std::regex_match(message, m, std::regex(R"((\S+): \((.*) not in \{(.*)\}\) OR \(File does not exist: .*\))"))) {
        const auto allowed = split_at_commas(m[3]);
        return given() + ", expected " + listed(allowed) + " or a file" + did_you_mean(m[2], allowed);
    }
    if (std::regex_match(message, m, std::regex(R"((\S+): At Most (\d+) required but received (\d+))")))
        return m[1].str() + ": got " + m[3].str() + ", expected at most " + m[2].str();
    return message;
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
    std::string text = "stickslip " + verb.get_name() + ": ";
    const std::string message = error.what();
    constexpr std::string_view unexpected = " not expected: ";
    if (const auto at = message.find(unexpected); at != std::string::npos) {
        const auto stranger = message.substr(at + unexpected.size());
        const auto name = stranger.substr(0, stranger.find_first_of("= "));
        const bool option = name.starts_with("-");
        text += option ? "there is no option " + in_quotes(name) + ", options are " + listed(option_names(verb)) +
                             did_you_mean(name, option_names(verb))
                       : in_quotes(name) + " is one argument too many";
    } else {
        text += value_error(message);
    }
    text += "\n";
    if (const auto footer = verb.get_footer(); !footer.empty()) text += footer + "\n";
    return text;
}

}  // namespace stickslip
