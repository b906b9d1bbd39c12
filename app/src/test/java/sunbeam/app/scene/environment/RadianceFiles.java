package sunbeam.app.scene.environment;

import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.IntBinaryOperator;

/** Writer of Radiance pictures for tests. */
public final class RadianceFiles {
    private RadianceFiles() {}

    static byte[] header(String lines, int width, int height) {
        String text = "#?RADIANCE\n" + lines + "\n\n-Y " + height + " +X " + width + "\n";
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /** Writes plain gray pixels of {@code (mantissa + 1/2) / 128}, the mantissa by column and row; 0 is black. */
    public static Path gray(Path file, int width, int height, IntBinaryOperator mantissa) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(header("FORMAT=32-bit_rle_rgbe", width, height));
        for (int i = 0; i < width * height; i++) {
            int value = mantissa.applyAsInt(i % width, i / width);
            bytes.write(new byte[] {(byte) value, (byte) value, (byte) value, (byte) (value == 0 ? 0 : 129)});
        }
        return Files.write(file, bytes.toByteArray());
    }

    /** Writes equal gray pixels in runs. */
    static Path runs(Path file, int width, int height, int mantissa) throws IOException {
        ByteArrayOutputStream row = new ByteArrayOutputStream();
        row.write(new byte[] {2, 2, (byte) (width >> 8), (byte) width});
        for (int channel = 0; channel < 4; channel++) {
            for (int left = width; left > 0; left -= 127) {
                row.write(new byte[] {(byte) (128 + Math.min(127, left)), (byte) (channel < 3 ? mantissa : 129)});
            }
        }
        try (OutputStream stream = new BufferedOutputStream(Files.newOutputStream(file))) {
            stream.write(header("FORMAT=32-bit_rle_rgbe", width, height));
            for (int i = 0; i < height; i++) {
                stream.write(row.toByteArray());
            }
        }
        return file;
    }

    static Path of(Path file, byte[] header, int... pixels) throws IOException {
        byte[] all = Arrays.copyOf(header, header.length + pixels.length);
        for (int i = 0; i < pixels.length; i++) {
            all[header.length + i] = (byte) pixels[i];
        }
        return Files.write(file, all);
    }
}
