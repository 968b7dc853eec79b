// diagnosis.json read back, as far as diagnoses are compared.
#pragma once
#include "sweep/study/compare/diagnosis_facts.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace stickslip {

/// `source` names the answer in messages. Throws BadInput for anything that is not diagnosis.json of this program.
DiagnosisFacts diagnosis_facts(const nlohmann::ordered_json& json, const std::string& source);

/// From diagnosis.json, or from the folder that holds it.
DiagnosisFacts read_diagnosis(const std::filesystem::path& path);

/// The JSON of a file. Throws BadInput with the byte at which it stops being JSON.
nlohmann::ordered_json read_json(const std::filesystem::path& file);

}  // namespace stickslip
