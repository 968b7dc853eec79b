// ParallelFor: whoever asks for an analysis brings the threads.
#pragma once
#include "analysis/base/parallel_for.h"
