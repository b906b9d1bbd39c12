package sunbeam.precompute.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.precompute.files.InputException;

/** Choices of settings from JSON, and messages about choices from any place. */
class JsonObjectTest {
    private static final Setting<Double> LENGTH =
            new Setting<>("coherenceLength", ValueKind.length(100e-9, 10e-3), "").inFiles("window");
    private static final Setting<Double> ANGLE = new Setting<>("turn", ValueKind.angle(-Math.PI, Math.PI), "");
    private static final Setting<Integer> TERMS = new Setting<>("terms", ValueKind.integer("N", 1, 500), "");
    private static final Setting<Double> ERROR = new Setting<>("error", ValueKind.number("ERROR", 1e-5, 1), "");
    private static final Setting<String> NAME = new Setting<>("name", ValueKind.text("NAME"), "");
    private static final List<Setting<?>> ALL = List.of(LENGTH, ANGLE, TERMS, ERROR, NAME);

    private static JsonObject plan(String json) throws IOException {
        byte[] bytes = ("{\n\"plan\": {\n" + json + "\n}}").getBytes(StandardCharsets.UTF_8);
        return JsonObject.read("scene.json", new ByteArrayInputStream(bytes)).object("plan", "{}");
    }

    @Test
    void readsPresentKeys() throws IOException {
        Choices choices = plan("\"window\": \"65 um\", \"terms\": 12, \"turn\": \"90 deg\", \"name\": \"7\"")
                .choices(ALL);
        assertThat(choices.find(LENGTH)).contains(65e-6);
        assertThat(choices.find(TERMS)).contains(12);
        assertThat(choices.find(ANGLE)).contains(Math.PI / 2);
        assertThat(choices.find(NAME)).contains("7");
        assertThat(choices.has(ERROR)).isFalse();
        assertThat(choices.origin(TERMS).place()).isEqualTo(ChoiceOrigin.Place.FILE);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    "terms": 0           | plan.terms  | 0 is out of range; give 1 to 500
                    "terms": 1.5         | plan.terms  | is no whole number
                    "terms": "5"         | plan.terms  | must be a number without quotes and unit
                    "terms": "many"      | plan.terms  | "many" is no number
                    "terms": null        | plan.terms  | must be a number
                    "error": 1e-9        | plan.error  | 1e-9 is out of range; give 1e-5 to 1
                    "window": 65         | plan.window | must be a text in quotes with its unit
                    "window": "65"       | plan.window | "65" has no unit; give 100 nm to 10 mm
                    "window": "1 parsec" | plan.window | unknown unit
                    "turn": "30"         | plan.turn   | "30" has no unit
                    "turn": "askew"      | plan.turn   | is no angle
                    "name": 7            | plan.name   | must be a text in quotes
                    """)
    void mistakesNameFileLineAndKey(String json, String key, String words) throws IOException {
        JsonObject plan = plan(json);
        assertThatThrownBy(() -> plan.choices(ALL))
                .isInstanceOfAny(SettingException.class, InputException.class)
                .hasMessageStartingWith("scene.json, line 3: \"" + key + "\": ")
                .hasMessageContaining(words);
    }

    @Test
    void laterComplaintsNameTheLineToo() throws IOException {
        Choices choices = plan("\"terms\": 12,\n\"error\": 0.1").choices(ALL);
        assertThatThrownBy(() -> choices.located(() -> {
                    throw new SettingException(ERROR, "is too small for so few ", TERMS, " and this ", LENGTH);
                }))
                .hasMessage("scene.json, line 4: \"plan.error\": 0.1 is too small for so few terms and this window");
        assertThatThrownBy(() -> choices.located(() -> {
                    throw new SettingException(LENGTH, "is missing");
                }))
                .as("the object's line where the key is not there")
                .hasMessage("scene.json, line 2: \"plan.window\": is missing");
    }

    @Test
    void isWrittenAsItIsRead() throws IOException {
        // More digits than messages print, and a name that looks like a number.
        Choices choices = Choices.none()
                .with(LENGTH, 65.123456789e-6)
                .with(ANGLE, Math.toRadians(30))
                .with(TERMS, 12)
                .with(ERROR, 1e-3)
                .with(NAME, "7");
        StringWriter text = new StringWriter();
        try (JsonGenerator json = new JsonFactory().createGenerator(text)) {
            json.writeStartObject();
            JsonObject.write(json, choices);
            json.writeEndObject();
        }
        assertThat(text.toString()).contains("\"terms\":12,\"error\":0.001");
        JsonObject read = JsonObject.read(
                "copy.json", new ByteArrayInputStream(text.toString().getBytes(StandardCharsets.UTF_8)));
        assertThat(read.choices(ALL)).isEqualTo(choices);
    }

    private static final ChoiceOrigin OPTION =
            ChoiceOrigin.of(ChoiceOrigin.Place.OPTION, setting -> "--" + setting.words("-"));

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

    /** Options in code, comments aside, but for one of Gwyddion's; and environment variables of the program. */
    private static final Pattern OPTION_NAME =
            Pattern.compile("(?m)^(?!\\s*(?:/?\\*|//)).*(?<![\\w-])(?:--(?!convert-to-gwy=)[a-z]|SUNBEAM_[A-Z])");

    @Test
    void noTextNamesAnOption() throws IOException {
        try (Stream<Path> sources = Files.walk(Path.of("src", "main", "java"))) {
            assertThat(sources.filter(Files::isRegularFile))
                    .allSatisfy(source -> assertThat(source).content().doesNotContainPattern(OPTION_NAME));
        }
    }
}
