package sunbeam.app.commands.evaluate;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.CoherenceWindow;

class OrdersApartTest {
    private static final CoherenceWindow WINDOW = CoherenceWindow.ofCoherenceLength(65e-6);

    @Test
    void twoPeriodsAtOnceAreEnough() {
        assertThat(new OrdersApart(32e-6, WINDOW, 1e-3).shortfall()).isEmpty();
        assertThat(new OrdersApart(35e-6, WINDOW, 1e-3).areTold()).isFalse();
    }

    /** The remedy is one that works, and one that the scan allows. */
    @Test
    void whatWouldTellThemApartIsSaid() {
        assertThat(new OrdersApart(50e-6, WINDOW, 1e-3).shortfall().orElseThrow())
                .contains("--coherence-length 96 um or more");
        assertThat(new OrdersApart(50e-6, CoherenceWindow.ofCoherenceLength(96e-6), 1e-3).areTold())
                .isTrue();
        assertThat(new OrdersApart(3.3e-6, CoherenceWindow.ofCoherenceLength(5e-6), 5e-6)
                        .shortfall()
                        .orElseThrow())
                .contains("1.5 times at once", "a scan whose shorter side is 6.4 um or more");
    }
}
