#include "sweep/files/records/foreign_log.h"

#include "sweep/files/text/bad_input.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <system_error>

extern char** environ;

namespace stickslip {
namespace {

std::vector<std::string> lines_of(const std::string& text)
{
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

std::system_error system_failure(const char* what)
{
    return {errno, std::generic_category(), what};
}

/// Reads until everybody has closed the other end; an interrupt meanwhile goes to the child.
std::string read_all(int end, pid_t child)
{
    std::string text;
    std::array<char, 4096> buffer{};
    for (;;) {
        const ssize_t got = read(end, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR)
            kill(child, SIGINT);
        else if (got <= 0)
            return text;
        else
            text.append(buffer.data(), static_cast<std::size_t>(got));
    }
}

/// Where a child's streams go, and that an interrupt waits until it has loaded what hears it.
class Spawning {
  public:
    Spawning()
    {
        posix_spawn_file_actions_init(&files_);
        posix_spawnattr_init(&attributes_);
        sigset_t blocked;
        sigemptyset(&blocked);
        sigaddset(&blocked, SIGINT), sigaddset(&blocked, SIGTERM);
        posix_spawnattr_setsigmask(&attributes_, &blocked);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK);
        posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    }
    ~Spawning()
    {
        posix_spawn_file_actions_destroy(&files_);
        posix_spawnattr_destroy(&attributes_);
    }
    Spawning(const Spawning&) = delete;
    Spawning& operator=(const Spawning&) = delete;

    void words_to(int end)
    {
        posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&files_, end, STDERR_FILENO);
    }

    /// Throws BadInput where there is no such program.
    pid_t start(std::vector<std::string> words) const
    {
        std::vector<char*> arguments;
        for (auto& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        pid_t child = 0;
        const int failed = posix_spawnp(&child, arguments[0], &files_, &attributes_, arguments.data(), environ);
        if (failed)
            throw BadInput(words[0] + " cannot be started (" + std::strerror(failed) +
                           "); logs other than CSV need it with the Python package of stickslip");
        return child;
    }

  private:
    posix_spawn_file_actions_t files_;
    posix_spawnattr_t attributes_;
};

std::filesystem::path own_folder()
{
    std::string name = (std::filesystem::temp_directory_path() / "stickslip-log-XXXXXX").string();
    if (!mkdtemp(name.data()))
        throw std::filesystem::filesystem_error("cannot make a folder", name,
                                                std::error_code(errno, std::generic_category()));
    return name;
}

/// The Python that reads logs. A `python3` of pyenv, conda or a virtual environment that stands first in PATH does not
/// see what Debian's package has installed; that of the package always does.
std::string reading_python()
{
    if (const char* chosen = std::getenv("STICKSLIP_PYTHON"); chosen && *chosen) return chosen;
    return std::filesystem::exists("/usr/lib/python3/dist-packages/stickslip/convert.py") ? "/usr/bin/python3"
                                                                                          : "python3";
}

}  // namespace

std::vector<std::string> conversion_command(const std::string& log, const std::string& table, const std::string& joint,
                                            const LogOptions& options)
{
    std::vector<std::string> words{reading_python(), "-m", "stickslip.convert", log, table};
    const std::pair<const char*, const std::string*> named[] = {
        {"--joint", &joint},       {"--topic", &options.topic}, {"--command", &options.command},
        {"--time", &options.time}, {"--group", &options.group}, {"--episode", &options.episode}};
    for (const auto& [name, value] : named)
        if (!value->empty()) words.insert(words.end(), {name, *value});
    return words;
}

int run_conversion(std::vector<std::string> words, std::string* said)
{
    Spawning spawning;
    int ends[2] = {-1, -1};
    if (said) {
        if (pipe2(ends, O_CLOEXEC) != 0) throw system_failure("cannot make a pipe");
        spawning.words_to(ends[1]);
    }
    pid_t child = 0;
    try {
        child = spawning.start(std::move(words));
    } catch (...) {
        for (const int end : ends) close(end);
        throw;
    }
    if (said) {
        close(ends[1]);
        *said = read_all(ends[0], child);
        close(ends[0]);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) kill(child, SIGINT);
    constexpr int by_signal = 128;
    return WIFEXITED(status) ? WEXITSTATUS(status) : by_signal + WTERMSIG(status);
}

ForeignLog::ForeignLog(const std::filesystem::path& log, const std::string& joint, const LogOptions& options)
    : log_(log), folder_(own_folder()), table_(folder_ / (name_of_log(log) + ".csv"))
{
    try {
        std::string said;
        const int code = run_conversion(conversion_command(log.string(), table_.string(), joint, options), &said);
        auto lines = lines_of(said);
        if (code != 0) {
            constexpr std::size_t most = 5;  // the end of a traceback says what it is about
            if (lines.empty()) lines.push_back(log.string() + ": reading it ended with " + std::to_string(code));
            if (lines.size() > most) lines.erase(lines.begin(), lines.end() - most);
            constexpr int by_python_itself = 1;  // it has no package stickslip, or one that does not start
            if (code == by_python_itself)
                lines.push_back("this was " + reading_python() + "; STICKSLIP_PYTHON=path chooses another Python");
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
