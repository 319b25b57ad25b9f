// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
// Whole recordings on disk, from the folder to the ImageSet.
#include "datasets/tum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <thread>

#include "datasets/check.h"
#include "datasets/depth_watch.h"
#include "datasets/open_dataset.h"
#include "datasets/test_recording.h"

namespace yorb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class Recording : public ::testing::Test {
 protected:
  void SetUp() override { WriteRecording(folder_, "seq", 6); }

  std::unique_ptr<Dataset> Open(const std::string& name = "seq", const std::string& camera = "") {
    auto dataset = OpenDataset(folder_.Path(name), camera);
    EXPECT_TRUE(dataset.ok()) << (dataset.ok() ? "" : dataset.error().message);
    return dataset.ok() ? *std::move(dataset) : nullptr;
  }
  std::string Complaint(const std::string& name = "seq", const std::string& camera = "") {
    const auto dataset = OpenDataset(folder_.Path(name), camera);
    EXPECT_FALSE(dataset.ok());
    if (dataset.ok()) return "";
    EXPECT_EQ(dataset.error().kind, Error::Kind::kBadInput);
    return dataset.error().message;
  }

  TestFolder folder_;
};

TEST_F(Recording, GivesEveryFrameAsItWasWritten) {
  const auto dataset = Open();
  ASSERT_EQ(dataset->size(), 6u);
  EXPECT_NEAR(dataset->rig().fps, 30, 0.01) << "from the stamps: the camera file states none";
  for (size_t i = 0; i < dataset->size(); ++i) {
    const auto frame = dataset->Load(i);
    ASSERT_TRUE(frame.ok() && frame->images);
    EXPECT_EQ(ToString(dataset->TimeOf(i)), Stamp(static_cast<int>(i)));
    EXPECT_TRUE(frame->images->timestamp == dataset->TimeOf(i));
    EXPECT_EQ(cv::norm(frame->images->colour, TestColour(static_cast<int>(i)), cv::NORM_INF), 0);
    cv::Mat grey;
    cv::cvtColor(frame->images->colour, grey, cv::COLOR_BGR2GRAY);
    EXPECT_EQ(cv::norm(frame->images->grey, grey, cv::NORM_INF), 0);
    EXPECT_FLOAT_EQ(frame->images->depth.At(10, 10), 1.5f);
    EXPECT_FLOAT_EQ(frame->depth.median_m, 1.5f);
    EXPECT_EQ(frame->num_skipped, 0);
  }
  EXPECT_EQ(dataset->PictureName(2), "rgb/2.png");
}

TEST_F(Recording, BrokenPicturesAreSkippedAndCounted) {
  folder_.Write("seq/rgb/2.png", folder_.Read("seq/rgb/2.png").substr(0, 500));
  folder_.Write("seq/rgb/0.png", "");
  folder_.Write("seq/depth/4.png", "");
  const auto dataset = Open();
  int num_skipped = 0, num_frames = 0;
  for (size_t i = 0; i < dataset->size(); ++i) {
    const auto frame = dataset->Load(i);
    ASSERT_TRUE(frame.ok());
    num_skipped += frame->num_skipped;
    num_frames += frame->images.has_value();
    EXPECT_EQ(frame->images.has_value(), i != 0 && i != 2) << i;
    if (frame->images) {
      EXPECT_EQ(frame->images->depth.empty(), i == 4) << i;
    }
  }
  EXPECT_EQ(num_skipped, 3);
  EXPECT_EQ(num_frames, 4);
  EXPECT_EQ(dataset->size(), 6u) << "coverage refers to the list";
}

TEST_F(Recording, FramesWithoutDepthAreFrames) {
  std::string depth = folder_.Read("seq/depth.txt");
  folder_.Write("seq/depth.txt", depth.substr(0, depth.find("depth/3.png") + 12));
  const auto dataset = Open();
  ASSERT_EQ(dataset->size(), 6u);
  EXPECT_TRUE(dataset->Load(5)->images->depth.empty());
  EXPECT_FALSE(dataset->Load(3)->images->depth.empty());
}

TEST_F(Recording, WrongDepthIsRefusedByName) {
  folder_.WritePicture("seq/depth/0.png", cv::Mat(kTestHeight, kTestWidth, CV_8UC1, cv::Scalar(7)));
  EXPECT_THAT(Complaint(), HasSubstr("depth/0.png"));
  folder_.WritePicture("seq/depth/0.png", cv::Mat(kTestHeight / 2, kTestWidth / 2, CV_16UC1, cv::Scalar(7)));
  EXPECT_THAT(Complaint(), HasSubstr("32x24"));
  folder_.WritePicture("seq/depth/0.png", TestDepth());
  folder_.WritePicture("seq/depth/3.png", TestColour(0));
  const auto late = Open()->Load(3);
  ASSERT_FALSE(late.ok());
  EXPECT_THAT(late.error().message, HasSubstr("depth/3.png"));
}

TEST_F(Recording, PicturesThatChangeSizeEndIt) {
  folder_.WritePicture("seq/rgb/3.png", TestColour(3, 32, 24));
  const auto dataset = Open();
  EXPECT_TRUE(dataset->Load(2).ok());
  const auto changed = dataset->Load(3);
  ASSERT_FALSE(changed.ok());
  EXPECT_THAT(changed.error().message, HasSubstr("rgb/3.png"));
}

TEST_F(Recording, MissingFilesAreFoundBeforehand) {
  fs::remove(folder_.Path("seq/rgb/4.png"));
  fs::remove(folder_.Path("seq/rgb/5.png"));
  EXPECT_THAT(Complaint(), HasSubstr("rgb/4.png"));
  EXPECT_THAT(Complaint(), HasSubstr("2 of the 6"));
  WriteRecording(folder_, "seq", 6);
  fs::remove(folder_.Path("seq/depth/1.png"));
  EXPECT_THAT(Complaint(), HasSubstr("depth/1.png"));
  fs::remove(folder_.Path("seq/depth.txt"));
  EXPECT_THAT(Complaint(), HasSubstr("depth.txt does not exist, and yorb needs depth"));
}

TEST_F(Recording, WithoutAnyPairNamesBothRanges) {
  folder_.Write("seq/depth.txt", "2000.5 depth/0.png\n2000.6 depth/1.png\n");
  EXPECT_THAT(Complaint(), HasSubstr("2000.500000 to 2000.600000"));
  EXPECT_THAT(Complaint(), HasSubstr("1000.000000 to "));
}

TEST_F(Recording, AssociationsWin) {
  folder_.Write("seq/associations.txt", "1000.5 rgb/1.png 1000.5 depth/1.png\n1000.6 rgb/2.png 1000.5 depth/1.png\n");
  const auto dataset = Open();
  ASSERT_EQ(dataset->size(), 2u);
  EXPECT_EQ(dataset->PictureName(0), "rgb/1.png");
  EXPECT_FALSE(dataset->Load(1)->images->depth.empty()) << "a repeated depth picture is allowed";
  folder_.Write("seq/associations.txt", "1000.5 rgb/1.png 1000.5 depth/1.png\n1000.5 rgb/1.png 1000.6 depth/2.png\n");
  EXPECT_THAT(Complaint(), HasSubstr("associations.txt, line 2"));
}

TEST_F(Recording, TheColourListAloneIsThatOfTheRecordingByAnyOfItsNames) {
  const TestFolder lists;
  EXPECT_FALSE(ReadColourList(lists.Path()).ok());
  lists.Write("associated.txt",
              "stamp file stamp file\n1.01,depth/a.png,1.0,rgb/a.png\n2.01,depth/b.png,2.0,rgb/b.png,7\n");
  const auto read = ReadColourList(lists.Path());
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->Times(), (std::vector<Timestamp>{{1000000000}, {2000000000}}));
  const std::vector<std::string> names = ListNames();
  EXPECT_THAT(names, testing::Contains(std::filesystem::path(read->file).filename().string()));
  lists.Write("rgb.txt", "timestamp filename\n1.0 a.png\n2.0 b.png\n3.0 c.png\n");
  EXPECT_EQ(ReadColourList(lists.Path())->Times().size(), 3u);
  lists.Write("associations.txt", "1.0 rgb/a.png 1.01 depth/a.png\n1.0 rgb/b.png 2.01 depth/b.png\n");
  const auto repeated = ReadColourList(lists.Path());
  ASSERT_FALSE(repeated.ok());
  EXPECT_THAT(repeated.error().message, HasSubstr("associations.txt, line 2"));
}

TEST_F(Recording, FloatDepthNeedsNoFactorAndUnitsDo) {
  folder_.Write("bare.yaml", "fx: 50\nfy: 50\ncx: 31.5\ncy: 23.5\n");
  EXPECT_THAT(Complaint("seq", folder_.Path("bare.yaml")), HasSubstr("depth_factor"));
  const std::vector<float> metres(kTestHeight * kTestWidth, 2.25f);
  const std::string pfm = "Pf\n" + std::to_string(kTestWidth) + " " + std::to_string(kTestHeight) + "\n-1\n" +
                          std::string(reinterpret_cast<const char*>(metres.data()), metres.size() * sizeof(float));
  std::string depth;
  for (int k = 0; k < 6; ++k) {
    folder_.Write("seq/depth/" + std::to_string(k) + ".pfm", pfm);
    depth += Stamp(k) + " depth/" + std::to_string(k) + ".pfm\n";
  }
  folder_.Write("seq/depth.txt", depth);
  EXPECT_EQ(Open("seq", folder_.Path("bare.yaml"))->Load(1)->images->depth.At(5, 5), 2.25f);
  EXPECT_EQ(Open("seq")->Load(1)->images->depth.At(5, 5), 2.25f) << "no depth factor is applied to metres";
}

TEST_F(Recording, TheCameraIsNamedByTheFolderOrAskedFor) {
  EXPECT_EQ(CameraOfFolderName("/x/rgbd_dataset_freiburg1_xyz"), "tum_fr1");
  EXPECT_EQ(CameraOfFolderName("/x/rgbd_dataset_freiburg2_desk/"), "tum_fr2");
  EXPECT_EQ(CameraOfFolderName("rgbd_dataset_freiburg3_walking_xyz/."), "tum_fr3");
  for (const char* other :
       {"/x/rgbd_bonn_balloon", "/x/freiburg4_xyz", "/x/my_freiburg1", "/rgbd_dataset_freiburg1_xyz/sub"}) {
    EXPECT_EQ(CameraOfFolderName(other), "") << other;
  }
  EXPECT_EQ(Open()->rig().name, "test");
  fs::remove(folder_.Path("seq/camera.yaml"));
  EXPECT_THAT(Complaint(), HasSubstr("--camera"));
  fs::rename(folder_.Path("seq"), folder_.Path("rgbd_dataset_freiburg1_xyz"));
  EXPECT_THAT(Complaint("rgbd_dataset_freiburg1_xyz"), HasSubstr("--camera")) << "64x48 is not what TUM's camera takes";
  EXPECT_EQ(Open("rgbd_dataset_freiburg1_xyz", "tum_fr1")->rig().camera.width, 64)
      << "named, it is scaled with a warning";
}

TEST_F(Recording, AnyPicturesDoForACameraThatIsOnlyLocated) {
  folder_.WritePicture("photos/b.png", TestColour(1));
  folder_.WritePicture("photos/c.jpg", TestColour(2));
  folder_.WritePicture("photos/depth/a.png", TestDepth());
  folder_.WritePicture("photos/a.png", TestColour(3));
  const auto lists = ReadAnyPictures(folder_.Path("photos"));
  ASSERT_TRUE(lists);
  EXPECT_EQ(lists->NumWithDepth(), 0u);
  std::vector<std::string> names;
  for (const ListedPicture& picture : lists->colour.pictures) {
    EXPECT_EQ(picture.time.seconds(), static_cast<double>(names.size()));
    names.push_back(picture.name);
  }
  EXPECT_THAT(names, testing::ElementsAre("a.png", "b.png", "c.jpg"));
  EXPECT_EQ(ReadAnyPictures(folder_.Path("seq"))->NumWithDepth(), ReadTumLists(folder_.Path("seq"))->NumWithDepth());
  fs::remove(folder_.Path("seq/depth.txt"));
  EXPECT_EQ(ReadAnyPictures(folder_.Path("seq"))->colour.pictures.size(), 6u);
  fs::create_symlink("nowhere.png", folder_.Path("photos/d.png"));
  const std::string missing = LookForFiles(*ReadAnyPictures(folder_.Path("photos"))).error().message;
  EXPECT_THAT(missing,
              testing::AllOf(HasSubstr("photos/d.png is missing; 1 of the 4 pictures"), Not(HasSubstr("line"))));
  fs::create_directories(folder_.Path("empty"));
  EXPECT_THAT(CheckLayout(folder_.Path("empty"), Layout::kAnyPictures).error().message, HasSubstr("nor pictures"));
  EXPECT_TRUE(CheckLayout(folder_.Path("photos"), Layout::kAnyPictures));
  EXPECT_FALSE(CheckLayout(folder_.Path("photos")));
}

TEST_F(Recording, FoldersWithoutListsAreRefusedWithAHint) {
  EXPECT_THAT(Complaint("gone"), HasSubstr("does not exist"));
  EXPECT_THAT(Complaint("seq/rgb.txt"), HasSubstr("is a file"));
  EXPECT_THAT(Complaint(""), HasSubstr("did you mean " + folder_.Path("seq")));
  fs::create_directories(folder_.Path("euroc/mav0"));
  EXPECT_THAT(Complaint("euroc"), HasSubstr("EuRoC"));
  folder_.Write("euroc/mav0/cam0/data.csv", "");
  EXPECT_THAT(Complaint("euroc/mav0"), HasSubstr("EuRoC"));
  folder_.Write("7/seq-01/frame-000000.depth.png", "");
  EXPECT_THAT(Complaint("7"), HasSubstr("7-Scenes"));
  EXPECT_THAT(Complaint("7/seq-01"), HasSubstr("7-Scenes"));
  folder_.Write("office0/results/depth000000.png", "");
  EXPECT_THAT(Complaint("office0"), HasSubstr("Replica"));
  folder_.Write("scene/intrinsic/intrinsic_depth.txt", "");
  EXPECT_THAT(Complaint("scene"), HasSubstr("ScanNet"));
  folder_.Write("loris/color.txt", "");
  folder_.Write("loris/aligned_depth.txt", "");
  EXPECT_THAT(Complaint("loris"), HasSubstr("call color.txt rgb.txt, and aligned_depth.txt depth.txt"));
}

TEST_F(Recording, FoldersThatCannotBeLookedIntoAreRefused) {
  const std::string endless(5000, 'x');  // as good as one without rights, which root does not know
  EXPECT_FALSE(HasTumLayout(endless));
  const auto opened = OpenDataset(endless, "tum_fr1");
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().kind, Error::Kind::kBadInput);
  EXPECT_THAT(opened.error().message, testing::HasSubstr("cannot be read"));
  EXPECT_THAT(OpenDataset("", "tum_fr1").error().message, testing::HasSubstr("is empty"));
}

TEST_F(Recording, LoadsAlikeFromManyThreads) {
  const auto dataset = Open();
  std::vector<std::thread> threads;
  std::vector<double> sums(4);
  for (size_t t = 0; t < sums.size(); ++t) {
    threads.emplace_back([&, t] {
      for (size_t i = 0; i < dataset->size(); ++i) sums[t] += cv::sum(dataset->Load(i)->images->grey)[0];
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const double sum : sums) EXPECT_EQ(sum, sums[0]);
}

TEST(RealRecording, OpensWithAllItsPairs) {
  const char* data = std::getenv("YORB_DATA");
  const std::string folder = std::string(data != nullptr ? data : "../shared/data") + "/fr1_xyz";
  if (!fs::exists(folder)) GTEST_SKIP() << "skipped: no data";
  const auto dataset = OpenDataset(folder, "tum_fr1");
  ASSERT_TRUE(dataset.ok()) << dataset.error().message;
  ASSERT_EQ((*dataset)->size(), 798u);
  const auto frame = (*dataset)->Load(400);
  ASSERT_TRUE(frame.ok() && frame->images);
  EXPECT_EQ(frame->images->depth.pixels.type(), CV_16UC1);
  EXPECT_GT(frame->depth.median_m, 0.4);
  EXPECT_LT(frame->depth.median_m, 3);
}

TEST(OpenDataset, DepthThatIsNamedAsColourIsRefused) {
  const TestFolder folder;
  WriteRecording(folder, "room", 3);
  const std::string rgb = folder.Read("room/rgb.txt"), depth = folder.Read("room/depth.txt");
  folder.WritePicture("room/x/0.png", TestDepth());
  const std::pair<std::string, std::string> lists[] = {
      {depth, rgb},                          // swapped
      {depth, depth},                        // named twice
      {Stamp(0) + " depth/1.png\n", depth},  // another one, in a folder of depth
      {Stamp(0) + " x/0.png\n", rgb},        // unnamed, beside colour as its depth
  };
  for (const auto& [colour_list, depth_list] : lists) {
    folder.Write("room/rgb.txt", colour_list);
    folder.Write("room/depth.txt", depth_list);
    const auto opened = OpenDataset(folder.Path("room"), "");
    ASSERT_FALSE(opened) << colour_list;
    EXPECT_THAT(opened.error().message, HasSubstr("is a depth picture that is named as colour"));
    EXPECT_THAT(opened.error().message, HasSubstr("rgb.txt, line"));
    EXPECT_FALSE(CheckSequence(folder.Path("room"), "").is_usable());
  }
}

TEST(OpenDataset, PicturesAreReadAsStoredAndExifIsToldOf) {
  const TestFolder folder;
  WriteRecording(folder, "room", 1);
  folder.WritePicture("room/rgb/0.jpg", TestColour(0));
  const unsigned char exif[] = {0xff, 0xe1, 0, 34, 'E', 'x', 'i', 'f', 0, 0, 'M', 'M', 0, 42, 0, 0, 0, 8,
                                0,    1,    1, 18, 0,   3,   0,   0,   0, 1, 0,   6,   0, 0,  0, 0, 0, 0};
  std::string jpeg = folder.Read("room/rgb/0.jpg");
  folder.Write("room/rgb/0.jpg", jpeg.insert(2, reinterpret_cast<const char*>(exif), sizeof(exif)));
  folder.Write("room/rgb.txt", Stamp(0) + " rgb/0.jpg\n");
  const auto opened = OpenDataset(folder.Path("room"), "");
  ASSERT_TRUE(opened) << opened.error().message;
  const auto frame = (*opened)->Load(0);
  EXPECT_EQ(frame->images->grey.size(), cv::Size(kTestWidth, kTestHeight));
  EXPECT_EQ(frame->orientation, 6);
}

TEST(OpenDataset, InfraredPicturesOfFewBitsAreScaledAlike) {
  const TestFolder folder;
  WriteRecording(folder, "room", 2);
  folder.Write("room/rgb.txt", Stamp(0) + " ir_in_depth/0.png\n" + Stamp(1) + " ir_in_depth/1.png\n");
  const cv::Mat bright(kTestHeight, kTestWidth, CV_16UC1, cv::Scalar(1023)), dark = bright / 8;
  folder.WritePicture("room/ir_in_depth/0.png", dark);
  folder.WritePicture("room/ir_in_depth/1.png", bright);
  const auto opened = OpenDataset(folder.Path("room"), "");
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ((*opened)->Load(0)->images->grey.at<uint8_t>(5, 5), 32);
  EXPECT_EQ((*opened)->Load(1)->images->grey.at<uint8_t>(5, 5), 255);
}

}  // namespace
}  // namespace yorb
