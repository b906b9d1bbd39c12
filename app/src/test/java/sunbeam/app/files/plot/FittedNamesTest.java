package sunbeam.app.files.plot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Font;
import java.util.List;
import org.junit.jupiter.api.Test;

class FittedNamesTest {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
    private static final double WIDEST = 200;
    private static final String LONG = "Cicindela campestris, elytron 03 (museum no. 1907-221), left, 20 um, retrace";

    @Test
    void longNamesLoseTheirMiddleAndShortOnesNothing() {
        String shown = FittedNames.of(LONG, FONT, WIDEST);

        assertThat(shown).startsWith("Cicindela camp").endsWith("retrace").contains("\u2026");
        // A letter more would not fit, and none of this font is wider than 14 pixels.
        assertThat(FittedNames.width(shown, FONT)).isBetween(WIDEST - 14, WIDEST);
        assertThat(FittedNames.of("kaefer #2", FONT, WIDEST)).isEqualTo("kaefer #2");
    }

    @Test
    void namesThatDifferInTheirMiddlesStayApart() {
        List<String> names = List.of(LONG, LONG.replace("03", "04"), LONG.replace("03", "05"), "blaze");

        List<String> shown = FittedNames.of(names, FONT, WIDEST);

        assertThat(shown).doesNotHaveDuplicates();
        assertThat(shown.get(1)).endsWith("#2");
        assertThat(shown).allMatch(name -> FittedNames.width(name, FONT) <= WIDEST);
    }
}
