package sunbeam.app.commands.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class MotionTest {
    @Test
    void sweepsHaveBothEndsAndWholeTurnsLeaveTheLastOut() {
        AngleSweep half = new AngleSweep(0, Math.PI);
        assertThat(half.at(4, 5)).isEqualTo(Math.PI);
        AngleSweep turn = new AngleSweep(0, 2 * Math.PI);
        assertThat(turn.at(3, 4)).isCloseTo(1.5 * Math.PI, within(1e-12));
        assertThat(half.at(0, 1)).isZero();
    }
}
