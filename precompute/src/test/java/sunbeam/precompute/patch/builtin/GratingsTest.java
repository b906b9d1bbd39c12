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
