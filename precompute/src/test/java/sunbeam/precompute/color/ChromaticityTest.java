package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ChromaticityTest {
    private static final CieTable CIE = CieTable.load();
    private static final Chromaticity WHITE = Chromaticity.of(CIE.white());

    @Test
    void whiteHasNoHue() {
        assertThat(WHITE.hue(CIE).nanometers()).isNaN();
        assertThat(Chromaticity.of(new double[3]).hue(CIE).nanometers())
                .as("black")
                .isNaN();
    }

    @ParameterizedTest
    @ValueSource(doubles = {420, 480, 500.5, 560, 600, 640})
    void lightOfOneWavelengthMixedWithWhiteKeepsItsDominantWavelength(double nanometers) {
        Chromaticity pure = Chromaticity.ofWavelength(CIE, nanometers * 1e-9);
        for (double share : new double[] {0.1, 0.5, 0.999}) {
            Chromaticity mixed = new Chromaticity(
                    WHITE.x() + share * (pure.x() - WHITE.x()), WHITE.y() + share * (pure.y() - WHITE.y()));
            // The locus is linear between table values.
            assertThat(mixed.hue(CIE).nanometers()).isCloseTo(nanometers, within(0.3));
            assertThat(mixed.hue(CIE).purity()).isCloseTo(share, within(1e-3));
        }
    }

    @Test
    void purplesHaveTheComplement() {
        Chromaticity purple = new Chromaticity(0.35, 0.2);

        Chromaticity.Hue hue = purple.hue(CIE);

        assertThat(hue.nanometers()).as("green, negative").isBetween(-570.0, -495.0);
        assertThat(hue.purity()).isBetween(0.3, 1.0);
    }

    /** CIE 15: sRGB's primaries have these dominant wavelengths against D65. */
    @Test
    void theScreensPrimariesHaveTheirKnownDominantWavelengths() {
        assertThat(Chromaticity.of(Srgb.xyz(1, 0, 0)).hue(CIE).nanometers()).isCloseTo(611.4, within(0.5));
        assertThat(Chromaticity.of(Srgb.xyz(0, 1, 0)).hue(CIE).nanometers()).isCloseTo(549.1, within(0.5));
        assertThat(Chromaticity.of(Srgb.xyz(0, 0, 1)).hue(CIE).nanometers()).isCloseTo(464.2, within(0.5));
    }
}
