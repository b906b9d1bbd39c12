package sunbeam.precompute.color;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class ColorNameTest {
    /** Colors of CSS Color Module level 4 that carry the name, or one that people use for it. */
    @ParameterizedTest
    @CsvSource({
        "black, 000000", "dark gray, 404040", "gray, 808080", "white, f5f5f5", "brown, 8b5a2b", "brown, 5a4632",
        "red, ff0000", "red, dc143c", "orange, ffa500", "orange, ff8c00", "yellow, ffff00", "yellow, ffd700",
        "green, 00ff00", "green, 228b22", "turquoise, 40e0d0", "turquoise, 00ffff", "blue, 0000ff", "blue, 1e90ff",
        "violet, 8a2be2", "violet, 9400d3", "purple, ff00ff", "purple, 8b008b"
    })
    void colorsHaveTheirNames(String name, String rgb) {
        assertThat(ColorName.of(CieLab.ofSrgb(Integer.parseInt(rgb, 16))).words())
                .isEqualTo(name);
    }

    /** Blue of 440 to 485 nm and the others, desaturated with white as a screen does it: half white light of the same luminance. */
    @ParameterizedTest
    @EnumSource(
            value = ColorName.class,
            names = {"RED", "ORANGE", "YELLOW", "GREEN", "TURQUOISE", "BLUE", "VIOLET"})
    void aColorOfTheSpectrumShowsItsWavelengths(ColorName name) {
        CieTable cie = CieTable.load();
        double middle = 0;
        int count = 0;
        for (int nm = 400; nm <= 680; nm++) {
            if (name.distance(nm * 1e-9) == 0) {
                middle += nm;
                count++;
            }
        }
        double wavelength = middle / count * 1e-9;
        double y = cie.at(wavelength, 1);
        double[] xyz = Srgb.xyz(1, 1, 1);
        for (int c = 0; c < 3; c++) {
            xyz[c] = 0.3 * (cie.at(wavelength, c) / y + xyz[c]);
        }
        assertThat(ColorName.of(CieLab.ofXyz(xyz[0], xyz[1], xyz[2]))).isEqualTo(name);
    }

    @Test
    void everyColorHasAName() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 100_000; i++) {
            assertThat(ColorName.of(CieLab.ofSrgb(random.nextInt(1 << 24)))).isNotNull();
        }
    }
}
