//===-- lib/Cost/Stability.cpp - where a shader loses digits ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Stability.h"
#include "lib/Cost/Blame.h"
#include "lib/Cost/Mixtures.h"
#include "lib/Cost/Points.h"
#include "llvm/ADT/STLExtras.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

using namespace llvm;

namespace anysl::cost {
namespace {

/// Traces of so many points are kept at once.
constexpr size_t pointsAtOnce = 16;
/// Points about the worst: of so many of them, towards each other and so many besides, in so many
/// steps, each half as far as the one before.
constexpr size_t worstPoints = 8, partners = 4, steps = 8;

/// The inputs of a point with which others may be mixed, and how much it lost.
struct KnownPoint {
  size_t point;
  double lost;
};

/// One search, from the given points to those about the worst.
class Search {
public:
  Search(Builder &builder, const std::string &shader, const StabilitySettings &settings,
         const std::function<void(double)> &progress)
      : builder(builder), settings(settings), progress(progress), digits(digitsOf(settings.real)) {
    report.shader = shader;
    report.real = settings.real;
    report.oracle = builder.oracle();
    report.limit = settings.limit;
    report.digits = digits;
    options = settings.grid;
    options.shader = shader;
    options.floatInputs = true;
    roundedLibrary = builder.buildTraced(settings.real);
    exactLibrary = builder.buildTraced(report.oracle);
  }

  StabilityReport run() {
    runGiven();
    for (unsigned round = 0; round < settings.rounds && !known.empty(); ++round)
      runAbout(round);
    dropWhatIsSmall();
    if (settings.real == "float")
      prove();
    return std::move(report);
  }

private:
  /// A result that lost digits, before it is known how small it is beside others.
  struct Suspicion {
    Incident incident;
    double error;
    std::optional<std::tuple<Cause, FilePosition, std::string>> place;
  };

  shade::GridOptions with(const std::string &library) const {
    shade::GridOptions result = options;
    result.library = library;
    return result;
  }

  void runGiven() {
    shade::Recorder recorder(std::numeric_limits<uint32_t>::max());
    Tracer rounded(with(roundedLibrary), options.recorded.empty() ? &recorder : nullptr),
        exact(with(exactLibrary));
    const shade::Grid &grid = rounded.grid();
    report.kind = anysl_kind_name(grid.shader().kind);
    globalsRead = grid.shader().globals_read;
    report.points = grid.pointCount();
    report.lost.assign(report.points, 0);
    if (options.recorded.empty()) {
      report.width = grid.width();
      report.height = grid.height();
    }
    examine(rounded, exact, report.points, 0.8);
    takePool(recorder);
  }

  /// The inputs of all points, from which others are mixed.
  void takePool(shade::Recorder &recorder) {
    if (options.recorded.empty()) {
      if (std::vector<shade::RecordedShader> parts = recorder.take(); !parts.empty())
        pool = std::move(parts.front());
      sortBySeed(pool);
      // Its lights are the command line's, and its world stays.
      pool.lights.clear();
      std::fill_n(pool.ambient, 3, 0.f);
      pool.lostLights = 0;
      options.environment.surroundingsGiven = true;
    } else {
      for (const auto &part : options.recorded)
        if (part->name == report.shader && part->kind == report.kind) {
          pool = *part;
          break;
        }
      placeRecorded();
    }
    options.constants.clear();
    options.ramps.clear();
    options.params.clear();
  }

  void placeRecorded() {
    auto valuesOf = [&](StringRef name) {
      auto found = find_if(pool.globals, [&](auto &values) { return values.name == name; });
      return found == pool.globals.end() ? nullptr : &*found;
    };
    for (auto [x, y] : {std::pair("u", "v"), std::pair("s", "t")})
      if (auto *xs = valuesOf(x), *ys = valuesOf(y); xs && ys && report.places.empty())
        for (size_t i = 0; i < report.points; ++i)
          report.places.push_back({xs->numbers[i], ys->numbers[i]});
  }

  /// Computes points both ways and notes what is wrong; \p share of all progress is made then.
  void examine(Tracer &rounded, Tracer &exact, size_t count, double share) {
    for (size_t first = 0; first < count; first += pointsAtOnce) {
      auto some = uint32_t(std::min(pointsAtOnce, count - first));
      std::vector<Trace> roundedTraces = rounded.run(first, some),
                         exactTraces = exact.run(first, some);
      for (size_t i = 0; i < some; ++i)
        examine(base + first + i, roundedTraces[i], exactTraces[i]);
      progress(done + share * double(first + some) / double(count));
    }
    done += share;
    base += count;
  }

  void examine(size_t point, const Trace &rounded, const Trace &exact) {
    if (!rounded.isComplete || !exact.isComplete)
      report.isComplete = false;
    TraceComparison comparison(rounded, exact, digits);
    double worst = 0;
    std::optional<Culprit> branch = comparison.branch();
    for (const ComparedResult &result : comparison.results()) {
      if (!options.print.empty() && !is_contained(options.print, result.name))
        continue;
      double &scale = scales[result.name];
      if (std::isfinite(result.magnitude))
        scale = std::max(scale, result.magnitude);
      worst = std::max(worst, isSmall(result.name, result.error) ? 0 : result.lost);
      if (result.lost <= settings.limit)
        continue;
      std::optional<Culprit> culprit = comparison.blame(result);
      Suspicion suspicion = makeSuspicion(point, rounded, exact, culprit);
      suspicion.incident.result = result.name;
      suspicion.incident.lost = result.lost;
      suspicion.incident.resultValue = rounded.steps[result.rounded].numbers();
      suspicion.incident.exactResult = exact.steps[result.exact].numbers();
      suspicion.error = result.error;
      if (culprit && culprit->cause == Cause::Branch)
        branch.reset();
      suspicions.push_back(std::move(suspicion));
    }
    if (branch)
      suspicions.push_back(makeSuspicion(point, rounded, exact, branch));
    known.push_back({point, worst});
  }

  Suspicion makeSuspicion(size_t point, const Trace &rounded, const Trace &exact,
                          const std::optional<Culprit> &culprit) const {
    Suspicion result = {{}, 0, {}};
    result.incident.point = point;
    if (!culprit)
      return result;
    const TraceStep &step = rounded.steps[culprit->step];
    const AnyslNoteSite &site = *step.site;
    result.place = {culprit->cause, {site.file, site.line, site.column}, site.op};
    result.incident.added = culprit->added;
    result.incident.value = step.numbers();
    const TraceStep &like = exact.steps[culprit->exact];
    result.incident.exactValue = like.numbers();
    result.incident.isExactFinite =
        all_of(result.incident.exactValue, [](double x) { return std::isfinite(x); });
    for (uint32_t read : step.readsFrom)
      result.incident.operands.push_back(rounded.steps[read].numbers());
    return result;
  }

  bool isSmall(const std::string &result, double error) const {
    auto scale = scales.find(result);
    return scale != scales.end() && error <= scale->second * std::pow(10, -digits);
  }

  /// Looks at points on the lines from the worst to some others.
  void runAbout(unsigned round) {
    std::vector<Mixed> wanted;
    std::vector<size_t> worst = worstOfAll();
    for (size_t from : worst) {
      // What is worst of all may be between the worst so far.
      std::vector<size_t> others = worst;
      for (size_t partner = 1; partner <= partners; ++partner)
        others.push_back((from + partner * (size_t(pool.points) / (partners + 1)) + 7919 * round) %
                         pool.points);
      for (size_t to : others)
        for (size_t step = 1; step <= steps && !haveSameInputs(from, to); ++step)
          wanted.push_back({from, to, std::ldexp(1.0, -int(step))});
    }
    if (wanted.empty())
      return;
    auto part = std::make_shared<shade::RecordedShader>(pool);
    mix(pool, wanted, *part);
    options.recorded = {part};
    Tracer rounded(with(roundedLibrary)), exact(with(exactLibrary));
    examine(rounded, exact, wanted.size(), 0.15 / settings.rounds);
    report.foundPoints += wanted.size();
    append(pool, *part);
  }

  /// The worst point of each place, and then the worst of all.
  std::vector<size_t> worstOfAll() const {
    std::vector<size_t> result;
    auto add = [&](size_t point) {
      if (result.size() < worstPoints &&
          none_of(result, [&](size_t other) { return haveSameInputs(point, other); }))
        result.push_back(point);
    };
    std::map<std::tuple<Cause, std::string, unsigned, unsigned, std::string>, const Suspicion *>
        worst;
    for (const Suspicion &suspicion : suspicions)
      if (suspicion.place) {
        const auto &[cause, position, op] = *suspicion.place;
        const Suspicion *&most = worst[{cause, position.file, position.line, position.column, op}];
        if (!most || suspicion.incident.lost > most->incident.lost)
          most = &suspicion;
      }
    for (const auto &[place, suspicion] : worst)
      add(suspicion->incident.point);
    std::vector<KnownPoint> all = known;
    llvm::sort(all, [](const KnownPoint &a, const KnownPoint &b) {
      return std::pair(-a.lost, a.point) < std::pair(-b.lost, b.point);
    });
    for (const KnownPoint &point : all)
      if (result.size() < worstPoints)
        add(point.point);
    return result;
  }

  /// Only now it is known how large results are; what is left goes into the report.
  void dropWhatIsSmall() {
    for (Suspicion &suspicion : suspicions) {
      Incident &incident = suspicion.incident;
      bool isWrong = !incident.result.empty() && !isSmall(incident.result, suspicion.error);
      bool isGiven = incident.point < report.points;
      if (!isWrong) {
        incident.result.clear();
        incident.lost = 0;
      } else if (isGiven) {
        double &lost = report.lost[incident.point];
        lost = std::max(lost, incident.lost);
      }
      bool isBranch = suspicion.place && std::get<Cause>(*suspicion.place) == Cause::Branch;
      if (!suspicion.place || (!isWrong && !isBranch))
        continue;
      UnstablePlace &place = placeOf(*suspicion.place);
      // One point may spoil several results by one operator.
      size_t &last = lastPoint[&place - report.unstablePlaces.data()];
      if (last != incident.point + 1)
        ++(isGiven ? place.points : place.foundPoints);
      last = incident.point + 1;
      bool isFirst = place.points + place.foundPoints == 1;
      if (isFirst ||
          std::pair(incident.lost, incident.added) > std::pair(place.worst.lost, place.worst.added))
        place.worst = incident;
    }
    for (const KnownPoint &point : known)
      if (point.point < report.points && report.lost[point.point] == 0 &&
          point.lost <= settings.limit)
        report.lost[point.point] = point.lost;
    report.unstable =
        size_t(count_if(report.lost, [&](double lost) { return lost > settings.limit; }));
    for (UnstablePlace &place : report.unstablePlaces)
      place.worst.inputs = inputs(place.worst.point);
    auto rank = [](const UnstablePlace &place) {
      return std::tuple(-place.worst.lost, -double(place.points), place.position.file,
                        place.position.line, place.position.column, place.op);
    };
    llvm::sort(report.unstablePlaces, [&](auto &a, auto &b) { return rank(a) < rank(b); });
  }

  UnstablePlace &placeOf(const std::tuple<Cause, FilePosition, std::string> &wanted) {
    const auto &[cause, position, op] = wanted;
    for (UnstablePlace &place : report.unstablePlaces)
      if (place.cause == cause && place.op == op && place.position.file == position.file &&
          place.position.line == position.line && place.position.column == position.column)
        return place;
    return report.unstablePlaces.emplace_back(UnstablePlace{cause, position, op, 0, 0, {}});
  }

  Inputs inputs(size_t point) const { return inputsOf(pool, point, globalsRead); }
  bool haveSameInputs(size_t a, size_t b) const { return a == b || inputs(a) == inputs(b); }

  /// Asks bounds of how many of the given points it is certain that little is lost.
  void prove() {
    // Bounds of derivatives are not known.
    bool readsDerivatives =
        builder.build(settings.real, {tiers()[0].str(), {}}).report.real != settings.real;
    if (!builder.works("interval") || readsDerivatives)
      return;
    shade::GridOptions given = settings.grid;
    given.shader = report.shader;
    given.floatInputs = true;
    given.library = builder.build("interval", {tiers()[0].str(), {}}).library;
    shade::Grid grid(given);
    Bounds bounds{*this, std::vector<double>(report.points, std::nan("")), {}, 0};
    auto hear = [](void *data, const AnyslNote *note) { static_cast<Bounds *>(data)->add(*note); };
    if (!anysl_library_note(grid.shaderLibrary(), hear, &bounds))
      return;
    for (; bounds.first < report.points; bounds.first += pointsAtOnce) {
      auto count = uint32_t(std::min(pointsAtOnce, report.points - bounds.first));
      shade::BatchHandle batch = grid.makeBatch(bounds.first, count);
      shade::check(anysl_shade(grid.instance(), batch.get(), 0, count, 1));
    }
    report.proven =
        size_t(count_if(bounds.lost, [&](double lost) { return lost <= settings.limit; }));
    for (auto &[site, points] : bounds.undecided)
      report.undecided.push_back({{site->file, site->line, site->column}, site->op, points.size()});
    llvm::sort(report.undecided, [](const UndecidedPlace &a, const UndecidedPlace &b) {
      return std::tie(a.position.file, a.position.line, a.position.column) <
             std::tie(b.position.file, b.position.line, b.position.column);
    });
  }

  /// What interval bounds say of each given point.
  struct Bounds {
    const Search &search;
    std::vector<double> lost; ///< of each point, at most; NaN: nothing is known
    std::map<const AnyslNoteSite *, std::set<size_t>> undecided;
    size_t first;

    void add(const AnyslNote &note) {
      size_t point = first + note.point;
      const AnyslNoteSite &site = *note.site;
      if (site.kind == ANYSL_NOTE_UNDECIDED) {
        undecided[&site].insert(point);
        lost[point] = HUGE_VAL;
      }
      if (site.kind != ANYSL_NOTE_BOUNDS)
        return;
      double width = 0, magnitude = 0;
      for (uint32_t i = 0; i < site.result_count; ++i) {
        width = std::max(width, note.operands[i] - note.results[i]);
        magnitude = std::max({magnitude, std::fabs(note.operands[i]), std::fabs(note.results[i])});
      }
      bool isKnown = std::isfinite(width) && std::isfinite(magnitude);
      double here = !isKnown || std::isnan(note.results[0]) ? HUGE_VAL
                    : search.isSmall(site.op, width) || width == 0
                        ? 0
                        : std::max(0.0, search.digits + std::log10(width / magnitude));
      if (!(lost[point] >= here))
        lost[point] = here;
    }
  };

  Builder &builder;
  const StabilitySettings &settings;
  const std::function<void(double)> &progress;
  double digits;
  shade::GridOptions options;
  std::string roundedLibrary, exactLibrary;
  StabilityReport report;
  shade::RecordedShader pool;
  std::vector<KnownPoint> known;
  std::vector<Suspicion> suspicions;
  std::map<std::string, double> scales; ///< of each result, its largest exact magnitude
  std::map<std::ptrdiff_t, size_t> lastPoint;
  uint64_t globalsRead = 0;
  size_t base = 0; ///< points that have been computed
  double done = 0; ///< share of progress
};

} // namespace

StabilityReport findInstability(Builder &builder, const std::string &shader,
                                const StabilitySettings &settings,
                                const std::function<void(double)> &progress) {
  return Search(builder, shader, settings, progress).run();
}

} // namespace anysl::cost
