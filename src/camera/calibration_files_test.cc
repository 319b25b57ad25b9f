// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// The calibration formats of other tools, and the cameras known by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "camera/builtin_cameras.h"
#include "camera/camera_io.h"

namespace yorb {
namespace {

using ::testing::HasSubstr;

Rig ReadCalib(const std::string& text) {
  const auto rig = ParseCameraFile(text, "calib.yaml");
  EXPECT_TRUE(rig.ok()) << (rig.ok() ? "" : rig.error().message);
  return rig.ok() ? *rig : Rig();
}

std::string CalibComplaint(const std::string& text) {
  const auto rig = ParseCameraFile(text, "calib.yaml");
  EXPECT_FALSE(rig.ok()) << text;
  return rig.ok() ? "" : rig.error().message;
}

void ExpectCamera(const Rig& rig, std::array<double, 8> distortion) {
  EXPECT_EQ(rig.camera.fx, 525.5);
  EXPECT_EQ(rig.camera.fy, 526.5);
  EXPECT_EQ(rig.camera.cx, 319.25);
  EXPECT_EQ(rig.camera.cy, 239.75);
  EXPECT_EQ(rig.camera.width, 640);
  EXPECT_EQ(rig.camera.height, 480);
  EXPECT_EQ(rig.camera.distortion, distortion);
}

TEST(CalibrationFile, RosCalibratorAndMessage) {
  const std::string file =
      "image_width: 640\nimage_height: 480\ncamera_name: head\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
      "  data: [525.5, 0, 319.25, 0, 526.5, 239.75, 0, 0, 1]\ndistortion_model: plumb_bob\n"
      "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [.1, -.2, .003, .004, .5]\n"
      "rectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
      "projection_matrix:\n  rows: 3\n  cols: 4\n  data: [1, 0, 3, 0, 0, 1, 2, 0, 0, 0, 1, 0]\n";
  const Rig rig = ReadCalib(file + "depth_factor: 1000\n");
  ExpectCamera(rig, {.1, -.2, .003, .004, .5, 0, 0, 0});
  EXPECT_EQ(rig.name, "head");
  EXPECT_EQ(rig.depth_factor, 1000);
  EXPECT_EQ(ReadCalib(file).depth_factor, 0) << "a calibration says nothing about depth";
  ExpectCamera(
      ReadCalib(
          "header:\n  seq: 1\n  frame_id: ''\nheight: 480\nwidth: 640\ndistortion_model: \"rational_polynomial\"\n"
          "D: [.1, -.2, .003, .004, .5, .6, .7, .8]\nK: [525.5, 0.0, 319.25, 0.0, 526.5, 239.75, 0.0, 0.0, 1.0]\n"
          "R: [1.0]\nP: [1.0]\nbinning_x: 0\n---\nheight: 1\n"),
      {.1, -.2, .003, .004, .5, .6, .7, .8});
  const std::string message =
      "height: 480\nwidth: 640\ndistortion_model: plumb_bob\nD: []\n"
      "K: [525.5, 0.0, 319.25, 0.0, 526.5, 239.75, 0.0, 0.0, 1.0]\n---\n";
  for (const std::string& messages : {message, message + message, "---\n" + message + "...\n"}) {
    const Rig echoed = ReadCalib(messages + "depth_factor: 1000\n");
    ExpectCamera(echoed, {});
    EXPECT_EQ(echoed.depth_factor, 1000) << "written below what `rostopic echo` wrote, behind its ---";
  }
  EXPECT_THAT(CalibComplaint(message + "depth_factor: many\n"), HasSubstr("line 7: depth_factor"));
  ExpectCamera(ReadCalib("height: 480\nwidth: 640\ndistortion_model: plumb_bob\nd:\n- 0.0\n- 0.0\n- 0.0\n- 0.0\n- 0.0\n"
                         "k:\n- 525.5\n- 0.0\n- 319.25\n- 0.0\n- 526.5\n- 239.75\n- 0.0\n- 0.0\n- 1.0\n"),
               {});
}

TEST(CalibrationFile, Open3dsJson) {
  const std::string start = "{\n\t\"width\" : 640,\n\t\"height\" : 480,\n\t\"intrinsic_matrix\" : ";
  const std::string columns = "[\n525.5,\n0,\n0,\n0,\n526.5,\n0,\n319.25,\n239.75,\n1\n]";
  ExpectCamera(ReadCalib(start + columns + "\n}\n"), {});
  ExpectCamera(ReadCalib(start + "[[525.5,0,319.25],[0,526.5,239.75],[0,0,1]]}"), {});
  EXPECT_EQ(ReadCalib(start + columns + "}").depth_factor, 0);
  EXPECT_EQ(ReadCalib(start + columns + ", \"depth_scale\": 1000.0}").depth_factor, 1000);
  EXPECT_EQ(ReadCalib(start + columns + ", \"depth_factor\": 5000}").depth_factor, 5000);
  EXPECT_THAT(CalibComplaint(start + "[525.5, 1, 0, 0, 526.5, 0, 319.25, 239.75, 1]}"), HasSubstr("intrinsic_matrix"));
  EXPECT_THAT(CalibComplaint(start + "[525.5, 526.5, 319.25, 239.75]}"), HasSubstr("holds 4"));
}

TEST(CalibrationFile, RealSensesJson) {
  const std::string start =
      "{\"width\":640,\"height\":480,\"ppx\":319.25,\"ppy\":239.75,\"fx\":525.5,\"fy\":526.5,\"coeffs\":";
  const std::string none = "[0.0, 0.0, 0.0, 0.0, 0.0]", some = "[0.1, -0.2, 0.003, 0.004, 0.5]";
  for (const char* model : {"\"Inverse Brown Conrady\"", "\"distortion.inverse_brown_conrady\"", "2", "\"None\""}) {
    ExpectCamera(ReadCalib(start + none + ",\"model\":" + model + "}"), {});
    EXPECT_EQ(CalibComplaint(start + some + ",\"model\":" + model + "}").find("calib.yaml, line 1: model does not"),
              0u);
  }
  for (const char* model : {"\"Brown Conrady\"", "\"distortion.brown_conrady\"", "4"}) {
    ExpectCamera(ReadCalib(start + some + ",\"model\":" + model + "}"), {.1, -.2, .003, .004, .5, 0, 0, 0});
  }
  EXPECT_THAT(CalibComplaint(start + some + "}"), HasSubstr("coeffs does not say"));
  EXPECT_THAT(CalibComplaint(start + none + ",\"model\":\"Kannala Brandt4\"}"), HasSubstr("undistort"));
  EXPECT_EQ(ReadCalib(start + none + ",\"depth_scale\": 0.001}").depth_factor, 1000);
}

TEST(CalibrationFile, OurKeysMisspeltOrInAGroupAreRefused) {
  const std::string ros =
      "image_width: 640\nimage_height: 480\ncamera_matrix: {data: [525.5, 0, 319.25, 0, 526.5, 239.75, 0, 0, 1]}\n"
      "distortion_coefficients: {data: []}\n";
  const std::string kalibr =
      "cam0:\n  intrinsics: [525.5, 526.5, 319.25, 239.75]\n  resolution: [640, 480]\n  distortion_coeffs: []\n";
  for (const std::string& file : {ros, kalibr}) {
    EXPECT_THAT(CalibComplaint(file + "depth_facter: 1000\n"), HasSubstr("the nearest is depth_factor"));
    EXPECT_THAT(CalibComplaint(file + "Readout: 0.02\n"), HasSubstr("the nearest is readout_s"));
    EXPECT_EQ(ReadCalib(file + "readout_s: 0.02\ntimeshift_cam_imu: 0.1\n").readout_s, 0.02);
  }
  EXPECT_THAT(CalibComplaint(kalibr + "  depth_factor: 1000\n"),
              HasSubstr("line 5: cam0.depth_factor is not read there; write depth_factor at the top level"));
}

TEST(CalibrationFile, OpenCv) {
  ExpectCamera(
      ReadCalib("%YAML:1.0\n---\ncalibration_time: \"Mon\"\nimage_width: 640\nimage_height: 480\n"
                "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 5.255e+02, 0., 319.25,\n"
                "       0., 526.5, 239.75, 0., 0., 1. ]\ndistortion_coefficients: !!opencv-matrix\n   rows: 1\n"
                "   cols: 5\n   dt: d\n   data: [ .1, -.2, .003, .004, .5 ]\navg_reprojection_error: 3.e-01\n"),
      {.1, -.2, .003, .004, .5, 0, 0, 0});
}

TEST(CalibrationFile, KalibrAndEuroc) {
  const std::string kalibr =
      "cam0:\n  cam_overlaps: []\n  camera_model: pinhole\n  distortion_coeffs: [.1, -.2, .003, .004]\n"
      "  distortion_model: radtan\n  intrinsics: [525.5, 526.5, 319.25, 239.75]\n  resolution: [640, 480]\n"
      "  rostopic: /cam0/image_raw\n";
  ExpectCamera(ReadCalib(kalibr), {.1, -.2, .003, .004, 0, 0, 0, 0});
  EXPECT_THAT(CalibComplaint(kalibr + "cam1:\n  camera_model: pinhole\n"), HasSubstr("more than one"));
  const Rig euroc = ReadCalib(
      "#Default imu sensor yaml file\nsensor_type: camera\ncomment: VI-Sensor\nT_BS:\n  cols: 4\n  rows: 4\n  data: "
      "[1.0, 0.0,\n"
      "         0.0, 1.0]\nrate_hz: 20\nresolution: [640, 480]\ncamera_model: pinhole\n"
      "intrinsics: [525.5, 526.5, 319.25, 239.75] #fu, fv, cu, cv\ndistortion_model: radial-tangential\n"
      "distortion_coefficients: [.1, -.2, .003, .004]\n");
  ExpectCamera(euroc, {.1, -.2, .003, .004, 0, 0, 0, 0});
  EXPECT_EQ(euroc.fps, 20);
}

TEST(CalibrationFile, CamodocalAsVinsHasIt) {
  const std::string head = "%YAML:1.0\n---\n", size = "camera_name: head\nimage_width: 640\nimage_height: 480\n";
  const std::string lens = "distortion_parameters:\n   k1: .1\n   k2: -.2\n   p1: .003\n   p2: .004\n";
  const std::string matrix =
      "projection_parameters:\n   fx: 525.5\n   fy: 526.5\n   cx: 319.25\n   cy: 239.75\ndepth_factor: 1000\n";
  const Rig rig = ReadCalib(head + "model_type: PINHOLE\n" + size + lens + matrix);
  ExpectCamera(rig, {.1, -.2, .003, .004, 0, 0, 0, 0});
  EXPECT_EQ(rig.name, "head");
  EXPECT_EQ(rig.depth_factor, 1000);
  ExpectCamera(ReadCalib(head + "model_type: PINHOLE_FULL\n" + size + lens +
                         "   k3: .5\n   k4: .6\n   k5: .7\n   k6: .8\n" + matrix),
               {.1, -.2, .003, .004, .5, .6, .7, .8});
  EXPECT_THAT(CalibComplaint(head + size + matrix), HasSubstr("distortion_parameters"));
  EXPECT_THAT(CalibComplaint(head + size + lens + "   K3: .5\n" + matrix), HasSubstr("distortion_parameters.K3"));
  EXPECT_THAT(CalibComplaint(head + size + lens), HasSubstr("projection_parameters.fx"));
  EXPECT_THAT(CalibComplaint(head + "model_type: MEI\n" + size + lens + matrix), HasSubstr("model_type is 'mei'"));
  EXPECT_THAT(CalibComplaint(head + "num_of_cam: 1\ncam0_calib: \"cam0.yaml\"\nimage_width: 640\n"),
              HasSubstr("cam0_calib"));
}

TEST(CalibrationFile, VinsSaysHowLongARollingShutterTakes) {
  const std::string camera =
      "%YAML:1.0\n---\nmodel_type: PINHOLE\nimage_width: 640\nimage_height: 480\n"
      "distortion_parameters:\n   k1: .1\n   k2: -.2\n   p1: .003\n   p2: .004\n"
      "projection_parameters:\n   fx: 525.5\n   fy: 526.5\n   cx: 319.25\n   cy: 239.75\n";
  const auto readout = [&](const std::string& lines) { return ReadCalib(camera + lines).readout_s; };
  EXPECT_EQ(readout("rolling_shutter: 1\nrolling_shutter_tr: 0.033\n"), 0.033);
  EXPECT_EQ(readout("rolling_shutter: 0\nrolling_shutter_tr: 0.033\n"), 0);
  EXPECT_EQ(readout("rolling_shutter_tr: 0.033\n"), 0);
  EXPECT_EQ(readout("rolling_shutter: 1\nrolling_shutter_tr: 0.033\nreadout_s: 0.02\n"), 0.02);
  EXPECT_THAT(CalibComplaint(camera + "rolling_shutter: 1\nrolling_shutter_tr: 33\n"),
              HasSubstr("rolling_shutter_tr must be between"));
  EXPECT_THAT(CalibComplaint(camera + "rolling_shutter: 1\n"), HasSubstr("rolling_shutter_tr"));
}

std::string RosMessageOfRegion(const std::string& region) {
  return "height: 960\nwidth: 1280\ndistortion_model: plumb_bob\nd: [.1, -.2, .003, .004, .5]\n"
         "k: [525.5, 0, 639.25, 0, 526.5, 479.75, 0, 0, 1]\nbinning_x: 0\nbinning_y: 0\nroi: {" +
         region + ", do_rectify: false}\n";
}

TEST(CalibrationFile, RosRegionsAreParts) {
  const auto read = [](const std::string& region) { return ReadCalib(RosMessageOfRegion(region)).camera; };
  const auto complaint = [](const std::string& region) { return CalibComplaint(RosMessageOfRegion(region)); };
  ExpectCamera(ReadCalib(RosMessageOfRegion("x_offset: 320, y_offset: 240, height: 480, width: 640")),
               {.1, -.2, .003, .004, .5, 0, 0, 0});
  for (const char* whole : {"x_offset: 0, y_offset: 0, height: 0, width: 0", "height: 960, width: 1280"}) {
    EXPECT_EQ(read(whole).cx, 639.25);
    EXPECT_EQ(read(whole).width, 1280);
  }
  EXPECT_THAT(complaint("x_offset: 700, y_offset: 240, height: 480, width: 640"), HasSubstr("roi.width"));
  EXPECT_THAT(complaint("x_offset: 320, y_offset: 240, height: 0, width: 640"), HasSubstr("roi.width"));
  EXPECT_THAT(complaint("x_offset: -1, y_offset: 240, height: 480, width: 640"), HasSubstr("roi.width"));
  EXPECT_THAT(complaint("x_offset: 640, y_offset: 240, height: 480, width: 640"), HasSubstr("roi.x_offset puts the"));
}

TEST(CalibrationFile, OtherLensesAndShapesAreRefusedByName) {
  const std::string start = "cam0:\n  intrinsics: [525.5, 526.5, 319.25, 239.75]\n  resolution: [640, 480]\n";
  EXPECT_THAT(CalibComplaint(start + "  camera_model: omni\n  distortion_coeffs: []\n"), HasSubstr("omni"));
  EXPECT_THAT(CalibComplaint(start + "  distortion_model: equidistant\n  distortion_coeffs: [1, 2, 3, 4]\n"),
              HasSubstr("equidistant"));
  EXPECT_THAT(CalibComplaint(start + "  distortion_model: radtan\n"), HasSubstr("distortion_coeffs"));
  EXPECT_THAT(CalibComplaint("cam0:\n  intrinsics: [1, 525.5, 526.5, 319.25, 239.75]\n  distortion_coeffs: []\n"),
              HasSubstr("cam0.intrinsics"));
  EXPECT_THAT(CalibComplaint("camera_matrix: [1, 2, 3]\ndistortion_coefficients: []\n"), HasSubstr("camera_matrix"));
  EXPECT_THAT(CalibComplaint("K: [525.5, 0, 319.25, 0, 526.5, 239.75, 0, 0, 1]\nD: [1, 2, 3]\n"), HasSubstr("D"));
  EXPECT_THAT(CalibComplaint("K: [0, 0, 319.25, 0, 0, 239.75, 0, 0, 1]\nD: []\n"), HasSubstr("K"));
}

TEST(BuiltinCamera, AreFoundFromTheProgramAndAllRead) {
  const auto names = BuiltinCameraNames();
  for (const char* name : {"tum_fr1", "tum_fr2", "tum_fr3", "generic_rgbd"}) {
    EXPECT_THAT(names, ::testing::Contains(name));
  }
  for (const std::string& name : names) {
    const auto rig = ReadCamera(name);
    ASSERT_TRUE(rig.ok()) << rig.error().message;
    EXPECT_EQ(rig->name, name);
    EXPECT_GT(rig->depth_factor, 0);
    EXPECT_GT(rig->camera.width, 0);
  }
  EXPECT_EQ(ReadCamera("tum_fr1")->camera.fx, 517.306408);
  EXPECT_EQ(ReadCamera("tum_fr3")->camera.HasDistortion(), false);
}

TEST(BuiltinCamera, UnknownNamesAreRefusedWithTheKnownOnes) {
  const auto unknown = ReadCamera("tum_fr9");
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().kind, Error::Kind::kBadInput);
  EXPECT_THAT(unknown.error().message, HasSubstr("tum_fr9"));
  EXPECT_THAT(unknown.error().message, HasSubstr("tum_fr3"));
  EXPECT_THAT(ReadCamera("gone.yaml").error().message, HasSubstr("gone.yaml"));
  EXPECT_THAT(ReadCamera("tum_fr1.yaml").error().message, HasSubstr("give tum_fr1"));
  EXPECT_THAT(FindConfigFile("cameras", "tum_fr").error().message, HasSubstr("tum_fr1"));
}

}  // namespace
}  // namespace yorb
