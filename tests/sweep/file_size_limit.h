// Stands for a full disk.
#pragma once
#include <sys/resource.h>

#include <csignal>

/// While it lives no file of this process may grow beyond the limit, and writing says so instead of killing it.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t most)
    {
        getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{most, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int);
};
