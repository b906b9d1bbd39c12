package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.terminal.UsageException;

/** A name that says JPEG, EXR or table is not given to a PNG. */
final class EndingTest {
    @ParameterizedTest
    @ValueSource(strings = {"map.jpg", "map.JPEG", "folder/map.exr", "map.npy", "map.csv", ".png.gif"})
    void aNameThatPromisesAnotherFormatIsRefused(String name) {
        assertThatThrownBy(() -> Ending.PNG.require("--output", Path.of(name)))
                .isInstanceOf(UsageException.class)
                .hasMessage("--output " + name + " would be a PNG picture in spite of its name; end it with .png");
    }

    @ParameterizedTest
    @ValueSource(strings = {"map.png", "map.PNG", "map", "scan.v1.2", "folder.jpg/map.png", "-", "/dev/null", "/", "."})
    void othersPass(String name) {
        assertThatCode(() -> Ending.PNG.require("--output", Path.of(name))).doesNotThrowAnyException();
    }

    @Test
    void aNameOfSunbeamsChoicePasses() {
        assertThatCode(() -> Ending.PNG.require("--output", null)).doesNotThrowAnyException();
    }
}
