// charts/drawn.json: what each chart in a folder was drawn from, so that a chart that would come out the same is kept.
#pragma once
#include "render/render.h"

#include <filesystem>
#include <map>
#include <optional>

namespace stickslip {

inline constexpr char drawn_charts_format[] = "stickslip-charts/1";

class DrawnCharts {
  public:
    /// What the folder says; nothing where it says nothing, or what this program does not read.
    explicit DrawnCharts(std::filesystem::path folder);

    /// The chart as it was drawn, where that was from the same and its files hold what was written.
    std::optional<RenderedFigure> kept(const std::string& id, const std::string& key) const;

    /// Writes the files of a chart, and returns what drawn.json says of it. Safe to call from several threads.
    std::string write(const std::string& id, const std::string& key, const RenderedFigure& figure) const;

    /// Writes drawn.json: `written` as `write` returned it, by id, and of `same` what it said before.
    void write_index(const std::map<std::string, std::string>& written, const std::vector<std::string>& same) const;

  private:
    std::filesystem::path folder_;
    std::map<std::string, std::string> said_;  ///< by id; JSON
};

}  // namespace stickslip
