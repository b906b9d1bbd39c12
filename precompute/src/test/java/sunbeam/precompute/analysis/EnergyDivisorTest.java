package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.CieTable.Observer;
import sunbeam.precompute.color.Illuminant;
import sunbeam.precompute.color.WavelengthBand;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;

class EnergyDivisorTest {
    private static final double TRACK = 740e-9;
    private static final double DEPTH = 120e-9;
    private static final int SAMPLES = 64;
    private static final CoherenceWindow SUNLIGHT =
            CoherenceWindow.ofCoherenceLength(CoherenceWindow.SUNLIGHT_COHERENCE_LENGTH);

    private static final Direction ABOVE = Direction.ofDegrees(0, 0);

    private static HeightMap tracks(double period) {
        return Surfaces.sampled(SAMPLES, 2, period / SAMPLES, (column, row) -> column < SAMPLES / 2 ? 0 : DEPTH);
    }

    private static EnergyDivisor divisor(HeightMap map) {
        return new EnergyDivisor(map, RefractiveIndex.KERATIN, SUNLIGHT);
    }

    /** |F_m|^2 of the sampled tracks. */
    private static double power(int m, double phase) {
        double share = m % 2 == 0 ? 0 : 1 / (SAMPLES / 2.0 * Math.sin(Math.PI * m / SAMPLES));
        return m == 0 ? Math.pow(Math.cos(phase / 2), 2) : Math.pow(Math.sin(phase / 2) * share, 2);
    }

    /**
     * Light that leaves over that of a mirror of keratin: the integral of brdf cos theta_r over the hemisphere, by direct sums in disc
     * coordinates, r = sin alpha.
     */
    private static double furnace(Direction wi, double wavelength, CoherenceWindow window) {
        int steps = 4000;
        double sigma = window.sigmaFrequency() * wavelength;
        double sum = 0;
        for (int m = -3; m <= 3; m++) {
            double middle = -wi.x() - m * wavelength / TRACK;
            // The window's Gaussian reaches a few degrees: only lines near the order's height are summed.
            for (int row = -40; row <= 40; row++) {
                double y = -wi.y() + sigma * row / 10;
                double half = Math.sqrt(Math.max(0, 1 - y * y));
                for (int i = 0; i < steps; i++) {
                    double alpha = Math.PI * ((i + 0.5) / steps - 0.5);
                    double x = half * Math.sin(alpha);
                    double far = (Math.pow(x - middle, 2) + Math.pow(y + wi.y(), 2)) / (sigma * sigma);
                    if (far < 40) {
                        DirectionPair pair = new DirectionPair(wi, Direction.ofDisc(x, y));
                        double power = Math.exp(-far) * power(m, 2 * Math.PI / wavelength * pair.w() * DEPTH);
                        double area = half * Math.cos(alpha) * Math.PI / steps * sigma / 10;
                        sum += Gain.KERATIN.brdf(pair, window, wavelength) / Gain.reflectance(wi.z()) * power * area;
                    }
                }
            }
        }
        return sum;
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 720", "0, 0, 737", "0, 0, 745", "0, 0, 550",
        "12, 0, 590", "20, 30, 560", "60, 0, 550", "70, 90, 500"
    })
    void aDiscSendsOutNoMoreThanAMirrorOfItsMaterial(double theta, double phi, double nanometers) {
        Direction wi = Direction.ofDegrees(theta, phi);
        double sent = furnace(wi, nanometers * 1e-9, SUNLIGHT);
        double divisor = divisor(tracks(TRACK)).at(wi, nanometers * 1e-9);
        // 1 %: what is left of the light beside an order's Gaussian where it crosses the horizon.
        assertThat(sent / divisor).isLessThan(1.01);
        assertThat(divisor).isCloseTo(Math.max(1, sent), within(0.01 * sent));
    }

    @ParameterizedTest
    @CsvSource({"30, 0, 400, 1.5", "60, 0, 600, 1", "85, 40, 550, 1"})
    void theDivisorIsTheSumOfEfficienciesOverAMirror(double theta, double phi, double nanometers, double least) {
        double period = 806e-9;
        HeightMap blaze = Surfaces.of(128, 1, period / 128, (x, y) -> 420e-9 * x / period);
        Direction wi = Direction.ofDegrees(theta, phi);
        double wavelength = nanometers * 1e-9;
        OrderLattice lattice = new OrderLattice(new SpatialFrequency(1 / period, 0), Optional.empty());
        OrderLight orders =
                OrderLight.of(new OrderSpectrum(blaze), lattice, RefractiveIndex.KERATIN, wi, wavelength, false);
        // Orders of a window of 10 mm are sharp.
        double divisor = new EnergyDivisor(blaze, RefractiveIndex.KERATIN, CoherenceWindow.ofCoherenceLength(10e-3))
                .at(wi, wavelength);
        assertThat(divisor)
                .isCloseTo(Math.max(1, orders.sum() / orders.mirror()), within(1e-3))
                .isGreaterThanOrEqualTo(least);
    }

    /** A part of three tracks would have orders of its own. */
    @Test
    void aPatchOfFewOrdersIsDividedAsAWhole() {
        HeightMap three = Surfaces.sampled(300, 2, TRACK / 100, (column, row) -> column % 100 < 50 ? 0 : DEPTH);
        HeightMap one = Surfaces.sampled(100, 2, TRACK / 100, (column, row) -> column < 50 ? 0 : DEPTH);
        double expected = divisor(one).at(ABOVE, 720e-9);
        assertThat(expected).isGreaterThan(1.3);
        // The expansions of both err by 1e-6 rms.
        assertThat(divisor(three).at(ABOVE, 720e-9)).isCloseTo(expected, within(1e-5));
    }

    @Test
    void aMirrorAndAShallowSurfaceAreNotDivided() {
        HeightMap mirror = Surfaces.of(16, 16, 100e-9, (x, y) -> 0);
        EnergyDivisor divisor = divisor(mirror);
        // float32 amplitudes; under grazing light a part of the mirror's Gaussian is beyond the horizon.
        assertThat(divisor.at(Direction.ofDegrees(40, 10), 500e-9)).isCloseTo(1, within(1e-4));
        assertThat(divisor.ofColors(Direction.ofDegrees(40, 10), CieTable.load()))
                .isCloseTo(1, within(1e-4));
    }

    @Test
    void colorsKeepTheLuminanceOfTheExactDivisors() {
        EnergyDivisor divisor = divisor(tracks(TRACK));
        Direction wi = Direction.ofDegrees(10, 0);
        CieTable light = CieTable.load();
        CieTable divided = divisor.under(wi, light);
        OrderSpectrum spectrum = new OrderSpectrum(tracks(TRACK));
        double exact = 0;
        double all = 0;
        for (int i = 0; i <= 400; i++) {
            double wavelength = (380 + i) * 1e-9;
            double sent = spectrum.sum(RefractiveIndex.KERATIN, wi, wavelength, SUNLIGHT.sigmaFrequency());
            exact += sent * divided.at(wavelength, 1);
            all += sent * light.at(wavelength, 1);
        }
        // Cells of 4 nm under a sum with a peak of 5 nm.
        assertThat(all / divisor.ofColors(wi, light)).isCloseTo(exact, within(0.01 * exact));
        assertThat(divisor.ofColors(wi, light)).isGreaterThan(1.01);
    }

    @Test
    void aLasersDivisorIsThatOfItsWavelength() {
        EnergyDivisor divisor = divisor(tracks(TRACK));
        CieTable laser = CieTable.of(Observer.CIE1931, Illuminant.of("E"), WavelengthBand.parse("700nm"));
        Direction wi = Direction.ofDegrees(0, 0);
        assertThat(divisor.ofColors(wi, laser)).isCloseTo(divisor.at(wi, 700e-9), within(0.01));
    }

    @Test
    void wideGratingsKeepTheirEnergyWithoutAWordAndNarrowOnesDoNot() {
        EnergyBalance narrow = EnergyBalance.largest(tracks(TRACK), RefractiveIndex.KERATIN, ABOVE)
                .orElseThrow();
        // At a multiple of 20 nm, just before the first orders cross the horizon.
        assertThat(narrow.warning())
                .hasValueSatisfying(words -> assertThat(words).startsWith("at 720 nm the model reflects 1."));
        HeightMap fine = Surfaces.sampled(256, 2, 20e-6 / 256, (column, row) -> column < 128 ? 0 : DEPTH);
        EnergyBalance balance =
                EnergyBalance.largest(fine, RefractiveIndex.KERATIN, ABOVE).orElseThrow();
        assertThat(balance.ratio()).isBetween(0.95, EnergyBalance.LARGEST);
        assertThat(balance.warning()).isEmpty();
        // Samples 300 nm apart repeat the spectrum within the horizon.
        assertThat(EnergyBalance.largest(tracks(20e-6), RefractiveIndex.KERATIN, ABOVE)
                        .orElseThrow()
                        .warning())
                .hasValueSatisfying(words -> assertThat(words).contains("samples 313 nm apart"));
    }

    @Test
    void aDeepReliefIsNotEvaluated() {
        HeightMap deep = Surfaces.sampled(32, 4, 1e-6, (column, row) -> column < 16 ? 0 : 7e-6);
        assertThat(EnergyBalance.largest(deep, RefractiveIndex.KERATIN, ABOVE)).isEmpty();
    }
}
