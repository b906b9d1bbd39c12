package sunbeam.app.measure.accuracy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.zip.CRC32;
import sunbeam.app.files.output.OutputException;

/**
 * Exact values that are computed batch by batch, kept in a file as soon as a batch is done, so that a run which was stopped
 * does not compute them again. One line for each batch: checksum, key, then the values; lines of other keys, and a line that
 * was cut off, are not used.
 */
final class ExactJournal {
    private final Path file;
    private final Map<String, String> kept = new HashMap<>();

    private ExactJournal(Path file) {
        this.file = file;
    }

    /** Of a file, which is made with the first batch. */
    static ExactJournal of(Path file) {
        ExactJournal journal = new ExactJournal(file);
        if (Files.isRegularFile(file)) {
            journal.read();
        }
        return journal;
    }

    private void read() {
        try {
            // Latin-1 takes any byte: what is damaged fails its checksum.
            for (String line : Files.readAllLines(file, StandardCharsets.ISO_8859_1)) {
                String[] parts = line.split("\t", -1);
                if (parts.length == 3 && parts[0].equals(checksum(parts[1], parts[2]))) {
                    kept.put(parts[1], parts[2]);
                }
            }
        } catch (IOException failure) {
            throw OutputException.of(file, failure);
        }
    }

    /**
     * The values of a batch: those that are kept, else those that are made, which are kept from then on.
     *
     * @param key all that determines the values
     * @param made a row of values each, which may have none
     */
    List<double[]> batch(String key, Supplier<List<double[]>> made) {
        String known = kept.get(key);
        if (known != null) {
            return parsed(known);
        }
        List<double[]> values = made.get();
        append(key, text(values));
        return values;
    }

    private static String text(List<double[]> rows) {
        List<String> texts = new ArrayList<>();
        for (double[] row : rows) {
            StringBuilder text = new StringBuilder();
            for (double value : row) {
                text.append(text.length() == 0 ? "" : " ").append(value);
            }
            texts.add(text.toString());
        }
        return String.join(",", texts);
    }

    private static List<double[]> parsed(String text) {
        List<double[]> rows = new ArrayList<>();
        for (String row : text.split(",", -1)) {
            String[] values = row.isEmpty() ? new String[0] : row.split(" ", -1);
            double[] numbers = new double[values.length];
            for (int i = 0; i < numbers.length; i++) {
                numbers[i] = Double.parseDouble(values[i]);
            }
            rows.add(numbers);
        }
        return rows;
    }

    private void append(String key, String values) {
        // A line that was cut off must not swallow this one.
        String line = "\n" + checksum(key, values) + "\t" + key + "\t" + values + "\n";
        try (FileChannel channel = FileChannel.open(
                file, StandardOpenOption.CREATE, StandardOpenOption.WRITE, StandardOpenOption.APPEND)) {
            ByteBuffer bytes = ByteBuffer.wrap(line.getBytes(StandardCharsets.ISO_8859_1));
            while (bytes.hasRemaining()) {
                channel.write(bytes);
            }
        } catch (IOException failure) {
            throw OutputException.of(file, failure);
        }
    }

    private static String checksum(String key, String values) {
        CRC32 checksum = new CRC32();
        checksum.update((key + "\t" + values).getBytes(StandardCharsets.ISO_8859_1));
        return Long.toHexString(checksum.getValue());
    }
}
