// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/onnx_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "detection/test_network.h"
#include "pictures/test_folder.h"

namespace yorb {
namespace {

using testing::HasSubstr;

/// Fields of a protocol buffer by hand, for what the writer does not write.
std::string Varint(uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
  return bytes + static_cast<char>(value);
}
std::string Number(int id, uint64_t value) { return Varint(static_cast<uint64_t>(id) << 3) + Varint(value); }
std::string Bytes(int id, const std::string& bytes) {
  return Varint(static_cast<uint64_t>(id) << 3 | 2) + Varint(bytes.size()) + bytes;
}

/// A file with one constant, a node that reads it and "images", and these bytes for the constant.
std::string FileWithTensor(const std::string& tensor) {
  const std::string dims = Bytes(1, Number(1, 1)) + Bytes(1, Number(1, 2));
  const auto value = [&](const std::string& name) {
    return Bytes(1, name) + Bytes(2, Bytes(1, Number(1, 1) + Bytes(2, dims)));
  };
  const std::string node = Bytes(1, "images") + Bytes(1, "w") + Bytes(2, "out") + Bytes(4, "Add");
  const std::string graph = Bytes(1, node) + Bytes(5, tensor) + Bytes(11, value("images")) + Bytes(12, value("out"));
  return Number(1, 7) + Bytes(7, graph) + Bytes(8, Number(2, 12));
}

TEST(Onnx, WhatIsWrittenIsReadAgain) {
  TestNetwork net(64, 32);
  net.model.metadata["names"] = "['a', 'b']";
  const std::string out = net.Op("Relu", {net.Conv("images", 3, 4, 3, 2)},
                                 {FloatAttribute("alpha", 0.25f), TextAttribute("mode", "nearest")});
  net.Output(net.Reshaped(out, {1, -1}), {1, -1});
  const auto model = ReadOnnxBytes(net.Bytes(), "net.onnx");
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model->nodes.size(), 3u);
  EXPECT_EQ(model->opset, 13);
  EXPECT_EQ(model->nodes[0].Integers("pads", {}), (std::vector<int64_t>{1, 1, 1, 1}));
  EXPECT_EQ(model->nodes[1].Number("alpha", 0), 0.25f);
  EXPECT_EQ(model->nodes[1].Text("mode", ""), "nearest");
  EXPECT_EQ(model->constants[0].floats, net.model.constants[0].floats);
  EXPECT_EQ(model->constants[2].ints, (std::vector<int64_t>{1, -1}));
  EXPECT_EQ(model->inputs[0].dims, (std::vector<int64_t>{1, 3, 32, 64}));
  EXPECT_EQ(model->outputs[0].dims, (std::vector<int64_t>{1, -1}));
  EXPECT_EQ(model->metadata.at("names"), "['a', 'b']");
  EXPECT_EQ(OnnxBytes(*model), net.Bytes());
}

TEST(Onnx, AFileThatIsCutAnywhereWithinItsGraphIsRefused) {
  const std::string bytes = TwoColourNetwork(false).Bytes();
  const size_t whole = bytes.size() - 4;  // the opset behind the graph
  for (size_t size = 0; size < whole; ++size) EXPECT_FALSE(ReadOnnxBytes(bytes.substr(0, size), "cut.onnx")) << size;
}

TEST(Onnx, DamageNeverReadsBeyondTheFile) {
  const std::string bytes = TwoColourNetwork().Bytes();
  Random random(3);
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = bytes;
    for (int i = 0; i < 3; ++i)
      damaged[random.Below(static_cast<uint32_t>(bytes.size()))] = static_cast<char>(random.Below(256));
    const auto model = ReadOnnxBytes(damaged, "damaged.onnx");  // read or refused; AddressSanitizer watches
    if (model) continue;
    EXPECT_THAT(model.error().message, HasSubstr("damaged.onnx"));
  }
}

TEST(Onnx, OtherFilesAreToldByTheirBeginnings) {
  EXPECT_THAT(ReadOnnxBytes("no network", "a.onnx").error().message, HasSubstr("a.onnx is no ONNX file"));
  EXPECT_THAT(ReadOnnxBytes("", "a.onnx").error().message, HasSubstr("0 bytes"));
  EXPECT_THAT(ReadOnnxBytes("PK\x03\x04 and more", "a.pt").error().message, HasSubstr("export"));
  EXPECT_THAT(ReadOnnxBytes("version https://git-lfs.github.com/spec/v1", "a.onnx").error().message, HasSubstr("LFS"));
  const auto told = [](const std::string& bytes) { return ReadOnnxBytes(bytes, "a.onnx").error().message; };
  EXPECT_THAT(told("\xef\xbb\xbf\r\n <!DOCTYPE html>"), HasSubstr("web page"));
  EXPECT_THAT(told("Entry not found\n"), testing::AllOf(HasSubstr("'Entry not found'"), HasSubstr("again")));
  EXPECT_THAT(told(std::string("\x1c\0\0\0TFL3", 8)), HasSubstr("TensorFlow Lite"));
  EXPECT_THAT(told(std::string("\x2c\1\0\0{\"description\": 1}", 22)), HasSubstr("TensorRT"));
  EXPECT_THAT(told("\x80\x02\x8a"), HasSubstr("export it to ONNX"));
  EXPECT_THAT(told(std::string(64, '\0')), HasSubstr("cut short; download or export it again"));
  EXPECT_THAT(ReadOnnxFile("no_such.onnx").error().message, HasSubstr("no_such.onnx does not exist"));
  EXPECT_THAT(ReadOnnxFile("/dev/null").error().message, HasSubstr("/dev/null is no regular file"));
}

TEST(Onnx, NodesThatReadWhatNothingMakesAreRefused) {
  TestNetwork net(64, 64);
  net.Output(net.Op("Relu", {"ghost"}), {1});
  EXPECT_THAT(ReadOnnxBytes(net.Bytes(), "a.onnx").error().message, HasSubstr("ghost"));
  TestNetwork none(64, 64);
  none.Op("Relu", {"images"});
  none.Output("ghost", {1});
  EXPECT_THAT(ReadOnnxBytes(none.Bytes(), "a.onnx").error().message, HasSubstr("ghost"));
}

TEST(Onnx, HalvesAreReadAsFloats) {
  // 1, -2, the largest, the smallest normal, the smallest of all, minus zero
  const std::string raw("\x00\x3c\x00\xc0\xff\x7b\x00\x04\x01\x00\x00\x80", 12);
  const auto model =
      ReadOnnxBytes(FileWithTensor(Number(1, 6) + Number(2, 10) + Bytes(8, "w") + Bytes(9, raw)), "half.onnx");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->constants[0].floats, (std::vector<float>{1, -2, 65504, 0x1p-14f, 0x1p-24f, 0}));
}

TEST(Onnx, BrainFloatsAreReadAndOtherTypesRefusedByNumber) {
  const std::string raw("\x80\x3f\x20\xc0", 4);  // 1, -2.5
  for (const std::string& numbers : {Bytes(9, raw), Number(5, 0x3f80) + Number(5, 0xc020)}) {
    const auto model = ReadOnnxBytes(FileWithTensor(Number(1, 2) + Number(2, 16) + Bytes(8, "w") + numbers), "b.onnx");
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model->constants[0].floats, (std::vector<float>{1, -2.5f}));
  }
  const auto eight =
      ReadOnnxBytes(FileWithTensor(Number(1, 1) + Number(2, 17) + Bytes(8, "w") + Number(5, 7)), "b.onnx");
  ASSERT_FALSE(eight);
  EXPECT_THAT(eight.error().message, testing::AllOf(HasSubstr("b.onnx"), HasSubstr("17")));
}

TEST(Onnx, WeightsInAnotherFileAreReadOrTheFileIsNamed) {
  const TestFolder folder;
  const auto entry = [](const std::string& key, const std::string& value) {
    return Bytes(13, Bytes(1, key) + Bytes(2, value));
  };
  const auto tensor = [&](const std::string& location, const std::string& length) {
    return Number(1, 2) + Number(2, 1) + Bytes(8, "w") + entry("location", location) + entry("offset", "4") +
           entry("length", length) + Number(14, 1);
  };
  const float numbers[] = {9, 1.5f, -3};
  folder.Write("weights.bin", std::string(reinterpret_cast<const char*>(numbers), sizeof(numbers)));
  const auto fine = ReadOnnxFile(folder.Write("fine.onnx", FileWithTensor(tensor("weights.bin", "8"))));
  ASSERT_TRUE(fine) << fine.error().message;
  EXPECT_EQ(fine->constants[0].floats, (std::vector<float>{1.5f, -3}));
  for (const auto& [location, length, word] :
       {std::tuple("gone.bin", "8", "gone.bin"), std::tuple("weights.bin", "12", "too short"),
        std::tuple("../weights.bin", "8", "beside it"), std::tuple("/etc/passwd", "8", "beside it")}) {
    const auto bad = ReadOnnxFile(folder.Write("bad.onnx", FileWithTensor(tensor(location, length))));
    ASSERT_FALSE(bad) << location;
    EXPECT_THAT(bad.error().message, testing::AllOf(HasSubstr("bad.onnx"), HasSubstr(word)));
  }
}

TEST(Onnx, ATensorWithTooFewNumbersIsDamaged) {
  const auto model = ReadOnnxBytes(
      FileWithTensor(Number(1, 3) + Number(2, 1) + Bytes(8, "w") + Bytes(9, std::string(8, '\0'))), "a.onnx");
  ASSERT_FALSE(model);
  EXPECT_THAT(model.error().message, HasSubstr("damaged"));
}

}  // namespace
}  // namespace yorb
