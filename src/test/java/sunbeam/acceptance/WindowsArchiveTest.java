package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * The archive for Windows, under Wine, from a folder whose name has blanks, umlauts and signs with a meaning in cmd; without a percent
 * sign, which Wine's cmd, unlike that of Windows, takes out of {@code %~dp0} and {@code %*}. Skipped unless SUNBEAM_WINDOWS_JAVA names a Java runtime of
 * Windows and Wine is installed; with the variable, {@code ./sunbeam test} also builds the archive.
 */
class WindowsArchiveTest extends InOneWorkplace {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final Duration PATIENCE = Duration.ofMinutes(3);

    private static final String MAP = "brdf-map blaze --size 32 --quiet --output %s.png --linear %s.npy";
    private static final String SCAN = "Gr\u00f6\u00dfe & x!.gsf";

    private static Path place;
    // These run at once: under Wine most of a command's time is the start of Java, on one processor.
    private static RunningSunbeam map;
    private static RunningSunbeam inspection;
    private static RunningSunbeam refusal;

    @BeforeAll
    static void unpack() throws Exception {
        assumeTrue(!System.getenv().getOrDefault("SUNBEAM_WINDOWS_JAVA", "").isEmpty(), "no Java of Windows");
        assumeTrue(isOnPath("wine"), "no Wine");
        Path archive = Sunbeam.repository().resolve("app/target/sunbeam-0.1.0-windows-x64.zip");
        place = Files.createDirectory(root.resolve("K\u00e4fer & (\u00d6l)! x"));
        try (ZipInputStream zip = new ZipInputStream(Files.newInputStream(archive))) {
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                Path file = place.resolve(entry.getName());
                if (entry.isDirectory()) {
                    Files.createDirectories(file);
                } else {
                    Files.createDirectories(file.getParent());
                    Files.copy(zip, file);
                }
            }
        }
        ended(0, wine("wineboot", "-i"));
        grating(place.resolve(SCAN));
        map = RunningSunbeam.start(onWindows(MAP.replace("%s", "windows").split(" ", -1)));
        inspection = RunningSunbeam.start(onWindows("inspect", SCAN, "--json", "--output", "\u00c4hre.png"));
        refusal = RunningSunbeam.start(onWindows("inspect", "K\u00e4fer.gsf"));
    }

    @AfterAll
    static void endWine() throws Exception {
        if (place != null) {
            for (RunningSunbeam running : List.of(map, inspection, refusal)) {
                running.close();
            }
            wine("wineserver", "-k").start().waitFor();
            // Links to this machine's folders and devices, lest they outlive Wine in a folder that is deleted.
            try (Stream<Path> links = Files.list(root.resolve("wine/dosdevices"))) {
                for (Path link : links.toList()) {
                    Files.delete(link);
                }
            }
        }
    }

    private static boolean isOnPath(String program) {
        return Stream.of(System.getenv("PATH").split(":", -1))
                .anyMatch(path -> Files.isExecutable(Path.of(path, program)));
    }

    private static ProcessBuilder wine(String... words) {
        ProcessBuilder builder = new ProcessBuilder(words).directory(place.toFile());
        builder.environment().put("WINEPREFIX", root.resolve("wine").toString());
        builder.environment().put("HOME", root.toString());
        builder.environment().put("WINEDEBUG", "-all");
        builder.environment().put("LC_ALL", "C.UTF-8");
        builder.environment().remove("JAVA_HOME");
        return builder;
    }

    private static ProcessBuilder onWindows(String... arguments) {
        List<String> words = new ArrayList<>(List.of("wine", "cmd", "/c", "sunbeam-0.1.0\\sunbeam.bat"));
        words.addAll(List.of(arguments));
        return wine(words.toArray(String[]::new));
    }

    private static SunbeamResult ended(int code, ProcessBuilder builder) throws Exception {
        try (RunningSunbeam running = RunningSunbeam.start(builder)) {
            return running.end(PATIENCE).ended(code);
        }
    }

    @Test
    void aMapHasTheNumbersOfLinux() throws Exception {
        workplace.command(MAP.replace("%s", "linux")).run().ended(0);
        map.end(PATIENCE).ended(0);

        NpyImage windows = NpyImage.read(place.resolve("windows.npy"), 32);
        NpyImage linux = NpyImage.read(workplace.resolve("linux.npy"), 32);
        // The same Mesa runs the same instructions on the same floats.
        assertThat(windows.values()).containsExactly(linux.values());
    }

    @Test
    void aScanWithAnUmlautAndSignsOfCmdHasTheVerdictOfLinux() throws Exception {
        Files.copy(place.resolve(SCAN), workplace.resolve("scan.gsf"));
        SunbeamResult linux =
                workplace.here("inspect scan.gsf --json --output scan.png").ended(0);
        SunbeamResult windows = inspection.end(PATIENCE).ended(0);

        assertThat(place.resolve("\u00c4hre.png")).exists();
        for (String field : List.of("verdict", "period_m", "roughness_m")) {
            assertThat(JSON.readTree(windows.stdout()).required(field))
                    .as(field)
                    .isEqualTo(JSON.readTree(linux.stdout()).required(field));
        }
    }

    /** Writes 20 lines of 500 nm, 60 nm deep, as a Gwyddion Simple Field. */
    private static Path grating(Path file) throws IOException {
        int side = 128;
        String header =
                "Gwyddion Simple Field 1.0\nXRes = 128\nYRes = 128\nXReal = 1e-5\nYReal = 1e-5\nXYUnits = m\nZUnits = m\n";
        int start = (header.length() / 4 + 1) * 4; // padded by 1 to 4 zeros
        ByteBuffer bytes = ByteBuffer.allocate(start + 4 * side * side).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(header.getBytes(StandardCharsets.US_ASCII)).position(start);
        for (int i = 0; i < side * side; i++) {
            bytes.putFloat((float) (30e-9 * Math.sin(2 * Math.PI * 20 * (i % side) / side)));
        }
        return Files.write(file, bytes.array());
    }

    @Test
    void aMissingFileIsOneLineAndItsExitCode() throws Exception {
        SunbeamResult result = refusal.end(PATIENCE).ended(SunbeamResult.UNUSABLE_INPUT);
        assertThat(result.stderr()).contains("sunbeam: K\u00e4fer.gsf is neither");
    }

    /** Wine makes Ctrl-C of SIGINT. */
    @Test
    void ctrlCLeavesNothing() throws Exception {
        assertThat(endedBy("INT").ended(SunbeamResult.INTERRUPTED).stderr()).doesNotContain("died");
        try (Stream<Path> files = Files.list(place)) {
            assertThat(files.map(file -> file.getFileName().toString())).noneMatch(name -> name.contains("gone"));
        }
    }

    /** Wine gives a killed process code 0, which Sunbeam's own 0 must not be taken for. */
    @Test
    void aJavaThatDiesIsOneLine() throws Exception {
        assertThat(endedBy("KILL").ended(1).stderr()).contains("sunbeam: Java has died");
    }

    /** Sends Java a signal while a map is drawn. */
    private static SunbeamResult endedBy(String signal) throws Exception {
        String size = "8192";
        try (RunningSunbeam running = RunningSunbeam.start(
                onWindows("brdf-map", "xenopeltis-like", "--size", size, "--output", "gone.png"))) {
            RunningSunbeam.await(
                    "the plan", () -> Files.readString(running.stderr()).contains("plan:"));
            ProcessHandle java = ProcessHandle.allProcesses()
                    .filter(process -> process.info().commandLine().orElse("").contains(size))
                    .filter(process -> process.info().commandLine().orElse("").contains("sunbeam.app.Main"))
                    .findFirst()
                    .orElseThrow();
            new ProcessBuilder("sh", "-c", "kill -" + signal + " " + java.pid())
                    .start()
                    .waitFor();
            return running.end(PATIENCE);
        }
    }

    /** Waits for the final picture and closes the window. */
    @Test
    void theViewerBecomesFinal() throws Exception {
        Files.writeString(place.resolve("plane.json"), """
                {
                  "mesh": "plane",
                  "patch": "blaze",
                  "camera": { "position": ["-5 cm", "-10 cm", "40 cm"], "lookAt": ["0 m", "0 m", "0 m"] },
                  "light": { "direction": [-0.2, 0.3, 0.9] },
                  "texture": "none",
                  "weights": { "diffraction": 30, "texture": 0.2, "ambient": 0.1 }
                }
                """);
        SunbeamResult result =
                ended(0, onWindows("view", "plane.json", "--size", "320x240", "--method", "full", "--measure", "1"));
        assertThat(result.stdout()).contains("final picture");
    }
}
