package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.LongStream;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;

/**
 * Finds what repeats in a surface. A patch is first taken as a piece of a surface: its edges are tapered, and a
 * regularity is a peak above the local background of the averaged spectrum that fits at least four times into the patch, or
 * the sharp line of a grating that holds much of the heights' variance ({@link SharpLines}).
 * Where that shows nothing and the patch is small against a coherence area, it may be taken as one period of a surface that
 * repeats, as the model takes it: a regularity is then a frequency that holds much of the heights' variance. A piece of a
 * surface is not: its waviness would be a period as long as the scan.
 */
public final class PeriodFinder {
    // In half a coherence length or less, the patch's own repetition is what light sees.
    private static final double LARGEST_REPEATED = CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH / 2;

    // Overtones beyond the fifth are weaker than what would hide the fundamental.
    private static final int LARGEST_DIVISOR = 5;
    // By its heights, than what stands out of the averaged spectrum.
    private static final double STRONGER = 2;
    // Fewer periods might be waviness, whose single bins stand out, too.
    private static final double FEWEST_OF_HIDDEN = 12;
    // By its heights, than the strongest overtone.
    private static final double STRONG_OVERTONE = 0.5;
    // Lines that differ by less are alike.
    private static final double LEAST_FUNDAMENTAL = 0.1;

    private final HeightSpectrum tapered;
    private final HeightSpectrum periodic;
    private final TaperedPeaks taperedPeaks;
    private final double pitchX;
    private final double pitchY;
    private final double rms;

    /** Heights that light sees repeated, without missing samples. */
    public PeriodFinder(HeightMap map) {
        this(map, true);
    }

    /**
     * Prepares.
     *
     * @param map heights without missing samples
     * @param repeated whether light sees the patch repeated; otherwise it is a piece of a surface and nothing else
     */
    public PeriodFinder(HeightMap map, boolean repeated) {
        this.rms = HeightStatistics.rms(map.toArray());
        this.pitchX = map.pitchX();
        this.pitchY = map.pitchY();
        this.tapered = HeightSpectrum.of(map, HeightSpectrum.Edges.TAPERED);
        this.taperedPeaks = new TaperedPeaks(tapered, map.pitchX(), map.pitchY());
        boolean small = repeated && Math.max(map.width(), map.height()) <= LARGEST_REPEATED;
        this.periodic = small ? HeightSpectrum.of(map, HeightSpectrum.Edges.PERIODIC) : null;
    }

    /** The surface's regularities in all directions. */
    public Periodicity all() {
        Periodicity others = choose(TaperedPeaks::all, PeriodicPeaks::all);
        Optional<SpectrumPeak> sharp = line().or(() -> new SharpLines(tapered).strongestOfMany(variance(tapered)))
                .or(() -> hidden(others));
        return withFundamental(
                sharp.map(line -> withLattice(line, withLine(line, others))).orElse(others));
    }

    /** A line beside which what the averaged spectrum shows is weak: a step or bow hides it there, not its overtones. */
    private Optional<SpectrumPeak> hidden(Periodicity others) {
        if (!others.found() || others.edges() != HeightSpectrum.Edges.TAPERED) {
            return Optional.empty();
        }
        double rms = STRONGER * others.peaks().get(0).rms();
        return new SharpLines(tapered).strongest(rms * rms, FEWEST_OF_HIDDEN);
    }

    /**
     * The surface's regularities along one direction.
     *
     * @param azimuth radians counter-clockwise from +x
     * @param tolerance standard deviation of the Gaussian, in cycles per metre, with which light looks at frequencies
     *     beside the line along the azimuth: {@link CoherenceWindow#sigmaFrequency()}
     */
    public Periodicity along(double azimuth, double tolerance) {
        Periodicity others =
                choose(peaks -> peaks.along(azimuth, tolerance), peaks -> peaks.along(azimuth, 3 * tolerance));
        return line().filter(sharp -> Math.abs(across(sharp, azimuth)) <= tolerance)
                .map(sharp -> withLine(projected(sharp, azimuth), others))
                .orElse(others);
    }

    /** The spectrum that an answer rests on. */
    public HeightSpectrum spectrum(Periodicity answer) {
        return answer.edges() == HeightSpectrum.Edges.TAPERED ? tapered : periodic;
    }

    private Optional<SpectrumPeak> line() {
        return new SharpLines(tapered).strongest(variance(tapered));
    }

    /**
     * The strongest wave may be an overtone of another sharp line, which waviness or narrow pairs of lines have hidden: that
     * comes first where it is the stronger, and second where it only says that neighbouring lines differ.
     */
    private Periodicity withFundamental(Periodicity found) {
        if (!found.found() || found.edges() != HeightSpectrum.Edges.TAPERED) {
            return found;
        }
        SpectrumPeak first = found.peaks().get(0);
        for (int divisor = LARGEST_DIVISOR; divisor >= 2; divisor--) {
            Optional<SpectrumPeak> below =
                    new SharpLines(tapered).at(first.frequencyX() / divisor, first.frequencyY() / divisor);
            if (below.filter(peak -> peak.rms() >= LEAST_FUNDAMENTAL * first.rms())
                    .isPresent()) {
                return withFundamental(found, below.get());
            }
        }
        return found;
    }

    /** Whether another overtone of a fundamental, which the first is no fundamental of, is strong, too: not only do neighbours differ. */
    private boolean hasOtherOvertone(SpectrumPeak first, SpectrumPeak below) {
        long divisor = Math.round(first.frequency() / below.frequency());
        return LongStream.rangeClosed(2, LARGEST_DIVISOR)
                .filter(multiple -> multiple % divisor != 0)
                .mapToObj(multiple -> new SharpLines(tapered)
                        .at(multiple * first.frequencyX() / divisor, multiple * first.frequencyY() / divisor))
                .flatMap(Optional::stream)
                .anyMatch(peak -> peak.rms() >= STRONG_OVERTONE * first.rms());
    }

    private Periodicity withFundamental(Periodicity found, SpectrumPeak below) {
        List<SpectrumPeak> peaks = new ArrayList<>(found.peaks());
        // The averaged spectrum may have shown it, too.
        peaks.removeIf(
                peak -> Math.hypot(peak.frequencyX() - below.frequencyX(), peak.frequencyY() - below.frequencyY())
                        < 0.1 * below.frequency());
        peaks.add(
                below.rms() >= found.peaks().get(0).rms()
                                || hasOtherOvertone(found.peaks().get(0), below)
                        ? 0
                        : 1,
                below);
        return new Periodicity(found.edges(), peaks, found.figure(), found.threshold());
    }

    private static double across(SpectrumPeak peak, double azimuth) {
        return peak.frequencyY() * Math.cos(azimuth) - peak.frequencyX() * Math.sin(azimuth);
    }

    /** What light in the plane of an azimuth sees of a line beside it. */
    private static SpectrumPeak projected(SpectrumPeak peak, double azimuth) {
        double along = peak.frequencyX() * Math.cos(azimuth) + peak.frequencyY() * Math.sin(azimuth);
        return new SpectrumPeak(along * Math.cos(azimuth), along * Math.sin(azimuth), peak.figure(), peak.rms());
    }

    /** The line first, then what the averaged spectrum shows beside it and its overtones. */
    private Periodicity withLine(SpectrumPeak line, Periodicity others) {
        List<SpectrumPeak> peaks = new ArrayList<>();
        peaks.add(line);
        if (others.edges() == HeightSpectrum.Edges.TAPERED) {
            others.peaks().stream()
                    .filter(peak -> !taperedPeaks.isOvertone(peak, line) && peak.rms() < line.rms())
                    .forEach(peaks::add);
        }
        return new Periodicity(HeightSpectrum.Edges.TAPERED, peaks, line.figure(), SharpLines.THRESHOLD);
    }

    /** The strongest line, those that run across it, and what else there is. */
    private Periodicity withLattice(SpectrumPeak line, Periodicity found) {
        List<SpectrumPeak> lattice = new SharpLines(tapered).across(line, pitchX, pitchY);
        List<SpectrumPeak> peaks = new ArrayList<>(List.of(line));
        peaks.addAll(lattice);
        found.peaks().stream()
                .skip(1)
                .filter(peak -> lattice.stream().noneMatch(other -> taperedPeaks.isOvertone(peak, other)))
                .forEach(peaks::add);
        return new Periodicity(found.edges(), peaks, found.figure(), found.threshold());
    }

    /** Of all bins but the zeroth. */
    private static double variance(HeightSpectrum spectrum) {
        return Arrays.stream(spectrum.power()).sum() - spectrum.at(0, 0);
    }

    private Periodicity choose(
            Function<TaperedPeaks, Periodicity> asPiece, Function<PeriodicPeaks, Periodicity> asPeriod) {
        Periodicity piece = asPiece.apply(taperedPeaks);
        return piece.found() || periodic == null ? piece : asPeriod.apply(new PeriodicPeaks(periodic, rms * rms));
    }
}
