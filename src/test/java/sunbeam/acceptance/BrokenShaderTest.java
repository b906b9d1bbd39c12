package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A shader that the driver refuses: told in one line with the author's file and line, and nothing is left behind. */
class BrokenShaderTest {
    private static final String SHADER = "include/fresnel.glsl";
    private static final String NAME = "cosThetaD";
    private static final String MISSPELT = "cosThetaX";

    @TempDir
    Path root;

    private Workplace workplace;

    @BeforeEach
    void layOut() throws IOException {
        workplace = Workplace.in(root);
        Files.writeString(workplace.resolve("in.csv"), "theta_i,phi_i,theta_r,phi_r\n0,0,10,180\n");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "brdf-map --patch blaze --size 8 --output map.png --linear map.npy",
                "reflectance --patch blaze --directions in.csv --output out.csv"
            })
    void aMisspeltNameInAnIncludedFile(String commandLine) throws Exception {
        List<String> lines = Files.readAllLines(shader(SHADER));
        int line = lastLineWith(NAME, lines);
        lines.set(line, lines.get(line).replace(NAME, MISSPELT));

        Complaint.assertThatIt(
                run(commandLine, SHADER, lines),
                Complaint.NO_GRAPHICS,
                // Lines are counted from 1.
                "sunbeam: " + SHADER + ":" + (line + 1) + ": ",
                MISSPELT,
                "`" + lines.get(line).strip() + "`",
                "[compiling ");
        assertThat(workplace.files()).containsExactly("in.csv");
    }

    private static Path shader(String name) {
        return Sunbeam.repository().resolve("shaders").resolve(name);
    }

    private static int lastLineWith(String word, List<String> lines) {
        int line = lines.size() - 1;
        while (!lines.get(line).contains(word)) {
            line--;
        }
        return line;
    }

    /** Runs the program with one shader replaced: Java looks into the folder before the program's own jars. */
    private SunbeamResult run(String commandLine, String name, List<String> lines) throws Exception {
        Path folder = root.resolve("shaders");
        assumeFalse(folder.toString().contains(" "), "skipped: the launcher splits Java's options at blanks");
        Path file = folder.resolve("sunbeam/shaders").resolve(name);
        Files.createDirectories(file.getParent());
        Files.write(file, lines);
        return workplace
                .command(commandLine.split(" ", -1))
                .with("SUNBEAM_JAVA_OPTIONS", "-Xbootclasspath/a:" + folder)
                .run();
    }
}
