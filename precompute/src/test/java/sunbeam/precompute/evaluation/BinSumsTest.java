package sunbeam.precompute.evaluation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.reference.ReferenceEvaluator;
import sunbeam.precompute.table.PatchIdentity;

final class BinSumsTest {
    // A patch of 6 by 4.5 um under a window of 8 um: several replicas and several bins count.
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(8e-6);
    private static final HeightMap MAP = Surfaces.random(67, 50, 90e-9, 700e-9, 11);
    private static final double[] WAVELENGTHS = {380e-9, 533e-9, 780e-9};
    private static final double[] ANGLES = {-1.5, -0.9, -0.2, 0.4, 1.2};

    private static ResponseGrid grid(double theta, double phi, double azimuth) {
        return new ResponseGrid(
                new GratingPlane(Math.toRadians(theta), Math.toRadians(phi), Math.toRadians(azimuth)),
                WAVELENGTHS,
                ANGLES);
    }

    private static BinSums sums(HeightMap map, ResponseGrid grid) {
        PatchIdentity identity =
                new PatchIdentity("test", map.columns(), map.rows(), map.pitchX(), map.pitchY(), "digest");
        return BinSums.of(identity, HeightLevels.of(map), WINDOW, grid);
    }

    /** The error that {@link BinSums} states, with 5 for the constant: 5e-6 of the amplitude's scale. */
    private static double allowed(double power) {
        return 5e-6 * Math.sqrt(power) + 1e-11;
    }

    @Test
    void coherentAndEnsemblePowerAreTheReferences() {
        for (ResponseGrid grid : List.of(grid(75, 0, 0), grid(30, 0, 100), grid(0, 0, -35), grid(40, 180, 20))) {
            ReferenceEvaluator reference = new ReferenceEvaluator(MAP, WINDOW, WindowOrigin.CENTRE);
            BinSums sums = sums(MAP, grid);
            WindowPlace centre = WindowPlace.of(WindowOrigin.CENTRE, MAP.columns(), MAP.rows());
            double[][] coherent =
                    sums.coherent(List.of(centre), row -> {}).get(0).values();
            double[][] ensemble = sums.ensemble(row -> {}).values();
            for (int row = 0; row < WAVELENGTHS.length; row++) {
                for (int column = 0; column < ANGLES.length; column++) {
                    DirectionPair pair = grid.plane().pair(ANGLES[column]);
                    ReferenceEvaluator.Power exact = reference.powers(pair, WAVELENGTHS[row]);
                    assertThat(coherent[row][column])
                            .as("%s, %s", grid.plane(), pair)
                            .isCloseTo(exact.coherent(), within(allowed(exact.coherent())));
                    assertThat(ensemble[row][column]).isCloseTo(exact.ensemble(), within(allowed(exact.ensemble())));
                }
            }
        }
    }

    @Test
    void movingTheWindowIsMovingThePatchTheOtherWay() {
        int column = 23;
        int row = 31;
        double[] moved = new double[MAP.columns() * MAP.rows()];
        for (int y = 0; y < MAP.rows(); y++) {
            for (int x = 0; x < MAP.columns(); x++) {
                moved[y * MAP.columns() + x] = MAP.at((x + column) % MAP.columns(), (y + row) % MAP.rows());
            }
        }
        HeightMap shifted = new HeightMap(MAP.columns(), MAP.rows(), MAP.pitchX(), MAP.pitchY(), moved);
        ResponseGrid grid = grid(60, 0, 70);
        List<ResponseMatrix> both =
                sums(MAP, grid).coherent(List.of(new WindowPlace(0, 0), new WindowPlace(column, row)), done -> {});
        double[][] corner = sums(shifted, grid)
                .coherent(List.of(new WindowPlace(0, 0)), done -> {})
                .get(0)
                .values();
        for (int i = 0; i < WAVELENGTHS.length; i++) {
            for (int j = 0; j < ANGLES.length; j++) {
                assertThat(both.get(1).values()[i][j]).isCloseTo(corner[i][j], within(allowed(corner[i][j])));
                assertThat(both.get(0).values()[i][j]).isNotCloseTo(corner[i][j], within(allowed(corner[i][j])));
            }
        }
    }

    @Test
    void theMeanOverAllPositionsIsTheEnsemble() {
        HeightMap map = Surfaces.random(9, 8, 300e-9, 200e-9, 2);
        ResponseGrid grid = grid(20, 0, 15);
        List<WindowPlace> all = new java.util.ArrayList<>();
        for (int i = 0; i < 72; i++) {
            all.add(new WindowPlace(i % 9, i / 9));
        }
        BinSums sums = sums(map, grid);
        List<ResponseMatrix> responses = sums.coherent(all, row -> {});
        double[][] ensemble = sums.ensemble(row -> {}).values();
        for (int i = 0; i < WAVELENGTHS.length; i++) {
            for (int j = 0; j < ANGLES.length; j++) {
                int row = i;
                int column = j;
                double mean = responses.stream()
                        .mapToDouble(response -> response.values()[row][column])
                        .average()
                        .orElseThrow();
                assertThat(mean).isCloseTo(ensemble[i][j], within(allowed(ensemble[i][j])));
            }
        }
    }

    @Test
    void aFlatPatchIsAMirror() {
        ResponseGrid grid = new ResponseGrid(
                new GratingPlane(Math.toRadians(50), 0, 0), WAVELENGTHS, new double[] {Math.toRadians(-50), 0});
        double[][] power = sums(Surfaces.of(16, 16, 100e-9, (x, y) -> 1e-3), grid)
                .coherent(List.of(new WindowPlace(3, 4)), row -> {})
                .get(0)
                .values();
        for (double[] row : power) {
            assertThat(row[0]).isCloseTo(1, within(1e-6));
            assertThat(row[1]).isCloseTo(0, within(1e-12));
        }
    }
}
