package sunbeam.precompute.patch;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;

class SlopeCheckTest {
    private static final double PITCH = 50e-9;

    @Test
    void isSilentOnSlopesUpToThirtyDegrees() {
        assertThat(ModelError.of(ramp(29.9)).warning()).isEmpty();
        assertThat(ModelError.of(new HeightMap(1, 1, PITCH, PITCH, new double[1]))
                        .warning())
                .isEmpty();
    }

    @Test
    void namesTheShareOfTheSurface() {
        // Left half flat, right half at 40 degrees: 31 of 63 steps climb.
        double rise = Math.tan(Math.toRadians(40));
        HeightMap half = Surfaces.of(64, 8, PITCH, (x, y) -> rise * Math.max(0, x - 32 * PITCH));

        assertThat(ModelError.of(half).warning().orElseThrow())
                .contains("49.2 % of the surface", "steeper than 30 degrees");
    }

    @Test
    void takesTheSteepestDirectionAcrossBothAxes() {
        // 25 degrees along each axis are 33 along the diagonal.
        double rise = Math.tan(Math.toRadians(25));
        HeightMap tilted = Surfaces.of(8, 8, PITCH, (x, y) -> rise * (x + y));

        assertThat(ModelError.of(tilted).warning().orElseThrow()).contains("100.0 %");
    }

    @Test
    void looksAlongTheOnlyAxisOfAProfile() {
        double rise = Math.tan(Math.toRadians(60));

        assertThat(ModelError.of(Surfaces.of(8, 1, PITCH, (x, y) -> rise * x))
                        .warning()
                        .orElseThrow())
                .contains("half or more of the light");
        assertThat(ModelError.of(Surfaces.of(1, 8, PITCH, (x, y) -> rise * y))
                        .warning()
                        .orElseThrow())
                .contains("half or more of the light");
    }

    @Test
    void forgivesTheWallOfAGratingAndTheSeam() {
        // One wall in 127 steps, and the jump from the ramp's end to its start that is not looked at.
        assertThat(ModelError.of(Surfaces.of(128, 1, PITCH, (x, y) -> x < 64 * PITCH ? 0 : 1e-6))
                        .warning())
                .isEmpty();
    }

    private static HeightMap ramp(double degrees) {
        double rise = Math.tan(Math.toRadians(degrees));
        return Surfaces.of(16, 16, PITCH, (x, y) -> rise * x);
    }
}
