// stickslip completion: what a shell needs to finish words, made from the verbs and options themselves.
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/program/verbs/word_option.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace stickslip {
namespace {

std::vector<const CLI::App*> verbs_of(const CLI::App& app)
{
    return app.get_subcommands([](const CLI::App*) { return true; });
}

/// One description, safe within single quotes and brackets of zsh.
std::string safe(const std::string& text)
{
    std::string kept;
    for (const char c : text.substr(0, text.find('\n')))
        if (c == '\'')
            kept += "’";
        else if (c == '[' || c == ']')
            kept += ' ';
        else if (c == ':')
            kept += " –";  // what stands behind a colon is another field
        else
            kept += c;
    return kept;
}

std::vector<std::string> options_of(const CLI::App& verb)
{
    std::vector<std::string> names;
    for (const auto* option : verb.get_options()) {
        for (const auto& name : option->get_lnames()) names.push_back("--" + name);
        for (const auto& name : option->get_snames()) names.push_back("-" + name);
    }
    return names;
}

/// "fold outcome …" where an option or argument takes one of a few words; the library names them in its type.
std::string allowed_words(const CLI::Option& option)
{
    const std::string type = option.get_type_name();
    const auto open = type.find('{'), close = type.find('}');
    if (open == std::string::npos || close == std::string::npos) return "";
    std::string words = type.substr(open + 1, close - open - 1);
    std::replace(words.begin(), words.end(), ',', ' ');
    return words;
}

/// Words that may follow an option, or the verb itself where its argument is one of a few.
std::string bash_words(const CLI::App& verb)
{
    std::string cases;
    for (const auto* option : verb.get_options()) {
        const auto words = allowed_words(*option);
        if (words.empty()) continue;
        const std::string before = option->get_positional() ? verb.get_name() : "--" + option->get_lnames().front();
        cases += fmt::format("        {}:{}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", verb.get_name(),
                             before, words);
    }
    return cases;
}

std::string bash(const CLI::App& app)
{
    std::string verbs, cases, words;
    for (const auto* verb : verbs_of(app)) {
        verbs += (verbs.empty() ? "" : " ") + verb->get_name();
        std::string options;
        for (const auto& name : options_of(*verb)) options += (options.empty() ? "" : " ") + name;
        cases += fmt::format("        {}) options='{}' ;;\n", verb->get_name(), options);
        words += bash_words(*verb);
    }
    return fmt::format(
        "# bash completion for stickslip\n"
        "_stickslip() {{\n"
        "    local word=${{COMP_WORDS[COMP_CWORD]}} options\n"
        "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
        "        COMPREPLY=($(compgen -W '{} --help --version' -- \"$word\"))\n"
        "        return\n"
        "    fi\n"
        "    case ${{COMP_WORDS[1]}} in\n"
        "{}"
        "    esac\n"
        "    case ${{COMP_WORDS[1]}}:${{COMP_WORDS[COMP_CWORD-1]}} in\n"
        "{}"
        "    esac\n"
        "    case $word in\n"
        "        -*) COMPREPLY=($(compgen -W \"$options\" -- \"$word\")) ;;\n"
        "        *) COMPREPLY=($(compgen -f -- \"$word\")); compopt -o filenames 2>/dev/null ;;\n"
        "    esac\n"
        "}}\n"
        "complete -F _stickslip stickslip\n",
        verbs, cases, words);
}

std::string zsh(const CLI::App& app)
{
    std::string verbs, cases;
    for (const auto* verb : verbs_of(app)) {
        verbs += fmt::format("        '{}:{}'\n", verb->get_name(), safe(verb->get_description()));
        std::string options, argument = "_files";
        for (const auto* option : verb->get_options()) {
            const auto words = allowed_words(*option);
            const std::string values = words.empty() ? "_files" : "(" + words + ")";
            if (option->get_positional() && !words.empty()) argument = values;
            for (const auto& name : option->get_lnames())
                options += fmt::format(" '--{}[{}]{}'", name, safe(option->get_description()),
                                       option->get_items_expected_max() > 0 ? ":value:" + values : "");
        }
        cases += fmt::format("        {}) _arguments{} '*:argument:{}' ;;\n", verb->get_name(), options, argument);
    }
    return fmt::format(
        "#compdef stickslip\n"
        "_stickslip() {{\n"
        "    local -a verbs\n"
        "    verbs=(\n"
        "{}"
        "    )\n"
        "    if (( CURRENT == 2 )); then\n"
        "        _describe verb verbs\n"
        "        return\n"
        "    fi\n"
        "    local verb=$words[2]\n"
        "    shift words\n"
        "    (( CURRENT-- ))\n"
        "    case $verb in\n"
        "{}"
        "    esac\n"
        "}}\n"
        "# the file lies in $fpath, or it is sourced\n"
        "if [ \"$funcstack[1]\" = _stickslip ]; then _stickslip \"$@\"; else compdef _stickslip stickslip; fi\n",
        verbs, cases);
}

std::string fish(const CLI::App& app)
{
    std::string text = "# fish completion for stickslip\n";
    for (const auto* verb : verbs_of(app)) {
        const auto& name = verb->get_name();
        const auto line = [&](const std::string& rest) {
            text += fmt::format("complete -c stickslip -n '__fish_seen_subcommand_from {}' {}\n", name, rest);
        };
        text += fmt::format("complete -c stickslip -n __fish_use_subcommand -f -a {} -d '{}'\n", name,
                            safe(verb->get_description()));
        for (const auto* option : verb->get_options()) {
            const auto words = allowed_words(*option);
            if (option->get_positional()) {
                if (!words.empty()) line(fmt::format("-f -a '{}'", words));
                continue;
            }
            std::string names;
            for (const auto& n : option->get_lnames()) names += " -l " + n;
            for (const auto& n : option->get_snames()) names += " -s " + n;
            const std::string value = option->get_items_expected_max() == 0 ? ""
                                      : words.empty()                       ? " -r"
                                                                            : " -x -a '" + words + "'";
            line(fmt::format("{}{} -d '{}'", names.substr(1), value, safe(option->get_description())));
        }
    }
    return text;
}

}  // namespace

void add_completion(CommandLine& line, Invocation& invocation)
{
    auto shell = std::make_shared<std::string>();
    auto verb = line.add_verb("completion", "Print what bash, zsh or fish needs to complete verbs and options");
    verb.add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(one_of({"bash", "zsh", "fish"}));
    verb.footer(
        "Examples: source <(stickslip completion bash)\n"
        "          stickslip completion fish | source");
    verb.callback([shell, &declared = line.declared(), &invocation] {
        fmt::print("{}", *shell == "bash" ? bash(declared) : *shell == "zsh" ? zsh(declared) : fish(declared));
        invocation.exit_code = exit_done;
    });
}

}  // namespace stickslip
