// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/camera_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

namespace yorb {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const char* const kOrb2 =
    "%YAML:1.0\n"
    "\n"
    "# Camera\n"
    "Camera.fx: 517.306408\n"
    "Camera.fy: 516.469215\n"
    "Camera.cx: 318.643040\n"
    "Camera.cy: 255.313989\n"
    "Camera.k1: 0.262383\n"
    "Camera.k2: -0.953104\n"
    "Camera.p1: -0.005358\n"
    "Camera.p2: 0.002628\n"
    "Camera.k3: 1.163314\n"
    "Camera.width: 640\n"
    "Camera.height: 480\n"
    "Camera.fps: 30.0\n"
    "Camera.bf: 40.0\n"
    "Camera.RGB: 1\n"
    "ThDepth: 35.0\n"
    "DepthMapFactor: 5000.0\n"
    "ORBextractor.nFeatures: 1000\n"
    "Viewer.KeyFrameSize: 0.05\n";

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

Rig Read(const std::string& text) {
  const auto rig = ParseCameraFile(text, "some/cam.yaml");
  EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().message) << "\n" << text;
  return rig.ok() ? *rig : Rig();
}

/// The complaint about a text that must be refused.
std::string Complaint(const std::string& text) {
  const auto rig = ParseCameraFile(text, "some/cam.yaml");
  EXPECT_FALSE(rig.ok()) << "accepted:\n" << text;
  if (rig.ok()) return "";
  EXPECT_EQ(rig.error().kind, Error::Kind::kBadInput);
  EXPECT_THAT(rig.error().message, HasSubstr("some/cam.yaml"));
  EXPECT_THAT(rig.error().message, Not(HasSubstr("\n")));
  return rig.error().message;
}

void ExpectSame(const Rig& a, const Rig& b) {
  EXPECT_EQ(a.camera.fx, b.camera.fx);
  EXPECT_EQ(a.camera.fy, b.camera.fy);
  EXPECT_EQ(a.camera.cx, b.camera.cx);
  EXPECT_EQ(a.camera.cy, b.camera.cy);
  EXPECT_EQ(a.camera.width, b.camera.width);
  EXPECT_EQ(a.camera.height, b.camera.height);
  EXPECT_EQ(a.camera.distortion, b.camera.distortion);
  EXPECT_EQ(a.baseline_px, b.baseline_px);
  EXPECT_EQ(a.close_factor, b.close_factor);
  EXPECT_EQ(a.depth_factor, b.depth_factor);
  EXPECT_EQ(a.fps, b.fps);
  EXPECT_EQ(a.readout_s, b.readout_s);
}

TEST(OrbSlamFile, GivesEveryValue) {
  const Rig rig = Read(kOrb2);
  EXPECT_EQ(rig.camera.fx, 517.306408);
  EXPECT_EQ(rig.camera.fy, 516.469215);
  EXPECT_EQ(rig.camera.cx, 318.643040);
  EXPECT_EQ(rig.camera.cy, 255.313989);
  EXPECT_EQ(rig.camera.width, 640);
  EXPECT_EQ(rig.camera.height, 480);
  EXPECT_EQ(rig.camera.distortion,
            (std::array<double, 8>{0.262383, -0.953104, -0.005358, 0.002628, 1.163314, 0, 0, 0}));
  EXPECT_EQ(rig.baseline_px, 40);
  EXPECT_EQ(rig.close_factor, 35);
  EXPECT_EQ(rig.depth_factor, 5000);
  EXPECT_EQ(rig.fps, 30);
  EXPECT_EQ(rig.name, "cam.yaml");
}

TEST(OrbSlamFile, IsTheSameInEverySpelling) {
  const Rig plain = Read(kOrb2);
  std::string odd = Replaced(kOrb2, "%YAML:1.0\n", "%YAML:1.0\n---\n");
  odd = Replaced(odd, "30.0", "30");
  odd = Replaced(odd, "5000.0", "5e3   # TUM");
  odd = Replaced(odd, "517.306408", "5.17306408e+02");
  odd = Replaced(odd, "Camera.height: 480\n", "Camera.height: 480\nCamera.width: 640.0\nCamera.type: \"PinHole\"\n");
  ExpectSame(Read(odd), plain);
  ExpectSame(Read("\n" + Replaced(odd, "\n", "\r\n")), plain);
  ExpectSame(Read(Replaced(kOrb2, ": ", ":\t")), plain);
  ExpectSame(Read(Replaced(kOrb2, ": ", ":")), plain);
  ExpectSame(Read(Replaced(kOrb2, "%YAML:1.0\n", "")), plain);
}

TEST(OrbSlamFile, OfVersionThreeHasOtherNames) {
  std::string three = Replaced(kOrb2, "%YAML:1.0\n", "%YAML:1.0\nFile.version: \"1.0\"\nCamera.type: \"PinHole\"\n");
  for (const char* key : {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3"}) {
    three = Replaced(three, std::string("Camera.") + key + ":", std::string("Camera1.") + key + ":");
  }
  three = Replaced(three, "Camera.bf: 40.0", "Stereo.b: 0.0773236");
  three = Replaced(three, "\nThDepth", "\nStereo.ThDepth");
  three = Replaced(three, "DepthMapFactor", "RGBD.DepthMapFactor");
  Rig rig = Read(three);
  EXPECT_NEAR(rig.baseline_px, 40, 1e-4);
  rig.baseline_px = 40;
  ExpectSame(rig, Read(kOrb2));
}

TEST(OrbSlamFile, MatricesAreRead) {
  const std::string matrix = "Tbc: !!opencv-matrix\n   rows: 2\n   cols: 2\n   dt: f\n   data: [1, 0,\n      0, 1]\n";
  ExpectSame(Read(kOrb2 + matrix), Read(kOrb2));
}

TEST(OrbSlamFile, MisspeltCameraKeysAreRefusedWithTheNearest) {
  EXPECT_THAT(Complaint(Replaced(kOrb2, "Camera.fx", "Camera.fz")), HasSubstr("Camera.fz"));
  EXPECT_THAT(Complaint(Replaced(kOrb2, "DepthMapFactor", "DepthMapFaktor")), HasSubstr("DepthMapFactor"));
  EXPECT_THAT(Complaint(Replaced(kOrb2, "Camera.k3", "Camera.K3")), HasSubstr("the nearest is Camera.k3"));
  EXPECT_THAT(Complaint(Replaced(kOrb2, "Camera.width", "Camera.widht")), HasSubstr("Camera.width"));
}

TEST(OrbSlamFile, MayStateAShutter) {
  EXPECT_EQ(Read(std::string(kOrb2) + "\nreadout_s: 0.026\n").readout_s, 0.026);
  EXPECT_THAT(Complaint(std::string(kOrb2) + "\nreadout_s: 26\n"), HasSubstr("readout_s"));
  EXPECT_THAT(Complaint(std::string(kOrb2) + "\nreadoutt_s: 0.026\n"), HasSubstr("readout_s"));
}

TEST(OrbSlamFile, WithoutDepthFactorSaysSoInsteadOfGuessing) {
  EXPECT_EQ(Read(Replaced(kOrb2, "DepthMapFactor: 5000.0\n", "")).depth_factor, 0);
}

TEST(OrbSlamFile, FishEyesAreRefused) {
  const std::string eye = std::string(kOrb2) + "Camera.type: \"KannalaBrandt8\"\n";
  EXPECT_THAT(Complaint(eye), HasSubstr("Camera.type"));
  EXPECT_THAT(Complaint(eye), HasSubstr("pinhole"));
}

TEST(OrbSlamFile, FaultsAreNamedByKeyAndLine) {
  const auto with = [](const char* key, const char* value) {
    std::string text = kOrb2;
    const size_t at = text.find(std::string(key) + ":");
    return text.replace(at, text.find('\n', at) - at, std::string(key) + ": " + value);
  };
  EXPECT_THAT(Complaint(Replaced(kOrb2, "Camera.fx: 517.306408\n", "")), HasSubstr("Camera.fx"));
  for (const char* value : {".nan", "nan", ".inf", "0", "-3", "1,5", "'517,3'", "wide", "", "[1, 2]", "{a: 1}", "~"}) {
    const std::string complaint = Complaint(with("Camera.fx", value));
    EXPECT_THAT(complaint, HasSubstr("Camera.fx")) << value;
  }
  EXPECT_THAT(Complaint(with("Camera.fx", "517,306")), HasSubstr("line 4"));
  EXPECT_THAT(Complaint(with("Camera.fx", "517,306")), HasSubstr("decimal point"));
  EXPECT_THAT(Complaint(with("Camera.fy", "-516.5")), HasSubstr("upside down"));
  EXPECT_THAT(Complaint(with("Camera.cx", "700")), HasSubstr("outside"));
  EXPECT_THAT(Complaint(with("Camera.bf", "0")), HasSubstr("Camera.bf"));
  EXPECT_THAT(Complaint(with("DepthMapFactor", "0")), HasSubstr("DepthMapFactor"));
  EXPECT_THAT(Complaint(with("DepthMapFactor", "-5000")), HasSubstr("DepthMapFactor"));
  EXPECT_THAT(Complaint(with("Camera.p1", "")), HasSubstr("Camera.p1"));
  EXPECT_THAT(Complaint(with("Camera.width", "640.5")), HasSubstr("Camera.width"));
  EXPECT_THAT(Complaint(Replaced(kOrb2, "Camera.p1: -0.005358\n", "")), HasSubstr("Camera.p1"));
  EXPECT_THAT(Complaint(std::string(kOrb2) + "Camera.fx: 600\n"), HasSubstr("twice"));
  EXPECT_THAT(Complaint(std::string(kOrb2) + "RGBD.DepthMapFactor: 1000\n"), HasSubstr("disagree"));
}

TEST(CameraFile, RubbishIsRefused) {
  EXPECT_THAT(Complaint(""), HasSubstr("empty"));
  EXPECT_THAT(Complaint(" \n\n"), HasSubstr("empty"));
  Complaint("Camera.fx: [0.26, \n");
  Complaint("%YAML:1.0\nCamera.fx: 517.3\nCamera.");
  Complaint("just words");
  Complaint("- 1\n- 2\n");
  Complaint("a: &a [*a]\n");
  Complaint("# only a remark\n");
  EXPECT_THAT(Complaint("<?xml version=\"1.0\"?>\n<opencv_storage/>"), HasSubstr("XML"));
  EXPECT_THAT(Complaint("features: {detector: fixed}"), HasSubstr("features.detector"));
  EXPECT_FALSE(ReadCameraFile("no/such/cam.yaml").ok());
  EXPECT_FALSE(ReadCameraFile(std::filesystem::temp_directory_path().string()).ok());
}

TEST(OurCameraFile, ReadsBackWhatItWrote) {
  Rig rig = Read(kOrb2);
  rig.name = "a \"quoted\" \\ name: with # signs";
  rig.camera.fx = 517.30640812345678;
  rig.readout_s = 0.026;
  const std::string text = CameraFileText(rig);
  ExpectSame(Read(text), rig);
  EXPECT_EQ(Read(text).name, rig.name);
  rig.camera.distortion = {.1, .2, .3, .4, .5, .6, .7, .8};
  ExpectSame(Read(CameraFileText(rig)), rig);
  rig.camera.distortion = {};
  rig.camera.width = rig.camera.height = 0;
  rig.depth_factor = rig.fps = 0;
  ExpectSame(Read(CameraFileText(rig)), rig);
}

TEST(OurCameraFile, RefusesUnknownKeysAndOddDistortion) {
  const std::string four = "fx: 500\nfy: 500\ncx: 320\ncy: 240\n";
  EXPECT_EQ(Read(four + "distortion: [.1, .2, .3, .4]").camera.distortion[3], .4);
  EXPECT_EQ(Read(four + "k1: .1\nk2: .2\np1: .3\np2: .4").camera.distortion[3], .4);
  EXPECT_THAT(Complaint(four + "distortion: [1, 2, 3]"), HasSubstr("distortion"));
  EXPECT_THAT(Complaint(four + "distortion: [1, .nan, 3, 4]"), HasSubstr("distortion"));
  EXPECT_THAT(Complaint(four + "depth_facter: 1000"), HasSubstr("depth_factor"));
  EXPECT_THAT(Complaint(four + "readout_s: -0.01"), HasSubstr("readout_s"));
  EXPECT_THAT(Complaint(four + "readout_s: 26"), HasSubstr("readout_s"));
  EXPECT_THAT(Complaint(four + "type: fisheye"), HasSubstr("fisheye"));
  EXPECT_THAT(Complaint(four + "width: 640"), HasSubstr("width"));
  EXPECT_NEAR(Read(four).baseline_px, 40, 1e-9);
  EXPECT_NEAR(Read(four + "baseline_m: 0.05").baseline_px, 25, 1e-9);
  EXPECT_THAT(Complaint(four + "baseline_m: 0.05\nbaseline_px: 25"), HasSubstr("baseline"));
}

TEST(FitToPictures, ScalesAlikeShapesAndRefusesOthers) {
  const Rig rig = Read(kOrb2);
  const auto same = FitToPictures(rig, 640, 480);
  ASSERT_TRUE(same.ok());
  EXPECT_FALSE(same->was_scaled);
  ExpectSame(same->rig, rig);
  const auto half = FitToPictures(rig, 320, 240);
  ASSERT_TRUE(half.ok());
  EXPECT_TRUE(half->was_scaled);
  EXPECT_EQ(half->rig.baseline_px, 20);
  EXPECT_NEAR(half->rig.CloseDepth(), rig.CloseDepth(), 1e-12);
  // The ray through a pixel of the small picture is the ray through the middle of the four that it was made from.
  const Eigen::Vector3d small = half->rig.camera.Unproject(100, 50, 1), large = rig.camera.Unproject(200.5, 100.5, 1);
  EXPECT_NEAR((small - large).norm(), 0, 1e-12);
  EXPECT_FALSE(FitToPictures(rig, 640, 360).ok());
  EXPECT_FALSE(FitToPictures(rig, 480, 640).ok());
}

TEST(FitToPictures, WithoutSizeThePrincipalPointMustBePlausible) {
  const Rig rig = Read("fx: 500\nfy: 500\ncx: 318.6\ncy: 255.3\ndepth_factor: 1000");
  const auto fitted = FitToPictures(rig, 640, 480);
  ASSERT_TRUE(fitted.ok());
  EXPECT_EQ(fitted->rig.camera.width, 640);
  EXPECT_FALSE(FitToPictures(rig, 320, 240).ok());
  EXPECT_FALSE(FitToPictures(rig, 1920, 1080).ok());
}

TEST(CameraFile, DamagedInAnyWayIsRefusedOrReadAsPlausibleNumbers) {
  std::mt19937 random(3);
  const std::string letters = "0123456789.-:,[]{}\"'#&*!%\n\t eEfx";
  for (int round = 0; round < 3000; ++round) {
    std::string text = kOrb2;
    for (int k = 0; k < 1 + round % 4; ++k) {
      const size_t at = random() % text.size();
      if (round % 3 == 0) text.erase(at, 1 + random() % 20);
      if (round % 3 == 1) text[at] = letters[random() % letters.size()];
      if (round % 3 == 2) text.insert(at, 1, letters[random() % letters.size()]);
    }
    const auto rig = ParseCameraFile(text, "some/cam.yaml");
    if (!rig) {
      EXPECT_THAT(rig.error().message, HasSubstr("some/cam.yaml"));
      continue;
    }
    const Pinhole& camera = rig->camera;
    for (const double number : {camera.fx, camera.fy, rig->baseline_px, rig->close_factor}) {
      EXPECT_TRUE(std::isfinite(number) && number > 0) << text;
    }
    EXPECT_TRUE(std::isfinite(camera.cx) && std::isfinite(camera.cy)) << text;
    for (const double number : camera.distortion) EXPECT_TRUE(std::isfinite(number)) << text;
    EXPECT_GE(rig->depth_factor, 0) << text;
  }
  Complaint(std::string(100000, '['));
}

}  // namespace
}  // namespace yorb
