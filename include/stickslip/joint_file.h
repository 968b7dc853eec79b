// read_joint(), joint_text(): a joint from TOML and back. Programs that call them link stickslip::files.
#pragma once
#include "sweep/files/toml/joint_file.h"
