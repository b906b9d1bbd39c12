package sunbeam.app.commands.color;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;

class PurestColorTest {
    private static final CieTable CIE = CieTable.load();
    private static final MirrorReach SUNLIGHT = new MirrorReach(CoherenceWindow.ofCoherenceLength(65e-6));

    private final List<SeenColor.View> views = new ArrayList<>();
    private final List<double[]> colours = new ArrayList<>();

    private static SeenColor.View view(double thetaR) {
        Direction wi = Direction.ofDegrees(30, 0);
        Direction wr = Direction.ofDegrees(Math.abs(thetaR), thetaR < 0 ? 180 : 0);
        return new SeenColor.View(true, 30, thetaR, new DirectionPair(wi, wr));
    }

    /** Light of a wavelength, with white light added, of that luminance. */
    private void see(double thetaR, double wavelength, double white, double luminance) {
        double[] xyz = new double[3];
        double[] d65 = {0.95047, 1, 1.08883};
        for (int c = 0; c < 3; c++) {
            xyz[c] = luminance * ((1 - white) * CIE.at(wavelength, c) / CIE.at(wavelength, 1) + white * d65[c]);
        }
        views.add(view(thetaR));
        colours.add(xyz);
    }

    private double purest(MirrorReach reach) {
        return views.get(new PurestColor(reach, CIE).of(views, colours).orElseThrow())
                .thetaRDegrees();
    }

    @Test
    void neitherTheMirrorsGlareNorWhatIsDarkWins() {
        see(-30, 580e-9, 0.9, 1);
        // Brown glare, as pure as can be, four degrees beside the mirror.
        see(-26, 590e-9, 0, 1e-2);
        see(38, 580e-9, 0.2, 1e-4);
        see(37, 580e-9, 0.4, 1e-4);
        see(70, 450e-9, 0, 1e-8);
        assertThat(purest(SUNLIGHT)).isEqualTo(38);
        // The same under light that is a million times as bright.
        colours.replaceAll(xyz -> new double[] {1e6 * xyz[0], 1e6 * xyz[1], 1e6 * xyz[2]});
        assertThat(purest(SUNLIGHT)).isEqualTo(38);
    }

    @Test
    void thereIsNoneWhereTheMirrorIsAllThereIs() {
        see(-30, 580e-9, 0.9, 1);
        // Rounding errors of the mirror's light.
        see(40, 580e-9, 0, 1e-12);
        assertThat(new PurestColor(SUNLIGHT, CIE).of(views, colours)).isEmpty();
        see(41, 580e-9, 0, 1e-5);
        assertThat(new PurestColor(SUNLIGHT, CIE).of(views, colours)).hasValue(2);
        MirrorReach tiny = new MirrorReach(CoherenceWindow.ofCoherenceLength(0.5e-6));
        assertThat(new PurestColor(tiny, CIE).of(views, colours)).isEmpty();
    }

    @Test
    void anOrdersWidthIsThatOfTheWindowsSpectrum() {
        DirectionPair pair = view(10).pair();
        double uv = Math.hypot(pair.u(), pair.v());
        double middle = 550e-9;
        double half = SUNLIGHT.orderWidth(middle, pair) / 2;
        double sigma = SUNLIGHT.window().sigmaFrequency();
        // exp(-(f - f0)^2 / sigma_f^2), f = |(u, v)| / lambda, falls to one half; to the first order in the width.
        double difference = uv / (middle - half) - uv / middle;
        assertThat(Math.exp(-Math.pow(difference / sigma, 2))).isCloseTo(0.5, within(0.01));
    }

    @Test
    void aSpectrumsWidthReachesOverAllOfItsPeaks() {
        double[] wavelengths = new double[401];
        double[] gaussian = new double[401];
        double[] two = new double[401];
        for (int i = 0; i <= 400; i++) {
            wavelengths[i] = (380 + i) * 1e-9;
            gaussian[i] = Math.exp(-Math.pow((i - 170) / 20.0, 2) / 2);
            two[i] = gaussian[i] + 0.8 * Math.exp(-Math.pow((i - 300) / 5.0, 2) / 2);
        }
        SpectralWidth one = SpectralWidth.of(wavelengths, gaussian);
        // 2 sqrt(2 ln 2) deviations; chords of 1 nm.
        assertThat(one.width()).isCloseTo(47.1e-9, within(0.05e-9));
        assertThat(one.peak()).isCloseTo(550e-9, within(1e-15));
        // The quartiles of a normal distribution.
        assertThat(one.to() - one.from()).isCloseTo(2 * 0.6745 * 20e-9, within(0.05e-9));
        assertThat(one.whole()).isTrue();
        SpectralWidth both = SpectralWidth.of(wavelengths, two);
        assertThat(both.width()).isBetween(150e-9, 165e-9);
        double[] rising = new double[401];
        for (int i = 0; i <= 400; i++) {
            rising[i] = i;
        }
        assertThat(SpectralWidth.of(wavelengths, rising).whole()).isFalse();
        assertThat(SpectralWidth.of(wavelengths, rising).width()).isCloseTo(200e-9, within(1e-12));
        assertThat(SpectralWidth.of(wavelengths, new double[401]).whole())
                .as("black")
                .isFalse();
    }
}
