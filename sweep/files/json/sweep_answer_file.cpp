#include "sweep/files/json/sweep_answer_file.h"

#include "sweep/files/json/answer_fields.h"
#include "sweep/files/text/bad_input.h"
#include "sweep/files/text/whole_file.h"

#include <fstream>
#include <iterator>

namespace stickslip {

void write_sweep_answer(const SweepAnswer& answer, const std::filesystem::path& directory)
{
    archive::Json json = {{"format", sweep_answer_format}};
    json.update(archive::written(answer));
    write_whole(directory / sweep_answer_name,
                json.dump(-1, ' ', false, archive::Json::error_handler_t::replace) + "\n");
}

std::optional<SweepAnswer> read_sweep_answer(const std::filesystem::path& directory, std::string_view plan_id)
{
    const auto path = directory / sweep_answer_name;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const auto json = archive::Json::parse(text, nullptr, false);
    if (!json.is_object()) throw BadInput(path.string() + ": is not a sweep answer; remove it to have it made again");
    const auto says = [&](const char* key, std::string_view value) {
        return json.contains(key) && json[key].is_string() && json[key].get_ref<const std::string&>() == value;
    };
    if (!says("format", sweep_answer_format) || !says("plan_id", plan_id)) return std::nullopt;
    try {
        SweepAnswer answer;
        archive::read(json, answer);
        return answer;
    } catch (const std::invalid_argument& e) {
        throw BadInput(path.string() + ": " + e.what() + "; remove the file to have it made again");
    }
}

}  // namespace stickslip
