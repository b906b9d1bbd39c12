package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

final class TileSideTest {
    @Test
    void aTileOfTheThesissShaderKeepsToItsTimeFromTheStart() {
        int side = TileSide.first().side();
        assertThat((long) side * side * 120_000L).isLessThanOrEqualTo(TileSide.BUDGET_NANOSECONDS);
    }

    @Test
    void tilesGrowWhereTheMethodIsFast() {
        TileSide side = TileSide.first();
        for (int tile = 0; tile < 100; tile++) {
            side = side.after(256, 256 * 100);
        }
        assertThat(side.side()).isEqualTo(TileSide.LARGEST);
    }

    @Test
    void oneCostlyTileShrinksTheNext() {
        TileSide side = new TileSide(100).after(128 * 128, 128 * 128 * 10_000L);
        // 40 ms are 4,000 pixels: the square of 63.
        assertThat(side.side()).isEqualTo(44);
    }

    @Test
    void anEmptyTileIsNotTakenForAFastMethod() {
        int before = TileSide.first().side();
        assertThat(TileSide.first().after(256, 10).side()).isEqualTo(before);
    }
}
