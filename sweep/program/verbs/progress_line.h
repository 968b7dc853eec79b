// A progress line on a terminal: share, rate, time left. Silent when piped.
#pragma once
#include "sweep/engine/engine.h"

#include <string>

namespace stickslip {

class ProgressLine {
  public:
    ProgressLine();
    bool shown() const { return terminal_; }
    void update(const Progress& progress);
    /// What goes on after the last point.
    void say_next(const std::string& what);
    /// Takes the line away again.
    void end();

  private:
    bool terminal_ = false;
    bool drawn_ = false;
};

}  // namespace stickslip
