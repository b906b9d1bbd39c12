package sunbeam.app.files.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.ImageIO;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import sunbeam.app.files.input.PngText;
import sunbeam.precompute.files.InputException;

/** Pictures and their text, tables and arrays, as other programs read them. */
final class PngWriterTest {
    private static final int[] PIXELS = {0xff000000, 0xffff8001, 0xff0080ff, 0xffffffff, 0xff123456, 0xfffedcba};

    @TempDir
    private Path folder;

    private static BufferedImage image() {
        BufferedImage image = new BufferedImage(3, 2, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 3, 2, PIXELS, 0, 3);
        return image;
    }

    private Path write(BufferedImage image, Map<String, String> text) {
        Path target = folder.resolve("out.png");
        PngWriter.write(target, Overwrite.REFUSE, image, text);
        return target;
    }

    @Test
    void pixelsComeBackExactlyMarkedAsSrgb() throws IOException {
        Path file = write(image(), Map.of());
        BufferedImage image = ImageIO.read(file.toFile());
        assertThat(image.getColorModel().hasAlpha()).isFalse();
        assertThat(image.getRGB(0, 0, 3, 2, null, 0, 3)).isEqualTo(PIXELS);
        assertThat(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1))
                .contains("sRGB\0");
    }

    @Test
    void textsComeBackInAnyLanguageAndTheirOrder() {
        Map<String, String> text = new LinkedHashMap<>();
        text.put("theta-i", "75 deg");
        text.put("Comment", "two\nlines, 65 \u00b5m");
        text.put("patch", "\u86c7 \u03bb/4");
        Path file = write(image(), text);
        Map<String, String> read = PngText.read(file);
        assertThat(read).containsAllEntriesOf(text);
        assertThat(read.get("Software")).startsWith("Sunbeam ");
        assertThat(read.keySet()).startsWith("Software", "theta-i", "Comment");
    }

    @Test
    void aFlippedBitInATextIsFound() throws IOException {
        Path file = write(image(), Map.of("patch", "blaze"));
        byte[] bytes = Files.readAllBytes(file);
        int position = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("blaze");
        bytes[position] ^= 1;
        Files.write(file, bytes);
        assertThatThrownBy(() -> PngText.read(file))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("checksum");
    }

    // Matrices of sRGB have seven digits.
    private static final float ROUNDING = 1e-5f;

    /** The red primary of Rec. 709. */
    @Test
    void openExrHasRedAsOne() throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        LinearFile.of(Path.of("a.exr"), new float[] {0.4124564f, 0.2126729f, 0.0193339f}, 1, 1)
                .writeTo(stream);

        ByteBuffer bytes = ByteBuffer.wrap(stream.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);

        assertThat(bytes.getInt(0)).as("OpenEXR's magic number").isEqualTo(20000630);
        // A line this short is stored uncompressed, its channels in the order of the alphabet.
        float[] stored = new float[4];
        bytes.position(bytes.capacity() - 4 * Float.BYTES)
                .slice()
                .order(ByteOrder.LITTLE_ENDIAN)
                .asFloatBuffer()
                .get(stored);
        assertThat(stored).containsExactly(new float[] {1, 0, 0, 1}, within(ROUNDING));
    }

    private static final String HASH = "0123";

    private Path picture() {
        Path file = folder.resolve("picture.png");
        BufferedImage image = new BufferedImage(40, 30, BufferedImage.TYPE_INT_RGB);
        PngWriter.write(file, Overwrite.REPLACE, image, Map.of(PngText.PARAMETERS, HASH));
        return file;
    }

    @Test
    void aPictureIsKnownByTheHashOfWhatDeterminesIt() {
        assertThat(PngText.find(picture(), HASH)).isPresent();
        assertThat(PngText.find(picture(), "4567")).isEmpty();
        assertThat(PngText.find(folder.resolve("none.png"), HASH)).isEmpty();
    }

    @Test
    void aPictureWithDamagedPixelsIsNotThePicture() throws IOException {
        Path file = picture();
        byte[] bytes = Files.readAllBytes(file);
        int pixels = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("IDAT") + 4;
        bytes[pixels + 8] ^= 1;
        Files.write(file, bytes);

        assertThat(PngText.find(file, HASH)).isEmpty();
    }

    /** Packets that tev's own Python client (tevclient 1.0.4) sends for the same pictures, without the pixels. */
    private static final String CREATE =
            "1e000000" + "04" + "01" + "6d617000" + "03000000" + "02000000" + "04000000" + "5200470042004100";

    private static final String UPDATE = "86000000" + "06" + "00" + "6d617000" + "04000000" + "5200470042004100"
            + "01000000" + "00000000" + "02000000" + "01000000"
            + "0000000000000000" + "0100000000000000" + "0200000000000000" + "0300000000000000"
            + "0400000000000000".repeat(4);

    private final StringWriter said = new StringWriter();

    @Test
    void packetsAreThoseOfTevsOwnClient() throws IOException {
        try (ServerSocket server = listening()) {
            TevClient client = TevClient.connect(server.getLocalPort(), new PrintWriter(said, true));
            try (Socket tev = server.accept()) {
                client.create("map", 3, 2);
                // White of D65, and no surface.
                client.update("map", 1, 0, 2, 1, new float[] {0.95047f, 1, 1.08883f, Float.NaN, Float.NaN, Float.NaN});
                client.close();
                byte[] sent = tev.getInputStream().readAllBytes();

                String hex = HexFormat.of().formatHex(sent);
                assertThat(hex).startsWith(CREATE + UPDATE);
                FloatBuffer pixels = ByteBuffer.wrap(sent)
                        .order(ByteOrder.LITTLE_ENDIAN)
                        .position((CREATE + UPDATE).length() / 2)
                        .asFloatBuffer();
                assertThat(pixels.remaining()).isEqualTo(8);
                for (int channel = 0; channel < 4; channel++) {
                    // The white has five digits.
                    assertThat(pixels.get(channel)).isCloseTo(1, Offset.offset(1e-4f));
                    assertThat(pixels.get(4 + channel)).isZero();
                }
            }
        }
    }

    @Test
    void aMissingTevIsReportedInOneLine() throws IOException {
        int port;
        try (ServerSocket server = listening()) {
            port = server.getLocalPort();
        }

        assertThatThrownBy(() -> TevClient.connect(port, new PrintWriter(said)))
                .isInstanceOf(OutputException.class)
                .hasMessage("--tev: no tev on port " + port
                        + " of this machine (nothing listens there); start tev first, or leave --tev out");
    }

    @Test
    void aTevThatEndsIsOneWarning() throws IOException {
        try (ServerSocket server = listening();
                TevClient client = TevClient.connect(server.getLocalPort(), new PrintWriter(said, true))) {
            server.accept().close();
            for (int i = 0; i < 50; i++) {
                client.create("map", 1, 1);
            }
            assertThat(said.toString()).hasLineCount(1).contains("tev takes no more pictures");
        }
    }

    /** A server that accepts and never reads: its buffers and ours are full after some megabytes. */
    @Test
    void aTevThatStallsIsOneWarningAfterFiveSeconds() throws IOException {
        try (ServerSocket server = listening();
                TevClient client = TevClient.connect(server.getLocalPort(), new PrintWriter(said, true));
                Socket stalled = server.accept()) {
            long start = System.nanoTime();
            int side = 2048;
            for (int i = 0; i < 4; i++) {
                client.update("map", 0, 0, side, side, new float[3 * side * side]);
            }
            assertThat(stalled.isConnected()).isTrue();
            // Twice the patience, for a busy machine.
            assertThat((int) Duration.ofNanos(System.nanoTime() - start).toMillis())
                    .isBetween(TevClient.PATIENCE_MILLISECONDS, 2 * TevClient.PATIENCE_MILLISECONDS);
            assertThat(said.toString()).hasLineCount(1).contains("tev takes no more pictures (no answer for 5 s)");
        }
    }

    private static ServerSocket listening() throws IOException {
        return new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    }
}
