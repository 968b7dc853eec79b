// Runs the program as a user's shell would.
#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/temporary_directory.h"

namespace program {

struct Run {
    int exit_code;
    std::string output;  ///< standard output and error together
};

/// A line of shell, from the root of the sources.
inline Run shell(const std::string& line)
{
    const std::string command = std::string("cd '") + SOURCE_ROOT + "' && { " + line + "; } 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) throw std::runtime_error("no shell");
    Run run;
    std::array<char, 4096> buffer;
    while (const auto n = fread(buffer.data(), 1, buffer.size(), pipe)) run.output.append(buffer.data(), n);
    const int status = pclose(pipe);
    run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return run;
}

/// `stickslip ARGUMENTS`, arguments as a shell reads them; without what it says of a search that takes longer than a
/// second, which depends on the machine.
inline Run stickslip(const std::string& arguments)
{
    Run run = shell(std::string("'") + STICKSLIP + "' " + arguments);
    constexpr const char* searching = "still searching: ";
    for (std::size_t at = run.output.find(searching); at != std::string::npos; at = run.output.find(searching, at)) {
        const bool starts_line = at == 0 || run.output[at - 1] == '\n';
        const std::size_t end = run.output.find('\n', at);
        if (starts_line && end != std::string::npos)
            run.output.erase(at, end + 1 - at);
        else
            ++at;
    }
    return run;
}

/// A folder of its own, removed at the end.
class Folder {
  public:
    std::string operator/(const std::string& name) const { return (directory_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const
    {
        std::ofstream(directory_ / name) << text;
        return (directory_ / name).string();
    }

  private:
    TemporaryDirectory directory_;
};

/// A file as it is; of a page the words, numbers apart from their units by ordinary spaces.
inline std::string read(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    std::string all = text.str();
    const std::string no_break = "\u00a0";
    if (file.ends_with(".html"))
        for (auto at = all.find(no_break); at != std::string::npos; at = all.find(no_break, at))
            all.replace(at, 2, " ");
    return all;
}

}  // namespace program
