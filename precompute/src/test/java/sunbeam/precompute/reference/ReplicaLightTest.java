package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.Replicas;
import sunbeam.precompute.reference.ExactLight.Quadrature;

class ReplicaLightTest {
    private static final double WAVELENGTH = 500e-9;
    // Rounding of a thousand terms.
    private static final double ROUNDING = 1e-12;

    private static DirectionPair seeing(double u, double v, double w) {
        return new DirectionPair(new Direction(-u, -v, -w), new Direction(0, 0, 0));
    }

    private static ReplicaLight light(HeightMap map, int alongX, int alongY) {
        return new ReplicaLight(map, new Replicas(alongX, alongY), CieTable.load());
    }

    @Test
    void aFlatSquareIsTheDiffractionOfItsAperture() {
        HeightMap flat = Surfaces.of(10, 8, 100e-9, (x, y) -> 0);
        ReplicaLight light = light(flat, 3, 2);
        double u = 0.13;
        double v = -0.21;
        double alongX = dirichlet(u / WAVELENGTH * 100e-9, 30);
        double alongY = dirichlet(v / WAVELENGTH * 100e-9, 16);
        assertThat(light.power(seeing(u, v, -1.5), WAVELENGTH))
                .isCloseTo(Math.pow(alongX * alongY, 2), within(ROUNDING));
    }

    private static double dirichlet(double turns, int count) {
        return Math.sin(Math.PI * turns * count) / (count * Math.sin(Math.PI * turns));
    }

    @Test
    void replicasAreOnePeriodTimesTheArrayFactor() {
        HeightMap map = Surfaces.random(12, 9, 90e-9, 200e-9, 3);
        DirectionPair pair = seeing(0.37, 0.22, -1.7);
        double one = light(map, 1, 1).power(pair, WAVELENGTH);
        double many = light(map, 5, 4).power(pair, WAVELENGTH);
        double arrayX = dirichlet(0.37 / WAVELENGTH * map.width(), 5);
        double arrayY = dirichlet(0.22 / WAVELENGTH * map.height(), 4);
        assertThat(many).isCloseTo(one * Math.pow(arrayX * arrayY, 2), within(ROUNDING));
    }

    @Test
    void anOrderHasTheSamePowerWhateverTheReplicas() {
        HeightMap map = Surfaces.random(12, 9, 90e-9, 200e-9, 3);
        DirectionPair order = seeing(2 * WAVELENGTH / map.width(), -WAVELENGTH / map.height(), -1.2);
        double one = light(map, 1, 1).power(order, WAVELENGTH);
        assertThat(light(map, 7, 7).power(order, WAVELENGTH)).isCloseTo(one, within(ROUNDING));
        // On a bin the Gaussian window and the sharp edge give the same order; neighbors are 40 deviations away.
        CoherenceWindow wide = new CoherenceWindow(7e-6);
        HeightMap grid = Surfaces.random(12, 12, 90e-9, 200e-9, 3);
        DirectionPair onBin = seeing(2 * WAVELENGTH / grid.width(), WAVELENGTH / grid.height(), -1.2);
        assertThat(new ReferenceEvaluator(grid, wide, WindowOrigin.CENTRE).coherent(onBin, WAVELENGTH))
                .isCloseTo(light(grid, 1, 1).power(onBin, WAVELENGTH), within(1e-9));
    }

    @Test
    void theSpecularDirectionOfAFlatPatchIsWhite() {
        HeightMap flat = Surfaces.of(4, 4, 100e-9, (x, y) -> 0);
        double[] xyz = light(flat, 2, 2).xyz(seeing(0, 0, -2), Quadrature.EXACT);
        // The chromaticity of D65, x = 0.3127, y = 0.3290, cut off at 780 nm.
        assertThat(xyz[1]).isCloseTo(1, within(ROUNDING));
        assertThat(xyz[0] / xyz[1]).isCloseTo(0.3127 / 0.3290, within(1e-3));
    }

    @Test
    void replicasFillTheCoherenceLength() {
        CoherenceWindow sunlight = CoherenceWindow.ofCoherenceLength(65e-6);
        assertThat(Replicas.filling(sunlight, 2.5e-6, 2.5e-6)).isEqualTo(new Replicas(26, 26));
        assertThat(Replicas.filling(sunlight, 65e-6, 25e-9)).isEqualTo(new Replicas(1, 2600));
        assertThat(Replicas.filling(sunlight, 1e-3, 1e-3)).isEqualTo(new Replicas(1, 1));
    }
}
