// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The networks that come with yorb, as readers other than ours see them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "detection/class_names.h"
#include "detection/onnx_model.h"

namespace yorb {
namespace {

const std::string kModels = YORB_SOURCE_DIR "/models/";

class ShippedNetwork : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const Result<OnnxModel> model = ReadOnnxFile(kModels + GetParam());
    ASSERT_TRUE(model) << model.error().message;
    model_ = *model;
  }

  OnnxModel model_;
};

TEST_P(ShippedNetwork, AnEnlargementWithoutARegionIsDeclaredByAnOperatorSetThatHasIt) {
  int num_enlargements = 0;
  for (const OnnxNode& node : model_.nodes) {
    if (node.op != "Resize") continue;
    ++num_enlargements;
    ASSERT_GE(node.inputs.size(), 3u);
    const bool has_no_region = node.inputs[1].empty();
    EXPECT_GE(model_.opset, has_no_region ? 13 : 11) << "ONNX Runtime refuses " << node.name;
  }
  const bool has_people = model_.metadata.count("people") > 0;
  EXPECT_EQ(num_enlargements, has_people ? 3 : 2);
  EXPECT_EQ(has_people, model_.outputs.back().name == "people");
}

TEST_P(ShippedNetwork, NamesTheClassesOfTheTableBesideIt) {
  std::vector<std::string> table;
  std::ifstream file(kModels + "classes.txt");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    int number = 0;
    std::string name;
    if (words >> number >> name) table.push_back(name);
  }
  ASSERT_FALSE(table.empty());
  const auto names = ParseClassNames(model_.metadata["names"]);
  ASSERT_TRUE(names);
  EXPECT_THAT(*names, testing::ElementsAreArray(table));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedNetwork, testing::Values("yolo_mo.onnx", "yolo_mo_n.onnx"), [](const auto& name) {
  const std::string file = name.param;
  return file.substr(0, file.find('.'));
});

}  // namespace
}  // namespace yorb
