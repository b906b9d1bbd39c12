package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.app.terminal.ExitCode;

/** DISPLAY names a screen without a server. Runs in a process of its own, since Java opens the display only once. */
class UnreachableScreenTest {

    @ParameterizedTest
    @ValueSource(strings = {":4711", "nonsense"})
    @EnabledOnOs(OS.LINUX)
    void oneLineSaysSo(String display) throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.awt.headless=false",
                "-cp",
                System.getProperty("java.class.path"),
                "sunbeam.app.Main",
                "view",
                "elaphe");
        builder.environment().put("DISPLAY", display);
        Process process = builder.redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
        assertThat(said.strip().lines())
                .singleElement()
                .asString()
                .contains("cannot open the screen", "'" + display + "'", "set DISPLAY");
        assertThat(process.exitValue()).isEqualTo(ExitCode.NO_GRAPHICS.code());
    }
}
