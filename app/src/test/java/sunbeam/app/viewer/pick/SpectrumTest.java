package sunbeam.app.viewer.pick;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** The color of a picked point's spectrum. */
final class SpectrumTest {
    @Test
    void aMirrorHasTheColorOfDaylight() {
        double[] powers = new double[81];
        Arrays.fill(powers, 1);
        double[] xyz = Spectrum.xyz(powers);
        // D65 by CIE 15: X = 0.9505, Z = 1.0891. Every fifth nanometer of daylight's lines leaves less than 0.2 %.
        assertThat(xyz[0]).isCloseTo(0.9505, within(2e-3));
        assertThat(xyz[1]).isCloseTo(1, within(2e-3));
        assertThat(xyz[2]).isCloseTo(1.0891, within(2e-3));
    }
}
