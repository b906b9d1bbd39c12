package sunbeam.precompute.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.setting.Choices.Origin;

class ChoicesTest {
    private static final Setting<Double> LENGTH =
            new Setting<>("coherenceLength", ValueKind.length(100e-9, 10e-3), "The window's size.");
    private static final Setting<Integer> TERMS = new Setting<>("terms", ValueKind.integer("N", 1, 500), "How many.");

    private static final Origin OPTION = Origin.of(Origin.Place.OPTION, setting -> "--" + setting.words("-"));

    @Test
    void storesTheChosenValuesOnly() {
        Choices choices = Choices.at(OPTION).with(TERMS, 12);
        assertThat(choices.find(TERMS)).contains(12);
        assertThat(choices.find(LENGTH)).isEmpty();
        assertThat(choices.get(LENGTH, 1e-6)).isEqualTo(1e-6);
        assertThat(choices.without(TERMS)).isEqualTo(Choices.none());
    }

    @Test
    void aComplaintWithoutAPlaceGetsThatOfTheChoiceItIsAbout() {
        Choices choices = Choices.none().with(TERMS, 12, OPTION);
        assertThatThrownBy(() -> choices.located(() -> {
                    throw new SettingException(TERMS, "are too many; give fewer, or another ", LENGTH);
                }))
                .hasMessage("--terms 12 are too many; give fewer, or another --coherence-length");
        assertThatThrownBy(() -> choices.located(() -> {
                    throw new SettingException(LENGTH, "is missing");
                }))
                .hasMessage("coherence length is missing");
    }

    @Test
    void complaintsAboutADefaultShowItsValue() {
        Choices choices = Choices.at(OPTION).with(TERMS, 12);
        assertThatThrownBy(() -> choices.located(() -> {
                    throw SettingException.of(LENGTH, 65e-6, "is too long");
                }))
                .hasMessage("--coherence-length 65 um is too long");
        assertThatThrownBy(() -> choices.located(() -> {
                    throw SettingException.of(TERMS, 13, "are too many");
                }))
                .as("what was chosen is shown as it was chosen")
                .hasMessage("--terms 12 are too many");
    }

    @Test
    void standardValuesApplyWithoutAChoice() {
        Setting<Double> length = LENGTH.withStandard(65e-6);
        assertThat(Choices.none().get(length)).isEqualTo(65e-6);
        assertThat(Choices.none().with(length, 20e-6).get(length)).isEqualTo(20e-6);
        assertThat(Choices.none().orStandard(length).describe()).isEqualTo("coherence length 65 um");
        assertThat(Choices.none().orStandard(TERMS)).isEqualTo(Choices.none());
        assertThatThrownBy(() -> LENGTH.withStandard(1.0)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void choicesHideThoseBelow() {
        Choices scene = Choices.none().with(TERMS, 12).with(LENGTH, 65e-6);
        Choices options = Choices.at(OPTION).with(TERMS, 20);
        Choices both = options.over(scene);
        assertThat(both.find(TERMS)).contains(20);
        assertThat(both.find(LENGTH)).contains(65e-6);
        assertThat(both.origin(TERMS).place()).isEqualTo(Origin.Place.OPTION);
        assertThat(both.origin(LENGTH).place()).isEqualTo(Origin.Place.PROGRAM);
        assertThat(both.describe()).isEqualTo("terms 20, coherence length 65 um");
    }

    @Test
    void equalityIsThatOfValues() {
        assertThat(Choices.none().with(TERMS, 12, OPTION))
                .isEqualTo(Choices.none().with(TERMS, 12))
                .isNotEqualTo(Choices.none().with(TERMS, 13));
    }

    /** Options in code, comments aside, but for one of Gwyddion's and that of numbers whose decimal mark is unclear. */
    private static final Pattern OPTION_NAME =
            Pattern.compile("(?m)^(?!\\s*(?:/?\\*|//)).*(?<![\\w-])--(?!convert-to-gwy=|decimal-mark )[a-z]");

    @Test
    void noTextNamesAnOption() throws IOException {
        try (Stream<Path> sources = Files.walk(Path.of("src", "main", "java"))) {
            assertThat(sources.filter(Files::isRegularFile))
                    .allSatisfy(source -> assertThat(source).content().doesNotContainPattern(OPTION_NAME));
        }
    }
}
