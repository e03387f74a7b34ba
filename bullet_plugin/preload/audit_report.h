// How the contacts of two narrowphases differ, by types of shapes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace dgd_preload {

/// What a narrowphase found in one call.
struct Deepest {
  bool is_contact = false;
  double separation = 0;  ///< That of the deepest contact, negative where bodies overlap; metres.
};

/// Magnitudes of differences, counted in bins of a quarter of a decade.
class Magnitudes {
 public:
  void Add(double magnitude);
  /// Upper end of the bin in which the part `fraction` of all magnitudes is reached; 0 if they are 0, or there are
  /// none.
  double Percentile(double fraction) const;

 private:
  static constexpr int kBinsPerDecade = 4, kLowestDecade = -15, kDecades = 20;
  std::array<std::uint64_t, kBinsPerDecade * kDecades + 1> bins_{};  ///< The first one has what is below all decades.
  std::uint64_t count_ = 0;
};

/// May be filled by several threads at once.
class AuditReport {
 public:
  void Add(int type_0, int type_1, const Deepest& builtin, const Deepest& ours);

  /// Some lines for each two types that met.
  std::string ToText() const;

 private:
  struct OneSided {
    std::uint64_t calls = 0;
    double deepest = 0;  ///< Least separation among them; metres.

    void Add(double separation);
  };
  struct Row {
    std::uint64_t calls = 0, neither = 0, both = 0;
    OneSided builtin_only, ours_only;
    Magnitudes differences;
    double worst = 0;  ///< Ours less the built-in's, of the largest magnitude; metres.
  };

  static std::string PartOf(std::uint64_t calls, const Row& row);
  static std::string TextOf(const std::pair<int, int>& types, const Row& row);

  mutable std::mutex mutex_;
  std::map<std::pair<int, int>, Row> rows_;
};

}  // namespace dgd_preload
