package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;

class PrincipalDirectionTest {
    @ParameterizedTest
    @ValueSource(doubles = {-80, -30, 0, 25, 90})
    void aGratingSpreadsLightAcrossItsLinesAlsoBesideWavesAndWalls(double azimuth) {
        double angle = Math.toRadians(azimuth);
        // 20 um with a wave of 18 um and 1 um depth along another direction.
        HeightMap map = Surfaces.of(
                200,
                200,
                100e-9,
                (x, y) -> 30e-9 * Math.sin(2 * Math.PI * (x * Math.cos(angle) + y * Math.sin(angle)) / 1.1e-6)
                        + 500e-9 * Math.sin(2 * Math.PI * y / 18e-6));

        double found = PrincipalDirection.azimuthDegrees(map);

        // The same axis modulo half a turn; what leaks from the wave through the taper turns it a little.
        assertThat(Math.abs(Math.sin(Math.toRadians(found - azimuth))))
                .isCloseTo(0, within(Math.sin(Math.toRadians(2))));
    }

    @Test
    void aFlatSurfaceHasNone() {
        assertThat(PrincipalDirection.azimuthDegrees(Surfaces.of(8, 8, 100e-9, (x, y) -> 0)))
                .isZero();
    }
}
