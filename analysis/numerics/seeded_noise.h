// The same normal numbers on every machine.
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

namespace stickslip {

/// splitmix64 (Steele, Lea & Flood 2014) and Box-Muller. The seed is scrambled: neighbours would else be one sequence,
/// shifted.
class SeededNoise {
  public:
    explicit SeededNoise(std::uint64_t seed) : state_(scrambled(seed * step)) {}
    double operator()()
    {
        const double radius = std::sqrt(-2 * std::log(1 - uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }
    /// In [0, 1).
    double uniform() { return static_cast<double>(scrambled(state_ += step) >> 11) * 0x1.0p-53; }

  private:
    static constexpr std::uint64_t step = 0x9E3779B97F4A7C15ull;
    static std::uint64_t scrambled(std::uint64_t z)
    {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

}  // namespace stickslip
