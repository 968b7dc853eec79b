// Fits that stop where they need predictions, so that several go on side by side in full packs of lanes.
#pragma once
#include "analysis/diagnosis/fit/residuals.h"

#include <coroutine>
#include <exception>
#include <optional>
#include <utility>

namespace stickslip::gap {

/// One fit on its way: where it waits, and for what.
struct Waiting {
    std::coroutine_handle<> at;
    Question* question = nullptr;
};

/// A part of a fit: a coroutine that is run by the part that awaits it, or by `side_by_side`.
template <class T>
class [[nodiscard]] Fitting {
  public:
    struct promise_type;
    using Handle = std::coroutine_handle<promise_type>;

    struct Return {
        bool await_ready() noexcept { return false; }
        std::coroutine_handle<> await_suspend(Handle done) noexcept
        {
            return done.promise().caller ? done.promise().caller : std::noop_coroutine();
        }
        void await_resume() noexcept {}
    };
    struct promise_type {
        Waiting* waiting = nullptr;
        std::coroutine_handle<> caller;
        std::optional<T> value;
        std::exception_ptr thrown;
        Fitting get_return_object() { return Fitting(Handle::from_promise(*this)); }
        std::suspend_always initial_suspend() noexcept { return {}; }
        Return final_suspend() noexcept { return {}; }
        void return_value(T found) { value = std::move(found); }
        void unhandled_exception() { thrown = std::current_exception(); }
    };

    explicit Fitting(Handle handle) : handle_(handle) {}
    Fitting(Fitting&& other) noexcept : handle_(std::exchange(other.handle_, {})) {}
    Fitting& operator=(Fitting&& other) noexcept
    {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Fitting()
    {
        if (handle_) handle_.destroy();
    }

    bool await_ready() const noexcept { return false; }
    template <class Promise>
    std::coroutine_handle<> await_suspend(std::coroutine_handle<Promise> caller)
    {
        handle_.promise().caller = caller, handle_.promise().waiting = caller.promise().waiting;
        return handle_;
    }
    T await_resume() { return result(); }

    /// For the first part of a fit: where it will say what it waits for.
    void begin(Waiting& waiting)
    {
        handle_.promise().waiting = &waiting;
        waiting.at = handle_;
    }
    bool done() const { return handle_.done(); }
    T result()
    {
        if (handle_.promise().thrown) std::rethrow_exception(handle_.promise().thrown);
        return std::move(*handle_.promise().value);
    }

  private:
    Handle handle_;
};

/// Awaited, it is answered together with what other fits ask.
struct Asked : Question {
    bool await_ready() const noexcept { return places.empty(); }
    template <class Promise>
    void await_suspend(std::coroutine_handle<Promise> asking)
    {
        asking.promise().waiting->question = this, asking.promise().waiting->at = asking;
    }
    void await_resume() const noexcept {}
};

/// What each of these fits comes to. Neither their order nor their number changes a bit of it.
template <class T>
std::vector<T> side_by_side(std::vector<Fitting<T>> fits)
{
    std::vector<Waiting> waiting(fits.size());
    for (std::size_t i = 0; i < fits.size(); ++i) fits[i].begin(waiting[i]);
    for (;;) {
        std::vector<Question*> questions;
        for (std::size_t i = 0; i < fits.size(); ++i) {
            if (fits[i].done()) continue;
            waiting[i].at.resume();
            if (!fits[i].done()) questions.push_back(waiting[i].question);
        }
        if (questions.empty()) break;
        answer(questions);
    }
    std::vector<T> found;
    for (auto& fit : fits) found.push_back(fit.result());
    return found;
}

/// One fit by itself.
template <class T>
T alone(Fitting<T> fit)
{
    std::vector<Fitting<T>> one;
    one.push_back(std::move(fit));
    return std::move(side_by_side(std::move(one))[0]);
}

}  // namespace stickslip::gap
