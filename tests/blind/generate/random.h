// Draws that are the same on every platform: the standard fixes the engine's numbers, but not those of its
// distributions.
#pragma once
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <random>
#include <vector>

namespace blind {

class Draw {
  public:
    explicit Draw(std::uint64_t seed) : engine_(seed) {}

    double uniform(double low, double high) { return low + (high - low) * (engine_() >> 11) * 0x1p-53; }
    double log_uniform(double low, double high) { return low * std::exp(uniform(0, std::log(high / low))); }
    int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    double sign() { return chance(0.5) ? 1 : -1; }
    double phase() { return uniform(-std::numbers::pi, std::numbers::pi); }
    std::uint64_t seed() { return engine_(); }

    /// Standard normal, by Box and Muller.
    double normal()
    {
        const double radius = std::sqrt(-2 * std::log(1 - uniform(0, 1)));
        return radius * std::cos(2 * std::numbers::pi * uniform(0, 1));
    }

    template <class T>
    T pick(std::initializer_list<T> choices)
    {
        return choices.begin()[below(static_cast<int>(choices.size()))];
    }

    template <class T>
    void shuffle(std::vector<T>& items)
    {
        for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(static_cast<int>(i))]);
    }

  private:
    std::mt19937_64 engine_;
};

/// A seed for item `index` of the stream `seed`, so that case 7 is the same whether 8 or 800 are made (splitmix64
/// finaliser).
inline std::uint64_t seed_of(std::uint64_t seed, std::uint64_t index)
{
    std::uint64_t x = seed + 0x9e3779b97f4a7c15u * (index + 1);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

}  // namespace blind
