// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera/key_table.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"

namespace yorb {
namespace {

constexpr double kMostPixels = 65535;

bool AreSame(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  const auto same = [](const std::string& x, const std::string& y) {
    const auto x_number = ParseDouble(x), y_number = ParseDouble(y);
    return x == y || (x_number && y_number && *x_number == *y_number);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace

void KeyTable::Add(KeyEntry entry) {
  const auto old = std::find_if(entries.begin(), entries.end(), [&](const KeyEntry& e) { return e.key == entry.key; });
  if (old == entries.end()) {
    entries.push_back(std::move(entry));
  } else if (!AreSame(old->values, entry.values)) {
    old->is_contradicted = true;
  }
}

const KeyEntry* KeyTable::Find(const std::string& key) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const KeyEntry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

bool KeyTable::HasPrefix(const std::string& prefix) const {
  return std::any_of(entries.begin(), entries.end(),
                     [&](const KeyEntry& e) { return e.key.compare(0, prefix.size(), prefix) == 0; });
}

std::string KeyTable::FirstOf(std::initializer_list<std::string> keys) const {
  for (const std::string& key : keys) {
    if (Has(key)) return key;
  }
  return *keys.begin();
}

const KeyEntry* KeyReader::Look(const std::string& key, bool is_required) {
  const KeyEntry* entry = table_.Find(key);
  if (entry == nullptr && is_required) RefuseFile("states no " + key);
  if (entry != nullptr && entry->is_contradicted) Refuse(key, "is given twice with different values");
  return entry;
}

double KeyReader::Read(const KeyEntry& entry, const std::string& value) {
  const std::string_view text = Trim(value);
  const auto number = ParseDouble(text);
  const bool is_yaml_special = text == ".nan" || text == ".NaN" || text == ".inf" || text == "-.inf";
  if (number && std::isfinite(*number)) return *number;
  if (number || is_yaml_special) {
    Refuse(entry.key, "is " + std::string(text) + ", a finite number is needed");
  } else if (std::count(text.begin(), text.end(), ',') == 1 && text.find_first_not_of("0123456789,+-") == text.npos) {
    Refuse(entry.key, "is '" + std::string(text) + "': numbers are written with a decimal point");
  } else {
    Refuse(entry.key, "is '" + std::string(text) + "', a number is needed");
  }
  return 0;
}

std::string KeyReader::Either(std::initializer_list<std::string> keys) {
  const std::string chosen = table_.FirstOf(keys);
  for (const std::string& key : keys) {
    if (table_.Has(key) && !AreSame(table_.Find(key)->values, table_.Find(chosen)->values)) {
      Refuse(key, "and " + chosen + " disagree");
    }
  }
  return chosen;
}

double KeyReader::Number(const std::string& key) {
  const KeyEntry* entry = Look(key, true);
  if (entry == nullptr) return 0;
  if (entry->values.size() != 1) {
    Refuse(key, "must be a single number");
    return 0;
  }
  return Read(*entry, entry->values.front());
}

double KeyReader::Number(const std::string& key, double otherwise) { return table_.Has(key) ? Number(key) : otherwise; }

double KeyReader::Positive(const std::string& key) {
  const double value = Number(key);
  if (!error_ && value <= 0) Refuse(key, "is " + FormatShortest(value) + " and must be greater than 0");
  return value;
}

double KeyReader::Positive(const std::string& key, double otherwise) {
  return table_.Has(key) ? Positive(key) : otherwise;
}

int KeyReader::Pixels(const std::string& key) {
  if (!table_.Has(key)) return 0;
  const double value = Positive(key);
  if (!error_ && (value != std::floor(value) || value > kMostPixels)) {
    Refuse(key, "is " + FormatShortest(value) + ", a whole number of pixels is needed");
  }
  return error_ ? 0 : static_cast<int>(value);
}

std::vector<double> KeyReader::Numbers(const std::string& key) {
  const KeyEntry* entry = Look(key, false);
  std::vector<double> numbers;
  if (entry == nullptr) return numbers;
  for (const std::string& value : entry->values) numbers.push_back(Read(*entry, value));
  return numbers;
}

std::string KeyReader::Word(const std::string& key, const std::string& otherwise) {
  const KeyEntry* entry = Look(key, false);
  if (entry == nullptr) return otherwise;
  if (entry->values.size() != 1) Refuse(key, "must be a single word");
  return entry->values.empty() ? otherwise : entry->values.front();
}

void KeyReader::Refuse(const std::string& key, const std::string& reason) {
  if (error_) return;
  const KeyEntry* entry = table_.Find(key);
  const std::string where = entry == nullptr ? ": " : ", line " + std::to_string(entry->line) + ": ";
  error_ = BadInput(table_.path + where + key + " " + reason);
}

void KeyReader::RefuseFile(const std::string& reason) {
  if (!error_) error_ = BadInput(table_.path + " " + reason);
}

}  // namespace yorb
