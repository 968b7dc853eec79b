// Runs a fuzz target where the compiler brings no fuzzer: every file of the corpus, then mutations of them from a
// printed seed. Usage: fuzz_TARGET [--inputs N] [--seed S] CORPUS...
// The input in hand is kept in shared memory and written to crash-TARGET when the process dies of it.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Input = std::vector<std::uint8_t>;
constexpr std::size_t largest_input = 1u << 16;
constexpr unsigned longest_seconds = 20;  ///< of one input; longer is a hang

struct InHand {
    std::size_t size = 0;
    std::uint64_t tried = 0;
    std::uint8_t bytes[largest_input];
};

/// What numbers, quotes and brackets break most readily.
constexpr const char* words[] = {"0",       "-1", "1e300", "1e-300", "1e999", "nan",    "inf", "9223372036854775808",
                                 "\"",      "[",  "]",     "{",      "}",     "=",      ",",   "\n",
                                 "\n[a]\n", "\0", "\xff",  "true",   "'''",   "\"\"\"", "#",   ".",
                                 "-",       "e",  ":"};

std::vector<Input> read_corpus(const std::vector<std::string>& places)
{
    std::vector<Input> corpus;
    std::vector<std::filesystem::path> files;
    for (const auto& place : places)
        if (std::filesystem::is_directory(place))
            for (const auto& entry : std::filesystem::directory_iterator(place)) files.push_back(entry.path());
        else
            files.emplace_back(place);
    std::ranges::sort(files);
    for (const auto& file : files) {
        std::ifstream in(file, std::ios::binary);
        Input input{std::istreambuf_iterator<char>(in), {}};
        input.resize(std::min(input.size(), largest_input));
        corpus.push_back(std::move(input));
    }
    return corpus;
}

Input mutated(const std::vector<Input>& corpus, std::mt19937_64& random)
{
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random() % n); };
    Input input = corpus[below(corpus.size())];
    for (std::size_t edits = 1 + below(6); edits > 0; --edits) {
        const std::size_t at = below(input.size() + 1);
        const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
        const std::size_t length = std::min(below(32), input.size() - at);
        switch (below(7)) {
            case 0:
                if (at < input.size()) input[at] ^= static_cast<std::uint8_t>(1u << below(8));
                break;
            case 1:
                if (at < input.size()) input[at] = static_cast<std::uint8_t>(random());
                break;
            case 2:
                input.erase(place, place + static_cast<std::ptrdiff_t>(length));
                break;
            case 3: {
                const Input copy(place, place + static_cast<std::ptrdiff_t>(length));
                const auto to = static_cast<std::ptrdiff_t>(below(input.size() + 1));
                input.insert(input.begin() + to, copy.begin(), copy.end());
                break;
            }
            case 4:
                input.resize(at);
                break;
            case 5: {
                const std::string_view word = words[below(std::size(words))];
                input.insert(place, word.begin(), word.end());
                break;
            }
            default: {
                const Input& other = corpus[below(corpus.size())];
                const std::size_t from = below(other.size());
                const std::size_t count = std::min(below(64), other.size() - from);
                const auto begin = other.begin() + static_cast<std::ptrdiff_t>(from);
                input.insert(place, begin, begin + static_cast<std::ptrdiff_t>(count));
            }
        }
    }
    input.resize(std::min(input.size(), largest_input));
    return input;
}

void try_input(const Input& input, InHand& in_hand)
{
    in_hand.size = input.size();
    std::ranges::copy(input, in_hand.bytes);
    alarm(longest_seconds);
    LLVMFuzzerTestOneInput(input.data(), input.size());
    ++in_hand.tried;
}

int run(const std::vector<Input>& corpus, std::uint64_t inputs, std::uint64_t seed, InHand& in_hand)
{
    try {
        for (const Input& input : corpus) try_input(input, in_hand);
        std::mt19937_64 random(seed);
        while (in_hand.tried < inputs) try_input(mutated(corpus, random), in_hand);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "escaped exception: %s\n", e.what());
        return 1;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    std::uint64_t inputs = 20'000, seed = 1;
    std::vector<std::string> places;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--inputs") && i + 1 < argc)
            inputs = std::stoull(argv[++i]);
        else if (!std::strcmp(argv[i], "--seed") && i + 1 < argc)
            seed = std::stoull(argv[++i]);
        else
            places.emplace_back(argv[i]);
    }
    const auto corpus = read_corpus(places);
    if (corpus.empty()) return std::fprintf(stderr, "usage: %s [--inputs N] [--seed S] CORPUS...\n", argv[0]), 2;

    void* shared = mmap(nullptr, sizeof(InHand), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) return std::perror("mmap"), 2;
    auto& in_hand = *new (shared) InHand;
    const auto begin = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child == 0) std::exit(run(corpus, inputs, seed, in_hand));
    int status = 0;
    waitpid(child, &status, 0);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    const std::string name = std::filesystem::path(argv[0]).filename();
    const bool sound = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    std::printf("%s: %llu inputs from %zu files, seed %llu, %.1f s: %s\n", name.c_str(),
                static_cast<unsigned long long>(in_hand.tried), corpus.size(), static_cast<unsigned long long>(seed),
                seconds.count(), sound ? "no finding" : "FINDING");
    if (sound) return 0;
    const std::string kept = "crash-" + name;
    std::ofstream(kept, std::ios::binary)
        .write(reinterpret_cast<const char*>(in_hand.bytes), static_cast<std::streamsize>(in_hand.size));
    std::printf("the input is in %s (%s)\n", kept.c_str(),
                WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? "it took too long" : "exit or signal");
    return 1;
}
