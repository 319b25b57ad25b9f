// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/log.h"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <map>
#include <mutex>
#include <sstream>
#include <utility>

#include "core/text.h"

namespace yorb {
namespace {

/// The one log of the process: what goes to the terminal, what to the file, and how often each warning came.
struct Log {
  std::mutex mutex;
  LogOptions options;
  std::shared_ptr<spdlog::logger> to_stdout, to_stderr, to_file, to_text;
  std::ostringstream text;
  std::map<std::string, int> warnings;
  bool file_failed = false;
};

Log& TheLog() {
  static Log log;
  return log;
}

constexpr const char* kDatedLine = "%Y-%m-%d %H:%M:%S.%e %l: %v";
constexpr std::streamoff kMostTextBytes = 200000;

std::shared_ptr<spdlog::logger> Plain(const char* name, spdlog::sink_ptr sink) {
  auto logger = std::make_shared<spdlog::logger>(name, std::move(sink));
  logger->set_pattern("%v");
  logger->set_error_handler([](const std::string&) { TheLog().file_failed = true; });
  return logger;
}

spdlog::logger& Stderr(Log& log) {
  if (!log.to_stderr) log.to_stderr = Plain("stderr", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  return *log.to_stderr;
}

void Write(Log& log, spdlog::level::level_enum level, const std::string& text) {
  const std::string line = OneLine(text);
  if (level >= spdlog::level::warn) Stderr(log).log(level, line);
  if (level < spdlog::level::warn && log.to_stdout) log.to_stdout->log(level, line);
  if (log.to_file) log.to_file->log(level, line);
  if (log.to_text && log.text.tellp() < kMostTextBytes) log.to_text->log(level, line);
}

void SumUp(Log& log) {
  for (auto& [kind, count] : log.warnings) {
    const int hidden = count - log.options.repeats_shown;
    if (hidden <= 0) continue;
    Write(log, spdlog::level::warn, kind + ": " + std::to_string(hidden) + " more of these warnings");
    count = log.options.repeats_shown;
  }
}

}  // namespace

Status StartLog(const LogOptions& options) {
  Log& log = TheLog();
  const std::lock_guard<std::mutex> lock(log.mutex);
  log.options = options;
  log.warnings.clear();
  log.file_failed = false;
  log.to_stdout = options.to_stdout ? Plain("stdout", std::make_shared<spdlog::sinks::stdout_sink_mt>()) : nullptr;
  log.to_file = log.to_text = nullptr;
  log.text.str("");
  if (options.keeps_text) {
    log.to_text = Plain("text", std::make_shared<spdlog::sinks::ostream_sink_mt>(log.text));
    log.to_text->set_pattern(kDatedLine);
  }
  if (options.file.empty()) return Status::Ok();
  try {
    log.to_file = Plain("file", std::make_shared<spdlog::sinks::basic_file_sink_mt>(options.file, true));
  } catch (const spdlog::spdlog_ex& error) {
    return BadInput(options.file + " cannot be written: " + error.what());
  }
  log.to_file->set_pattern(kDatedLine);
  return Status::Ok();
}

void SumUpWarnings() {
  Log& log = TheLog();
  const std::lock_guard<std::mutex> lock(log.mutex);
  SumUp(log);
}

std::string LogText() {
  Log& log = TheLog();
  const std::lock_guard<std::mutex> lock(log.mutex);
  return log.text.str();
}

Status StopLog() {
  Log& log = TheLog();
  const std::lock_guard<std::mutex> lock(log.mutex);
  SumUp(log);
  log.warnings.clear();
  if (log.to_file) log.to_file->flush();
  const std::string file = log.options.file;
  log.to_file = log.to_stdout = log.to_text = nullptr;
  log.options = {};
  if (std::exchange(log.file_failed, false)) return Failure(file + " cannot be written whole; is the disk full?");
  return Status::Ok();
}

void LogInfo(const std::string& line) {
  Log& log = TheLog();
  const std::lock_guard<std::mutex> lock(log.mutex);
  Write(log, spdlog::level::info, line);
}

void LogError(const std::string& line) {
  Log& log = TheLog();
  const std::lock_guard<std::mutex> lock(log.mutex);
  Write(log, spdlog::level::err, line);
}

void LogWarning(const std::string& kind, const std::string& line) {
  Log& log = TheLog();
  const std::lock_guard<std::mutex> lock(log.mutex);
  if (++log.warnings[kind] <= log.options.repeats_shown) Write(log, spdlog::level::warn, line);
}

}  // namespace yorb
