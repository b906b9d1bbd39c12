package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.patch.HeightMap;

/** Scans whose parts do not go on in each other: what is told of the whole must not be tight and wrong. */
class PiecesOfScansTest {
    private static final int DRAWS = 8;

    /** Of five slips 56 of 60 intervals missed, as rows before and after them were taken for one wave; of two halves one in four. */
    @ParameterizedTest
    @EnumSource(
            value = FaultyScan.Kind.class,
            names = {"SLIPPED", "SLIPPED_OFTEN", "LOST_OFTEN", "TWO_HALVES", "SIDE_BY_SIDE", "DISLOCATED"})
    void theIntervalHoldsWhatThePartsSay(FaultyScan.Kind kind) {
        for (long seed = 9000; seed < 9000 + DRAWS; seed++) {
            FaultyScan scan = FaultyScan.draw(kind, seed);
            scan.estimate()
                    .ifPresent(told -> assertThat(scan.holdsTruth(told))
                            .as(scan.words() + ": " + told)
                            .isTrue());
        }
    }

    /** Most scans whose scanner slips are answered, and to better than a piece between two slips would be. */
    @ParameterizedTest
    @EnumSource(
            value = FaultyScan.Kind.class,
            names = {"SLIPPED_OFTEN", "LOST_OFTEN"})
    void manySlipsAreMended(FaultyScan.Kind kind) {
        int told = 0;
        for (long seed = 9000; seed < 9000 + DRAWS; seed++) {
            told += FaultyScan.draw(kind, seed).estimate().isPresent() ? 1 : 0;
        }
        assertThat(told).isGreaterThan(DRAWS / 2);
    }

    /** Five slips of a quarter of a period, in a scan of a period that is known: mended, the rows are one grating's. */
    @ParameterizedTest
    @EnumSource(Shape.class)
    void rowsThatAreMovedBackTellThePeriod(Shape shape) {
        double period = 12.8;
        double angle = Math.toRadians(35);
        double[] heights = new double[160 * 120];
        for (int i = 0; i < heights.length; i++) {
            int row = i / 160;
            int slips = row / 20;
            double x = i % 160 + 0.25 * period / Math.cos(angle) * slips;
            double turns = (x * Math.cos(angle) - row * Math.sin(angle)) / period;
            heights[i] = 1e-8 * shape.at(turns - Math.floor(turns));
        }
        HeightMap map = new HeightMap(160, 120, 1e-7, 1e-7, heights);
        PeriodEstimate told = PeriodEstimator.estimate(
                        map, new PeriodFinder(map, false).all().peaks().get(0))
                .orElseThrow();
        assertThat(told.slips()).hasSize(5);
        // Without noise, of 14 periods: a hundredth of one across the scan.
        assertThat(told.period()).isBetween(0.999 * period * 1e-7, 1.001 * period * 1e-7);
        assertThat(told.describeSlips())
                .singleElement()
                .asString()
                .startsWith("the lines jump sideways at 5 rows, the first 20 from the top");
    }

    /** A picture that was stretched along y: between copies a row seems to slip, by the same everywhere; 22 % too long was told. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4})
    void rowsThatAreThereSeveralTimesDoNotSlip(int copies) {
        double period = 14;
        double angle = Math.toRadians(40);
        double[] heights = new double[160 * 160];
        for (int i = 0; i < heights.length; i++) {
            int row = i / 160 / copies * copies;
            heights[i] = 1e-8 * Math.cos(2 * Math.PI * (i % 160 * Math.cos(angle) - row * Math.sin(angle)) / period);
        }
        HeightMap map = new HeightMap(160, 160, 1e-7, 1e-7, heights);
        PeriodEstimate told = PeriodEstimator.estimate(
                        map, new PeriodFinder(map, false).all().peaks().get(0))
                .orElseThrow();
        assertThat(told.slips()).isEmpty();
        // Steps of the phase are the same all over the scan: a thousandth, as of rows that are moved back.
        assertThat(told.period()).isBetween(0.999 * period * 1e-7, 1.001 * period * 1e-7);
    }

    enum Shape {
        SINE {
            @Override
            double at(double part) {
                return Math.cos(2 * Math.PI * part);
            }
        },
        SAW {
            @Override
            double at(double part) {
                return part;
            }
        };

        abstract double at(double part);
    }
}
