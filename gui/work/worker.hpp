#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "base/error.hpp"
#include "gui/look/whole_share.hpp"

namespace jointid::gui {

/// One thread that does one thing after another, so that no window waits and no file is read by two threads. All signals are
/// emitted, and all results delivered, in the thread that the object lives in. The destructor asks the work to end and waits for
/// it.
class Worker : public QObject {
  Q_OBJECT

 public:
  /// What is left to do with the result, in the thread of the window.
  using Deliver = std::function<void()>;
  /// How work is watched and stopped; all may be called by any thread.
  struct Watch {
    std::function<bool()> interrupted;
    std::function<void(const char* stage, std::size_t done, std::size_t total)> progress;
    std::function<void(Deliver)> show = {};  ///< what there is so far; a few times per second at most
    std::function<void(const JobStep&)> begin = [](const JobStep&) {};  ///< a step of the job begins: progress is its own
  };
  using Work = std::function<Deliver(const Watch&)>;

  explicit Worker(QObject* parent = nullptr);
  ~Worker() override;

  /// Does it after what was added before.
  void add(Work work);
  /// Forgets what has not begun and asks what has begun to end; it delivers nothing unless it was ready.
  void cancel();
  bool is_busy() const { return waiting_ > 0; }

 Q_SIGNALS:
  void progressed(const jointid::gui::JobShare& share);
  void failed(const jointid::InputError& error);
  void cancelled();
  void busy_changed(bool busy);

 private:
  void run(const std::stop_token& stop);
  void do_one(const Work& work, std::size_t ticket, const std::stop_token& stop);
  void end(Deliver deliver);

  std::mutex mutex_;
  std::condition_variable_any more_;
  std::deque<Work> queue_;
  std::atomic<std::size_t> generation_ = 0;  ///< raised by cancel(): older work is to end
  int waiting_ = 0;                          ///< added and not ended, as the window knows it
  std::jthread thread_;
};

}  // namespace jointid::gui
