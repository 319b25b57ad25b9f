# SPDX-FileCopyrightText: 2026 The yorb-slam authors
# SPDX-License-Identifier: BSD-3-Clause
# The commands of daily work. `make build` leaves build/release/apps/yorb; `make check` is all of CI.

JOBS ?= $(shell nproc)
RELEASE := build/release
YORB := $(RELEASE)/apps/yorb
# Programs with sanitizers of gcc 12 dislike much randomness in their addresses; where this is not allowed, go on without.
STEADY := $(shell setarch -R true 2>/dev/null && echo setarch -R)
BUILD = cmake --build $(1) --parallel $(JOBS)

.PHONY: build test demo check check-all-but-test format format-check layers headers werror asan tsan tidy install-check \
        training install packages clean help

build: packages $(RELEASE)/build.ninja  ## build the program, release
	@$(call BUILD,$(RELEASE)) --target yorb

test: packages $(RELEASE)/build.ninja  ## build and run all tests, release
	@$(call BUILD,$(RELEASE))
	@ctest --preset release --parallel $(JOBS)

demo: build  ## render a sequence, run SLAM on it, evaluate, name the report
	@tools/demo.sh $(YORB) build/demo

check: check-all-but-test  ## all of CI
	@$(MAKE) --no-print-directory test

check-all-but-test:
	@tools/check.sh

format:  ## write all sources in the house format
	@find apps src tests tools training -name '*.h' -print0 -o -name '*.cc' -print0 | xargs -0 clang-format-14 -i

format-check:
	@find apps src tests tools training -name '*.h' -print0 -o -name '*.cc' -print0 | xargs -0 clang-format-14 --dry-run --Werror

layers:  ## rooms, guests, lengths, licence lines
	@python3 tools/check_layers.py

headers: packages  ## the public headers compile as C++17
	@python3 tools/check_headers.py --jobs $(JOBS)

werror: packages  ## release with warnings as errors (stays so for later builds in this folder)
	@cmake --preset release -DYORB_WERROR=ON
	@$(call BUILD,$(RELEASE))

asan: packages build/dev/build.ninja  ## tests with AddressSanitizer and UBSan
	@cmake --build --preset dev --parallel $(JOBS)
	@$(STEADY) ctest --preset dev --parallel $(JOBS)

tsan: packages build/tsan/build.ninja  ## tests of everything that has threads with ThreadSanitizer
	@cmake --build --preset tsan --parallel $(JOBS)
	@$(STEADY) ctest --preset tsan --parallel $(JOBS)

tidy: packages $(RELEASE)/build.ninja  ## clang-tidy over all sources
	@tools/tidy.sh $(RELEASE) $(JOBS)

install-check: build  ## install to a scratch prefix and build a consumer against it
	@tools/check_install.sh $(RELEASE) build/install_check

training:  ## build yorb-train (libtorch) in build/training, and run its tests
	@tools/install_packages.sh
	@tools/install_packages.sh train
	@cmake -S . -B build/training -G Ninja -DYORB_TRAINING=ON -DYORB_BENCHES=OFF
	@cmake --build build/training --parallel $(JOBS) --target yorb-train training_test
	@ctest --test-dir build/training --output-on-failure -R '^training\.'

install: build  ## PREFIX=/usr/local
	@$(call BUILD,$(RELEASE))
	@cmake --install $(RELEASE) --prefix $(or $(PREFIX),/usr/local)

packages:
	@tools/install_packages.sh

clean:  ## throw away all that was built
	@rm -rf build

help:
	@sed -n 's/^\([a-z-]*\):.*## /\1: /p' $(MAKEFILE_LIST)

build/%/build.ninja: CMakePresets.json
	@cmake --preset $*
