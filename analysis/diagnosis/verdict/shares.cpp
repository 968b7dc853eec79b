#include "analysis/diagnosis/verdict/shares.h"

#include <algorithm>
#include <cstdint>

namespace stickslip::gap {

void add_shares(std::vector<Share>& shares, const std::vector<Block>& blocks, std::size_t whole)
{
    constexpr int resamples = 200;
    if (blocks.empty()) return;
    const auto of = [&](const Block& sum, std::size_t i) {
        double total = 0;
        for (std::size_t j = 0; j < whole; ++j) total += std::max(0.0, sum[j]);
        return total > 0 ? std::clamp(sum[i] / total, 0.0, 1.0) : 0;
    };
    Block sum(blocks[0].size(), 0);
    for (const auto& b : blocks)
        for (std::size_t i = 0; i < b.size(); ++i) sum[i] += b[i];
    std::uint64_t state = 1;
    std::vector<std::vector<double>> drawn(shares.size());
    for (int r = 0; r < resamples; ++r) {
        Block again(sum.size(), 0);
        for (std::size_t n = 0; n < blocks.size(); ++n) {
            state = state * 6364136223846793005ull + 1442695040888963407ull;
            const auto& b = blocks[(state >> 33) % blocks.size()];
            for (std::size_t i = 0; i < b.size(); ++i) again[i] += b[i];
        }
        for (std::size_t i = 0; i < shares.size(); ++i) drawn[i].push_back(of(again, i));
    }
    for (std::size_t i = 0; i < shares.size(); ++i) {
        std::sort(drawn[i].begin(), drawn[i].end());
        shares[i].share = of(sum, i);
        shares[i].interval = {drawn[i][resamples / 40], drawn[i][resamples - 1 - resamples / 40]};
    }
}

}  // namespace stickslip::gap
