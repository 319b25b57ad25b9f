// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The program: reads the command line and hands over to the chosen subcommand.
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <string>
#include <vector>

#include "apps/command.h"
#include "core/log.h"
#include "core/text.h"
#include "runs/version.h"

namespace yorb {

int Complain(const Error& error) {
  std::fprintf(stderr, "yorb: %s\n", OneLine(error.message).c_str());
  return error.kind == Error::Kind::kBadInput ? kExitBadInput : kExitFailure;
}

namespace {

/// A program that was started without standard streams must not find its result files in their place.
void OpenMissingStreams() {
  for (int file = STDIN_FILENO; file <= STDERR_FILENO; ++file) {
    if (::fcntl(file, F_GETFD) == -1 && ::open("/dev/null", O_RDWR) == -1) return;
  }
}

/// What the libraries underneath would do on their own: die of a closed pipe or a size limit, print, start threads,
/// keep freed memory for each thread by itself.
void CalmLibraries() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  cv::setNumThreads(1);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; });
#ifdef __GLIBC__
  ::mallopt(M_ARENA_MAX, 1);  // what one stage frees the next takes: frames go from thread to thread
#endif
  std::cerr.rdbuf(nullptr);  // where OpenCV tells of pictures that it cannot decode; we write to stderr itself
  ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);  // AV_LOG_QUIET: nor ffmpeg of videos
}

/// The subcommand that the command line got as far as.
const CLI::App& ChosenCommand(const CLI::App& program) {
  const CLI::App* chosen = &program;
  while (!chosen->get_subcommands().empty()) chosen = chosen->get_subcommands().front();
  return *chosen;
}

std::vector<std::string> OptionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> CommandsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

/// The nearest known words, all that are equally near: "--set or --seed".
std::string Nearest(const std::string& word, const std::vector<std::string>& known) {
  const size_t least = EditDistance(word, NearestWord(word, known));
  std::string nearest;
  for (const std::string& candidate : known) {
    if (EditDistance(word, candidate) == least) nearest += (nearest.empty() ? "" : " or ") + candidate;
  }
  return nearest;
}

std::string FullName(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name()
                                         : FullName(*command.get_parent()) + " " + command.get_name();
}

/// One line that says what is wrong with the command line.
std::string Explain(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& command = ChosenCommand(program);
  const std::string help = " (" + FullName(command) + " --help says more)";
  const std::vector<std::string> commands = CommandsOf(command);
  for (const std::string& word : command.remaining()) {
    if (word.size() < 2 || word.front() != '-') continue;
    const std::string name = word.substr(0, word.find('='));
    return name + " is no option of " + FullName(command) + "; did you mean " + Nearest(name, OptionsOf(command)) +
           "?" + help;
  }
  if (!commands.empty()) {
    if (command.remaining().empty())
      return FullName(command) + " needs a command, such as " + FullName(command) + " " + commands.front() + help;
    const std::string word = command.remaining().front();
    return word + " is no command of " + FullName(command) + "; did you mean " + Nearest(word, commands) + "?" + help;
  }
  const std::string what = error.what();
  const size_t start = what.find_first_not_of(": ");  // CLI11 begins so where it knows no name for an option
  return FullName(command) + ": " + (start == std::string::npos ? what : what.substr(start)) + help;
}

/// Bad input for an option with nothing behind it, as scripts give it whose variable is not set: taken as left out, it
/// would be ignored in silence. Whoever asks for a folder by position complains of an empty one himself.
Status CheckValues(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& values = option->results();
    const bool is_named = !option->get_lnames().empty();
    if (is_named && std::any_of(values.begin(), values.end(), [](const std::string& v) { return v.empty(); }))
      return BadInput("--" + option->get_lnames().front() + " is empty; give a value, or leave it out");
  }
  return Status::Ok();
}

int ReadAndAct(int argc, char** argv) {
  CLI::App program{"yorb: visual SLAM that stays accurate among moving people", "yorb"};
  program.require_subcommand(1);
  program.set_version_flag("--version", std::string("yorb ") + Version(), "Prints the version and ends");
  program.footer(
      "Examples:\n"
      "  yorb run rgbd_dataset_freiburg1_xyz --out results\n"
      "  yorb eval --reference groundtruth.txt --estimate results/trajectory.txt\n"
      "  yorb run --help");
  Action action;
  AddRunCommand(program, action);
  AddCheckCommand(program, action);
  AddEvalCommand(program, action);
  AddSynthCommand(program, action);
  AddDetectCommand(program, action);
  AddVocabCommand(program, action);
  AddMapCommand(program, action);
  AddBenchCommand(program, action);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // help or version, on standard output
    return Complain(BadInput(Explain(program, error)));
  }
  if (const Status given = CheckValues(ChosenCommand(program)); !given) return Complain(given.error());
  const int code = action();
  SumUpWarnings();  // of commands that keep no log: a warning that repeats is counted, never lost
  return code;
}

/// Whether standard output goes into a pipe whose reader has seen enough (`| head`).
bool IsReaderGone() {
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&out, 1, 0) > 0 && (out.revents & POLLERR) != 0;
}

/// Output that was lost, to a full disk say, is no success.
int CheckOutput(int code) {
  const bool is_whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (is_whole || code != kExitDone || IsReaderGone()) return code;
  return Complain(Failure("standard output cannot be written; is the disk full?"));
}

/// Ends without the exit handlers of the libraries underneath: OpenBLAS waits there for its threads, without an end
/// where the system gives them no memory (`ulimit -v`).
[[noreturn]] void End(int code) {
  std::fflush(nullptr);
  std::_Exit(code);
}

}  // namespace
}  // namespace yorb

int main(int argc, char** argv) {
  yorb::OpenMissingStreams();
  yorb::CalmLibraries();
  try {
    yorb::End(yorb::CheckOutput(yorb::ReadAndAct(argc, argv)));
  } catch (const std::exception& error) {
    yorb::End(yorb::Complain(yorb::FailureOf(error)));
  }
}
