package sunbeam.app.promise;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.app.measure.errors.RelativeError;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.WavelengthNodes;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.reference.ReferenceColor;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;
import sunbeam.precompute.reference.ReferenceEvaluator;

final class TaylorSeriesTest {
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(10e-6);
    private static final Direction NORMAL = new Direction(0, 0, 1);

    /** A sinusoidal grating of a relief, seen near its first order. */
    private static double[] errors(double relief) {
        HeightMap grating = BuiltInPatches.generate("sinusoid");
        double factor = relief / grating.relief();
        HeightMap map = grating.map(height -> factor * height);
        CieTable cie = CieTable.load();
        ReferenceEvaluator evaluator = new ReferenceEvaluator(map, WINDOW, WindowOrigin.CENTRE);
        ReferenceColor color = new ReferenceColor(evaluator, WINDOW, cie, Quadrature.INTEGRATED);
        TaylorSeries series = new TaylorSeries(HeightLevels.of(map), WINDOW, 60);
        double[] worst = new double[2];
        for (int i = 0; i < 5; i++) {
            DirectionPair pair =
                    new DirectionPair(NORMAL, Direction.ofDisc(-0.55 / (map.width() * 1e6) - 0.02 * i, 0.01 * i));
            WavelengthNodes nodes = color.nodes(pair);
            double[][] tables =
                    series.coefficients(pair.u(), pair.v(), nodes, List.of(60)).get(0);
            double[] exact = color.xyz(pair, false);
            worst[0] = Math.max(worst[0], RelativeError.ofColor(TaylorSeries.inDouble(tables, pair.w()), exact));
            worst[1] = Math.max(worst[1], RelativeError.ofColor(TaylorSeries.inFloat(tables, pair.w()), exact));
        }
        return worst;
    }

    @Test
    void aShallowReliefComesOutAsTheReferenceHasIt() {
        double[] errors = errors(0.1e-6);
        // Bins beyond six deviations of the window are left out: 1e-8 of an amplitude.
        assertThat(errors[0]).isLessThan(1e-5);
        // Terms of up to e^3.3 cancel: some digits of float32's seven are lost.
        assertThat(errors[1]).isLessThan(1e-2);
    }

    @Test
    void aDeepReliefLeavesFloat32NoDigits() {
        double[] errors = errors(0.8e-6);
        // k |w| relief is up to 26: terms of e^26 = 2e11, of which float32 keeps 1e4.
        assertThat(errors[1]).isGreaterThan(1);
        assertThat(errors[0]).isLessThan(1e-2);
    }
}
