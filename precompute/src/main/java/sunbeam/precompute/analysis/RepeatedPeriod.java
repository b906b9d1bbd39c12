package sunbeam.precompute.analysis;

import java.util.Optional;
import java.util.function.Predicate;
import sunbeam.precompute.optics.HeightMap;

/** The exact period of a surface that repeats one patch without end: its strongest frequency, where that is most of it. */
final class RepeatedPeriod {
    // Of the heights' variance, in a wave and its overtones.
    private static final double LEAST_SHARE = 0.4;

    private RepeatedPeriod() {}

    /** Empty where no frequency of these holds enough. */
    static Optional<GratingPeriod> of(HeightMap map, Predicate<SpatialFrequency> which) {
        HeightSpectrum spectrum = HeightSpectrum.of(map, HeightSpectrum.Edges.PERIODIC);
        double[] power = spectrum.power();
        double all = 0;
        int best = -1;
        int zero = power.length / 2;
        for (int i = zero + 1; i < power.length; i++) {
            all += power[i];
            boolean higher = power[i] > (best < 0 ? 0 : power[best]);
            best = higher && which.test(spectrum.frequency(i)) ? i : best;
        }
        if (best < 0) {
            return Optional.empty();
        }
        int jx = spectrum.bandX().first() + best % spectrum.bandX().count();
        int jy = spectrum.bandY().first() + best / spectrum.bandX().count();
        double explained = 0;
        for (int k = 1; spectrum.bandX().holds(k * jx) && spectrum.bandY().holds(k * jy); k++) {
            explained += spectrum.at(k * jx, k * jy);
        }
        SpatialFrequency wave = spectrum.frequency(best);
        return explained < LEAST_SHARE * all
                ? Optional.empty()
                : Optional.of(GratingPeriod.exact(wave, explained / all));
    }
}
