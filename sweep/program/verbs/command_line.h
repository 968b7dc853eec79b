// What a verb declares of the command line. A thin layer: the headers of CLI11 take ten seconds to compile, so that
// only command_line.cpp and what reads the declared line as a whole (help, completion, manual) include them.
#pragma once
#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace stickslip {

/// Which values an option takes.
struct Check {
    std::function<std::string(const std::string&)> complaint;  ///< what is wrong with a value; empty: nothing
    std::string type;                                          ///< of the values, in the help
};

/// The path of a file that exists.
Check existing_file();

/// The number that a value is; nothing where it is none.
std::optional<double> number_in(const std::string& value);

/// Refuses an option that does not go with the others, as the library refuses a wrong value.
[[noreturn]] void refuse_option(const std::string& option, const std::string& why);

/// An option or argument as it is being declared: each call adds to it and gives it back.
class Option {
  public:
    explicit Option(CLI::Option* option) : option_(option) {}
    Option* operator->() { return this; }

    Option required();
    Option check(const Check& check);
    /// Shows in the help the value that its variable has now.
    Option capture_default_str();
    Option needs(const Option& other);
    Option excludes(const Option& other);
    Option expected(int count);
    Option expected(int least, int most);
    /// One value each time it is given: what follows is an argument.
    Option one_value();

  private:
    CLI::Option* option_;
};

/// A verb as it is being declared. Variables have to outlive the parsing.
class Verb {
  public:
    explicit Verb(CLI::App* verb) : verb_(verb) {}

    /// `names` as "-o,--output" or, for an argument, "JOINT". Values: std::string, double, int, unsigned, std::size_t,
    /// std::uint64_t and vectors of strings.
    template <class Value>
    Option add_option(const std::string& names, Value& value, const std::string& help);
    Option add_flag(const std::string& names, bool& value, const std::string& help);
    void footer(const std::string& text);
    void callback(std::function<void()> run);

  private:
    CLI::App* verb_;
};

/// The command line of the program as its verbs are added.
class CommandLine {
  public:
    explicit CommandLine(CLI::App& app) : app_(&app) {}

    Verb add_verb(const std::string& name, const std::string& description);
    /// What has been declared, for those that read it.
    CLI::App& declared() const { return *app_; }

  private:
    CLI::App* app_;
};

}  // namespace stickslip
