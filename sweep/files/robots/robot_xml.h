// The two formats of robots, from XML. Internal to sweep/files.
#pragma once
#include "sweep/files/robots/xml_input.h"
#include "sweep/study/import/robot.h"

namespace stickslip::files {

Robot read_urdf(const XmlFile& file);
/// `folder` is where included files are looked up.
Robot read_mjcf(XmlFile file, const std::filesystem::path& folder);

}  // namespace stickslip::files
