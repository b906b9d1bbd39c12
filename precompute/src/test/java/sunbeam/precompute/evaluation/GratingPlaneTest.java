package sunbeam.precompute.evaluation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.optics.DirectionPair;

final class GratingPlaneTest {
    private static final double ROUNDING = 1e-14;

    @ParameterizedTest
    @CsvSource({"75, 0, 0", "75, 0, 100", "30, 180, 20", "40, 25, -60", "0, 0, 45", "60, 90, 10"})
    void allDirectionsAreUnitVectorsWhoseUvLiesAlongTheGrating(double theta, double phi, double azimuth) {
        GratingPlane plane = new GratingPlane(Math.toRadians(theta), Math.toRadians(phi), Math.toRadians(azimuth));
        for (double share : new double[] {-0.99, -0.3, 0, 0.5, 0.9}) {
            double angle = share * plane.largestThetaR();
            DirectionPair pair = plane.pair(angle);
            assertThat(pair.wi().dot(pair.wi())).isCloseTo(1, within(ROUNDING));
            assertThat(pair.wr().dot(pair.wr())).isCloseTo(1, within(ROUNDING));
            assertThat(pair.u()).isCloseTo(plane.u(angle) * Math.cos(plane.azimuth()), within(ROUNDING));
            assertThat(pair.v()).isCloseTo(plane.u(angle) * Math.sin(plane.azimuth()), within(ROUNDING));
            assertThat(plane.thetaR(plane.u(angle))).isCloseTo(angle, within(1e-12));
        }
    }

    @Test
    void beyondTheHorizonThereIsNoAngle() {
        assertThat(new GratingPlane(Math.toRadians(75), 0, 0).thetaR(0.2)).isNaN();
    }
}
