package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.precompute.numerics.Lagrange;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.spectrum.Band;

/** Search for lines (peaks of waves) in the power spectrum of a piece of a surface; bins are those of the unpadded piece, cycles per meter. */
record WaveSearch(
        HeightMap scan, HeightSpectrum spectrum, Predicate<SpatialFrequency> which, double binX, double binY) {
    // In bins of 1 / the scan's side; a Hann window's line reaches 2.
    private static final double LINE = 3;
    // Radius of a broad line as a share of its frequency.
    private static final double BREADTH = 0.15;
    static final int OVERTONES = 5;
    static final double AS_STRONG = 0.5;
    private static final double FEWEST_PERIODS = 3;
    // A lattice has lines in three directions, and two sums or differences of these.
    private static final int MOST_LINES = 5;
    private static final int MOST_DIRECTIONS = 3;
    // Per scan, for a period that is stated.
    private static final double FALSE_ALARMS = 0.01;
    // Along an axis: power in a Hann window's line over that of its peak.
    private static final double HANN_BINS = 1.5;
    // Ratio of frequencies: a sum of two waves is finer than both, but for the third direction of a hexagonal lattice.
    private static final double COARSER = 0.95;
    // Power of a fundamental relative to the overtone's: one that needs no other evidence, and a fifth of the
    // amplitude.
    private static final double LEAST_FUNDAMENTAL = 0.25;
    private static final double WEAK_FUNDAMENTAL = 0.04;
    private static final double SIGNIFICANT = 40;
    private static final double PROMINENT = 10;
    // A fainter fundamental must exceed chance. Uneven lines have a random, exponentially distributed power between
    // their orders, whose maximum of four bins exceeds 16 times the median in 6 of 100,000 scans. A median of three
    // bins, as six periods have beside them, may be three times too low.
    private static final double FAINT_PROMINENT = 50;
    private static final double FEWEST_OF_FAINT = 6;
    // Power: a twentieth of the amplitude. Leveling and windows leave less of a pure wave between its orders.
    private static final double FAINTEST_FUNDAMENTAL = 0.0025;
    // Random surfaces with a ring as spectrum reach 7, gratings and lattices 11 and more.
    static final double LEAST_CONTRAST = 10;
    // Sectors of 15 degrees in half a turn: rows of a snake's scale stray by 8.
    private static final int SECTORS = 12;
    // Prominence of gratings; noise along one axis reaches 23.
    private static final double LEAST_PARALLEL = 50;
    // Frequencies below this share of a wave's are waviness.
    private static final double COARSEST = 0.5;
    // Frequencies beside a line, as shares of its own.
    private static final double COARSER_FROM = 0.4;
    private static final double COARSER_TO = 0.7;
    private static final double FINER_FROM = 1.3;
    private static final double FINER_TO = 1.8;

    WaveSearch(HeightMap scan, Predicate<SpatialFrequency> which) {
        this(scan, HeightSpectrum.of(scan, HeightSpectrum.Edges.TAPERED), which, 1 / scan.width(), 1 / scan.height());
    }

    Optional<SpatialFrequency> strongest(Predicate<SpatialFrequency> also) {
        Predicate<SpatialFrequency> both = which.and(also);
        return spectrum.highest(place -> both.test(spectrum.frequency(place))).map(this::refined);
    }

    /** Returns the highest peaks, then the highest of power times frequency, as that of waviness falls; each outside of those before it. */
    List<SpatialFrequency> peaks(Predicate<SpatialFrequency> also, int most) {
        int wide = spectrum.bandX().count();
        double[] power = spectrum.power();
        List<Integer> places = IntStream.range(power.length / 2 + 1, power.length)
                .filter(place -> power[place] > 0
                        && IntStream.of(1, wide - 1, wide, wide + 1)
                                .allMatch(step -> (place < step || power[place] >= power[place - step])
                                        && (place + step >= power.length || power[place] >= power[place + step])))
                .boxed()
                .toList();
        Comparator<Integer> byPower = Comparator.comparingDouble(place -> -power[place]);
        Comparator<Integer> byBoth = Comparator.comparingDouble(
                place -> -power[place] * spectrum.frequency(place).length());
        List<SpatialFrequency> peaks = new ArrayList<>();
        for (Comparator<Integer> order : List.of(byPower, byBoth)) {
            int end = peaks.size() + most / 2;
            for (int place : places.stream().sorted(order).toList()) {
                SpatialFrequency wave = refined(place);
                boolean isNew = peaks.stream().noneMatch(known -> isNear(wave, known, BREADTH));
                if (peaks.size() < end && isNew && which.test(wave) && also.test(wave)) {
                    peaks.add(wave);
                }
            }
        }
        peaks.subList(Math.min(most / 2, peaks.size()), peaks.size())
                .sort(Comparator.comparingDouble(wave -> -top(wave)));
        return peaks;
    }

    private SpatialFrequency refined(int place) {
        int jx = spectrum.binX(place);
        int jy = spectrum.binY(place);
        double here = spectrum.at(jx, jy);
        double x = jx + Lagrange.top(spectrum.at(jx - 1, jy), here, spectrum.at(jx + 1, jy));
        double y = jy + Lagrange.top(spectrum.at(jx, jy - 1), here, spectrum.at(jx, jy + 1));
        return new SpatialFrequency(x / spectrum.width(), y / spectrum.height());
    }

    /** 1 at the line's radius: bins of the scan, or a share of the line's frequency if that is larger. */
    private double distance(SpatialFrequency frequency, SpatialFrequency center, double share) {
        double reach = share * center.length();
        return Math.hypot(
                (frequency.x() - center.x()) / Math.max(LINE * binX, reach),
                (frequency.y() - center.y()) / Math.max(LINE * binY, reach));
    }

    /** Power within a line's radius, and the sums of its frequencies times their power. */
    private record Moments(double power, double x, double y) {}

    private Moments around(SpatialFrequency center, double share, Predicate<SpatialFrequency> counted) {
        double reachX = Math.max(LINE * binX, share * center.length());
        double reachY = Math.max(LINE * binY, share * center.length());
        int left = (int) Math.ceil((center.x() - reachX) * spectrum.width());
        int right = (int) Math.floor((center.x() + reachX) * spectrum.width());
        int bottom = (int) Math.ceil((center.y() - reachY) * spectrum.height());
        int top = (int) Math.floor((center.y() + reachY) * spectrum.height());
        Moments sum = new Moments(0, 0, 0);
        for (int jy = bottom; jy <= top; jy++) {
            for (int jx = left; jx <= right; jx++) {
                SpatialFrequency frequency = new SpatialFrequency(jx / spectrum.width(), jy / spectrum.height());
                double power = spectrum.at(jx, jy);
                if (distance(frequency, center, share) <= 1 && power > 0 && counted.test(frequency)) {
                    sum = new Moments(sum.power + power, sum.x + power * frequency.x(), sum.y + power * frequency.y());
                }
            }
        }
        return sum;
    }

    /** Share, 0..1, of a broad line's power within a sharp line's radius. */
    double sharpness(SpatialFrequency wave) {
        Predicate<SpatialFrequency> all = frequency -> true;
        double power = around(wave, BREADTH, all).power();
        return power > 0 ? around(wave, 0, all).power() / power : 0;
    }

    SpatialFrequency centroid(SpatialFrequency wave) {
        SpatialFrequency result = wave;
        for (int i = 0; i < 3; i++) {
            Moments moments = around(result, BREADTH, which);
            result = moments.power > 0
                    ? new SpatialFrequency(moments.x / moments.power, moments.y / moments.power)
                    : result;
        }
        return result;
    }

    /** Share, 0..1, of the variance too fine to diffract light. */
    double unseen() {
        double total = spectrum.total();
        return total > 0 ? Math.max(0, 1 - Arrays.stream(spectrum.power()).sum() / total) : 0;
    }

    /**
     * Share, 0..1, of the variance in a wave and its overtones, without waviness; what is too fine to diffract counts: a faint wave must
     * not be nearly all of a finer surface.
     */
    double share(SpatialFrequency wave) {
        double all = 0.5 * spectrum.total();
        double[] power = spectrum.power();
        for (int i = power.length / 2; i < power.length; i++) {
            SpatialFrequency frequency = spectrum.frequency(i);
            boolean counts = frequency.length() > COARSEST * wave.length() && which.test(frequency);
            all -= counts ? 0 : i == power.length / 2 ? 0.5 * power[i] : power[i];
        }
        DoubleStream explained = IntStream.rangeClosed(1, OVERTONES)
                .mapToDouble(k -> around(wave.times(k), BREADTH / k, which).power());
        return all > 0 ? Math.min(1, explained.sum() / all) : 0;
    }

    /** Mean power in a line's sector over the median sector of the ring at its frequency. */
    double contrast(SpatialFrequency wave) {
        return contrast(wave, 1 - BREADTH, 1 + BREADTH);
    }

    private double contrast(SpatialFrequency wave, double from, double to) {
        double[] sums = new double[SECTORS];
        int[] counts = new int[SECTORS];
        for (int place : binsBetween(wave, from, to)) {
            double turns = (spectrum.frequency(place).azimuth() - wave.azimuth()) / Math.PI + 0.5 / SECTORS;
            int sector = Math.min(SECTORS - 1, (int) (SECTORS * (turns - Math.floor(turns))));
            sums[sector] += spectrum.power()[place];
            counts[sector]++;
        }
        Arrays.setAll(sums, i -> sums[i] / Math.max(1, counts[i]));
        double line = sums[0];
        Arrays.sort(sums);
        return line / sums[SECTORS / 2];
    }

    /** Returns how many unlike lines repeat together: 2 or 3 if there is a peak at a half or a third of a wave's frequency, else 1. */
    int ridges(SpatialFrequency wave) {
        return IntStream.of(2, 3)
                .filter(count -> isFundamental(wave.times(1.0 / count), wave, count))
                .boxed()
                .max(Comparator.comparingDouble(count -> top(wave.times(1.0 / count))))
                .orElse(1);
    }

    /** Whether a fundamental is there; of many periods its overtone, too, which may outshine it where one line in three differs. */
    private boolean isFundamental(SpatialFrequency below, SpatialFrequency wave, int count) {
        List<SpatialFrequency> overtones =
                IntStream.range(1, 2 * count).mapToObj(below::times).toList();
        double periods = below.periodsIn(scan);
        int lines = periods < FEWEST_OF_FAINT ? 1 : count - 1;
        return which.test(below)
                && periods >= FEWEST_PERIODS
                && overtones.subList(0, lines).stream().anyMatch(line -> isLine(line, wave, overtones, periods));
    }

    private boolean isLine(
            SpatialFrequency line, SpatialFrequency wave, List<SpatialFrequency> others, double periods) {
        double power = top(line) / top(wave);
        boolean isFaint = power < WEAK_FUNDAMENTAL;
        if (!isPeak(line) || power < FAINTEST_FUNDAMENTAL || (isFaint && periods < FEWEST_OF_FAINT)) {
            return false;
        }
        if (power >= LEAST_FUNDAMENTAL && contrast(line) >= LEAST_CONTRAST) {
            return true;
        }
        return significance(line) >= SIGNIFICANT && prominence(line, others) >= (isFaint ? FAINT_PROMINENT : PROMINENT);
    }

    private boolean isPeak(SpatialFrequency wave) {
        double highest = 0;
        int x = (int) Math.rint(wave.x() * spectrum.width());
        int y = (int) Math.rint(wave.y() * spectrum.height());
        for (int jy = -2; jy <= 2; jy++) {
            for (int jx = -2; jx <= 2; jx++) {
                highest = Math.max(highest, spectrum.at(x + jx, y + jy));
            }
        }
        return top(wave) >= highest;
    }

    double top(SpatialFrequency frequency) {
        int x = (int) Math.rint(frequency.x() * spectrum.width());
        int y = (int) Math.rint(frequency.y() * spectrum.height());
        DoubleStream square = IntStream.range(0, 9).mapToDouble(i -> spectrum.at(x - 1 + i % 3, y - 1 + i / 3));
        return square.max().orElseThrow();
    }

    /** Height of a wave's peak over the largest median beside it, without the bins of other waves. */
    double prominence(SpatialFrequency wave, List<SpatialFrequency> others) {
        double coarser = beside(wave, others, COARSER_FROM, COARSER_TO);
        double finer = beside(wave, others, FINER_FROM, FINER_TO);
        return top(wave) / Math.max(alongRows(wave), Math.max(coarser, finer));
    }

    /** Median of the power at a wave's frequency along x: rows of a vibration that differ in phase have it at all frequencies along y. */
    private double alongRows(SpatialFrequency wave) {
        if (Math.abs(wave.x()) < LINE * binX) {
            return 0;
        }
        int x = (int) Math.rint(wave.x() * spectrum.width());
        int y = (int) Math.rint(wave.y() * spectrum.height());
        int from = (int) (spectrum.height() * Math.max((LINE + 1) * binY, COARSER_FROM * wave.length()));
        double[] powers = IntStream.rangeClosed(from, Math.max(3 * from, from + 8))
                .flatMap(step -> IntStream.of(y + step, y - step))
                .filter(spectrum.bandY()::holds)
                .mapToDouble(jy ->
                        Math.max(spectrum.at(x, jy), Math.max(spectrum.at(x - 1, jy), spectrum.at(x + 1, jy))))
                .toArray();
        return powers.length == 0 ? 0 : Quantiles.of(powers, 0.5);
    }

    /** Height of a peak over the median of the bins 3 to 6 bins of the scan from it. */
    double significance(SpatialFrequency wave) {
        int count = 0;
        int stepX = (int) Math.rint(2 * LINE * binX * spectrum.width());
        int stepY = (int) Math.rint(2 * LINE * binY * spectrum.height());
        double[] powers = new double[(2 * stepX + 1) * (2 * stepY + 1)];
        int x = (int) Math.rint(wave.x() * spectrum.width());
        int y = (int) Math.rint(wave.y() * spectrum.height());
        for (int jy = -stepY; jy <= stepY; jy++) {
            for (int jx = -stepX; jx <= stepX; jx++) {
                double distance = Math.hypot((double) jx / stepX, stepY > 0 ? (double) jy / stepY : 0);
                if (distance >= 0.5
                        && distance <= 1
                        && spectrum.bandX().holds(x + jx)
                        && spectrum.bandY().holds(y + jy)) {
                    powers[count++] = spectrum.at(x + jx, y + jy);
                }
            }
        }
        double middle = count == 0 ? 0 : Quantiles.of(Arrays.copyOf(powers, count), 0.5);
        return middle > 0 ? top(wave) / middle : Double.POSITIVE_INFINITY;
    }

    /** Height of the highest of the accepted waves' independent peaks over the median, which noise reaches in 1 of 100 scans. */
    double chance() {
        long accepted = IntStream.range(spectrum.power().length / 2 + 1, spectrum.power().length)
                .filter(place -> which.test(spectrum.frequency(place)))
                .count();
        double padding = binX * spectrum.width() * binY * spectrum.height();
        // Powers of noise are distributed exponentially.
        return Math.log(Math.max(1, accepted / padding) / FALSE_ALARMS) / Math.log(2);
    }

    /** Share, 0..1, of the variance in plane waves with overtones: a Hann window's line holds 1.5 bins' worth of its peak along each axis. */
    double lineShare(List<SpatialFrequency> waves) {
        double bins = 2
                * worth(binX * spectrum.width(), spectrum.bandX())
                * worth(binY * spectrum.height(), spectrum.bandY());
        double tops = waves.stream()
                .flatMap(wave -> Stream.of(wave, wave.times(2), wave.times(3)))
                .mapToDouble(this::top)
                .sum();
        return Math.min(1, bins * tops / spectrum.total());
    }

    private static double worth(double padding, Band band) {
        return band.count() > 1 ? HANN_BINS * padding : 1;
    }

    /** Median over frequencies of the highest bin in the wave's sector: all but one are empty if the surface varies along one axis only. */
    private double beside(SpatialFrequency wave, List<SpatialFrequency> others, double from, double to) {
        double within = Math.sin(0.5 * Math.PI / SECTORS);
        double step = Math.hypot(wave.x() / spectrum.width(), wave.y() / spectrum.height()) / wave.length();
        Map<Long, Double> highest = new HashMap<>();
        for (int place : binsBetween(wave, from, to)) {
            SpatialFrequency frequency = spectrum.frequency(place);
            if (frequency.sineTo(wave) <= within && others.stream().noneMatch(other -> isNear(frequency, other, 0))) {
                highest.merge(Math.round(frequency.length() / step), spectrum.power()[place], Math::max);
            }
        }
        double[] powers = highest.values().stream().mapToDouble(power -> power).toArray();
        return powers.length == 0 ? 0 : Quantiles.of(powers, 0.5);
    }

    /** Mean power at a wave's frequency, in all directions, over that of coarser bins. */
    double ring(SpatialFrequency wave) {
        return density(wave, 1 - BREADTH, 1 + BREADTH) / density(wave, COARSER_FROM, COARSER_TO);
    }

    private double density(SpatialFrequency wave, double from, double to) {
        return Arrays.stream(binsBetween(wave, from, to))
                .mapToDouble(place -> spectrum.power()[place])
                .average()
                .orElse(0);
    }

    /** Returns one bin of each opposite pair at frequencies from one share of the wave's to another. */
    private int[] binsBetween(SpatialFrequency wave, double from, double to) {
        return IntStream.range(spectrum.power().length / 2 + 1, spectrum.power().length)
                .filter(place -> {
                    double length = spectrum.frequency(place).length();
                    return length >= from * wave.length() && length <= to * wave.length();
                })
                .toArray();
    }

    /**
     * Returns the line, up to two in other directions that are no sums or differences of coarser ones, and one along the line's direction that
     * is no overtone, half as strong or stronger; the strongest is first.
     */
    List<SpatialFrequency> lines(SpatialFrequency line) {
        double beside = Math.sin(1.5 * Math.PI / SECTORS);
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
                                && IntStream.rangeClosed(2, OVERTONES).noneMatch(k -> isNear(other, first.times(k), 0)))
                .filter(other -> strongest(near -> isNear(near, other, 0)).equals(Optional.of(other)))
                .filter(other -> prominence(other, lines) >= LEAST_PARALLEL)
                .ifPresent(lines::add);
        return lines;
    }

    private Optional<SpatialFrequency> another(List<SpatialFrequency> found, Predicate<SpatialFrequency> also) {
        double length = found.get(0).length();
        double least = AS_STRONG * around(found.get(0), BREADTH, which).power();
        // Not waviness, a wide line's own bins, or its opposite's.
        return strongest(also.and(other -> other.length() > COARSEST * length
                        && found.stream().noneMatch(known -> isNear(other, known, BREADTH))))
                .filter(other -> around(other, BREADTH, which).power() >= least && contrast(other) >= LEAST_CONTRAST);
    }

    private boolean isSum(SpatialFrequency sum, SpatialFrequency one, SpatialFrequency two) {
        return Math.max(one.length(), two.length()) < COARSER * sum.length()
                && (isNear(sum, one.plus(two), 0) || isNear(sum, one.plus(two.times(-1)), 0));
    }

    boolean isNear(SpatialFrequency frequency, SpatialFrequency line, double share) {
        return distance(frequency, line, share) <= 1 || distance(frequency, line.times(-1), share) <= 1;
    }
}
