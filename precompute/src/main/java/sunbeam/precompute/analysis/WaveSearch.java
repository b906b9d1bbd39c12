package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.precompute.optics.HeightMap;

/** Search for lines (peaks of waves) in the power spectrum of a piece of a surface. */
record WaveSearch(HeightMap scan, LineMeasures measures) {
    static final double AS_STRONG = 0.5;
    // A period that is called sure is seen so often.
    private static final double FEWEST_PERIODS = 4;
    // A lattice has lines in three directions, and two sums or differences of these.
    private static final int MOST_LINES = 5;
    private static final int MOST_DIRECTIONS = 3;
    // Ratio of frequencies: a sum of two waves is finer than both, but for the third direction of a hexagonal lattice.
    private static final double COARSER = 0.95;
    // Power of a fundamental relative to the overtone's that needs no other evidence.
    private static final double LEAST_FUNDAMENTAL = 0.25;
    private static final double SIGNIFICANT = 40;
    private static final double PROMINENT = 10;
    // Chance that a difference of uneven lines is taken for a repeated one, for each of three lines: 1 of 1000 scans.
    private static final double CHANCE = 0.0003;
    // Power: a twentieth of the amplitude. Leveling and windows leave less of a pure wave between its orders.
    private static final double FAINTEST_FUNDAMENTAL = 0.0025;
    // Power of the k-th overtone of narrow lines (a sixth of the period), times k^2, relative to the first's. Beyond
    // the
    // 40th it is below that of the faintest fundamental.
    private static final double SHARPEST = 4;
    private static final int HIGHEST_ALIAS = 40;
    // Random surfaces with a ring as spectrum reach 7, gratings and lattices 11 and more.
    static final double LEAST_CONTRAST = 10;
    // Contrast of waves that hold most of the variance, over the sectors beside them. A ring leaves two or three waves
    // there, whose powers are distributed exponentially: their median is a hundredth of the strongest in 1 of 100
    // scans.
    private static final double CROSSING_CONTRAST = 100;
    private static final double MOST = 0.5;
    // Prominence of gratings; noise along one axis reaches 23.
    private static final double LEAST_PARALLEL = 50;

    WaveSearch(HeightMap scan, Predicate<SpatialFrequency> which) {
        this(scan, LineMeasures.of(scan, which));
    }

    Optional<SpatialFrequency> strongest(Predicate<SpatialFrequency> also) {
        HeightSpectrum spectrum = measures.spectrum();
        Predicate<SpatialFrequency> both = measures.which().and(also);
        return spectrum.highest(place -> both.test(spectrum.frequency(place))).map(measures::refined);
    }

    /** Returns the highest peaks, then the highest of power times frequency, as that of waviness falls; each outside of those before it. */
    List<SpatialFrequency> peaks(Predicate<SpatialFrequency> also, int most) {
        HeightSpectrum spectrum = measures.spectrum();
        double[] power = spectrum.power();
        List<Integer> places = IntStream.range(power.length / 2 + 1, power.length)
                .filter(this::isTop)
                .filter(place -> measures.which().test(spectrum.frequency(place)))
                .boxed()
                .toList();
        List<SpatialFrequency> peaks = new ArrayList<>();
        for (ToDoubleFunction<Integer> height : List.<ToDoubleFunction<Integer>>of(
                place -> power[place],
                place -> power[place] * spectrum.frequency(place).length())) {
            int end = peaks.size() + most / 2;
            Iterator<Integer> ranked = places.stream()
                    .sorted(Comparator.comparingDouble(height).reversed())
                    .iterator();
            while (peaks.size() < end && ranked.hasNext()) {
                SpatialFrequency wave = measures.refined(ranked.next());
                boolean isNew = peaks.stream().noneMatch(known -> measures.isNear(wave, known, LineMeasures.BREADTH));
                if (isNew && measures.which().test(wave) && also.test(wave)) {
                    peaks.add(wave);
                }
            }
        }
        peaks.subList(Math.min(most / 2, peaks.size()), peaks.size())
                .sort(Comparator.comparingDouble(wave -> -measures.top(wave)));
        return peaks;
    }

    private boolean isTop(int place) {
        double[] power = measures.spectrum().power();
        int wide = measures.spectrum().bandX().count();
        double here = power[place];
        boolean top = here > 0;
        for (int step = 1; top && step <= wide + 1; step = step == 1 ? Math.max(2, wide - 1) : step + 1) {
            top = (place < step || here >= power[place - step])
                    && (place + step >= power.length || here >= power[place + step]);
        }
        return top;
    }

    /** Returns how many unlike lines repeat together: 2 or 3 if there is a peak at a half or a third of a wave's frequency, else 1. */
    int ridges(SpatialFrequency wave) {
        return IntStream.of(2, 3)
                .filter(count -> isFundamental(wave.times(1.0 / count), wave, count))
                .boxed()
                .max(Comparator.comparingDouble(count -> measures.top(wave.times(1.0 / count))))
                .orElse(1);
    }

    /** Whether a fundamental is there, or its overtone, which may outshine it where one line in three differs. */
    private boolean isFundamental(SpatialFrequency below, SpatialFrequency wave, int count) {
        List<SpatialFrequency> overtones =
                IntStream.range(1, 2 * count).mapToObj(below::times).toList();
        return measures.which().test(below)
                && below.periodsIn(scan) >= FEWEST_PERIODS
                && overtones.subList(0, count - 1).stream().anyMatch(line -> isLine(line, wave, overtones));
    }

    private boolean isLine(SpatialFrequency line, SpatialFrequency wave, List<SpatialFrequency> others) {
        double power = measures.top(line) / measures.top(wave);
        if (!isPeak(line) || power < FAINTEST_FUNDAMENTAL) {
            return false;
        }
        boolean isAlias = IntStream.rangeClosed(2, HIGHEST_ALIAS)
                .anyMatch(k -> power * k * k <= SHARPEST && measures.isAlias(line, wave.times(k)));
        boolean isStrong = power >= LEAST_FUNDAMENTAL && measures.contrast(line) >= LEAST_CONTRAST;
        boolean isSeen = isStrong
                || (measures.significance(line) >= SIGNIFICANT
                        && measures.prominence(line, others) >= PROMINENT
                        && measures.exceedsChance(line, wave, others, CHANCE));
        return isSeen && !isAlias && PhaseSlope.isSteady(scan, line);
    }

    private boolean isPeak(SpatialFrequency wave) {
        double highest = 0;
        int x = (int) Math.rint(wave.x() * measures.spectrum().width());
        int y = (int) Math.rint(wave.y() * measures.spectrum().height());
        for (int jy = -2; jy <= 2; jy++) {
            for (int jx = -2; jx <= 2; jx++) {
                highest = Math.max(highest, measures.spectrum().at(x + jx, y + jy));
            }
        }
        return measures.top(wave) >= highest;
    }

    /**
     * Returns the line, up to two in other directions that are no sums or differences of coarser ones, and one along the line's direction that
     * is no overtone, half as strong or stronger; the strongest is first.
     */
    List<SpatialFrequency> lines(SpatialFrequency line) {
        double beside = Math.sin(1.5 * Math.PI / LineMeasures.SECTORS);
        List<SpatialFrequency> found = new ArrayList<>(List.of(line));
        for (int i = 1; i < MOST_LINES; i++) {
            another(found, other -> found.stream().allMatch(known -> other.sineTo(known) > beside))
                    .ifPresent(found::add);
        }
        List<SpatialFrequency> lines = new ArrayList<>(found.stream()
                .filter(sum -> found.stream().noneMatch(one -> found.stream().anyMatch(two -> isSum(sum, one, two))))
                .limit(MOST_DIRECTIONS)
                .toList());
        SpatialFrequency first = lines.get(0);
        // The flank of a wide line or an overtone has its highest bin at the edge of what is left out.
        another(
                        lines,
                        other -> other.sineTo(first) < GratingPeriod.CONE
                                && IntStream.rangeClosed(2, LineMeasures.OVERTONES)
                                        .noneMatch(k -> measures.isNear(other, first.times(k), 0)))
                .filter(other ->
                        strongest(near -> measures.isNear(near, other, 0)).equals(Optional.of(other)))
                .filter(other -> measures.prominence(other, lines) >= LEAST_PARALLEL)
                .ifPresent(lines::add);
        return lines;
    }

    private Optional<SpatialFrequency> another(List<SpatialFrequency> found, Predicate<SpatialFrequency> also) {
        double length = found.get(0).length();
        double least = AS_STRONG * power(found.get(0));
        // Not waviness, a wide line's own bins, or its opposite's.
        return strongest(also.and(other -> other.length() > LineMeasures.COARSEST * length
                        && found.stream().noneMatch(known -> measures.isNear(other, known, LineMeasures.BREADTH))))
                .filter(other -> power(other) >= least
                        && (measures.contrast(other) >= LEAST_CONTRAST || isCrossing(other, found, least)));
    }

    private double power(SpatialFrequency wave) {
        return measures.around(wave, LineMeasures.BREADTH, measures.which()).power();
    }

    /** Whether a wave and the lines found, with their sums and differences that are as strong, leave little in other directions. */
    private boolean isCrossing(SpatialFrequency other, List<SpatialFrequency> found, double least) {
        List<SpatialFrequency> lines = Stream.of(
                        found.stream(),
                        Stream.of(other),
                        found.stream()
                                .flatMap(known -> Stream.of(known.plus(other), known.plus(other.times(-1))))
                                .filter(sum -> measures.which().test(sum) && power(sum) >= least))
                .flatMap(waves -> waves)
                .toList();
        return measures.lineShare(lines) >= MOST && measures.contrastBeside(other, lines) >= CROSSING_CONTRAST;
    }

    private boolean isSum(SpatialFrequency sum, SpatialFrequency one, SpatialFrequency two) {
        return Math.max(one.length(), two.length()) < COARSER * sum.length()
                && (measures.isNear(sum, one.plus(two), 0) || measures.isNear(sum, one.plus(two.times(-1)), 0));
    }
}
