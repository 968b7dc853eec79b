// stickslip blind: diagnoses blind test cases, each in a process of its own that sees only its folder, and scores the
// answers.
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"
#include "sweep/program/verbs/blind_calibration.h"
#include "sweep/program/verbs/exit_code.h"
#include "sweep/program/verbs/number_option.h"
#include "sweep/program/verbs/say.h"
#include "sweep/program/verbs/verbs.h"
#include "sweep/study/score.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <thread>

namespace stickslip {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Options {
    std::string directory, truth, answers, score, calibration, population;
    int jobs = 1;
    int threads = 0;
    double timeout = 600;  ///< s a case
};

struct Running {
    std::size_t number = 0;
    std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();
    bool stopped = false, signalled = false;  ///< for taking too long; by an interrupt of the whole run
};

std::string read_text(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw BadInput(file.string() + ": cannot be read");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<fs::path> cases_of(const fs::path& directory)
{
    std::vector<fs::path> cases;
    if (!fs::is_directory(directory)) throw BadInput(directory.string() + ": is not a directory");
    for (const auto& entry : fs::directory_iterator(directory))
        if (fs::exists(entry.path() / "joint.toml")) cases.push_back(entry.path());
    std::sort(cases.begin(), cases.end());
    if (cases.empty()) throw BadInput(directory.string() + ": holds no case (a folder with joint.toml and records)");
    return cases;
}

/// Runs this program's diagnose on a copy of the case in a folder of its own; gives the process.
pid_t start(const fs::path& one_case, const fs::path& scratch, int threads)
{
    fs::create_directories(scratch);
    std::vector<std::string> words{fs::read_symlink("/proc/self/exe").string(), "diagnose", "joint.toml"};
    for (const auto& entry : fs::directory_iterator(one_case)) {
        const auto name = entry.path().filename().string();
        write_whole(scratch / name, read_text(entry.path()));  // fs::copy calls a full disk an error of input or output
        if (name.ends_with(".csv") || name.ends_with(".csv.gz")) words.push_back(name);
    }
    std::sort(words.begin() + 3, words.end());
    for (const char* word : {"-o", "answer", "--no-report", "--threads"}) words.emplace_back(word);
    words.push_back(std::to_string(threads));
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    // only async-signal-safe calls from here on
    if (chdir(scratch.c_str()) != 0) _exit(127);
    const int null = open("/dev/null", O_WRONLY);
    const int log = open("log.txt", O_WRONLY | O_CREAT, 0644);
    dup2(null, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
}

Json failed(const std::string& log)
{
    return {{"verdict", "failed"}, {"effects", Json::array()}, {"log", log}};
}

struct Ended {
    pid_t process = -1;
    bool interrupted = false;  ///< what it has written is half an answer or none
};

/// Waits for a case to end; stops those that take too long, and all of them where a stop is requested.
Ended next_done(std::map<pid_t, Running>& running, double timeout, const std::atomic<bool>& interrupted)
{
    for (;;) {
        int status = 0;
        const pid_t done = waitpid(-1, &status, WNOHANG);
        const bool by_signal = done > 0 && WIFSIGNALED(status) && interrupted;
        if (done != 0) return {done, by_signal || (WIFEXITED(status) && WEXITSTATUS(status) == exit_interrupted)};
        const auto now = std::chrono::steady_clock::now();
        for (auto& [pid, one] : running) {
            // a terminal has sent them the signal already, a batch system has not
            if (interrupted && !one.signalled) one.signalled = true, kill(pid, SIGINT);
            if (!one.stopped && std::chrono::duration<double>(now - one.since).count() > timeout)
                one.stopped = true, kill(pid, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

/// What answers.json says of one case, from its diagnosis.json.
Json answer_of(const fs::path& scratch)
{
    const fs::path file = scratch / "answer" / "diagnosis.json";
    if (!fs::exists(file)) return failed(fs::exists(scratch / "log.txt") ? read_text(scratch / "log.txt") : "");
    const Json d = Json::parse(read_text(file));
    Json answer{{"verdict", d["verdict"]}, {"effects", Json::array()}, {"probabilities", Json::array()}};
    for (const auto& effect : d["effects"]) {
        answer["effects"].push_back(effect["names"]);
        answer["probabilities"].push_back(effect["probability"]);
    }
    answer["ambiguous_with"] = d["ambiguous_with"];
    answer["gap_before"] = d["gap"]["overall"]["before"];
    answer["gap_after"] = d["gap"]["overall"]["after"];
    return answer;
}

using Truths = std::map<std::string, blind::Truth>;

/// Read before the work: what is wrong with the file is said before hours of it.
Truths truths_of(const Options& options)
{
    if (options.truth.empty()) return {};
    const auto text = read_text(options.truth);
    try {
        return blind::parse_truths(text);
    } catch (const std::exception& e) {
        throw BadInput(options.truth + ": " + e.what());
    }
}

void use_answers(const Options& options, const std::vector<fs::path>& cases, const Json& all, const Truths& truths)
{
    if (options.truth.empty()) return;
    const auto answers = blind::parse_answers(all.dump());
    const auto score = blind::score(answers, truths);
    fmt::print("{}", blind::score_text(score));
    if (!options.score.empty()) write_whole(options.score, blind::score_json(score) + "\n");
    if (options.calibration.empty()) return;
    write_calibration(options.calibration, options.population, cases, answers, truths);
    fmt::print("calibration: {}\n", options.calibration);
}

int run_cases(const Options& options, Invocation& invocation)
{
    if (!options.calibration.empty() && (options.truth.empty() || options.population.empty()))
        throw BadInput("--calibration: needs --truth, and --population to say how the cases were drawn");
    const auto cases = cases_of(options.directory);
    const Truths truths = truths_of(options);
    const fs::path root = fs::temp_directory_path() / fmt::format("stickslip-blind-{}", getpid());
    std::map<pid_t, Running> running;
    std::map<std::string, Json> answers;
    std::size_t next = 0;
    while (next < cases.size() || !running.empty()) {
        while (next < cases.size() && static_cast<int>(running.size()) < std::max(1, options.jobs) &&
               !invocation.interrupted) {
            const auto name = cases[next].filename().string();
            try {
                running[start(cases[next], root / name, options.threads)] = {next};
            } catch (const std::exception& e) {  // the others are still answered
                answers[name] = failed(e.what());
                say("{:>4}/{}  {}  failed  {}\n", answers.size(), cases.size(), name, e.what());
            }
            ++next;
        }
        if (running.empty() && invocation.interrupted) break;
        if (running.empty()) continue;
        const auto [done, cut_short] = next_done(running, options.timeout, invocation.interrupted);
        if (done < 0) break;
        const Running one = running.at(done);
        const auto name = cases[one.number].filename().string();
        running.erase(done);
        if (cut_short && invocation.interrupted) continue;
        answers[name] = one.stopped ? failed(fmt::format("stopped after {} s", options.timeout))
                        : cut_short ? failed("its process was interrupted")
                                    : answer_of(root / name);
        say("{:>4}/{}  {}  {}  {}\n", answers.size(), cases.size(), name, answers[name]["verdict"].get<std::string>(),
            answers[name]["effects"].empty() ? "" : answers[name]["effects"][0].dump());
        fs::remove_all(root / name);
    }
    fs::remove_all(root);
    Json all = Json::object();
    for (auto& [name, answer] : answers) all[name] = answer;
    const fs::path file =
        options.answers.empty() ? fs::path(options.directory) / "answers.json" : fs::path(options.answers);
    write_whole(file, all.dump(2) + "\n");
    for (const auto& [name, answer] : answers)
        if (answer["verdict"] == "failed") say("{} failed: {}\n", name, answer.value("log", std::string("no log")));
    fmt::print("answers: {}\n", file.string());
    if (answers.size() < cases.size()) {
        say("interrupted: {} of {} cases were answered; the others are left out\n", answers.size(), cases.size());
        return exit_interrupted;
    }
    use_answers(options, cases, all, truths);
    return exit_done;
}

}  // namespace

void add_blind(CommandLine& line, Invocation& invocation)
{
    auto options = std::make_shared<Options>();
    auto verb = line.add_verb("blind", "Diagnose blind cases, each in a separate process, and score the answers");
    verb.add_option("DIR", options->directory, "folder of case-NN/{joint.toml, *.csv.gz}")->required();
    verb.add_option("--truth", options->truth, "file of the true answers: scores them, after all cases are answered");
    verb.add_option("--answers", options->answers, "where to write the answers (DIR/answers.json)");
    verb.add_option("--score", options->score, "where to write the score as JSON");
    verb.add_option("--calibration", options->calibration,
                    "where to write answers and truth as a calibration for diagnose --guarantee");
    verb.add_option("--population", options->population,
                    "how the cases were drawn: generator, seed; the guarantee holds for joints drawn in this way");
    verb.add_option("--jobs", options->jobs, "cases that run at the same time")->check(whole_between(1, most_threads));
    verb.add_option("--timeout", options->timeout, "seconds after which a case is stopped")->check(positive_number());
    add_threads(verb, options->threads, "threads of each diagnosis; 0: all cores");
    verb.footer(
        "Example: stickslip blind cases --truth cases.truth.json\n"
        "Exit codes: 0 done (the answers say which cases failed), 2 bad input, 3 interrupted, with the answers so far "
        "written.");
    verb.callback([options, &invocation] {
        catch_interrupts(invocation);
        invocation.exit_code = run_cases(*options, invocation);
    });
}

}  // namespace stickslip
