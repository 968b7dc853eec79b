// stickslip man-page: the manual in roff, made from the verbs and options themselves.
#include "sweep/engine/build.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/verbs.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace stickslip {
namespace {

/// Text as roff takes it: no line begins with a control character, backslashes and hyphens are themselves.
std::string roff(const std::string& text)
{
    std::string out;
    bool line_start = true;
    for (const char c : text) {
        if (line_start && (c == '.' || c == '\'')) out += "\\&";
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
        line_start = c == '\n';
    }
    return out;
}

std::string option_entry(const CLI::Option& option)
{
    std::string head = option.get_name(option.get_positional());
    if (!option.get_positional()) head = option.get_name(false, true);
    const auto type = option.get_type_name();
    const auto standard = option.get_default_str();
    std::string text =
        ".TP\n.B " + roff(head) +
        (type.empty() || option.get_positional() ? "" : " \\fI" + roff(type.substr(0, type.find(':'))) + "\\fR") +
        "\n" + roff(option.get_description());
    if (!standard.empty()) text += " (default " + roff(standard) + ")";
    return text + "\n";
}

std::string verb_section(const CLI::App& verb)
{
    std::string text = ".SS " + roff(verb.get_name()) + "\n" + roff(verb.get_description()) + ".\n";
    for (const auto* option : verb.get_options())
        if (option->get_name() != "--help") text += option_entry(*option);
    if (const auto footer = verb.get_footer(); !footer.empty()) text += ".PP\n.EX\n" + roff(footer) + "\n.EE\n";
    return text;
}

std::string man_page(const CLI::App& app)
{
    std::string text = ".TH STICKSLIP 1 \"\" \"stickslip " + program_version() +
                       "\" \"User commands\"\n.SH NAME\nstickslip \\- stick-slip of robot joints\n"
                       ".SH SYNOPSIS\n.B stickslip\n.I verb\n.RI [ options ]\n.SH DESCRIPTION\n" +
                       roff(app.get_description()) + "\n.SH VERBS\n";
    for (const auto* verb : app.get_subcommands([](const CLI::App*) { return true; })) text += verb_section(*verb);
    text +=
        ".SH ENVIRONMENT\n.TP\n.B SOURCE_DATE_EPOCH\nDate written on reports, in seconds since 1970.\n"
        ".TP\n.B STICKSLIP_INSTRUCTIONS\nbaseline, avx2 or avx512: the widest instructions that simulations use; "
        "default: all that the processor has. With GLIBC_TUNABLES=glibc.cpu.hwcaps=\\-AVX2,\\-FMA a check can be tried "
        "here as another machine would compute it.\n"
        ".TP\n.B NO_COLOR\nSet to anything: no colours on the terminal either.\n.SH EXIT STATUS\n" +
        roff(app.get_footer()) + "\n";
    return text;
}

}  // namespace

void add_man_page(CommandLine& line, Invocation& invocation)
{
    auto verb = line.add_verb("man-page", "Print the manual page");
    verb.footer("Example: stickslip man-page | man -l -");
    verb.callback([&declared = line.declared(), &invocation] {
        fmt::print("{}", man_page(declared));
        invocation.exit_code = exit_done;
    });
}

}  // namespace stickslip
