package sunbeam.precompute.scan.format;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.text.Quoted;

/**
 * The way through an installed Gwyddion, which reads some 170 formats: {@code gwyddion --convert-to-gwy}. It needs a
 * display, though it opens no window.
 */
public final class GwyddionConversion {
    private static final String CONVERTED = "converted.gwy";
    private static final String SAID = "said.txt";
    /** What a conversion may leave in the folder that it is given. */
    public static final List<String> FILES = List.of(CONVERTED, SAID);

    /** A scan takes a second or two; longer only a file that Gwyddion cannot cope with. */
    private static final int MOST_SECONDS = 60;

    private static final int LONGEST_COMPLAINT = 4096;

    private final Map<String, String> environment;

    /** @param environment of this process: where programs are, and which display */
    public GwyddionConversion(Map<String, String> environment) {
        this.environment = Map.copyOf(environment);
    }

    /** The words that start Gwyddion, on a screen of its own where there is no display; empty when that cannot be. */
    private List<String> command() {
        Optional<String> gwyddion = program("gwyddion");
        if (gwyddion.isEmpty()) {
            return List.of();
        }
        if (!environment.getOrDefault("DISPLAY", "").isEmpty()) {
            return List.of(gwyddion.get());
        }
        return program("xvfb-run")
                .map(screen -> List.of(screen, "-a", gwyddion.get()))
                .orElse(List.of());
    }

    private Optional<String> program(String name) {
        return Pattern.compile(File.pathSeparator, Pattern.LITERAL)
                .splitAsStream(environment.getOrDefault("PATH", ""))
                .filter(folder -> !folder.isEmpty())
                .map(folder -> Path.of(folder, name))
                .filter(Files::isExecutable)
                .findFirst()
                .map(Path::toString);
    }

    /** Whether there is a Gwyddion, and a display or the means of having one. */
    public boolean isInstalled() {
        return !command().isEmpty();
    }

    /**
     * Converts a file; to be called where Gwyddion is installed.
     *
     * @param scan in any format
     * @param folder for the result; its owner deletes it
     * @return the file in Gwyddion's format
     * @throws ScanException when Gwyddion does not know the format either
     */
    public Path convert(Path scan, Path folder) throws IOException {
        List<String> words = new ArrayList<>(command());
        if (words.isEmpty()) {
            throw new IllegalStateException("Gwyddion is not installed");
        }
        Path converted = folder.resolve(CONVERTED);
        Path said = folder.resolve(SAID);
        words.add("--convert-to-gwy=" + converted);
        words.add(scan.toAbsolutePath().toString());
        Process process = new ProcessBuilder(words)
                .redirectErrorStream(true)
                .redirectOutput(said.toFile())
                .start();
        process.getOutputStream().close();
        boolean ended = waitFor(process);
        if (!ended || !Files.isRegularFile(converted)) {
            throw new ScanException("is in no format that Sunbeam knows, and Gwyddion cannot read it ("
                    + (ended ? lastLine(said) : "no answer within " + MOST_SECONDS + " s")
                    + "); export it as .gwy, .gsf or text");
        }
        return converted;
    }

    private static boolean waitFor(Process process) throws IOException {
        try {
            return process.waitFor(MOST_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", stop);
        } finally {
            process.destroyForcibly();
        }
    }

    private static String lastLine(Path said) throws IOException {
        String text = new String(readHead(said), StandardCharsets.UTF_8);
        return text.lines()
                .filter(line -> line.contains(": "))
                .map(line -> line.substring(line.lastIndexOf(": ") + 2))
                .filter(line -> !line.isBlank())
                .findFirst()
                .map(Quoted::of)
                .orElse("it says nothing");
    }

    private static byte[] readHead(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return in.readNBytes(LONGEST_COMPLAINT);
        }
    }
}
