package sunbeam.precompute.patch.builtin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.HeightMap;

class GratingsTest {
    /** Rounding of sums over a few thousand heights, in square meters against mean squares of 1e-15. */
    private static final double ROUNDING = 1e-26;

    @Test
    void blazeRisesTowardsPlusXOverOnePeriod() {
        HeightMap blaze = BuiltInPatches.generate("blaze");
        assertThat(blaze.width()).isCloseTo(2.5e-6, within(1e-18));
        double step = 250e-9 / blaze.columns();
        for (int row = 0; row < blaze.rows(); row++) {
            for (int column = 1; column < blaze.columns(); column++) {
                // Equal steps but for rounding.
                assertThat(blaze.at(column, row) - blaze.at(column - 1, row)).isCloseTo(step, within(1e-20));
            }
        }
        // Mid-interval samples miss half a step at either end.
        assertThat(blaze.relief()).isCloseTo(250e-9 - step, within(1e-20));
    }

    @Test
    void blazeSendsLightToMinusX() {
        HeightMap blaze = BuiltInPatches.generate("blaze");
        double lambda = 500e-9;
        double left = orderPower(blaze, lambda, -1);
        double right = orderPower(blaze, lambda, 1);
        // 250 nm retard 500 nm light by one wave per period: all of it goes into the first order on the left.
        assertThat(left).isGreaterThan(0.99);
        assertThat(right).isLessThan(0.01);
    }

    /** Power near the normal (w = -2) in the direction wr = (order * lambda / period, 0, .), so u = -x. */
    private static double orderPower(HeightMap patch, double lambda, int order) {
        double k = 2 * Math.PI / lambda;
        double u = -order * lambda / patch.width();
        double re = 0;
        double im = 0;
        for (int column = 0; column < patch.columns(); column++) {
            double phase = k * (-2 * patch.at(column, 0) + u * column * patch.pitchX());
            re += Math.cos(phase) / patch.columns();
            im += Math.sin(phase) / patch.columns();
        }
        return re * re + im * im;
    }

    @Test
    void sinusoidHasOneFrequencyOnly() {
        HeightMap sinusoid = BuiltInPatches.generate("sinusoid");
        Spectrum spectrum = new Spectrum(sinusoid);
        double amplitude = 100e-9;
        assertThat(spectrum.meanSquare((p, q) -> Math.abs(p) == 1 && q == 0))
                .isCloseTo(amplitude * amplitude / 2, within(ROUNDING));
        assertThat(spectrum.meanSquare((p, q) -> Math.abs(p) != 1 || q != 0)).isLessThan(ROUNDING);
    }

    @Test
    void lamellarHasTwoHeightsAndNoEvenOrders() {
        HeightMap lamellar = BuiltInPatches.generate("lamellar");
        assertThat(lamellar.heights()).containsOnly(0, 137.5e-9);
        long ridge = IntStream.range(0, lamellar.columns())
                .filter(column -> lamellar.at(column, 0) > 0)
                .count();
        assertThat(ridge).isEqualTo(lamellar.columns() / 2);
        assertThat(new Spectrum(lamellar).meanSquare((p, q) -> p % 2 == 0)).isLessThan(ROUNDING);
    }
}
