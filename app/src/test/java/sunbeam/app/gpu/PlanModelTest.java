package sunbeam.app.gpu;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import sunbeam.app.gpu.directions.DirectionsRenderer.Query;
import sunbeam.precompute.cause.ErrorSource;
import sunbeam.precompute.cause.PlanModel;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Accuracy;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.BinSampling;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.GridSampling;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.OrderSampling;
import sunbeam.precompute.plan.Plan;
import sunbeam.precompute.plan.RaySampling;
import sunbeam.precompute.plan.Sampling;
import sunbeam.precompute.plan.TableChoices;
import sunbeam.precompute.table.FourierTable;
import sunbeam.precompute.table.PatchIdentity;
import sunbeam.precompute.table.TableBuilder;

/** The double-precision model of a plan is what the shaders compute, save for float32: else it would blame the wrong source. */
@NeedsDisplay
class PlanModelTest extends InAContext {
    // A coarse tolerance, so that what the approximations leave out is far above float32.
    private static final double TOLERANCE = 1e-1;
    // Rounding of sums and of the tables that are interpolated, for powers above 1e-6 of the mirror's; a source that is
    // blamed for a tolerance missed is above 1e-3.
    private static final double FLOAT32 = 2e-4;
    private static final double BRIGHT = 1e-6;

    private static final HeightMap WAVES = Surface.waves(24, 20, 120e-9, 250e-9);
    private static final HeightMap ROUGH = Surface.noise(48, 40, 100e-9, 300e-9, 4);

    private static FullMethod method(double coherenceLength, Average average) {
        return new FullMethod(
                TableChoices.of(new Accuracy.ByTolerance(TOLERANCE)),
                Optional.empty(),
                new GaussianArea(CoherenceWindow.ofCoherenceLength(coherenceLength), WindowOrigin.CORNER, average));
    }

    /** A surface, a method, and how the plan samples the spectrum. */
    record Setup(HeightMap map, FullMethod method, Class<? extends Sampling> sampling) {}

    static Stream<Named<Setup>> setups() {
        FullMethod small = method(20e-6, Average.COHERENT);
        return Stream.of(
                Named.of("orders", new Setup(WAVES, small, OrderSampling.class)),
                Named.of("rays", new Setup(WAVES, method(5e-6, Average.COHERENT), RaySampling.class)),
                Named.of("rays, ensemble", new Setup(WAVES, method(5e-6, Average.ENSEMBLE), RaySampling.class)),
                Named.of("grid", new Setup(ROUGH, method(1.2e-6, Average.COHERENT), GridSampling.class)),
                Named.of("grid, ensemble", new Setup(ROUGH, method(1.2e-6, Average.ENSEMBLE), GridSampling.class)),
                Named.of(
                        "bins",
                        new Setup(
                                WAVES,
                                small.with(new Neighbourhood(1, Neighbourhood.Anchor.FLOOR))
                                        .with(TableChoices.of(new Accuracy.ByTolerance(TOLERANCE))
                                                .withWavelengthStep(7e-9)),
                                BinSampling.class)));
    }

    private static PlanModel model(Setup setup, Plan plan) {
        HeightMap map = setup.map();
        PatchIdentity identity =
                new PatchIdentity("test", map.columns(), map.rows(), map.pitchX(), map.pitchY(), "test");
        FourierTable table = new TableBuilder(identity, HeightLevels.of(map), done -> {})
                .build(plan.expansion(), plan.bandX(), plan.bandY());
        return new PlanModel(plan, map, CieTable.load(), () -> table);
    }

    @ParameterizedTest
    @MethodSource("setups")
    void powersAreThoseOfTheShader(Setup setup) {
        List<Query> queries =
                new Directions(5).nearOrders(setup.map(), setup.method().area().window(), 40);
        Comparison comparison = new Comparison(context, setup.map(), setup.method());
        List<float[]> computed = comparison.spectral(queries);
        PlanModel model = model(setup, comparison.plan(queries));
        boolean ensemble = setup.method().area().average() == Average.ENSEMBLE;
        int bright = 0;
        for (int i = 0; i < queries.size(); i++) {
            double expected = model.powers(queries.get(i).pair(), queries.get(i).wavelength())
                    .get(ErrorSource.CROP);
            if (expected > BRIGHT) {
                bright++;
                assertThat(Math.abs(computed.get(i)[ensemble ? 1 : 0] - expected) / expected)
                        .as("%s", queries.get(i))
                        .isLessThan(FLOAT32);
            }
        }
        assertThat(bright).isGreaterThan(5);
    }

    @ParameterizedTest
    @MethodSource("setups")
    void coloursAreThoseOfTheShader(Setup setup) {
        List<DirectionPair> pairs = new Directions(6)
                .nearOrders(setup.map(), setup.method().area().window(), 12).stream()
                        .map(Query::pair)
                        .toList();
        Comparison comparison = new Comparison(context, setup.map(), setup.method());
        List<float[]> computed = comparison.colours(pairs);
        Plan plan =
                comparison.plan(pairs.stream().map(pair -> new Query(pair, 0)).toList());
        assertThat(plan.sampling()).isInstanceOf(setup.sampling());
        PlanModel model = model(setup, plan);
        int bright = 0;
        for (int i = 0; i < pairs.size(); i++) {
            Map<ErrorSource, double[]> stages = model.xyz(pairs.get(i));
            double[] expected = stages.get(ErrorSource.CROP);
            double largest = Math.max(expected[0], Math.max(expected[1], expected[2]));
            if (largest > BRIGHT) {
                bright++;
                for (int c = 0; c < 3; c++) {
                    assertThat(Math.abs(computed.get(i)[c] - expected[c]) / largest)
                            .as("%s channel %d", pairs.get(i), c)
                            .isLessThan(FLOAT32);
                }
            }
        }
        assertThat(bright).isGreaterThan(3);
    }
}
