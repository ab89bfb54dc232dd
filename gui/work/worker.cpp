#include "gui/work/worker.hpp"

#include <QMetaObject>
#include <chrono>

#include "base/control.hpp"
#include "base/stopwatch.hpp"

namespace jointid::gui {
namespace {

constexpr double seconds_between_signs = 0.05;

/// What any exception tells the user.
InputError as_input_error(const std::exception& error) {
  if (const auto* input = dynamic_cast<const InputError*>(&error)) return *input;
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return InputError({ErrorKind::data, "", "", "there is not enough memory", "take fewer lines or files"});
  }
  return InputError({ErrorKind::data, "", "", std::string("a bug in jointid: ") + error.what(), "please report it"});
}

}  // namespace

Worker::Worker(QObject* parent) : QObject(parent), thread_([this](const std::stop_token& stop) { run(stop); }) {}

Worker::~Worker() {
  ++generation_;
  thread_.request_stop();
  thread_.join();
}

void Worker::add(Work work) {
  {
    const std::scoped_lock lock(mutex_);
    queue_.push_back(std::move(work));
  }
  more_.notify_one();
  if (++waiting_ == 1) Q_EMIT busy_changed(true);
}

void Worker::cancel() {
  std::size_t forgotten = 0;
  {
    const std::scoped_lock lock(mutex_);
    forgotten = queue_.size();
    queue_.clear();
    ++generation_;
  }
  for (std::size_t i = 0; i < forgotten; ++i) end([this] { Q_EMIT cancelled(); });
}

void Worker::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    Work work;
    std::size_t ticket = 0;
    {
      std::unique_lock lock(mutex_);
      if (!more_.wait(lock, stop, [this] { return !queue_.empty(); })) return;
      work = std::move(queue_.front());
      queue_.pop_front();
      ticket = generation_;
    }
    do_one(work, ticket, stop);
  }
}

void Worker::do_one(const Work& work, std::size_t ticket, const std::stop_token& stop) {
  std::mutex last_mutex;  // progress comes from several threads
  auto last = Clock::time_point();
  WholeShare whole;
  Watch watch;
  watch.interrupted = [this, ticket, stop] { return stop.stop_requested() || generation_ != ticket; };
  watch.progress = [&](const char* stage, std::size_t done, std::size_t total) {
    const std::scoped_lock lock(last_mutex);
    const double part = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : -1.0;
    const JobShare share = whole.note(QString::fromUtf8(stage), part);
    if (seconds_since(last) < seconds_between_signs) return;
    last = Clock::now();
    QMetaObject::invokeMethod(
        this, [this, share] { Q_EMIT progressed(share); }, Qt::QueuedConnection);
  };
  watch.begin = [&](const JobStep& step) {
    const std::scoped_lock lock(last_mutex);
    whole.begin(step);
  };
  watch.show = [this](Deliver deliver) { QMetaObject::invokeMethod(this, std::move(deliver), Qt::QueuedConnection); };
  try {
    end(work(watch));
  } catch (const Interrupted&) {
    end([this] { Q_EMIT cancelled(); });
  } catch (const std::exception& error) {
    end([this, what = as_input_error(error)] { Q_EMIT failed(what); });
  }
}

void Worker::end(Deliver deliver) {
  const auto finish = [this, deliver = std::move(deliver)] {
    if (--waiting_ == 0) Q_EMIT busy_changed(false);
    if (deliver) deliver();
  };
  QMetaObject::invokeMethod(this, finish, Qt::QueuedConnection);
}

}  // namespace jointid::gui
