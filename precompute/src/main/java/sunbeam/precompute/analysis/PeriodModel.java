package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.StatUtils;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Leveling;

/**
 * Estimates the period of a piece of a surface. A sharp line of the spectrum is corrected by the slope of the wave's phase, whose interval
 * includes the estimates from halves of the scan and from its rows, with crossing waves subtracted. A broad line has the centroid of its
 * power, and an interval from tiles.
 */
record PeriodModel(HeightMap scan, WaveSearch search, Hypothesis asked) {
    // Below three, waves are candidates for a larger scan only.
    private static final double FEWEST_TRIED = 2.2;
    // In a tile.
    private static final double FEWEST_PERIODS = 4;
    // Distance of a wave in a part of the scan, as a share of the frequency.
    private static final double NEAR = 0.3;
    // Half widths of the interval: a part that deviates by more has another period.
    private static final double INCONSISTENT = 2;
    // A cause that makes a part deviate also biases the whole.
    private static final double BEYOND = 1.3;
    // Share of the wave's power; the wave is not seen in parts that have less.
    private static final double SEEN_IN_PART = 0.25;
    // LineMeasures.sharpness of a sharp line, and of one of a few equally strong speckles.
    private static final double SHARP = 0.5;
    private static final double AS_STRONG = 0.25;
    private static final int MOST_TILES = 4;
    private static final int MOST_TRIED = 8;

    /**
     * Searches the scan without edges, its robust heights, and these without ridges, each if those before it show no sure period, or none at
     * all; empty if no accepted wave fits twice.
     */
    static Optional<GratingPeriod> of(HeightMap scan, Hypothesis asked) {
        Optional<GratingPeriod> leveled = TerraceEdges.removed(scan)
                .flatMap(level -> strongest(RobustHeights.of(level).clipped(), asked));
        if (leveled.filter(GratingPeriod::isSure).isPresent()) {
            return leveled;
        }
        RobustHeights robust = RobustHeights.of(scan);
        Optional<GratingPeriod> best = strongest(robust.clipped(), asked)
                .filter(found -> found.isBetterThan(leveled.filter(GratingPeriod::hasOrder)))
                .or(() -> leveled);
        boolean isSeen = best.filter(GratingPeriod::isSeen).isPresent();
        Optional<HeightMap> left = isSeen ? Optional.empty() : robust.withoutRidges();
        Optional<GratingPeriod> beside =
                left.flatMap(heights -> strongest(heights, asked)).filter(GratingPeriod::isSeen);
        HeightMap judged = beside.flatMap(found -> left).orElse(scan);
        return Stream.of(beside, best)
                .flatMap(Optional::stream)
                .filter(GratingPeriod::isSure)
                .findFirst()
                .or(() -> few(judged, asked))
                .or(() -> beside)
                .or(() -> best);
    }

    private static Optional<GratingPeriod> few(HeightMap scan, Hypothesis asked) {
        return CoarseWave.in(scan, asked)
                .map(wave -> GratingPeriod.vague(List.of(wave), wave.periodsIn(scan), 1)
                        .tooLittle(Reasons.few(wave.periodsIn(scan), wave)));
    }

    private static Optional<GratingPeriod> strongest(HeightMap robust, Hypothesis asked) {
        Predicate<SpatialFrequency> visible =
                wave -> asked.test(wave) && wave.length() * HeightSpectrum.SHORTEST_PERIOD <= 1;
        return new PeriodModel(robust, new WaveSearch(robust, visible), asked).strongest();
    }

    /** Judges the highest peaks, of which those of waviness and defects may be higher than a grating's; the first that is order wins. */
    private Optional<GratingPeriod> strongest() {
        Optional<GratingPeriod> best = Optional.empty();
        List<SpatialFrequency> tried = search.peaks(wave -> wave.periodsIn(scan) >= FEWEST_TRIED, MOST_TRIED);
        for (SpatialFrequency line : tried) {
            GratingPeriod found = judged(line);
            boolean better = best.filter(known -> known.certainty().compareTo(found.certainty()) <= 0
                            || (known.hasOrder() && isOvertone(line, known.wave())))
                    .isEmpty();
            best = better ? Optional.of(found) : best;
            if (best.get().isSeen()) {
                break;
            }
        }
        return best.map(found -> found.hasOrder() ? found : found.excluding(WaveLimit.of(search.measures(), tried)));
    }

    private boolean isOvertone(SpatialFrequency line, SpatialFrequency of) {
        return IntStream.rangeClosed(2, LineMeasures.OVERTONES)
                .anyMatch(k -> search.measures().isNear(line, of.times(k), 0));
    }

    private GratingPeriod judged(SpatialFrequency strongest) {
        List<SpatialFrequency> lines = search.lines(strongest);
        SpatialFrequency line = lines.get(0);
        List<SpatialFrequency> parallel = lines.stream()
                .skip(1)
                .filter(other -> other.sineTo(line) < GratingPeriod.CONE)
                .toList();
        double sharpness = search.measures().sharpness(line);
        boolean sharp = sharpness >= SHARP || tiles(line) < 2;
        SpatialFrequency middle = sharp ? line : search.measures().centroid(line);
        boolean lattice = GratingPeriod.vague(lines, 0, 0).isLattice();
        double share = (lattice ? lines : List.of(middle))
                .stream().mapToDouble(search.measures()::share).sum();
        Evidence evidence = new Evidence(
                !sharp,
                middle.periodsIn(scan),
                middle.samplesIn(scan),
                Math.min(1, share),
                // A ridge that crosses the wave is not its like.
                Math.min(
                        search.measures().lineShare(lines),
                        lines.size() * search.measures().lineShare(List.of(line))),
                search.measures().contrast(middle),
                search.measures().ring(middle),
                search.measures().prominence(line, parallel),
                search.measures().significance(line),
                search.measures().unseen(),
                asked.isStated() ? search.measures().chance() : Double.POSITIVE_INFINITY,
                0);
        Decision decision = Decision.of(evidence);
        List<SpatialFrequency> waves = new ArrayList<>(lines);
        waves.set(0, middle);
        if (decision.certainty.compareTo(GratingPeriod.Certainty.PROBABLE) > 0) {
            return told(decision, evidence, GratingPeriod.vague(waves, evidence.periods(), evidence.share()));
        }
        // Lines that differ in turn also have waves of the longer period, which would turn this wave's phase.
        int ridges = search.ridges(line);
        List<SpatialFrequency> beside = new ArrayList<>(parallel);
        IntStream.range(1, ridges).forEach(k -> beside.add(line.times((double) k / ridges)));
        waves.set(0, sharp ? corrected(without(beside), line) : middle);
        waves = sharp && lattice ? refined(waves) : waves;
        GratingPeriod found = GratingPeriod.vague(waves, waves.get(0).periodsIn(scan), evidence.share());
        found = sharp ? byPhase(found, beside) : byTiles(found, sharpness >= AS_STRONG ? line : middle);
        // A crossing wave, or the user, tells the direction.
        boolean isProfile = found.others().stream().allMatch(other -> other.sineTo(line) < GratingPeriod.CONE)
                && asked.azimuth().isEmpty()
                && !PhaseSlope.hasDirection(scan, found.wave());
        found = isProfile ? found.ofProfile() : found;
        decision = Decision.of(evidence.within(
                0.5 * (1 / found.low() - 1 / found.high()) / found.wave().length()));
        return told(decision, evidence, ridges > 1 ? found.longer(ridges) : found);
    }

    private GratingPeriod told(Decision decision, Evidence evidence, GratingPeriod found) {
        return found.withCertainty(decision.certainty, Reasons.of(decision, evidence, found.wave(), asked));
    }

    private GratingPeriod byPhase(GratingPeriod vague, List<SpatialFrequency> beside) {
        SpatialFrequency wave = vague.wave();
        HeightMap alone = without(Stream.concat(vague.others().stream(), beside.stream())
                .distinct()
                .toList());
        double half = PhaseSlope.of(alone, wave, false).halfWidth();
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
        double least = SEEN_IN_PART * search.measures().top(wave);
        List<Double> parts = new ArrayList<>();
        for (Crop part : halves) {
            near(part.apply(alone), wave, least).ifPresent(found -> parts.add(found.length()));
        }
        parts.add(Math.hypot(wave.x(), wave.y() + PhaseSlope.byRows(alone, wave)));
        for (double part : parts) {
            interval = Math.abs(part - wave.length()) > INCONSISTENT * half
                    ? interval.reaching(wave.length() + BEYOND * (part - wave.length()))
                    : interval;
        }
        double across = PhaseSlope.of(alone, wave, true).halfWidth();
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
            SpatialFrequency part = LineMeasures.of(tile.apply(scan), asked).centroid(wave);
            lengths[i] = part.length();
            turns[i] = Math.IEEEremainder(part.azimuth() - wave.azimuth(), Math.PI);
        }
        double student = GratingPeriod.student(lengths.length - 1);
        double half = student * Math.sqrt(StatUtils.variance(lengths) / side);
        double turn = student * Math.sqrt(StatUtils.variance(turns) / side);
        Interval interval = new Interval(wave.length() - half, wave.length() + half).reaching(line.length());
        return vague.within(interval.low(), interval.high(), turn);
    }

    private int tiles(SpatialFrequency wave) {
        return (int) Math.min(MOST_TILES, wave.periodsIn(scan) / FEWEST_PERIODS);
    }

    /** Frequencies, cycles per meter. */
    private record Interval(double low, double high) {
        Interval reaching(double part) {
            return new Interval(Math.min(low, part), Math.max(high, part));
        }
    }

    /** Finds each wave again with the others subtracted: two that are alike cancel each other along lines of the scan. */
    private List<SpatialFrequency> refined(List<SpatialFrequency> lattice) {
        List<SpatialFrequency> waves = new ArrayList<>(lattice);
        for (int i = 0; i < 2 * waves.size(); i++) {
            SpatialFrequency wave = waves.remove(0);
            waves.add(near(without(waves), wave, 0).orElse(wave));
        }
        return waves;
    }

    private HeightMap without(List<SpatialFrequency> waves) {
        HeightMap left = scan;
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

    /** @param least power of the wave's peak, square meters */
    private static Optional<SpatialFrequency> near(HeightMap part, SpatialFrequency wave, double least) {
        WaveSearch search = new WaveSearch(part, frequency -> frequency.distance(wave) < NEAR * wave.length());
        return search.strongest(frequency -> true)
                .filter(found -> search.measures().top(found) >= least)
                .map(found -> corrected(Leveling.PLANE.apply(part), found));
    }
}
