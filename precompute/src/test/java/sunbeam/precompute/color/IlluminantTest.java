package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.color.CieTable.Observer;

/** Lights, chromaticities, and integrals over wavelengths. */
class IlluminantTest {
    /** CIE 15:2018, tables 3, 10 and 12. */
    @ParameterizedTest
    @CsvSource({
        "D65, CIE1931, 0.31272, 0.32903",
        "D50, CIE1931, 0.34567, 0.35851",
        "A, CIE1931, 0.44758, 0.40745",
        "E, CIE1931, 0.33333, 0.33333",
        "F11, CIE1931, 0.38052, 0.37713",
        "LED-B3, CIE1931, 0.3756, 0.3723",
        "D65, CIE1964, 0.31381, 0.33098",
        "A, CIE1964, 0.45117, 0.40594"
    })
    void whiteHasThePublishedChromaticity(String light, Observer observer, double x, double y) {
        Chromaticity white =
                Chromaticity.of(CieTable.of(observer, Illuminant.of(light)).white());

        // The published values are sums at 5 nm up to 830 nm.
        assertThat(white.x()).isCloseTo(x, within(2e-4));
        assertThat(white.y()).isCloseTo(y, within(2e-4));
    }

    @ParameterizedTest
    @CsvSource({"D65, true", "D50, true", "A, true", "E, true", "LED-B3, true", "F11, false"})
    void daylightAndBulbsAreSmoothUnlikeFluorescentLampsAndLasers(String name, boolean smooth) {
        Illuminant light = Illuminant.of(name);
        assertThat(light.isSmooth()).isEqualTo(smooth);
        assertThat(light.through(WavelengthBand.parse("532nm")).isSmooth()).isFalse();
    }

    @Test
    void aLineHasTheColorOfItsWavelengthAndItsPower() {
        CieTable laser = CieTable.of(Observer.CIE1931, Illuminant.of("D65"), WavelengthBand.parse("532nm"));

        double[] xyz = WavelengthNodes.integrated(laser, 5e3).sum(wavelength -> wavelength == 0 ? 0 : 0.3);

        assertThat(xyz[1]).isCloseTo(0.3, within(1e-12));
        // Color matching functions bend by less than 1e-3 within a nanometer.
        Chromaticity locus = Chromaticity.ofWavelength(CieTable.load(), 532e-9);
        assertThat(Chromaticity.of(xyz).x()).isCloseTo(locus.x(), within(1e-4));
        assertThat(Chromaticity.of(xyz).y()).isCloseTo(locus.y(), within(1e-4));
    }

    @Test
    void wavelengthsOfAFilterEndWhereItsLightDoes() {
        CieTable filter = CieTable.of(Observer.CIE1931, Illuminant.of("D65"), WavelengthBand.parse("500nm..600nm"));
        // Half of the nanometer around either end passes.
        assertThat(filter.shortestWavelength()).isCloseTo(499e-9, within(1e-18));
        assertThat(filter.longestWavelength()).isCloseTo(601e-9, within(1e-18));
        assertThat(CieTable.load().shortestWavelength()).isEqualTo(CieTable.MINIMUM_WAVELENGTH);
        assertThat(CieTable.load().longestWavelength()).isCloseTo(CieTable.MAXIMUM_WAVELENGTH, within(1e-18));

        WavelengthNodes all = WavelengthNodes.logarithmic(CieTable.load(), 0.003, 0);
        WavelengthNodes some = WavelengthNodes.logarithmic(filter, 0.003, 0);
        // 0.19 of 0.72 in the logarithm, and five nodes beside either end.
        assertThat(some.count()).isLessThan(all.count() / 2);
        // Both integrate such a smooth function exactly but for rounding.
        assertThat(some.sum(wavelength -> 1e-6 / wavelength))
                .containsExactly(
                        WavelengthNodes.integrated(filter, 5e3).sum(wavelength -> 1e-6 / wavelength), within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"532nm, 532nm", "0.532 um, 532nm", "500nm..600nm, 500nm..600nm", "380nm, 380.5nm", "612.25nm, 612.25nm"
    })
    void bandsAreReadAsTheyAreWritten(String text, String written) {
        assertThat(WavelengthBand.parse(text)).hasToString(written);
        assertThat(WavelengthBand.parse(written)).hasToString(written);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "532", "300nm", "600nm..500nm",
                "500nm..500.2nm", "500nm..900nm", "1nm..2nm..3nm",
                "", "..", "NaNnm"
            })
    void textsThatAreNoBandAreRefusedByName(String text) {
        assertThatThrownBy(() -> WavelengthBand.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContainingAll(text, "532nm");
        assertThatThrownBy(() -> WavelengthBand.parse("600nm..500nm")).hasMessageContaining("is reversed");
    }

    private static final CieTable CIE = CieTable.load();
    private static final Chromaticity WHITE = Chromaticity.of(CIE.white());

    @Test
    void whiteAndBlackHaveNoHue() {
        assertThat(WHITE.hue(CIE).nanometers()).isNaN();
        assertThat(Chromaticity.of(new double[3]).hue(CIE).nanometers()).isNaN();
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
        Chromaticity.Hue hue = new Chromaticity(0.35, 0.2).hue(CIE);
        assertThat(hue.nanometers()).as("green, negative").isBetween(-570.0, -495.0);
        assertThat(hue.purity()).isBetween(0.3, 1.0);
    }

    /** Under a light that has no power at the violet end of the band. */
    @Test
    void purplesUnderLedsHaveAPurity() {
        Chromaticity.Hue hue = new Chromaticity(0.35, 0.2).hue(CieTable.of(Observer.CIE1931, Illuminant.of("LED-B3")));
        assertThat(hue.nanometers()).as("green, negative").isBetween(-570.0, -495.0);
        assertThat(hue.purity()).isBetween(0.3, 1.0);
    }

    /** CIE 15: sRGB's primaries have these dominant wavelengths against D65. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0, 611.4", "0, 1, 0, 549.1", "0, 0, 1, 464.2"})
    void theScreensPrimariesHaveTheirKnownDominantWavelengths(double r, double g, double b, double nanometers) {
        assertThat(Chromaticity.of(Srgb.xyz(r, g, b)).hue(CIE).nanometers()).isCloseTo(nanometers, within(0.5));
    }

    private static final double SIGMA_FREQUENCY = 9794;

    /** 40 points on each of 16 parts of every nanometer of the tables, which are linear between their values. */
    private static double[] gaussLegendre(DoubleUnaryOperator power) {
        GaussIntegrator rule = new GaussIntegratorFactory().legendre(40);
        double[] xyz = new double[3];
        double part = 1e-9 / 16;
        for (int i = 0; i < 400 * 16; i++) {
            for (int g = 0; g < 40; g++) {
                double wavelength = CieTable.MINIMUM_WAVELENGTH + part * (i + 0.5 + 0.5 * rule.getPoint(g));
                double weight = 0.5 * part * rule.getWeight(g) / CIE.integralOfY();
                for (int c = 0; c < 3; c++) {
                    xyz[c] += weight * power.applyAsDouble(wavelength) * CIE.at(wavelength, c);
                }
            }
        }
        return xyz;
    }

    /** Orders from 1 to 400 nm wide: within the band and beyond its ends, and on the flanks of the color matching functions. */
    @ParameterizedTest
    @CsvSource({
        "1.9, 381.3e-9",
        "1.9, 378.5e-9",
        "1.2, 412.3e-9",
        "1.2, 555.55e-9",
        "1, 781e-9",
        "0.8, 779e-9",
        "0.3, 395e-9",
        "0.3, 717e-9",
        "0.1, 450.5e-9",
        "0.02, 503.2e-9"
    })
    void ordersHaveTheirColor(double uv, double middle) {
        double deviation = SIGMA_FREQUENCY / (Math.sqrt(2) * uv);
        DoubleUnaryOperator order =
                wavelength -> Math.exp(-0.5 * Math.pow((1 / wavelength - 1 / middle) / deviation, 2));
        double[] expected = gaussLegendre(order);
        double largest = Math.max(expected[0], Math.max(expected[1], expected[2]));
        // The reference's step.
        double step = 1 / (1 / (0.7 * deviation) + 1 / 12e3);
        // Error of polynomials of degree 11: 5e-7 in the worst of 200 orders; relatively more of the little light that
        // the band leaves of an order beyond its ends.
        assertThat(WavelengthNodes.integrated(CIE, step).sum(order))
                .containsExactly(expected, within(2e-6 * Math.max(1e-4, largest)));
        // The reference's accuracy; sampling in steps of 0.5 nm erred by 1e-3 here.
        assertThat(WavelengthNodes.exact(CIE, order, step)).containsExactly(expected, within(1e-9 * largest));
    }
}
