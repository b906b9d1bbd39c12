package sunbeam.app.commands.evaluate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.terminal.Range;
import sunbeam.precompute.evaluation.FirstOrder;
import sunbeam.precompute.evaluation.ResponseGrid;
import sunbeam.precompute.optics.CoherenceWindow;

class DirectionBudgetTest {
    private static final CoherenceWindow SUNLIGHT = CoherenceWindow.ofCoherenceLength(65e-6);
    private static final Range WAVELENGTHS = new Range(380, 780, 1);

    private static GratingRequest request(boolean all) {
        return new GratingRequest(
                Math.toRadians(75),
                0,
                OptionalDouble.empty(),
                Optional.empty(),
                WAVELENGTHS,
                all,
                OptionalDouble.empty());
    }

    private static ResponseGrid grid(GratingRequest request, double side, double period) {
        DirectionBudget budget = new DirectionBudget(side, side, SUNLIGHT);
        return request.grid(request.plane(0), FirstOrder.around(period, 1.35), budget);
    }

    /** The thesis's 401 wavelengths and 1500 angles on the scans of its size. */
    @ParameterizedTest
    @CsvSource({"20e-6, 1e-6", "65e-6, 1.2e-6", "100e-6, 1.6e-6"})
    void scansOfUsualSizeTakeAll(double side, double period) {
        ResponseGrid grid = grid(request(false), side, period);
        assertThat(grid.wavelengths()).hasSize(401);
        assertThat(grid.angles()).hasSize(1500);
        assertThat(request(false).leftOut(grid)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"300e-6, 10e-6", "1e-3, 20e-6"})
    void largeScansTakeFewerAndSaySo(double side, double period) {
        ResponseGrid grid = grid(request(false), side, period);
        long directions = (long) grid.wavelengths().length * grid.angles().length;
        assertThat(new DirectionBudget(side, side, SUNLIGHT).holds(directions)).isTrue();
        // A ridge is met at as many wavelengths as --positions and the mean look at.
        assertThat(grid.wavelengths().length).isBetween(21, 201);
        assertThat(request(false).leftOut(grid).orElseThrow())
                .contains("only " + grid.wavelengths().length + " wavelengths", "--wavelengths 380:780:1 takes all");
    }

    @Test
    void whatIsAskedForIsTaken() {
        ResponseGrid grid = grid(request(true), 1e-3, 20e-6);
        assertThat(grid.wavelengths()).hasSize(401);
        assertThat(grid.angles()).hasSize(1500);
    }

    /** An order of 65 um is narrower than the range of a short period's angles over 150: these are not thinned so far. */
    @Test
    void anglesStayFineEnoughForAPeak() {
        ResponseGrid grid = grid(request(false), 3e-3, 0.7e-6);
        double shortest = grid.wavelengths()[0];
        double coarsest = 0;
        for (int i = 1; i < grid.angles().length; i++) {
            double step = grid.plane().u(grid.angles()[i]) - grid.plane().u(grid.angles()[i - 1]);
            coarsest = Math.max(coarsest, Math.abs(step) / shortest);
        }
        // Three samples on the top of a ridge that is 1.7 deviations wide.
        assertThat(coarsest).isLessThan(0.6 * SUNLIGHT.sigmaFrequency());
    }
}
