package sunbeam.app.viewer.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Point2D;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.optics.Direction;

final class GratingOrdersTest {
    // Rounding of double precision.
    private static final double ROUNDING = 1e-12;

    /** Compares with GratingPlane for light from any direction. */
    @Test
    void ordersLieWhereTheGratingEquationSendsThem() {
        double period = 1.5e-6;
        double azimuth = Math.toRadians(35);
        GratingPlane plane = new GratingPlane(Math.toRadians(20), Math.toRadians(50), azimuth);
        Direction light = plane.pair(0).wi();
        GratingOrders orders =
                new GratingOrders(new SpatialFrequency(Math.cos(azimuth) / period, Math.sin(azimuth) / period), light);
        int seen = 0;
        for (int order = -4; order <= 4; order++) {
            for (double wavelength : GratingOrders.WAVELENGTHS) {
                double theta = plane.thetaR(order * wavelength / period);
                boolean isThere = Math.abs(theta) < plane.largestThetaR();
                assertThat(orders.direction(order, wavelength).isPresent()).isEqualTo(isThere);
                if (isThere) {
                    Point2D found = orders.direction(order, wavelength).orElseThrow();
                    Direction expected = plane.pair(theta).wr();
                    assertThat(found.getX()).isCloseTo(expected.x(), within(ROUNDING));
                    assertThat(found.getY()).isCloseTo(expected.y(), within(ROUNDING));
                    seen++;
                }
            }
        }
        assertThat(seen).as("marks").isGreaterThan(6);
    }
}
