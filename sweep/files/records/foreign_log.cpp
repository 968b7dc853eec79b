#include "sweep/files/records/foreign_log.h"

#include "sweep/files/text/bad_input.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

extern char** environ;

namespace stickslip {
namespace {

/// Runs a program with its error output in a file; its exit code, or 128 + the signal that ended it.
int run(std::vector<std::string> words, const std::string& errors)
{
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    pid_t child = 0;
    const int failed = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed)
        throw BadInput(words[0] + " cannot be started (" + std::strerror(failed) +
                       "); logs other than CSV need it with the Python package of stickslip");
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    constexpr int by_signal = 128;
    return WIFEXITED(status) ? WEXITSTATUS(status) : by_signal + WTERMSIG(status);
}

std::vector<std::string> lines_of(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

std::filesystem::path own_folder()
{
    std::string name = (std::filesystem::temp_directory_path() / "stickslip-log-XXXXXX").string();
    if (!mkdtemp(name.data()))
        throw std::filesystem::filesystem_error("cannot make a folder", name,
                                                std::error_code(errno, std::generic_category()));
    return name;
}

}  // namespace

std::vector<std::string> conversion_command(const std::string& log, const std::string& table, const std::string& joint,
                                            const LogOptions& options)
{
    std::vector<std::string> words{"python3", "-m", "stickslip.convert", log, table};
    const std::pair<const char*, const std::string*> named[] = {{"--joint", &joint},
                                                                {"--topic", &options.topic},
                                                                {"--command", &options.command},
                                                                {"--time", &options.time},
                                                                {"--episode", &options.episode}};
    for (const auto& [name, value] : named)
        if (!value->empty()) words.insert(words.end(), {name, *value});
    return words;
}

ForeignLog::ForeignLog(const std::filesystem::path& log, const std::string& joint, const LogOptions& options)
    : log_(log), folder_(own_folder()), table_(folder_ / (name_of_log(log) + ".csv"))
{
    try {
        const auto errors = folder_ / "errors";
        const int code = run(conversion_command(log.string(), table_.string(), joint, options), errors.string());
        auto lines = lines_of(errors);
        if (code != 0) {
            constexpr std::size_t most = 5;  // the end of a traceback says what it is about
            if (lines.empty()) lines.push_back(log.string() + ": reading it ended with " + std::to_string(code));
            if (lines.size() > most) lines.erase(lines.begin(), lines.end() - most);
            throw BadInput(lines);
        }
        guesses_ = std::move(lines);
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
        throw;
    }
}

ForeignLog::~ForeignLog()
{
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::vector<std::string> ForeignLog::as_of_the_log(std::vector<std::string> messages) const
{
    const std::string mine = table_.string();
    for (auto& text : messages)
        for (auto at = text.find(mine); at != std::string::npos; at = text.find(mine, at))
            text.replace(at, mine.size(), log_.string()), at += log_.string().size();
    return messages;
}

}  // namespace stickslip
