// read_reference(), write_record(): what a joint is to follow from CSV, and what it did to CSV. Link stickslip::files.
#pragma once
#include "sweep/files/records/reference_file.h"
