package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.util.ArithmeticUtils;
import sunbeam.precompute.optics.HeightMap;

/** Finds the exact periods of a repeated patch from its strongest frequencies. */
record RepeatedPeriod(HeightSpectrum spectrum, Predicate<SpatialFrequency> which, double all) {
    // Share of the variance; noise has less in one frequency.
    private static final double OVERTONE = 0.01;
    private static final int MOST_DIRECTIONS = 3;
    // Shares of the variance in the waves and their overtones, for a period and for any piece, whose strongest
    // frequencies need the third share: noise along one axis, too, has overtones of the patch's length, but weak ones.
    private static final double SHARE_OF_PERIOD = 0.4;
    private static final double SHARE_OF_PIECE = 0.98;
    private static final double PEAKS_OF_PIECE = 0.5;

    /** Wave with its overtones: bins, power of all, and of the strongest frequency. */
    private record Family(SpatialFrequency wave, int jx, int jy, double power, double peak) {
        boolean holds(int x, int y) {
            return (long) x * jy == (long) y * jx;
        }
    }

    /**
     * Returns the strongest accepted period, with up to two others at least half as strong; empty below these shares.
     *
     * @param known whether the map is a period, not any piece
     */
    static Optional<GratingPeriod> of(HeightMap map, Predicate<SpatialFrequency> which, boolean known) {
        HeightSpectrum spectrum = HeightSpectrum.of(map, HeightSpectrum.Edges.PERIODIC);
        // Half of the variance: one bin of each opposite pair.
        double all = 0.5 * DoubleStream.of(spectrum.power()).sum();
        RepeatedPeriod search = new RepeatedPeriod(spectrum, which, all);
        List<Family> found = new ArrayList<>();
        for (int i = 0; i < MOST_DIRECTIONS; i++) {
            search.strongest(found)
                    .filter(next -> found.isEmpty() || next.power >= WaveSearch.AS_STRONG * found.get(0).power)
                    .ifPresent(found::add);
        }
        double share = found.stream().mapToDouble(Family::power).sum() / all;
        double peaks = found.stream().mapToDouble(Family::peak).sum() / all;
        boolean enough = share >= (known ? SHARE_OF_PERIOD : SHARE_OF_PIECE) && (known || peaks >= PEAKS_OF_PIECE);
        if (!enough || !which.test(found.get(0).wave)) {
            return Optional.empty();
        }
        List<SpatialFrequency> waves = found.stream().map(Family::wave).toList();
        double length = waves.get(0).length();
        return Optional.of(
                GratingPeriod.vague(waves, Double.POSITIVE_INFINITY, share).within(length, length, 0));
    }

    private Optional<Family> strongest(List<Family> before) {
        return spectrum.highest(place -> which.test(spectrum.frequency(place))
                        && before.stream()
                                .noneMatch(family -> family.holds(spectrum.binX(place), spectrum.binY(place))))
                .map(place -> family(spectrum.binX(place), spectrum.binY(place), spectrum.frequency(place)));
    }

    /** The bin may be an overtone; all strong multiples belong to the family. */
    private Family family(int jx, int jy, SpatialFrequency strongest) {
        int number = ArithmeticUtils.gcd(jx, jy);
        double[] powers = overtones(jx / number, jy / number).toArray();
        int fundamental = number;
        for (int k = 1; k <= powers.length; k++) {
            fundamental = powers[k - 1] > OVERTONE * all ? ArithmeticUtils.gcd(fundamental, k) : fundamental;
        }
        int x = jx / number * fundamental;
        int y = jy / number * fundamental;
        SpatialFrequency wave = strongest.times((double) fundamental / number);
        return new Family(wave, x, y, overtones(x, y).sum(), spectrum.at(jx, jy));
    }

    private DoubleStream overtones(int jx, int jy) {
        IntPredicate inside =
                k -> spectrum.bandX().holds(k * jx) && spectrum.bandY().holds(k * jy);
        return IntStream.iterate(1, inside, k -> k + 1).mapToDouble(k -> spectrum.at(k * jx, k * jy));
    }
}
