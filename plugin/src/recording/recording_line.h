// The way of a session's calls, and of those of its calibrations, to the recording, if one runs.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "plugin/src/recording/recorder.h"

namespace hrt::plugin {

/// Outlives its session for as long as calibrations have it. record() is real-time, and may be called from
/// any threads; the others are the session's.
class RecorderGate {
 public:
  /// Hands on what `make_record()` returns; nothing is built for a recording that is off.
  template <class MakeRecord>
  void record(MakeRecord&& make_record) {
    callers_.fetch_add(1);
    if (Recorder* recorder = recorder_.load()) recorder->push(make_record());
    callers_.fetch_sub(1);
  }
  /// The same for what belongs to one recording, `of`, only.
  template <class MakeRecord>
  void record(std::uint64_t of, MakeRecord&& make_record) {
    callers_.fetch_add(1);
    if (Recorder* recorder = recorder_.load(); recorder && count_.load() == of) recorder->push(make_record());
    callers_.fetch_sub(1);
  }

  void open(Recorder* recorder) {
    count_.fetch_add(1);
    recorder_.store(recorder);
  }
  /// Afterwards nobody has the recorder. A call that was under way in another thread at the fork never ends
  /// in the child.
  void close(bool forked) {
    recorder_.store(nullptr);
    if (forked) callers_.store(0);
    while (callers_.load() > 0) std::this_thread::yield();
  }

  /// Which recording runs, from 1; 0: none.
  std::uint64_t current() const { return recorder_.load() ? count_.load() : 0; }

 private:
  std::atomic<Recorder*> recorder_{nullptr};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<int> callers_{0};
};

}  // namespace hrt::plugin
