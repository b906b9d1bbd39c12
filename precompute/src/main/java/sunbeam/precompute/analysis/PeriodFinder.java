package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;

/**
 * Finds what repeats in a surface. A patch is first taken as a piece of a surface: its edges are tapered, and a
 * regularity is a peak above the local background of the averaged spectrum that fits at least four times into the patch, or
 * the sharp line of a grating that holds much of the heights' variance ({@link SharpLines}).
 * Where that shows nothing and the patch is small against a coherence area, it is taken as one period of a surface that
 * repeats, as the model takes it: a regularity is then a frequency that holds much of the heights' variance.
 */
public final class PeriodFinder {
    // In half a coherence length or less, the patch's own repetition is what light sees.
    private static final double LARGEST_REPEATED = CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH / 2;

    private final HeightSpectrum tapered;
    private final HeightSpectrum periodic;
    private final TaperedPeaks taperedPeaks;
    private final double rms;

    /** @param map heights without missing samples */
    public PeriodFinder(HeightMap map) {
        this.rms = HeightStatistics.rms(map.toArray());
        this.tapered = HeightSpectrum.of(map, HeightSpectrum.Edges.TAPERED);
        this.taperedPeaks = new TaperedPeaks(tapered);
        boolean small = Math.max(map.width(), map.height()) <= LARGEST_REPEATED;
        this.periodic = small ? HeightSpectrum.of(map, HeightSpectrum.Edges.PERIODIC) : null;
    }

    /** The surface's regularities in all directions. */
    public Periodicity all() {
        Periodicity others = choose(TaperedPeaks::all, PeriodicPeaks::all);
        return line().map(sharp -> withLine(sharp, others)).orElse(others);
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
