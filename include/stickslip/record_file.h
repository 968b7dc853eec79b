// read_record(): a measured record from CSV. Programs that call it link stickslip::files.
#pragma once
#include "sweep/files/records/record_file.h"
