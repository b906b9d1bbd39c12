package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.util.ArithmeticUtils;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.spectrum.Band;
import sunbeam.precompute.spectrum.BandTransform2d;

/**
 * Power spectrum of a patch's heights, up to the Nyquist frequency or the highest that diffracts light (2 / 380 nm).
 *
 * @param bandX bins along x, and bandY along y (upwards), symmetric about 0
 * @param width meters, padding included: a bin's frequency along x is bin / width
 * @param power square meters, {@code [(jy - bandY.first) * bandX.count + jx - bandX.first]}
 * @param total sum of the power, square meters, also beyond the bands
 */
public record HeightSpectrum(Band bandX, Band bandY, double width, double height, double[] power, double total) {
    /** Meters; half the shortest wavelength, for light and viewer at grazing angles. */
    static final double SHORTEST_PERIOD = CieTable.MINIMUM_WAVELENGTH / 2;
    // Samples; larger padded ones would take gigabytes.
    private static final int MOST_PADDED = 1 << 22;

    public enum Edges {
        /** One period: heights minus their mean; each bin is an exact frequency. */
        PERIODIC,
        /** A piece: heights minus their plane, times a Hann window of mean square 1, padded with zeros to twice the size. */
        TAPERED
    }

    public static HeightSpectrum of(HeightMap map, Edges edges) {
        boolean tapered = edges == Edges.TAPERED;
        int padding = tapered && (long) map.columns() * map.rows() <= MOST_PADDED ? 2 : 1;
        HeightMap level = (tapered ? Leveling.PLANE : Leveling.MEAN).apply(map);
        double[] taperX = taper(map.columns(), tapered);
        double[] taperY = taper(map.rows(), tapered);
        // A profile has a mean across it, and no waves.
        int columns = map.columns() > 1 ? padding * map.columns() : 1;
        int rows = map.rows() > 1 ? padding * map.rows() : 1;
        Band bandX = band(columns, map.pitchX());
        Band bandY = band(rows, map.pitchY());
        IntToDoubleFunction tapering = i -> level.heights()[i] * taperX[i % map.columns()] * taperY[i / map.columns()];
        double[] power = new BandTransform2d(columns, rows, bandX, bandY).powers((samples, row) -> {
            for (int column = 0; row < map.rows() && column < map.columns(); column++) {
                samples[column] = tapering.applyAsDouble(row * map.columns() + column);
            }
        });
        DoubleStream heights = IntStream.range(0, level.heights().length).mapToDouble(tapering);
        double squares = heights.map(height -> height * height).sum();
        return new HeightSpectrum(
                bandX, bandY, columns * map.pitchX(), rows * map.pitchY(), power, squares / columns / rows);
    }

    private static Band band(int samples, double pitch) {
        int reach = Math.min((samples - 1) / 2, (int) Math.ceil(samples * pitch / SHORTEST_PERIOD));
        return Band.of(-reach, reach);
    }

    private static double[] taper(int samples, boolean tapered) {
        return IntStream.range(0, samples)
                .mapToDouble(i -> Math.sin(Math.PI * (i + 0.5) / samples))
                .map(sine -> tapered && samples > 1 ? sine * sine / Math.sqrt(0.375) : 1)
                .toArray();
    }

    /** Returns the power of a bin in square meters; 0 outside the bands. */
    public double at(int jx, int jy) {
        return bandX.holds(jx) && bandY.holds(jy)
                ? power[(jy - bandY.first()) * bandX.count() + jx - bandX.first()]
                : 0;
    }

    int binX(int place) {
        return bandX.first() + place % bandX.count();
    }

    int binY(int place) {
        return bandY.first() + place / bandX.count();
    }

    /** Returns the place of the highest accepted bin, among one of each opposite pair; empty if all are 0. */
    Optional<Integer> highest(IntPredicate accepted) {
        int best = -1;
        for (int place = power.length / 2 + 1; place < power.length; place++) {
            if (power[place] > (best < 0 ? 0 : power[best]) && accepted.test(place)) {
                best = place;
            }
        }
        return best < 0 ? Optional.empty() : Optional.of(best);
    }

    SpatialFrequency frequency(int place) {
        return new SpatialFrequency(binX(place) / width, binY(place) / height);
    }

    /** Finds the exact periods of a repeated patch from its strongest frequencies. */
    record RepeatedPeriod(HeightSpectrum spectrum, Predicate<SpatialFrequency> which, double all) {
        // Share of the variance; noise has less in one frequency.
        private static final double OVERTONE = 0.01;
        private static final int MOST_DIRECTIONS = 3;
        // Shares of the variance in the waves and their overtones, for a period and for any piece; and in a piece's
        // strongest frequencies: noise along one axis, too, has overtones of the patch's length, but weak ones.
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
            return Optional.of(GratingPeriod.vague(waves, Double.POSITIVE_INFINITY, share)
                    .within(length, length, 0)
                    .withCertainty(GratingPeriod.Certainty.SURE, ""));
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
            IntStream strong = IntStream.rangeClosed(1, powers.length).filter(k -> powers[k - 1] > OVERTONE * all);
            int fundamental = strong.reduce(number, ArithmeticUtils::gcd);
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
}
