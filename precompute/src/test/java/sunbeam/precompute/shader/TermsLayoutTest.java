package sunbeam.precompute.shader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TermsLayoutTest {

    @Test
    void texelsOfOnePlaceLieSideBySide() {
        TermsLayout layout = TermsLayout.of("rays", 1402, 900, 3, 2);
        assertEquals(3, layout.together());
        assertEquals(1, layout.layersPerGrid());
        assertEquals(ArrayLayout.layered("rays", 3 * 1402, 900, 2, 4), layout.array());
    }

    @ParameterizedTest
    @CsvSource({"5000, 100, 8", "16384, 100, 8", "1400, 9000, 8", "300, 300, 100", "8192, 5, 3"})
    void rowsAndLayersStayWithinLimitsAndHoldAllTexels(int samples, int rows, int texels) {
        TermsLayout layout = TermsLayout.of("rays", samples, rows, texels, 2);
        assertEquals(samples, layout.samples());
        assertEquals(rows, layout.array().height());
        assertTrue(layout.array().width() <= 16384, layout::toString);
        assertTrue(layout.together() == 1
                || layout.array().bytes() / layout.array().layers() <= 1L << 28);
        assertTrue(layout.together() * layout.layersPerGrid() >= texels, layout::toString);
        assertEquals(2 * layout.layersPerGrid(), layout.array().layers());
    }

    @Test
    void aGridThatIsItselfTooLongIsLeftToThePlan() {
        assertEquals(20_000, TermsLayout.of("rays", 20_000, 1, 3, 1).array().width());
    }
}
