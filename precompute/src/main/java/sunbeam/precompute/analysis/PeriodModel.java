package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.units.Lengths;

/**
 * The period of a piece of a surface: heights less their plane, the highest bin of their Hann-windowed, zero-padded power
 * spectrum, corrected by the slope of the wave's phase in windows of two periods, along the wave and along its lines. The
 * interval is that of the slope, widened to what the scan's halves and its rows by themselves tell.
 */
final class PeriodModel {
    private static final int WINDOW_PERIODS = 2;
    static final double FEWEST_PERIODS = 4;
    private static final double FEWEST_SEEN = 3;
    private static final double FEWEST_SAMPLES = 4;
    // What is seen less often and not told may be waviness, under which finer lines are looked for.
    private static final double FEWEST_OF_A_GRATING = 7;
    // Half of the interval over the period.
    private static final double WIDEST = 0.1;
    static final double LEAST_SHARE = 0.08;
    // Cycles over the scan: by as much, what lies beyond the scan or between its samples may draw the slope.
    private static final double FINITE = 0.01;
    // Of a frequency, on either side, where a part of the scan is asked for it.
    private static final double NEAR = 0.3;
    // Of the power around a line, in the line itself: one line, or a quarter of it.
    private static final double SHARP = 0.5;
    private static final double AS_STRONG = 0.25;
    private static final int MOST_TILES = 4;
    private static final int FEWEST_TILES = 2;
    private static final int MOST_TRIED = 4;
    private static final double FINER = 4;
    private static final double BEYOND = 1.3;
    private static final int DIGITS = 3;

    private final HeightMap scan;
    private final HeightMap level;
    private final WaveSearch search;
    private final Predicate<SpatialFrequency> which;

    private PeriodModel(HeightMap scan, Predicate<SpatialFrequency> which) {
        this.scan = scan;
        this.level = Levelling.PLANE.apply(scan);
        this.search = new WaveSearch(scan, which);
        this.which = which;
    }

    /** Of the strongest of some waves; empty where none of them is seen three times or more. */
    static Optional<GratingPeriod> of(HeightMap scan, Predicate<SpatialFrequency> which) {
        return new PeriodModel(scan, which).strongest();
    }

    private Optional<GratingPeriod> strongest() {
        Predicate<SpatialFrequency> left = wave -> wave.periodsIn(scan) >= FEWEST_SEEN;
        Optional<GratingPeriod> first = Optional.empty();
        for (int i = 0; i < MOST_TRIED; i++) {
            Optional<SpatialFrequency> line = search.strongest(left);
            if (line.isEmpty()) {
                break;
            }
            GratingPeriod told = told(line.get());
            first = told.isTold() ? Optional.of(told) : first.or(() -> Optional.of(told));
            if (told.isTold() || told.periods() > FEWEST_OF_A_GRATING) {
                break;
            }
            SpatialFrequency refused = line.get();
            left = left.and(wave -> wave.length() > FINER * refused.length());
        }
        return first;
    }

    private GratingPeriod told(SpatialFrequency line) {
        double sharpness = search.sharpness(line);
        boolean sharp = sharpness >= SHARP || tiles(line) < FEWEST_TILES;
        SpatialFrequency wave = sharp ? corrected(level, line) : search.centroid(line);
        double periods = wave.periodsIn(scan);
        double share = search.share(wave);
        GratingPeriod vague =
                new GratingPeriod(wave, 0, Double.POSITIVE_INFINITY, Math.PI, periods, share, Optional.empty());
        if (share < LEAST_SHARE) {
            return vague.refused(String.format(
                    Locale.ROOT,
                    "no order found: a white gloss without color; the strongest wave, of about %s, explains only %.0f %% of the heights' variance",
                    shortly(vague.period()),
                    100 * share));
        }
        if (periods < FEWEST_PERIODS) {
            return vague.refused(String.format(
                    Locale.ROOT,
                    "no order found for sure: a wave of about %s is seen only %.1f times, and fewer than four may be chance; take a larger scan",
                    shortly(vague.period()),
                    Math.floor(10 * periods) / 10));
        }
        if (wave.samplesIn(scan) < FEWEST_SAMPLES) {
            return vague.refused(String.format(
                    Locale.ROOT,
                    "too few samples: a wave of about %s has %.1f of them, and fewer than four may be the alias of a shorter one; scan finer",
                    shortly(vague.period()),
                    wave.samplesIn(scan)));
        }
        GratingPeriod told = sharp ? byPhase(vague) : byTiles(vague, sharpness >= AS_STRONG ? line : wave);
        if (1 / told.low() - 1 / told.high() > 2 * WIDEST * wave.length()) {
            return told.refused(String.format(
                    Locale.ROOT,
                    "no single period: the surface repeats after about %s, but so unevenly that this scan does not tell it to a tenth; take a larger scan, or a part of it",
                    shortly(told.period())));
        }
        return told;
    }

    /** Of a sharp line: what its phase does besides growing evenly, and what parts of the scan tell. */
    private GratingPeriod byPhase(GratingPeriod vague) {
        SpatialFrequency wave = vague.wave();
        DemodulatedPhase.Slope along = along(level, wave).slope(GratingPeriod.PROBABILITY);
        DemodulatedPhase.Slope across = across(level, wave).slope(GratingPeriod.PROBABILITY);
        double half = Math.max(along.halfWidth(), FINITE * wave.length() / vague.periods());
        Interval interval = new Interval(wave.length() - half, wave.length() + half);
        for (HeightMap part : parts()) {
            interval = interval.reaching(near(part, wave).length(), wave.length());
        }
        interval = interval.reaching(byRows(wave).length(), wave.length());
        return vague.within(interval.low(), interval.high(), Math.atan(across.halfWidth() / wave.length()));
    }

    /**
     * Of a broad line, whose phase no wave keeps: the middle of its power in tiles of the scan. Tiles beside each other along
     * straight lines tell the same, so that only as many count as stand along the wave.
     *
     * @param line that the interval holds as well: of two periods as strong as each other the middle is neither
     */
    private GratingPeriod byTiles(GratingPeriod vague, SpatialFrequency line) {
        SpatialFrequency wave = vague.wave();
        int side = tiles(wave);
        double[] lengths = new double[side * side];
        double[] turns = new double[side * side];
        for (int i = 0; i < lengths.length; i++) {
            int column = i % side;
            int row = i / side;
            double left = scan.width() * column / side;
            double bottom = scan.height() * row / side;
            Crop crop = new Crop(left, left + scan.width() / side, bottom, bottom + scan.height() / side);
            SpatialFrequency part = new WaveSearch(crop.apply(scan), which).centroid(wave);
            lengths[i] = part.length();
            turns[i] = Math.IEEEremainder(part.azimuth() - wave.azimuth(), Math.PI);
        }
        double student = new TDistribution(lengths.length - 1)
                .inverseCumulativeProbability(0.5 + 0.5 * GratingPeriod.PROBABILITY);
        double half = student * Math.sqrt(StatUtils.variance(lengths) / side);
        double turn = student * Math.sqrt(StatUtils.variance(turns) / side);
        Interval interval =
                new Interval(wave.length() - half, wave.length() + half).reaching(line.length(), wave.length());
        return vague.within(interval.low(), interval.high(), turn);
    }

    /** Tiles along each side, of four periods or more. */
    private int tiles(SpatialFrequency wave) {
        return (int) Math.min(MOST_TILES, wave.periodsIn(scan) / FEWEST_PERIODS);
    }

    /** Of frequencies, cycles per metre. */
    private record Interval(double low, double high) {
        /** Widened to what a part tells, and a little further: what makes parts differ draws the whole, too. */
        Interval reaching(double part, double whole) {
            double end = whole + BEYOND * (part - whole);
            return new Interval(Math.min(low, end), Math.max(high, end));
        }
    }

    private HeightMap[] parts() {
        double x = 0.5 * scan.width();
        double y = 0.5 * scan.height();
        return List.of(
                        new Crop(0, x, 0, scan.height()),
                        new Crop(x, scan.width(), 0, scan.height()),
                        new Crop(0, scan.width(), 0, y),
                        new Crop(0, scan.width(), y, scan.height()))
                .stream()
                .map(crop -> crop.apply(scan))
                .toArray(HeightMap[]::new);
    }

    private static DemodulatedPhase along(HeightMap level, SpatialFrequency wave) {
        return DemodulatedPhase.of(level, wave, wave.azimuth(), WINDOW_PERIODS * wave.period(), false);
    }

    private static DemodulatedPhase across(HeightMap level, SpatialFrequency wave) {
        return DemodulatedPhase.of(level, wave, wave.azimuth() + 0.5 * Math.PI, WINDOW_PERIODS * wave.period(), true);
    }

    /** The wave whose phase, followed along both directions, stands still. */
    private static SpatialFrequency corrected(HeightMap level, SpatialFrequency wave) {
        SpatialFrequency result = wave;
        for (int i = 0; i < 2; i++) {
            double alongSlope =
                    along(level, result).slope(GratingPeriod.PROBABILITY).value();
            double acrossSlope =
                    across(level, result).slope(GratingPeriod.PROBABILITY).value();
            result = result.corrected(alongSlope, acrossSlope);
            if (!(result.distance(wave) < NEAR * wave.length())) {
                // Farther off it is another wave that is followed.
                return wave;
            }
        }
        return result;
    }

    /** The wave of a part of the scan that is near one of the whole. */
    private static SpatialFrequency near(HeightMap part, SpatialFrequency wave) {
        return new WaveSearch(part, frequency -> frequency.distance(wave) < NEAR * wave.length())
                .strongest(frequency -> true)
                .map(found -> corrected(Levelling.PLANE.apply(part), found))
                .orElse(wave);
    }

    /** The wave as its rows tell it one after the other. */
    private SpatialFrequency byRows(SpatialFrequency wave) {
        return new SpatialFrequency(wave.x(), wave.y() + RowPhase.slope(level, wave));
    }

    private static String shortly(double metres) {
        return Lengths.rounded(metres, DIGITS);
    }
}
