package sunbeam.precompute.analysis;

import java.util.function.Function;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.patch.HeightMap;

/**
 * Finds what repeats in a surface. A patch is first taken as a piece of a surface: its edges are tapered, and a
 * regularity is a peak above the local background of the averaged spectrum that fits at least four times into the patch.
 * Where that shows nothing and the patch is small against a coherence area, it is taken as one period of a surface that
 * repeats, as the model takes it: a regularity is then a frequency that holds much of the heights' variance.
 */
public final class PeriodFinder {
    // In half a coherence length or less, the patch's own repetition is what light sees.
    private static final double LARGEST_REPEATED = CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH / 2;

    private final HeightSpectrum tapered;
    private final HeightSpectrum periodic;
    private final TaperedPeaks taperedPeaks;

    /** @param map heights without missing samples */
    public PeriodFinder(HeightMap map) {
        this.tapered = HeightSpectrum.of(map, HeightSpectrum.Edges.TAPERED);
        this.taperedPeaks = new TaperedPeaks(tapered);
        boolean small = Math.max(map.width(), map.height()) <= LARGEST_REPEATED;
        this.periodic = small ? HeightSpectrum.of(map, HeightSpectrum.Edges.PERIODIC) : null;
    }

    /** The surface's regularities in all directions. */
    public Periodicity all() {
        return choose(TaperedPeaks::all, PeriodicPeaks::all);
    }

    /**
     * The surface's regularities along one direction.
     *
     * @param azimuth radians counter-clockwise from +x
     * @param tolerance standard deviation of the Gaussian, in cycles per metre, with which light looks at frequencies
     *     beside the line along the azimuth: {@link CoherenceWindow#sigmaFrequency()}
     */
    public Periodicity along(double azimuth, double tolerance) {
        return choose(peaks -> peaks.along(azimuth, tolerance), peaks -> peaks.along(azimuth, 3 * tolerance));
    }

    /** The spectrum that an answer rests on. */
    public HeightSpectrum spectrum(Periodicity answer) {
        return answer.edges() == HeightSpectrum.Edges.TAPERED ? tapered : periodic;
    }

    private Periodicity choose(
            Function<TaperedPeaks, Periodicity> asPiece, Function<PeriodicPeaks, Periodicity> asPeriod) {
        Periodicity piece = asPiece.apply(taperedPeaks);
        return piece.found() || periodic == null ? piece : asPeriod.apply(new PeriodicPeaks(periodic));
    }
}
