// A progress line on a terminal: share, rate, time left. Silent when piped.
#pragma once
#include "sweep/engine/engine.h"

namespace stickslip {

class ProgressLine {
  public:
    ProgressLine();
    bool shown() const { return terminal_; }
    void update(const Progress& progress);
    /// Takes the line away again.
    void end();

  private:
    bool terminal_ = false;
    bool drawn_ = false;
};

}  // namespace stickslip
