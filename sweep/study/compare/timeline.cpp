#include "sweep/study/compare/timeline.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <limits>

namespace stickslip {
namespace {

/// Reads a date from one place of a text on.
class Digits {
  public:
    explicit Digits(std::string_view text) : text_(text) {}

    /// Exactly so many digits, and none behind them where it `ends` a number; -1 where they are not there.
    int take(std::size_t count)
    {
        if (text_.size() < count) return -1;
        int value = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (!std::isdigit(static_cast<unsigned char>(text_[i]))) return -1;
            value = 10 * value + (text_[i] - '0');
        }
        text_.remove_prefix(count);
        return value;
    }
    void skip_one_of(std::string_view marks)
    {
        if (!text_.empty() && marks.find(text_.front()) != std::string_view::npos) text_.remove_prefix(1);
    }
    bool digit_next() const { return !text_.empty() && std::isdigit(static_cast<unsigned char>(text_.front())); }
    std::string_view left() const { return text_; }

  private:
    std::string_view text_;
};

/// What stands behind the date, if it is a time of day.
std::chrono::seconds time_of_day(Digits in)
{
    using namespace std::chrono;
    in.skip_one_of("T_ -");
    const int hour = in.take(2);
    in.skip_one_of(":-");
    const int minute = hour < 0 ? -1 : in.take(2);
    if (hour < 0 || hour > 23 || minute < 0 || minute > 59) return seconds(0);
    in.skip_one_of(":-");
    const int second = in.take(2);
    const bool valid = second >= 0 && second < 60 && !in.digit_next();
    return hours(hour) + minutes(minute) + seconds(valid ? second : 0);
}

std::optional<Timestamp> date_at(std::string_view text)
{
    using namespace std::chrono;
    Digits in(text);
    const int year_number = in.take(4);
    in.skip_one_of("-");
    const int month_number = year_number < 0 ? -1 : in.take(2);
    in.skip_one_of("-");
    const int day_number = month_number < 0 ? -1 : in.take(2);
    if (day_number < 0) return {};
    const year_month_day date{year(year_number), month(static_cast<unsigned>(month_number)),
                              day(static_cast<unsigned>(day_number))};
    constexpr int first_year = 1970;
    if (!date.ok() || year_number < first_year) return {};
    return sys_days(date) + time_of_day(in);
}

NumberSeries& series_of(std::vector<NumberSeries>& all, const FoundNumber& found, std::size_t runs)
{
    const auto same = std::find_if(all.begin(), all.end(), [&](const NumberSeries& s) {
        return s.of == found.of && s.name == found.number.name && s.unit == found.number.unit;
    });
    if (same != all.end()) return *same;
    const std::vector<double> none(runs, std::numeric_limits<double>::quiet_NaN());
    all.push_back({found.number.name, found.number.unit, found.of, none, none});
    return all.back();
}

}  // namespace

Timeline timeline_of(std::string title, std::vector<DatedDiagnosis> runs)
{
    std::stable_sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    Timeline t{std::move(title), std::move(runs), {}, {}};
    for (std::size_t i = 1; i < t.runs.size(); ++i)
        t.steps.push_back(compare_diagnoses(t.runs[i - 1].facts, t.runs[i].facts));
    for (std::size_t i = 0; i < t.runs.size(); ++i)
        for (const auto& found : t.runs[i].facts.numbers) {
            if (found.of == FoundNumber::Of::correction) continue;
            auto& series = series_of(t.numbers, found, t.runs.size());
            series.value[i] = found.number.value, series.standard_error[i] = found.number.standard_error;
            ++series.found;
        }
    std::stable_sort(t.numbers.begin(), t.numbers.end(),
                     [](const auto& a, const auto& b) { return a.found > b.found; });
    return t;
}

std::optional<Timestamp> date_in(std::string_view name)
{
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (i > 0 && std::isdigit(static_cast<unsigned char>(name[i - 1]))) continue;  // in the middle of a number
        if (const auto date = date_at(name.substr(i))) return date;
    }
    return {};
}

std::string date_text(Timestamp at)
{
    using namespace std::chrono;
    const auto day_start = floor<days>(at);
    const year_month_day date(day_start);
    const hh_mm_ss<seconds> time(at - day_start);
    char text[64];
    std::snprintf(text, sizeof text, "%04d-%02u-%02u", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
    std::string all = text;
    if (at == day_start) return all;
    std::snprintf(text, sizeof text, " %02d:%02d", static_cast<int>(time.hours().count()),
                  static_cast<int>(time.minutes().count()));
    return all + text;
}

double days_between(Timestamp from, Timestamp to)
{
    using Days = std::chrono::duration<double, std::ratio<86400>>;
    return std::chrono::duration_cast<Days>(to - from).count();
}

}  // namespace stickslip
