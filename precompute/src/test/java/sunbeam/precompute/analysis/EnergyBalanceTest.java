package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.RefractiveIndex;

class EnergyBalanceTest {
    private static final Direction ABOVE = Direction.ofDegrees(0, 0);

    private static EnergyBalance at(HeightMap map, Direction wi, double wavelength) {
        return new EnergyBalance(new OrderSpectrum(map).sum(RefractiveIndex.KERATIN, wi, wavelength, 0), wavelength);
    }

    /** Two levels of equal width, 120 nm apart: tracks of a DVD. */
    private static HeightMap tracks(double period) {
        return Surfaces.sampled(32, 4, period / 32, (column, row) -> column < 16 ? 0 : 120e-9);
    }

    @Test
    void mirrorsConserveEnergy() {
        HeightMap mirror = Surfaces.of(40, 30, 50e-9, (x, y) -> 3e-6);
        assertThat(at(mirror, Direction.ofDegrees(50, 20), 550e-9).ratio())
                .isCloseTo(1, within(1e-6)); // amplitudes are float32
    }

    @Test
    void flatOrdersOfALamellarGratingTakeTheirClosedForm() {
        double period = 740e-9;
        double wavelength = 720e-9;
        // Orders 0 and +-1 from above: |F_0|^2 = cos^2(k w h / 2), |F_1|^2 = sin^2(k w h / 2) (2 / pi)^2 up to the
        // samples' sinc; order m is 1 / cos theta_m as bright by the BRDF's factor.
        double cosine = Math.sqrt(1 - Math.pow(wavelength / period, 2));
        double zero = Math.pow(Math.cos(2 * Math.PI / wavelength * 2 * 60e-9), 2);
        double inOne = Math.pow(Math.sin(2 * Math.PI / wavelength * (1 + cosine) * 60e-9), 2)
                * Math.pow(1.0 / 16 / Math.sin(Math.PI / 32), 2);

        EnergyBalance balance = at(tracks(period), ABOVE, wavelength);

        double reflectance = Gain.reflectance(Math.sqrt(0.5 * (1 + cosine))) / Gain.R0;
        assertThat(balance.ratio())
                .isCloseTo(zero + 2 * reflectance * inOne / cosine, within(1e-6)); // the error of the expansion
        assertThat(balance.warning())
                .hasValueSatisfying(words -> assertThat(words).contains("720 nm"));
    }

    @Test
    void wideGratingsKeepTheirEnergyWithoutAWord() {
        EnergyBalance balance = EnergyBalance.largest(tracks(20e-6), RefractiveIndex.KERATIN, ABOVE)
                .orElseThrow();
        assertThat(balance.ratio()).isBetween(0.95, EnergyBalance.LARGEST);
        assertThat(balance.warning()).isEmpty();
    }

    @Test
    void aDeepReliefIsNotEvaluated() {
        HeightMap deep = Surfaces.sampled(32, 4, 1e-6, (column, row) -> column < 16 ? 0 : 7e-6);
        assertThat(EnergyBalance.largest(deep, RefractiveIndex.KERATIN, ABOVE)).isEmpty();
    }
}
