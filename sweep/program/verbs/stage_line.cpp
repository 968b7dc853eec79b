#include "sweep/program/verbs/stage_line.h"

#include "sweep/program/verbs/say.h"
#include "sweep/words/stage_text.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <utility>

namespace stickslip {
namespace {

constexpr StageLine::Interval on_terminal{500}, in_log{30'000};

}  // namespace

StageLine::StageLine(std::string shorter, std::optional<Interval> patience)
    : shorter_(std::move(shorter)), terminal_(isatty(STDERR_FILENO) != 0)
{
    clock_ = std::thread([this, patience] {
        const auto interval = terminal_ ? on_terminal : in_log;
        auto next = start_ + patience.value_or(interval);
        std::unique_lock lock(mutex_);
        while (!ended_.wait_until(lock, next, [this] { return end_; })) {
            draw();
            next = std::chrono::steady_clock::now() + interval;
        }
    });
}

StageLine::~StageLine()
{
    {
        const std::lock_guard lock(mutex_);
        end_ = true;
    }
    ended_.notify_all();
    clock_.join();
    if (!terminal_ || !drawn_) return;
    say("\r\x1b[K");
    std::fflush(stderr);
}

void StageLine::stage(std::string what, double done)
{
    const std::lock_guard lock(mutex_);
    const bool begins = stage_ != what || !is_set(done);
    // another joint's diagnosis begins anew
    if (!(done >= done_)) began_ = std::chrono::steady_clock::now();
    stage_ = std::move(what);
    done_ = done;
    if (!begins) return;
    tasks_ = 0;
    if (terminal_ && drawn_) draw();
}

std::string searches_less(double effort)
{
    return fmt::format("--effort {:.3g} searches less", effort / 10);
}

StageProgress StageLine::listener(std::string about)
{
    return [this, about = std::move(about)](DiagnosisStage begins, double done) {
        stage(about + std::string(stage_text(begins)), done);
    };
}

ParallelFor StageLine::counted(ParallelFor run)
{
    const auto counting = std::make_shared<std::atomic<bool>>(false);
    return [this, counting, run = std::move(run)](std::size_t n, const std::function<void(std::size_t)>& task) {
        if (counting->exchange(true)) return run(n, task);  // what a task shares with others is no task
        struct End {
            std::atomic<bool>& counting;
            ~End() { counting = false; }
        } end{*counting};
        finished_ = 0;
        tasks_ = n;
        run(n, [&](std::size_t i) {
            task(i);
            ++finished_;
        });
    };
}

void StageLine::draw()
{
    if (stage_.empty()) return;
    const auto now = std::chrono::steady_clock::now();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - start_).count();
    const auto left = time_left_text(done_, std::chrono::duration<double>(now - began_).count());
    const std::size_t tasks = tasks_, finished = finished_;
    const auto text = fmt::format("{}{}{}  {} s{}{}",
                                  is_set(done_) ? fmt::format("{:3.0f} %  ", 100 * done_) : "still searching: ", stage_,
                                  tasks > 1 ? fmt::format(", {} of {}", finished, tasks) : "", seconds,
                                  left.empty() ? "" : ", " + left, shorter_.empty() ? "" : "  (" + shorter_ + ")");
    say("{}{}{}", terminal_ ? "\r\x1b[K" : "", text, terminal_ ? "" : "\n");
    std::fflush(stderr);
    drawn_ = true;
}

}  // namespace stickslip
