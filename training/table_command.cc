// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <string>

#include "training/command.h"
#include "training/network.h"

namespace yorb {
namespace {

Status PrintTable(const std::string& name, int num_classes) {
  Network network(MakeLayout(name, num_classes));
  const Layout& layout = network->layout;
  const auto count = [](const torch::nn::Module& module) {
    int64_t sum = 0;
    for (const torch::Tensor& parameter : module.parameters()) sum += parameter.numel();
    return static_cast<long long>(sum);
  };
  const std::vector<int> channels = OutChannels(layout);
  std::printf("%4s  %-10s %12s  %-16s %8s\n", "row", "from", "parameters", "module", "channels");
  for (size_t i = 0; i < layout.rows.size(); ++i) {
    std::string from;
    for (const int row : layout.rows[i].from) from += std::to_string(row).append(" ");
    std::printf("%4zu  %-10s %12lld  %-16s %8d\n", i, from.c_str(), count(*network->rows[i]),
                KindName(layout.rows[i].kind).c_str(), channels[i]);
  }
  for (size_t level = 0; level < 3; ++level)
    std::printf("%4s  %-10d %12lld  %-16s %8d\n", "", layout.detect_from[level], count(*network->heads[level]),
                "Detect", layout.NumHeadChannels());
  std::printf("%s with %d classes: %lld parameters\n", name.c_str(), num_classes, count(*network));
  return Status::Ok();
}

}  // namespace

void AddTableCommand(CLI::App& program, Action& action) {
  struct Arguments {
    std::string network;
    int num_classes = 10;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("table", "Print a network row by row, with its parameters");
  command->add_option("NETWORK", arguments->network)->required()->check(CLI::IsMember(LayoutNames()));
  command->add_option("--num-classes", arguments->num_classes)->check(CLI::Range(1, 1000))->capture_default_str();
  command->callback([arguments, &action] {
    action = [arguments] { return PrintTable(arguments->network, arguments->num_classes); };
  });
}

}  // namespace yorb
