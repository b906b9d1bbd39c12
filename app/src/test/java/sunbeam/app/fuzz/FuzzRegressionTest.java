package sunbeam.app.fuzz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.app.failure.Failure;

/** What fuzzing has found stays mended: all readers, with 512 MB and 5 s for each input, of mutations of seeds that are read. */
final class FuzzRegressionTest {
    @Test
    void everyReaderReadsOrRefuses(TestReporter reporter) throws Exception {
        Process process = FuzzTarget.java(FuzzRegressionTest.class.getName())
                .redirectErrorStream(true)
                .start();
        String told = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(told).isZero();
        assertThat(told).contains("findings: 0");
        told.lines().forEach(line -> reporter.publishEntry("fuzz", line));
    }

    @TempDir
    private Path folder;

    @ParameterizedTest
    @EnumSource(FuzzedReader.class)
    void everySeedIsRead(FuzzedReader reader) throws Exception {
        assertThat(reader.seeds()).isNotEmpty();
        for (byte[] seed : reader.seeds()) {
            Path file = Files.write(folder.resolve(reader.fileName()), seed);
            assertThatCode(() -> reader.read(file)).doesNotThrowAnyException();
        }
    }

    @ParameterizedTest
    @EnumSource(FuzzedReader.class)
    void anEmptyFileIsRefused(FuzzedReader reader) throws Exception {
        Path file = Files.write(folder.resolve(reader.fileName()), new byte[0]);
        assertThatThrownBy(() -> reader.read(file))
                .satisfies(refusal -> assertThat(Failure.of(refusal).isBug()).isFalse());
    }

    /**
     * Runs the inputs that are kept (corpora and every input that was ever a finding), the seeds and mutations of each through all readers;
     * in a process of its own, so that its memory is the budget.
     */
    public static void main(String[] arguments) throws IOException {
        Path folder = Files.createTempDirectory("sunbeam-fuzz");
        int findings = 0;
        for (FuzzedReader reader : FuzzedReader.values()) {
            int tried = 0;
            FuzzTarget target = new FuzzTarget(reader, folder);
            for (byte[] input : inputs(reader)) {
                tried++;
                findings += isFinding(target, input) ? 1 : 0;
            }
            System.out.println(reader.label() + ": " + tried + " inputs");
        }
        System.out.println("findings: " + findings);
        System.exit(findings == 0 ? 0 : 1);
    }

    private static boolean isFinding(FuzzTarget target, byte[] input) throws IOException {
        try {
            target.assertReadOrRefusedInTime(input);
            return false;
        } catch (AssertionError | OutOfMemoryError | StackOverflowError finding) {
            Path file = Files.write(Files.createTempFile("sunbeam-finding-", ".bin"), input);
            System.out.println("finding " + file + ": " + finding);
            finding.printStackTrace(System.out);
            return true;
        }
    }

    private static List<byte[]> inputs(FuzzedReader reader) throws IOException {
        List<byte[]> sources = new ArrayList<>(reader.seeds());
        Path folder = Path.of("src/test/resources/sunbeam/app/fuzz").resolve(reader.corpus());
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : files.sorted().toList()) {
                    sources.add(Files.readAllBytes(file));
                }
            }
        }
        Random random = new Random(13);
        List<byte[]> inputs = new ArrayList<>(List.of(new byte[0]));
        for (byte[] source : sources) {
            inputs.add(source);
            for (int mutation = 0; mutation < 150; mutation++) {
                inputs.add(mutated(source, random));
            }
        }
        return inputs;
    }

    /** A few bytes changed, doubled, cut out or cut off, most of them near the beginning, where headers are. */
    private static byte[] mutated(byte[] seed, Random random) {
        byte[] content = seed.clone();
        for (int change = random.nextInt(4); change >= 0 && content.length > 1; change--) {
            int at = random.nextInt(random.nextBoolean() ? Math.min(100, content.length) : content.length);
            switch (random.nextInt(6)) {
                case 0 -> content[at] = (byte) random.nextInt(256);
                case 1 -> content[at] ^= (byte) (1 << random.nextInt(8));
                case 2 -> content[at] = (byte) (random.nextBoolean() ? 0xff : 0x7f);
                case 3 -> content = spliced(content, at, at, content.length - at);
                case 4 -> content = spliced(content, at, Math.min(content.length, at + 1 + random.nextInt(8)), 0);
                default -> content = java.util.Arrays.copyOf(content, at);
            }
        }
        return content;
    }

    /** What comes before {@code from}, {@code again} bytes from there, and what comes after {@code to}. */
    private static byte[] spliced(byte[] content, int from, int to, int again) {
        byte[] result = new byte[from + again + content.length - to];
        System.arraycopy(content, 0, result, 0, from + again);
        System.arraycopy(content, to, result, from + again, content.length - to);
        return result;
    }
}
