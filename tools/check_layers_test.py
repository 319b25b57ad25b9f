#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of check_layers.py on small trees that break one rule each."""
import os
import tempfile
import unittest

import check_layers

SPDX = "// SPDX-FileCopyrightText: 2026 The yorb-slam authors\n// SPDX-License-Identifier: BSD-3-Clause\n"
HASH_SPDX = SPDX.replace("//", "#")
LAYERS = """# first
core                      ids
camera                    models
features   detection      ORB | boxes
optimize                  BA
system                    wiring
"""


def room(name, *deps):
    return f"{HASH_SPDX}yorb_room({name} DEPS {' '.join(deps)})\n"


class CheckLayers(unittest.TestCase):
    def complaints(self, changes):
        """Complaints about a tree that is well but for `changes` ({path: text without its SPDX lines})."""
        tree = {
            "src/core/a.h": "#include <string>\n", "src/core/CMakeLists.txt": room("core"),
            "src/camera/b.h": '#include "core/a.h"\n', "src/camera/CMakeLists.txt": room("camera", "yorb_core"),
            "src/features/CMakeLists.txt": room("features", "yorb_camera", "opencv_imgproc"),
            "src/detection/c.h": '#include "camera/b.h"\n', "src/detection/CMakeLists.txt": room("detection", "yorb_camera"),
            "src/optimize/CMakeLists.txt": room("optimize", "yorb_features"),
            "src/system/CMakeLists.txt": room("system", "yorb_optimize", "yorb_detection"),
        }
        tree.update(changes)
        with tempfile.TemporaryDirectory() as root:
            for path, text in {"src/LAYERS": LAYERS, **tree}.items():
                os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
                with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                    file.write(SPDX + text if path.endswith((".h", ".cc")) and not text.startswith("bare") else text)
            return check_layers.check_tree(root)

    def expect(self, changes, *words):
        """Exactly one complaint, which holds all the words."""
        complaints = self.complaints(changes)
        self.assertEqual(len(complaints), 1, complaints)
        for word in words:
            self.assertIn(word, complaints[0])

    def test_a_good_tree_passes(self):
        self.assertEqual(self.complaints({}), [])

    def test_includes_go_up_only(self):
        complaints = self.complaints({"src/features/x.cc": '#include "detection/c.h"\n'})
        self.assertIn("src/features/x.cc:3: features includes sideways into detection", complaints[0])
        complaints = self.complaints({"src/core/x.h": '#include "camera/b.h"\n'})
        self.assertIn("src/core/x.h:3: core includes down into camera", complaints[0])

    def test_included_files_and_rooms_exist(self):
        self.expect({"src/camera/x.cc": '#include "core/gone.h"\n'}, "src/camera/x.cc:3", "does not exist")
        self.expect({"src/camera/x.cc": '#include "b.h"\n'}, "of no room")
        self.expect({"src/garden/x.cc": "\n"}, "src/garden/x.cc:1", "not in src/LAYERS")
        self.expect({"src/camera/x.cc": '#include "apps/command.h"\n'}, "apps is below every room")

    def test_guests_stay_in_their_rooms(self):
        for include, bad, good in [
                ("spdlog/spdlog.h", "src/core/x.cc", "src/core/log.cc"),
                ("yaml-cpp/yaml.h", "src/camera/rig.cc", "src/camera/camera_io.cc"),
                ("opencv2/core.hpp", "src/optimize/x.cc", "src/features/x.cc"),
                ("nlohmann/json.hpp", "src/camera/x.cc", "src/system/x.cc"),
                ("CLI/CLI.hpp", "src/system/x.cc", "apps/x.cc"),
                ("ceres/ceres.h", "src/optimize/x.cc", "src/optimize/x_test.cc"),
                ("gtest/gtest.h", "src/core/x.cc", "src/core/x_test.cc"),
                ("benchmark/benchmark.h", "src/core/x_test.cc", "src/core/x_bench.cc"),
                ("ceres/ceres.h", "src/optimize/oracle.h", "src/optimize/ceres_oracle.h"),
                ("mutex", "src/camera/x.h", "src/core/channel.h"),
                ("thread", "src/system/slam.cc", "src/system/pipeline.cc")]:
            with self.subTest(include=include):
                self.expect({bad: f"#include <{include}>\n"}, f"{bad}:3", "stays in")
                self.assertEqual(self.complaints({good: f"#include <{include}>\n"}), [])

    def test_words_that_libraries_do_not_say(self):
        for line, word in [("std::atomic<int> a;", "threads"), ("std::cout << 1;", "print"), ("printf(\"x\");", "print"),
                           ("std::exit(1);", "exit"), ("abort();", "exit"), ('getenv("HOME");', "environment"),
                           ("usleep(3);", "sleeping"), ("std::mt19937 r;", "chance"), ("// TODO: later", "notes")]:
            with self.subTest(line=line):
                self.expect({"src/camera/x.cc": line + "\n"}, "src/camera/x.cc:3", word)
        for line in ["// std::cout is not for us", 'auto s = "std::cout";', "Snprintf(1);", "brand(1);", "q.exit(1);",
                     "std::snprintf(b, 9, f);"]:
            with self.subTest(line=line):
                self.assertEqual(self.complaints({"src/camera/x.cc": line + "\n"}), [])

    def test_headers_for_tests_are_included_by_tests_alone(self):
        pictures = {"src/core/test_pictures.h": "std::thread t;\n"}
        self.assertEqual(self.complaints({**pictures, "src/camera/x_test.cc": '#include "core/test_pictures.h"\n'}), [])
        self.expect({**pictures, "src/camera/x.cc": '#include "core/test_pictures.h"\n'}, "src/camera/x.cc:3", "for tests")

    def test_lengths(self):
        self.expect({"src/core/x.h": "\n" * 149}, "151 lines, the limit is 150")
        self.expect({"src/core/x.cc": "\n" * 399}, "401 lines, the limit is 400")
        self.assertEqual(self.complaints({"src/core/x.h": "\n" * 148, "src/core/x.cc": "\n" * 398}), [])

    def test_licence_lines(self):
        self.expect({"src/core/x.h": "bare\n"}, "src/core/x.h:1", "SPDX")
        self.expect({"tools/x.py": "print(1)\n"}, "tools/x.py:1", "SPDX")
        self.assertEqual(self.complaints({"tools/x.py": "#!/usr/bin/env python3\n" + HASH_SPDX}), [])

    def test_cmake_agrees_with_layers(self):
        self.expect({"src/detection/CMakeLists.txt": room("detection", "yorb_camera", "yorb_features")}, "not above detection")
        self.expect({"src/detection/CMakeLists.txt": room("detection", "yorb_camera", "yorb_cellar")}, "no room cellar")
        self.expect({"src/optimize/CMakeLists.txt": room("optimize", "yorb_features", "opencv_core")}, "without OpenCV")
        self.expect({"src/optimize/CMakeLists.txt": room("optimize", "yorb_features", "Ceres::ceres")}, "Ceres")
        self.assertIn("stands in the folder of optimize",
                      self.complaints({"src/optimize/CMakeLists.txt": room("garden", "yorb_features")})[0])
        self.assertEqual(self.complaints({"src/optimize/CMakeLists.txt": room("optimize", "yorb_features TEST_DEPS Ceres::ceres")}), [])

    def test_cmake_agrees_with_includes(self):
        self.expect({"src/detection/CMakeLists.txt": room("detection")}, "src/detection/c.h:3", "does not lead to yorb_camera")
        self.assertEqual(self.complaints({
            "src/system/x_test.cc": '#include "detection/c.h"\n',
            "src/system/CMakeLists.txt": room("system", "yorb_optimize TEST_DEPS yorb_detection")}), [])

    def test_layers_file_itself(self):
        self.assertIn("twice", self.complaints({"src/LAYERS": LAYERS + "core    again\n"})[0])


if __name__ == "__main__":
    unittest.main()
