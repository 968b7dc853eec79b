// Records of a joint from texts, and what their reader says of bad ones.
#pragma once
#include "sweep/files/records/record_file.h"
#include "sweep/files/toml/joint_file.h"
#include "tests/sweep/files/messages.h"
#include "tests/temporary_directory.h"

#include <zlib.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace record_texts {

using namespace stickslip;

inline Joint joint_of(const std::string& motion)
{
    return read_joint_text("joint = { motion = \"" + motion +
                               "\", inertia = 1 }\ncontrol = { k_p = 1, period = 1e-3 }\n" +
                               "friction = { law = \"coulomb-viscous\", coulomb = 1, viscous = 1 }\n",
                           "joint.toml");
}

inline std::filesystem::path file(const std::string& content, const std::string& name = "run.csv")
{
    std::ofstream(shared_directory() / name, std::ios::binary) << content;
    return shared_directory() / name;
}

inline RecordReading read(const std::string& content, const std::string& layout = "",
                          const std::string& motion = "prismatic")
{
    const Joint joint = joint_of(motion);
    return read_record(file(content), joint, read_record_layout_text(layout, "record.toml", joint));
}

/// The errors of a file, without the folder in front.
inline std::vector<std::string> errors(const std::string& content, const std::string& layout = "",
                                       const RecordLimits& limits = {})
{
    const Joint joint = joint_of("prismatic");
    auto all = messages_of(
        [&] { read_record(file(content), joint, read_record_layout_text(layout, "record.toml", joint), limits); });
    for (auto& message : all)
        while (message.find(shared_directory().path().string()) != std::string::npos)
            message.erase(message.find(shared_directory().path().string()),
                          shared_directory().path().string().size() + 1);
    return all;
}

inline std::string only_error(const std::string& content, const std::string& layout = "",
                              const RecordLimits& limits = {})
{
    const auto all = errors(content, layout, limits);
    for (const auto& message : all) UNSCOPED_INFO(message);
    REQUIRE(all.size() == 1);
    return all.front();
}

inline std::string gzipped(const std::string& text, const char* mode = "wb")
{
    const auto path = (shared_directory() / "zip.gz").string();
    gzFile out = gzopen(path.c_str(), mode);
    gzwrite(out, text.data(), static_cast<unsigned>(text.size()));
    gzclose(out);
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace record_texts
