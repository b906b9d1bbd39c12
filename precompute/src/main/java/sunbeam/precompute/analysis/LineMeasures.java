package sunbeam.precompute.analysis;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleFunction;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.precompute.numerics.Lagrange;
import sunbeam.precompute.numerics.Quantiles;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.spectrum.Band;

/**
 * Measures of lines (peaks of waves) in the power spectrum of a piece of a surface.
 *
 * @param which accepted waves
 * @param binX width of a bin of the unpadded piece, cycles per meter, and binY likewise
 * @param excluded power of one of each opposite pair of bins that are not accepted, square meters
 */
record LineMeasures(
        HeightMap scan,
        HeightSpectrum spectrum,
        Predicate<SpatialFrequency> which,
        double binX,
        double binY,
        double excluded) {
    // In bins of 1 / the scan's side; a Hann window's line reaches 2.
    private static final double LINE = 3;
    // Radius of a broad line as a share of its frequency.
    static final double BREADTH = 0.15;
    static final int OVERTONES = 5;
    // Per scan, for a period that is stated.
    private static final double FALSE_ALARMS = 0.01;
    // Along an axis: power in a Hann window's line over that of its peak.
    private static final double HANN_BINS = 1.5;
    private static final double HANN_REACH = 2.4;
    // Bins between a line and the alias that makes it.
    private static final double NEAR_ALIAS = 1.5;
    // Sectors of 15 degrees in half a turn: rows of a snake's scale stray by 8.
    static final int SECTORS = 12;
    // Frequencies below this share of a wave's are waviness.
    static final double COARSEST = 0.5;
    // Frequencies beside a line, as shares of its own.
    private static final double COARSER_FROM = 0.4;
    private static final double COARSER_TO = 0.7;
    private static final double FINER_FROM = 1.3;
    private static final double FINER_TO = 1.8;
    static final double BESIDE = COARSER_TO - COARSER_FROM + FINER_TO - FINER_FROM;

    static LineMeasures of(HeightMap scan, Predicate<SpatialFrequency> which) {
        HeightSpectrum spectrum = HeightSpectrum.of(scan, HeightSpectrum.Edges.TAPERED);
        double[] power = spectrum.power();
        int middle = power.length / 2;
        double excluded = 0.5 * power[middle];
        for (int place = middle + 1; place < power.length; place++) {
            excluded += which.test(spectrum.frequency(place)) ? 0 : power[place];
        }
        return new LineMeasures(scan, spectrum, which, 1 / scan.width(), 1 / scan.height(), excluded);
    }

    SpatialFrequency refined(int place) {
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

    boolean isNear(SpatialFrequency frequency, SpatialFrequency line, double share) {
        return distance(frequency, line, share) <= 1 || distance(frequency, line.times(-1), share) <= 1;
    }

    /** Whether sampling makes a line of a wave of too high a frequency. */
    boolean isAlias(SpatialFrequency line, SpatialFrequency fine) {
        SpatialFrequency folded = new SpatialFrequency(
                Math.IEEEremainder(fine.x(), 1 / scan.pitchX()), Math.IEEEremainder(fine.y(), 1 / scan.pitchY()));
        return !folded.equals(fine) && line.distance(folded) <= NEAR_ALIAS * Math.max(binX, binY);
    }

    /** Power within a line's radius, and the sums of its frequencies times their power. */
    record Moments(double power, double x, double y) {}

    Moments around(SpatialFrequency center, double share, Predicate<SpatialFrequency> counted) {
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
        double all = relevant(wave);
        return all > 0 ? Math.min(1, explained(wave) / all) : 0;
    }

    private double explained(SpatialFrequency wave) {
        return IntStream.rangeClosed(1, OVERTONES)
                .mapToDouble(k -> around(wave.times(k), BREADTH / k, which).power())
                .sum();
    }

    private double relevant(SpatialFrequency wave) {
        double all = 0.5 * spectrum.total() - excluded;
        for (int place : binsBetween(wave, 0, COARSEST)) {
            all -= which.test(spectrum.frequency(place)) ? spectrum.power()[place] : 0;
        }
        return all;
    }

    /** Mean power in a line's sector over the median sector of the ring at its frequency. */
    double contrast(SpatialFrequency wave) {
        return contrast(wave, 0, List.of());
    }

    /** Likewise over the sectors without the bins that the lines reach: of few periods, two crossing lines fill most. 0 if they fill all. */
    double contrastBeside(SpatialFrequency wave, List<SpatialFrequency> lines) {
        return contrast(wave, 0, lines);
    }

    private double contrast(SpatialFrequency wave, double added, List<SpatialFrequency> lines) {
        double[] sums = new double[SECTORS];
        int[] counts = new int[SECTORS];
        for (int place : binsBetween(wave, 1 - BREADTH, 1 + BREADTH)) {
            SpatialFrequency frequency = spectrum.frequency(place);
            double turns = (frequency.azimuth() - wave.azimuth()) / Math.PI + 0.5 / SECTORS;
            int sector = Math.min(SECTORS - 1, (int) (SECTORS * (turns - Math.floor(turns))));
            boolean isFree = lines.stream()
                    .allMatch(line -> isBesideLine(frequency, line) && isBesideLine(frequency, line.times(-1)));
            if (sector == 0 || isFree) {
                sums[sector] += spectrum.power()[place];
                counts[sector]++;
            }
        }
        sums[0] += added;
        double line = sums[0] / Math.max(1, counts[0]);
        double[] means = IntStream.range(0, SECTORS)
                .filter(i -> lines.isEmpty() || (i > 0 && counts[i] > 0))
                .mapToDouble(i -> sums[i] / Math.max(1, counts[i]))
                .sorted()
                .toArray();
        return means.length == 0 ? 0 : line / means[means.length / 2];
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

    /**
     * Whether a line between a wave's orders exceeds what uneven lines have there by chance: in each independent bin along the wave a power
     * that is distributed exponentially, so that its ratio to the mean of others follows Fisher's distribution. False where no bin is left
     * beside the lines.
     *
     * @param lines the wave's longer period in question and its overtones
     * @param chance that a line of uneven lines is taken for one of order
     */
    boolean exceedsChance(SpatialFrequency line, SpatialFrequency wave, List<SpatialFrequency> lines, double chance) {
        int steps = (int) Math.rint(2 * wave.periodsIn(scan)); // of half a bin
        double independent = 0;
        double sum = 0;
        int count = 0;
        boolean goesOn = false;
        for (int step = 1; step < steps; step++) {
            SpatialFrequency place = wave.times((double) step / steps);
            boolean isFree = isBesideLine(place, new SpatialFrequency(0, 0))
                    && lines.stream().allMatch(other -> isBesideLine(place, other));
            if (isFree) {
                independent += goesOn ? 0.5 / HANN_BINS : 1;
                sum += spectrum.at(
                        (int) Math.rint(place.x() * spectrum.width()), (int) Math.rint(place.y() * spectrum.height()));
                count++;
            }
            goesOn = isFree;
        }
        double limit = independent * (Math.pow(chance, -1 / independent) - 1);
        return count > 0 && top(line) >= limit * sum / count;
    }

    /** Whether a Hann window leaves less than a thousandth of a line's power at a place. */
    private boolean isBesideLine(SpatialFrequency place, SpatialFrequency line) {
        return Math.hypot((place.x() - line.x()) / binX, (place.y() - line.y()) / binY) > HANN_REACH;
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
        double tops = waves.stream()
                .flatMap(wave -> Stream.of(wave, wave.times(2), wave.times(3)))
                .mapToDouble(this::top)
                .sum();
        return Math.min(1, 2 * worth() * tops / spectrum.total());
    }

    /** Power of a line over that of its peak. */
    double worth() {
        return worth(binX * spectrum.width(), spectrum.bandX()) * worth(binY * spectrum.height(), spectrum.bandY());
    }

    /** Returns the evidence of a sharp line by its peak, square meters, if that is higher than what is there. */
    DoubleFunction<Evidence> evidence(SpatialFrequency wave) {
        double here = top(wave);
        double all = relevant(wave);
        double share = explained(wave);
        double lines = lineShare(List.of(wave)) * spectrum.total();
        double contrast = contrast(wave);
        double contrastOfPeak = contrast(wave, worth() * here, List.of()) - contrast;
        double prominence = prominence(wave, List.of()) / here;
        double significance = significance(wave) / here;
        double ring = ring(wave);
        double unseen = unseen();
        return peak -> {
            double added = worth() * (peak - here);
            return new Evidence(
                    false,
                    wave.periodsIn(scan),
                    wave.samplesIn(scan),
                    (share + added) / (all + added),
                    (lines + 2 * added) / (spectrum.total() + 2 * added),
                    contrast + contrastOfPeak * (peak / here - 1),
                    ring,
                    prominence * peak,
                    significance * peak,
                    unseen,
                    Double.POSITIVE_INFINITY,
                    0);
        };
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
        int reachX = (int) Math.min(spectrum.bandX().last(), to * wave.length() * spectrum.width());
        int reachY = (int) Math.min(spectrum.bandY().last(), to * wave.length() * spectrum.height());
        int[] places = new int[(reachY + 1) * (2 * reachX + 1)];
        double least = square(from * wave.length());
        double most = square(to * wave.length());
        int count = 0;
        for (int jy = 0; jy <= reachY; jy++) {
            for (int jx = jy == 0 ? 1 : -reachX; jx <= reachX; jx++) {
                double square = square(jx / spectrum.width()) + square(jy / spectrum.height());
                if (square >= least && square <= most) {
                    places[count++] =
                            (jy - spectrum.bandY().first()) * spectrum.bandX().count()
                                    + jx
                                    - spectrum.bandX().first();
                }
            }
        }
        return Arrays.copyOf(places, count);
    }

    private static double square(double value) {
        return value * value;
    }
}
