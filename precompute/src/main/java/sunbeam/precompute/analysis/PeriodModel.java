package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Lengths;

/**
 * Estimates the period of a piece of a surface. A sharp line of the spectrum is corrected by the slope of the wave's phase, whose interval
 * includes the estimates from halves of the scan and from its rows, with crossing waves subtracted. A broad line has the centroid of its
 * power, and an interval from tiles.
 */
record PeriodModel(
        HeightMap scan, HeightMap level, WaveSearch search, Predicate<SpatialFrequency> which, String nothing) {
    // For a sure period; fewer may be chance or waviness.
    static final double FEWEST_PERIODS = 4;
    // For a probable period: the Hann window spreads what does not repeat over up to two periods.
    private static final double FEWEST_SEEN = 3;
    // Per period; fewer may be an alias.
    private static final double FEWEST_SAMPLES = 4;
    // Half width, as a share of the frequency.
    private static final double WIDEST = 0.1;
    // White noise stays below this share of the variance.
    static final double LEAST_SHARE = 0.08;
    // Half width in cycles per length: the slope's bias from finite size and sampling.
    private static final double FINITE = 0.01;
    // Distance of a wave in a part of the scan, as a share of the frequency.
    private static final double NEAR = 0.3;
    // A cause that makes a part deviate also biases the whole.
    private static final double BEYOND = 1.3;
    // WaveSearch.sharpness of a sharp line, and of one of a few equally strong speckles.
    private static final double SHARP = 0.5;
    private static final double AS_STRONG = 0.25;
    private static final int MOST_TILES = 4;
    // Prominence: isotropic noise stays below; rows of a snake's fingers have 16 to 30, gratings 50 and more.
    private static final double LEAST_PROMINENCE = 12;
    // Straight lines have fewer independent samples: noise reaches 16, once in 600 surfaces 23.
    private static final double LEAST_OF_STRAIGHT = 20;
    // Few periods overlap their neighborhood: noise reaches 5, three trenches 6 or more, a wave alone in noise 8.
    private static final double LEAST_OF_FEW = 6;
    private static final double CONTRAST_OF_FEW = 50;
    // Share of the variance: stretched noise reaches 0.45, gratings of 3.2 periods or more have 0.7.
    private static final double STRAIGHT = 0.55;
    // Prominence of undersampled lines, and of uneven lines that are not straight.
    private static final double WITHOUT_LINES = 60;
    private static final int BINS_PER_PERIOD = 12;

    /**
     * Empty if no accepted wave fits three times into the scan.
     *
     * @param nothing start of the reason if no period is seen
     */
    static Optional<GratingPeriod> of(HeightMap scan, Predicate<SpatialFrequency> which, String nothing) {
        Predicate<SpatialFrequency> visible = which.and(wave -> wave.length() * HeightSpectrum.SHORTEST_PERIOD <= 1);
        return new PeriodModel(scan, Leveling.PLANE.apply(scan), new WaveSearch(scan, visible), visible, nothing)
                .strongest(wave -> wave.periodsIn(scan) >= FEWEST_SEEN);
    }

    /** Waviness may hide a grating more than four times as fine, which then takes its place. */
    private Optional<GratingPeriod> strongest(Predicate<SpatialFrequency> left) {
        Optional<SpatialFrequency> line = search.strongest(left);
        Optional<GratingPeriod> first = line.map(found -> judged(search.fundamental(found, left)));
        if (first.isEmpty() || first.get().isSeen()) {
            return first;
        }
        double coarse = line.orElseThrow().length();
        return strongest(left.and(wave -> wave.length() > FEWEST_PERIODS * coarse))
                .filter(GratingPeriod::isSeen)
                .or(() -> first);
    }

    private GratingPeriod judged(SpatialFrequency strongest) {
        List<SpatialFrequency> lines = search.lines(strongest);
        SpatialFrequency line = lines.get(0);
        double sharpness = search.sharpness(line);
        boolean sharp = sharpness >= SHARP || tiles(line) < 2;
        List<SpatialFrequency> waves = new ArrayList<>(lines);
        List<SpatialFrequency> parallel = lines.stream()
                .skip(1)
                .filter(other -> other.sineTo(line) < GratingPeriod.CONE)
                .toList();
        waves.set(0, sharp ? corrected(without(parallel), line) : search.centroid(line));
        boolean lattice = GratingPeriod.vague(waves, 0, 0).isLattice();
        waves = sharp && lattice ? refined(waves) : waves;
        SpatialFrequency wave = waves.get(0);
        double periods = wave.periodsIn(scan);
        List<SpatialFrequency> counted = lattice ? waves : waves.subList(0, 1);
        double share = Math.min(1, counted.stream().mapToDouble(search::share).sum());
        boolean few = periods < FEWEST_PERIODS;
        GratingPeriod vague = GratingPeriod.vague(waves, periods, share);
        if (share < LEAST_SHARE && search.unseen() > 0.5) {
            return vague.none("no order found: most of the relief is finer than light resolves (190 nm)");
        }
        String about = Lengths.rounded(wave.period(), 2);
        String gloss = nothing + "; the strongest wave, of about " + about;
        if (share < LEAST_SHARE) {
            return vague.none(gloss + Text.format(", explains only %.0f %% of the heights' variance", 100 * share));
        }
        double contrast = search.contrast(wave);
        if (contrast < WaveSearch.LEAST_CONTRAST && !few && search.ring(wave) >= WaveSearch.LEAST_RING) {
            return vague.withCertainty(
                    GratingPeriod.Certainty.ALL_DIRECTIONS,
                    "no grating found: waves of about " + about + " run in nearly all directions alike");
        }
        double inLines = straightShare(wave);
        boolean straight = inLines >= STRAIGHT;
        double seen = Math.floor(10 * periods) / 10;
        if (periods < FEWEST_SEEN && straight && contrast >= CONTRAST_OF_FEW) {
            return vague.tooLittle(Text.format("only %.1f periods of about %s", seen, about));
        }
        // The centroid of speckles may lie between two of them; that of straight lines does not.
        double prominence = search.prominence(straight ? wave : line, parallel);
        boolean alone = !few && search.isAlone(wave);
        double least = few || alone ? LEAST_OF_FEW : straight ? LEAST_OF_STRAIGHT : LEAST_PROMINENCE;
        if (contrast < (few ? CONTRAST_OF_FEW : WaveSearch.LEAST_CONTRAST) || prominence < least) {
            return vague.none(gloss + ", is no stronger than one of noise");
        }
        if (few) {
            String evidence = ", is seen only %.1f times; its lines explain only %.0f %% of the heights' variance";
            return straight
                    ? vague.probable(Text.format("%.1f periods seen, too few for an interval", seen))
                    : vague.none(gloss + Text.format(evidence, seen, 100 * inLines));
        }
        double samples = wave.samplesIn(scan);
        if (samples < FEWEST_SAMPLES) {
            String sampled = Text.format("%.1f samples a period: perhaps the alias of a shorter one", samples);
            return straight && prominence >= WITHOUT_LINES
                    ? vague.probable(sampled + "; scan finer")
                    : vague.none(gloss + ", has only " + sampled);
        }
        GratingPeriod found = sharp ? byPhase(vague) : byTiles(vague, sharpness >= AS_STRONG ? line : wave);
        return 1 / found.low() - 1 / found.high() <= 2 * WIDEST * wave.length()
                ? found
                : found.probable("so uneven that this scan does not determine it to 10 %; use a larger one");
    }

    /** Returns the share, 0..1, of the variance in means along the wave's straight lines. */
    private double straightShare(SpatialFrequency wave) {
        double bin = wave.period() / BINS_PER_PERIOD;
        int count = 2 + (int) (Math.hypot(scan.width(), scan.height()) / bin);
        double[] sums = new double[count];
        int[] counts = new int[count];
        double all = 0;
        for (int row = 0; row < scan.rows(); row++) {
            double y = (0.5 * scan.rows() - row - 0.5) * scan.pitchY();
            for (int column = 0; column < scan.columns(); column++) {
                double x = (column + 0.5 - 0.5 * scan.columns()) * scan.pitchX();
                int place = (int) (0.5 * count + (x * wave.x() + y * wave.y()) / wave.length() / bin);
                sums[place] += level.at(column, row);
                counts[place]++;
                all += level.at(column, row) * level.at(column, row);
            }
        }
        Arrays.setAll(sums, i -> sums[i] * sums[i] / Math.max(1, counts[i]));
        return StatUtils.sum(sums) / all;
    }

    private GratingPeriod byPhase(GratingPeriod vague) {
        SpatialFrequency wave = vague.wave();
        HeightMap alone = without(vague.others());
        double finite = FINITE * wave.length() / vague.periods();
        double half = Math.max(PhaseSlope.of(alone, wave, false).halfWidth(), finite);
        Interval interval = new Interval(wave.length() - half, wave.length() + half);
        double x = 0.5 * scan.width();
        double y = 0.5 * scan.height();
        List<Crop> halves = new ArrayList<>();
        if (scan.columns() > 1) {
            halves.add(new Crop(0, x, 0, scan.height()));
            halves.add(new Crop(x, scan.width(), 0, scan.height()));
        }
        if (scan.rows() > 1) {
            halves.add(new Crop(0, scan.width(), 0, y));
            halves.add(new Crop(0, scan.width(), y, scan.height()));
        }
        for (Crop part : halves) {
            interval = interval.reaching(near(part.apply(alone), wave).length(), wave.length());
        }
        SpatialFrequency byRows = new SpatialFrequency(wave.x(), wave.y() + PhaseSlope.byRows(alone, wave));
        interval = interval.reaching(byRows.length(), wave.length());
        double across = Math.max(PhaseSlope.of(alone, wave, true).halfWidth(), finite);
        return vague.within(interval.low(), interval.high(), Math.atan(across / wave.length()));
    }

    /**
     * Takes the interval from the centroids in tiles. Tiles along straight lines are not independent: the error falls only along the wave.
     *
     * @param line line that the interval must include: the centroid of two equally strong periods is neither
     */
    private GratingPeriod byTiles(GratingPeriod vague, SpatialFrequency line) {
        SpatialFrequency wave = vague.wave();
        int side = tiles(wave);
        double[] lengths = new double[side * side];
        double[] turns = new double[side * side];
        double width = scan.width() / side;
        double height = scan.height() / side;
        for (int i = 0; i < lengths.length; i++) {
            double left = width * (i % side);
            int row = i / side;
            Crop tile = new Crop(left, left + width, height * row, height * (row + 1));
            SpatialFrequency part = new WaveSearch(tile.apply(scan), which).centroid(wave);
            lengths[i] = part.length();
            turns[i] = Math.IEEEremainder(part.azimuth() - wave.azimuth(), Math.PI);
        }
        double student = GratingPeriod.student(lengths.length - 1);
        double half = student * Math.sqrt(StatUtils.variance(lengths) / side);
        double turn = student * Math.sqrt(StatUtils.variance(turns) / side);
        Interval interval =
                new Interval(wave.length() - half, wave.length() + half).reaching(line.length(), wave.length());
        return vague.within(interval.low(), interval.high(), turn);
    }

    private int tiles(SpatialFrequency wave) {
        return (int) Math.min(MOST_TILES, wave.periodsIn(scan) / FEWEST_PERIODS);
    }

    /** Frequencies, cycles per meter. */
    private record Interval(double low, double high) {
        Interval reaching(double part, double whole) {
            double end = whole + BEYOND * (part - whole);
            return new Interval(Math.min(low, end), Math.max(high, end));
        }
    }

    /** Finds each wave again with the others subtracted: two that are alike cancel each other along lines of the scan. */
    private List<SpatialFrequency> refined(List<SpatialFrequency> lattice) {
        List<SpatialFrequency> waves = new ArrayList<>(lattice);
        for (int i = 0; i < 2 * waves.size(); i++) {
            SpatialFrequency wave = waves.remove(0);
            waves.add(near(without(waves), wave));
        }
        return waves;
    }

    private HeightMap without(List<SpatialFrequency> waves) {
        HeightMap left = level;
        for (SpatialFrequency wave : waves) {
            left = PhaseSlope.without(left, wave);
        }
        return left;
    }

    private static SpatialFrequency corrected(HeightMap level, SpatialFrequency wave) {
        SpatialFrequency result = wave;
        for (int i = 0; i < 2; i++) {
            result = result.corrected(
                    PhaseSlope.of(level, result, false).value(),
                    PhaseSlope.of(level, result, true).value());
            if (!(result.distance(wave) < NEAR * wave.length())) {
                return wave;
            }
        }
        return result;
    }

    private static SpatialFrequency near(HeightMap part, SpatialFrequency wave) {
        return new WaveSearch(part, frequency -> frequency.distance(wave) < NEAR * wave.length())
                .strongest(frequency -> true)
                .map(found -> corrected(Leveling.PLANE.apply(part), found))
                .orElse(wave);
    }
}
