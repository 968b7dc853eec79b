// Why a diagnosis or a plan is refused: a code with its names and numbers.
#pragma once
#include "analysis/results/cannot_answer.h"
