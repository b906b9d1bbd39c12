package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import org.apache.commons.math3.special.BesselJ;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.analysis.OrderLattice.Order;
import sunbeam.precompute.analysis.OrderLight.Efficiency;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.reference.ExactLight;

class OrderLightTest {
    private static final double PERIOD = 2.5e-6;
    private static final int COLUMNS = 2048;
    // The expansion's error of amplitudes, which are at most about 1, twice in their squares, times R of at most 0.1.
    private static final double EXPANSION = 1e-6;

    private static OrderLight light(HeightMap map, Direction wi, double wavelength) {
        Patch patch =
                new Patch("p", map, map, "p", List.of(), List.of(), List.of(), List.of(), Patch.Repetition.PERIODIC);
        OrderLattice lattice = OrderLattice.of(patch, GratingPeriod.of(patch));
        return OrderLight.of(new OrderSpectrum(map), lattice, RefractiveIndex.KERATIN, wi, wavelength, false);
    }

    private static HeightMap grating(DoubleBinaryOperator height) {
        return Surfaces.of(COLUMNS, 1, PERIOD / COLUMNS, height);
    }

    /** Factor of |F|^2 in the efficiency of the order that leaves along wr = -wi + lambda (x, y) / PERIOD; NaN beyond the horizon. */
    private static double factor(Direction wi, double wavelength, int x, int y) {
        return Optional.of(pair(wi, wavelength, x, y))
                .filter(pair -> pair.cosThetaR() > 0)
                .map(pair -> Gain.reflectance(pair.cosThetaD())
                        * Math.pow((1 + pair.wi().dot(pair.wr())) / pair.w(), 2)
                        / (pair.cosThetaI() * pair.cosThetaR()))
                .orElse(Double.NaN);
    }

    private static DirectionPair pair(Direction wi, double wavelength, int x, int y) {
        return new DirectionPair(
                wi, Direction.ofDisc(-wi.x() + wavelength * x / PERIOD, -wi.y() + wavelength * y / PERIOD));
    }

    private static double bessel(int order, double argument) {
        return Math.pow(BesselJ.value(Math.abs(order), Math.abs(argument)), 2);
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 450", "40, 0, 600", "40, 90, 600", "65, 30, 500", "80, 137, 400"})
    void ordersOfASinusoidAreBesselFunctionsAlsoUnderConicalIncidence(double theta, double phi, double nanometers) {
        double amplitude = 150e-9;
        double wavelength = nanometers * 1e-9;
        Direction wi = Direction.ofDegrees(theta, phi);
        OrderLight light = light(grating((x, y) -> amplitude * Math.sin(2 * Math.PI * x / PERIOD)), wi, wavelength);

        assertThat(light.efficiencies()).hasSizeGreaterThan(5);
        light.efficiencies().forEach((order, efficiency) -> {
            double w = pair(wi, wavelength, order.m(), 0).w();
            double expected =
                    factor(wi, wavelength, order.m(), 0) * bessel(order.m(), 2 * Math.PI / wavelength * w * amplitude);
            assertThat(order.n()).isZero();
            assertThat(efficiency.value()).as("%s", order).isCloseTo(expected, within(EXPANSION));
        });
        assertThat(light.between()).isZero();
        assertThat(light.mirror()).isCloseTo(Gain.reflectance(wi.z()), within(1e-15));
    }

    @Test
    void anUnequalLatticeHasTwoNumbersForEachOrder() {
        double high = 120e-9;
        double low = 30e-9;
        HeightMap map = Surfaces.of(
                64,
                64,
                PERIOD / 64,
                (x, y) -> high * Math.sin(2 * Math.PI * x / PERIOD) + low * Math.sin(2 * Math.PI * y / PERIOD));
        Direction wi = Direction.ofDegrees(35, 20);
        double wavelength = 520e-9;

        OrderLight light = light(map, wi, wavelength);

        // The lattice's points in the disc of directions, up to those on its border.
        assertThat(light.lattice().most(wavelength))
                .isCloseTo(light.efficiencies().size(), within(10.0));
        assertThat(light.efficiencies()).containsKeys(new Order(1, 2), new Order(-1, -1));
        light.efficiencies().forEach((order, efficiency) -> {
            double w = pair(wi, wavelength, order.m(), order.n()).w();
            double k = 2 * Math.PI / wavelength * w;
            double expected = factor(wi, wavelength, order.m(), order.n())
                    * bessel(order.m(), k * high)
                    * bessel(order.n(), k * low);
            assertThat(efficiency.value()).as("%s", order).isCloseTo(expected, within(EXPANSION));
        });
    }

    @Test
    void aHexagonalPatchHasTheLatticeOfItsBins() {
        double constant = 2e-6;
        double height = Math.sqrt(3) * constant;
        double depth = 30e-9;
        int columns = 100;
        int rows = 174;
        double[] heights = new double[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            int row = i / columns;
            double x = 2 * Math.PI * (i % columns) / columns;
            double y = 2 * Math.PI * row / rows;
            heights[i] = depth * (Math.cos(2 * y) + Math.cos(x + y) + Math.cos(x - y));
        }
        HeightMap map = new HeightMap(columns, rows, constant / columns, height / rows, heights);
        Direction wi = Direction.ofDegrees(45, 17);
        OrderLight light = light(map, wi, 380e-9);

        double reciprocal = 2 / height;
        assertThat(light.lattice().first().length()).isCloseTo(reciprocal, within(1e-9 * reciprocal));
        assertThat(light.lattice().second().orElseThrow().length()).isCloseTo(reciprocal, within(1e-9 * reciprocal));
        // J_0^3 and, as three waves of one triangle add up to order 0, small terms of higher orders.
        assertThat(light.at(new Order(0, 0)).value()).isCloseTo(0.0198, within(1e-4));
        // Rounding errors beyond the horizon.
        assertThat(light.between()).isLessThan(1e-20);
    }

    /** Samples 300 nm apart repeat the spectrum within the horizon, along y too under light at 65 degrees. */
    @ParameterizedTest
    @CsvSource({"0, 0, 450, 0", "40, 37, 450, 0", "65, 90, 400, 1"})
    void ordersBeyondTheSamplingAreThoseOfTheReference(double theta, double phi, double nanometers, int rows) {
        HeightMap coarse = Surfaces.sampled(8, 8, 300e-9, (column, row) -> 30e-9 * column + (column == 5 ? 60e-9 : 0));
        Patch patch = new Patch(
                "p", coarse, coarse, "p", List.of(), List.of(), List.of(), List.of(), Patch.Repetition.PERIODIC);
        Direction wi = Direction.ofDegrees(theta, phi);
        double wavelength = nanometers * 1e-9;
        OrderLattice lattice =
                OrderLattice.of(patch, GratingPeriod.of(patch)).ofSamples(patch, List.of(wi), wavelength);
        OrderSpectrum spectrum = new OrderSpectrum(coarse);
        OrderLight light = OrderLight.of(spectrum, lattice, RefractiveIndex.KERATIN, wi, wavelength, false);
        // Orders 417 per mm apart are sharp under the standard window, whose deviation is 10 per mm.
        ExactLight exact = GaussianArea.STANDARD.over(coarse, CieTable.load());
        double area = 4 * Math.PI * Math.pow(exact.window().sigmaMeters() / wavelength, 2);

        light.efficiencies().forEach((order, efficiency) -> {
            DirectionPair pair = new DirectionPair(wi, light.direction(order).orElseThrow());
            double power = exact.powers(pair, wavelength).ensemble();
            double expected = Gain.KERATIN.brdf(pair, exact.window(), wavelength) / area * power;
            assertThat(efficiency.value()).as("%s", order).isCloseTo(expected, within(EXPANSION));
        });
        assertThat(light.efficiencies().keySet()).extracting(Order::m).contains(5);
        assertThat(light.efficiencies().keySet()).extracting(Order::n).contains(rows);
        assertThat(light.between()).isZero();
        double sum = light.efficiencies().values().stream()
                .mapToDouble(Efficiency::value)
                .sum();
        assertThat(light.sum()).isCloseTo(sum, within(1e-12));
        // The divisor that conserves energy counts the same orders.
        assertThat(spectrum.sum(RefractiveIndex.KERATIN, wi, wavelength, 0) * light.mirror())
                .isCloseTo(sum, within(1e-9));
    }

    @Test
    void aScansIntervalHoldsTheSurfacesEfficiency() {
        // The depth of the lines changes over 4 um; each piece estimates the mean of J_1^2 over the whole surface.
        int samples = 1024;
        double pitch = 100e-9;
        double period = 1.6e-6;
        SplittableRandom random = new SplittableRandom(5);
        double[] depth = smooth(random, samples, 40);
        HeightMap surface = Surfaces.sampled(
                samples,
                samples,
                pitch,
                (column, row) -> (60e-9 + 30e-9 * depth[row * samples + column])
                        * Math.sin(2 * Math.PI * column * pitch / period));
        OrderLattice lattice = new OrderLattice(new SpatialFrequency(1 / period, 0), Optional.empty());
        Direction wi = Direction.ofDegrees(20, 0);
        Order order = new Order(1, 0);
        double truth = efficiency(surface, lattice, wi, order).value();
        int held = 0;
        for (int i = 0; i < 16; i++) {
            HeightMap piece = surface.part(256 * (i % 4), 256 * (i / 4), 256, 256);
            Efficiency efficiency = efficiency(piece, lattice, wi, order);
            held += efficiency.low() <= truth && truth <= efficiency.high() ? 1 : 0;
            assertThat(efficiency.high() / efficiency.low()).isLessThan(2);
        }
        // 95 % of 16 are 15.2; neighboring parts share a correlation length, and 12 or fewer have a probability of 1 %.
        assertThat(held).isGreaterThanOrEqualTo(13);
    }

    @Test
    void anOrderOnTheHorizonIsBeyondIt() {
        HeightMap blaze = grating((x, y) -> 400e-9 * x / PERIOD);
        OrderSpectrum spectrum = new OrderSpectrum(blaze);
        // At these wavelengths orders have a sine of 1, with a rounding error.
        for (double sine = 0; sine < 0.9; sine += 0.01) {
            Direction wi = Direction.ofDisc(sine, 0);
            for (int order = -12; order < 0; order++) {
                double wavelength = (1 - sine) * PERIOD / -order;
                if (wavelength > 380e-9 && wavelength < 780e-9) {
                    OrderLight light = light(blaze, wi, wavelength);
                    assertThat(light.direction(new Order(order, 0))).isEmpty();
                    assertThat(light.sum()).isLessThan(2 * light.mirror());
                    assertThat(spectrum.sum(RefractiveIndex.KERATIN, wi, wavelength, 0))
                            .isLessThan(2);
                }
            }
        }
    }

    @Test
    void aScansBinOnTheHorizonLeavesOverItsWidth() {
        HeightMap scan = Surfaces.of(480, 1, 50e-9, (x, y) -> 60e-9 * Math.sin(2 * Math.PI * x / 1.1e-6));
        OrderSpectrum spectrum = new OrderSpectrum(scan);
        OrderLattice lattice = new OrderLattice(new SpatialFrequency(1 / 1.1e-6, 0), Optional.empty());
        Direction wi = Direction.ofDegrees(0, 0);
        for (int bin = 32; bin < 63; bin++) {
            double[] sums = new double[2];
            for (int i = 0; i < 2; i++) {
                double wavelength = 24e-6 / (bin + 1e-13 + 0.1 * i);
                sums[i] = OrderLight.of(spectrum, lattice, RefractiveIndex.KERATIN, wi, wavelength, true)
                        .sum();
            }
            // A bin near the horizon has at most 1 % of the light, but 1e4 times that at a point.
            assertThat(sums[0]).as("bin %d", bin).isCloseTo(sums[1], within(0.01 * sums[1]));
        }
    }

    private static Efficiency efficiency(HeightMap map, OrderLattice lattice, Direction wi, Order order) {
        return OrderLight.of(new OrderSpectrum(map), lattice, RefractiveIndex.KERATIN, wi, 550e-9, true)
                .efficiencies()
                .get(order);
    }

    /** Returns noise, -1 to 1, bilinear between values at every {@code step} samples. */
    private static double[] smooth(SplittableRandom random, int samples, int step) {
        int knots = samples / step + 2;
        double[] values = random.doubles((long) knots * knots, -1, 1).toArray();
        double[] result = new double[samples * samples];
        for (int i = 0; i < result.length; i++) {
            double x = (double) (i % samples) / step;
            int row = i / samples;
            int column = (int) x;
            int at = row / step * knots + column;
            double fx = x - column;
            double fy = (double) (row % step) / step;
            result[i] = (1 - fy) * ((1 - fx) * values[at] + fx * values[at + 1])
                    + fy * ((1 - fx) * values[at + knots] + fx * values[at + knots + 1]);
        }
        return result;
    }
}
