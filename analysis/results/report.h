// A report before it is a page: verdict first, then alerts, charts, tables, provenance. Plain text fields are escaped
// by the page writer; fields called mark-up may hold the chart mark-up "k_{p}", "10^{−6}" and nothing else.
#pragma once
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/results/detailed_chart.h"
#include "analysis/results/line_drawing.h"
#include "analysis/results/stability_panels.h"

namespace stickslip {

/// One number of the first screen, with its limit and its meaning.
struct Headline {
    enum class Tone { neutral, good, warning, bad };
    Tone tone = Tone::neutral;
    std::string value;    ///< mark-up, "× 1.82" or "55.0 kN/m"
    std::string meaning;  ///< mark-up, "k_p margin to the stability boundary (k_{cr} = 55.0 kN/m)"
};

struct Alert {
    Headline::Tone tone = Headline::Tone::warning;
    std::string text;
};

/// A share of 1, drawn before the words of a table's cell; NaN: none. Its interval is NaN where there is none.
struct ShareBar {
    double share, low, high;
};

struct Table {
    std::string title;
    std::vector<std::string> columns;            ///< mark-up
    std::vector<std::vector<std::string>> rows;  ///< mark-up
    std::size_t bar_column = 0;                  ///< which cells the bars stand in
    std::vector<ShareBar> bars = {};             ///< empty, or one for each row
};

/// Text to take along as it is, such as the lines of a file: shown in a box that copies and saves it.
struct Snippet {
    std::string title;  ///< mark-up
    std::string text;   ///< plain
    std::string file;   ///< name under which it is saved; empty: it can only be copied
};

using Picture =
    std::variant<StabilityMap, CriticalGainSurface, LineChart, FieldMap, StabilityPanels, LineDrawing, DetailedChart>;

/// A chart with the words under it.
struct Figure {
    std::string id;  ///< [a-z0-9-]+: anchor in the page and name of the SVG/PNG/CSV file beside it
    Picture picture;
    std::string caption;  ///< mark-up: how to read it and what was compared
    std::string finding;  ///< alt text: what the picture shows, in words
};

struct Section {
    std::string id, title;  ///< title is mark-up
    std::string text;       ///< mark-up paragraph, may be empty
    std::vector<Figure> figures;
    std::vector<Table> tables;
};

struct Report {
    std::string title;     ///< mark-up
    std::string subtitle;  ///< mark-up: joint, control kind, grid
    std::string verdict;   ///< mark-up: the answer in one sentence
    Headline::Tone tone = Headline::Tone::neutral;
    std::vector<Headline> headlines;
    std::vector<Alert> alerts;
    std::vector<std::string> findings = {};  ///< mark-up: short paragraphs of the first screen, below the numbers
    std::vector<Snippet> snippets = {};      ///< below them
    std::vector<Section> sections;
    std::vector<std::string> not_checked;                         ///< mark-up
    std::vector<std::pair<std::string, std::string>> provenance;  ///< version, commit, spec hash, seed, command …
};

}  // namespace stickslip
